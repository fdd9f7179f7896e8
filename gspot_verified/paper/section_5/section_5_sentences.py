"""Ledger of Section 5: a count of equations, the synchronisation, the words for the slow manifolds, and misprints."""

from __future__ import annotations

import re

from flint import fmpq_mpoly

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.formulas import mended
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.checks.words import Place, held_against, quoted, said
from gspot_verified.paper.section_5 import section_5_outer
from gspot_verified.paper.section_5.section_5_recursion import ALGEBRA
from gspot_verified.paper.section_5.section_5_recursion import PRINTED as RECURSION
from gspot_verified.paper.section_5.section_5_theorem import HYPOTHESES

SECTION = Section("Section 5, Theorem 1")
KINDS = {"printed": {"differential": 4, "algebraic": 1}, "corrected": {"differential": 3, "algebraic": 2}}
"""Line 1652."""
LEFT = dict(RECURSION["5-orders"])
"""The left-hand sides B, Y, V, Z, L of specialBn to specialLn; the right-hand sides are known."""
UNKNOWNS = {"b0": "b1", "y0": "y1", "v0": "v1", "z0": "z1", "l0": "l1"}
"""b_n, y_n, v_n, z_n, λ_n and their derivatives in s."""
RATE = "k"
"""A symbol for d/ds, with s frozen."""
DIFFERENCES = Algebra("lam p b y v P B Y V a1 a2 a3")
EXTENDED = {"p": "a1", "b": "a2 - a3*lam", "y": "v", "v": "b + p*lam"}
"""genSysP to genSysV."""
FUNCTIONS = {"P": "a1", "B": "a2 - a3*lam", "Y": "V", "V": "B + P*lam"}
"""gensys2 to gensys5 for the functions of the state."""
BRACKETS = "lines 296 to 299, 2050 to 2058, 2521 to 2543"
PLACES = {
    "lines 2053, 2054, 2056": (r"\\epsilon\^\{(\(?2\(\\beta-1\)/3)\}", 3),
    "lines 2536, 2538, 2541": (
        r"\\dot\{\\phi\}(\\left\(k_\{\\phi\}\\left\(\\phi-\\phi_0\\right\)\)?\+c_\{\\phi\}\\dot\{\\phi\}\\right\))",
        3,
    ),
    "line 299": (r"dynamic jam (\(by reaching the G-spot \$b=p=0\$\)?)\.", 1),
}
"""A pattern with a printed group of brackets, as it is and with the fault mended, and how often it is there."""


LETTERS = "lines 1395 to 1405, 2037 to 2045"
FUNCTIONS_OF_XI = {
    letter: (
        Place("line 1396", rf"\\tilde\{{\\xi\}}\^\\prime &=.*?({letter})\(\\xi\)(?=.*?specialX)"),
        Place("line 2038", rf"\\tilde\{{\\xi\}}\^\\prime&=.*?(\\tilde\{{{letter}\}})\(\\xi\)"),
    )
    for letter in "FG"
}
"""What stands before (ξ) in the two equations for ξ."""
SIGNS_AND_CLASSES = "lines 1516 to 1523, 1615 to 1620, 1671 to 1674, 1742 to 1745"
MISPRINTS = {
    "the sign that defines r_{b,n} and r_n": (
        Place("line 1618", r"(:=(?: *=)*) *r_\{b,n\}"),
        Place("line 1673", r"(:=(?: *=)*) *r_n\(s\)"),
    ),
    "the class for n = 2ν + 1 in Step 4 and in Theorem 1": (
        Place("line 1744", r"\$(P_[^\s$]+)\$ if \$n=2\\nu\+1\$"),
        Place("line 1518", r"\\xi_\{2\\nu\+1\}\(s\)\\in (P_\S+),"),
    ),
}
"""What is printed in two places that ask for the same."""
APPROACH = "lines 1916 to 1920, 1961 to 1965, 2003 to 2009"
NAMED_SIDE = Place("line 1918", r"in the critical manifold for \$p([<>])0\$")
ANSATZ_TIME = Place("line 2005", r"\\hat\{\\xi\}\(t\)&=\\xi_0\((-?)t\)\^r")
SIDES = {">": 1, "<": -1}
ATTRACTED = {"printed": None, "corrected": ">"}
SLOPE = "-a2"
"""α_1* < 0, the rate of p."""
"""The side of p that the trajectories come from: the one of line 1918, and the right one."""
MANIFOLDS = "lines 1967 to 1971, 1980 to 1984"
AT_EPSILON_0 = Place("line 1967", r"for \$\\eps=0\$ occur on the (\w+) manifold")
NEAR_BY = Place("line 1982", r"exist a \{\\em (\w+) manifolds\} which are \$O\(\\eps\)\$")
NAMES = {"ε = 0": "critical", "near by": "slow"}
"""What they are called in the theory of fast-slow systems that line 1980 cites."""
UNIQUE = "lines 1363 to 1369"
REGULAR = "jacobian"
"""The hypothesis of 5-theorem-1 by which Y = J⁻¹ is defined."""
SIZES = (1, 2, 3, 4)
"""Sizes of the Jacobian at which Cramer's rule is written out with symbols."""
DIMENSION = Algebra("m")
AT_THE_G_SPOT = {"P, B, Y, V": "4", "J": "m - 4"}
"""How many functions vanish at the G-spot."""
MECHANISM = "falling rod of Génot and Brogliato"


def _left_sides() -> list[fmpq_mpoly]:
    return [ALGEBRA.read(LEFT[name]) for name in "BYVZL"]


def counted_by_derivatives(form: str) -> bool | None:
    """Whether so many of the equations have the derivative of an unknown, and so many have none."""
    found = [any(not left.derivative(rate).is_zero() for rate in UNKNOWNS.values()) for left in _left_sides()]
    return {"differential": found.count(True), "algebraic": found.count(False)} == KINDS[form]


def counted_by_the_order(form: str) -> bool | None:
    """Whether the order of the whole system, the degree of its determinant in d/ds, is that of the first kind."""
    rows = [
        [left.derivative(name) + left.derivative(rate) * ALGEBRA.symbols[RATE] for name, rate in UNKNOWNS.items()]
        for left in _left_sides()
    ]
    powers = ALGEBRA.coefficients(ALGEBRA.determinant(rows), RATE)
    total = sum(KINDS[form].values())
    return None if not powers else max(powers) == KINDS[form]["differential"] and total == len(rows)


def _kinds() -> Entry:
    forms = ("printed", "corrected")
    return SECTION.settled(
        "5-kinds",
        "lines 1651 to 1653",
        r"\text{four coupled ODEs and one algebraic equation}",
        "The equations of order n, specialBn to specialZn, are four differential equations for b_n, y_n, v_n, z_n and "
        "λ_n, and specialLn is algebraic",
        Rung.EXACT.check(
            "which of the five left-hand sides have the derivative of an unknown",
            mended(*map(counted_by_derivatives, forms)),
            "specialBn, specialYn and specialVn; in specialZn the derivative is that of z_(n-1), which is known",
        ),
        Rung.EXACT.check(
            "the degree in d/ds of the determinant of the five equations: with λ_n by specialLn, four equations that "
            "give the derivatives of b_n, y_n, v_n, z_n would have the order four",
            mended(*map(counted_by_the_order, forms)),
            "the order is three, as that of third-order_b",
        ),
        corrected="Three differential equations (specialBn to specialVn) and two algebraic ones (specialZn, specialLn)",
    )


def difference_of(name: str) -> fmpq_mpoly:
    """The rate of a variable less that of its function of the state."""
    return DIFFERENCES.read(EXTENDED[name]) - DIFFERENCES.read(FUNCTIONS[name.upper()])


def differences_are_linear() -> bool | None:
    """Whether the differences p - P, b - B, y - Y, v - V have rates that are linear in them, without a free term.

    So they are 0 at all times when they are at one (λ_N is continuous): a linear equation has one solution.
    """
    read = DIFFERENCES.read
    wanted = {"p": "0*p", "b": "0*b", "y": "v - V", "v": "b - B + (p - P)*lam"}
    return all((difference_of(name) - read(text)).is_zero() for name, text in wanted.items())


def differences_follow_one_by_one() -> bool | None:
    """The same in the order p, b, v, y: each rate is 0 once those before are equal."""
    equal: dict[str, fmpq_mpoly] = {}
    for name in "pbvy":
        if not DIFFERENCES.substitute(difference_of(name), equal).is_zero():
            return False
        equal[name] = DIFFERENCES.symbols[name.upper()]
    return True


def _synchronised() -> Entry:
    return SECTION.settled(
        "5-synchronised",
        "lines 1331 to 1336",
        r"p(t_0)=\mathcal P(\xi(t_0)),\ldots\ \Rightarrow\ p(t)=\mathcal P(\xi(t)),\ldots",
        "With a continuous λ_N the further variables p, b, y, v are equal to the functions of the state at all times "
        "when they are so at one",
        Rung.EXACT.check(
            "the four differences satisfy a linear homogeneous equation (λ_N continuous)", differences_are_linear()
        ),
        Rung.EXACT.check(
            "one after another: p - P and b - B are constant, then v - V, then y - Y", differences_follow_one_by_one()
        ),
        note="The functions of the state satisfy the same equations: 2-slip-equations.",
    )


def cofactors_invert() -> bool | None:
    """Whether the matrix of cofactors times the Jacobian is its determinant times 1: J⁻¹ exists where that is not 0."""
    answers = []
    for size in SIZES:
        algebra = Algebra(" ".join(f"j{row}{column}" for row in range(size) for column in range(size)))
        rows = [[algebra.symbols[f"j{row}{column}"] for column in range(size)] for row in range(size)]
        whole = algebra.determinant(rows)
        for i in range(size):
            for k in range(size):
                # row i of the cofactors' transpose, times column k: the expansion of a determinant by column i
                replaced = [[row[k] if column == i else row[column] for column in range(size)] for row in rows]
                expected = whole if i == k else algebra.constant(0)
                answers.append((algebra.determinant(replaced) - expected).is_zero())
    return all(answers)


def has_a_regular_jacobian() -> bool | None:
    """Whether the functions are m, as the components of ξ, for every m: a square Jacobian, by hypothesis regular."""
    total = sum((DIMENSION.read(f"{text} + 0*m") for text in AT_THE_G_SPOT.values()), start=DIMENSION.constant(0))
    if REGULAR not in HYPOTHESES:
        return None
    return (total - DIMENSION.symbols["m"]).is_zero()


def one_in_a_box() -> bool | None:
    """Whether the library's Krawczyk test proves one G-spot of a mechanism in a box, where it is not rational."""
    try:
        return find_g_spot(shipped_mechanism(MECHANISM)).exact is False
    except GSpotError:
        return None


def _unique() -> Entry:
    return SECTION.settled(
        "5-locally-unique",
        UNIQUE,
        r"[\mathcal P_\xi,\mathcal B_\xi,\mathcal Y_\xi,\mathcal V_\xi,\mathcal J_\xi]\ \text{non-singular}",
        "For continuously differentiable functions: where p = b = y = v = 0 and J = 0 with a regular Jacobian, there "
        "is no other such place near by",
        Page("krawczyk", (cofactors_invert,)).carries(
            Rung.EXACT.check(
                "Corollary, with as many functions as components of ξ, f(ξ*) = 0, and Y the inverse of the Jacobian "
                "at ξ*, its cofactors over its determinant",
                has_a_regular_jacobian(),
            )
        ),
        Rung.POINTS.check("the same test in balls at a G-spot of a mechanism", one_in_a_box()),
        note="It is the inverse function theorem.",
    )


def brackets_close(place: str) -> bool | None:
    """Whether each bracket that opens in the printed group is closed there, in order."""
    pattern, times = PLACES[place]
    found = re.findall(pattern, quoted(BRACKETS))
    if len(found) != times:
        return None
    return all(_closes(group) for group in found)


def _closes(text: str) -> bool:
    depth = 0
    for letter in text:
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if depth < 0:
            return False
    return depth == 0


def _brackets() -> Entry:
    return SECTION.settled(
        "5-brackets",
        BRACKETS,
        r"\text{(by reaching the G-spot }b=p=0,\quad"
        r"\epsilon^{(2(\beta-1)/3},\quad\dot\phi\,(k_\phi(\phi-\phi_0))+c_\phi\dot\phi)",
        "Every bracket of the caption of Figure 3 (line 299), of the perturbed variables (lines 2054, 2056) and of α_2 "
        "(line 2538) is closed",
        *(
            Rung.EXACT.check(
                f"{place}: each bracket with its partner", brackets_close(place), "a bracket has no partner"
            )
            for place in PLACES
        ),
        corrected="b = p = 0); 2(β-1)/3; (k_φ (φ - φ_0) + c_φ φ\u0307)",
    )


def _letters() -> Entry:
    return SECTION.settled(
        "5-letters",
        LETTERS,
        r"\tilde\xi'=\tilde F(\xi)+\tilde G(\xi)\lambda_N",
        "The slow system of the inner scale is printed with the functions F and G with a tilde, as those of specialX",
        *(held_against(LETTERS, f"{letter} in both", *places) for letter, places in FUNCTIONS_OF_XI.items()),
        corrected="F(ξ) + G(ξ) λ_N: nothing is defined with F and G with a tilde",
    )


def _typesetting() -> Entry:
    return SECTION.settled(
        "5-typesetting",
        SIGNS_AND_CLASSES,
        r":=\,=r_{b,n}(s),\quad P_\nu-3",
        "r_{b,n} is defined by the sign that defines r_n; the class that is printed for the terms (i) of Step 4 for "
        "n = 2ν + 1 is the one that is printed in Theorem 1",
        *(held_against(SIGNS_AND_CLASSES, what, *places) for what, places in MISPRINTS.items()),
        corrected=":= r_{b,n}(s); P_{ν-3}",
    )


def side_of(form: str) -> str | None:
    """The side of p that is named in line 1918, or the right one."""
    return ATTRACTED[form] or said(APPROACH, NAMED_SIDE)


def ansatz_is_on_the_side(form: str) -> bool | None:
    """Whether p = α_1 t has the sign of the side where the power of the ansatz is real.

    (-t)^r is real for every r > 0 where t = -a3 < 0, and t^r where t = a3.
    """
    time, side = said(APPROACH, ANSATZ_TIME), side_of(form)
    if time is None or side is None:
        return None
    p = DIFFERENCES.read(SLOPE) * DIFFERENCES.read("-a3" if time == "-" else "a3")
    return rising_signs(SIDES[side] * p)


def comes_to_the_g_spot_on_the_side(form: str) -> bool | None:
    """Whether p² falls there: its rate is 2 p α_1."""
    side = side_of(form)
    if side is None:
        return None
    p = DIFFERENCES.read("a3")
    return rising_signs(-2 * SIDES[side] * p * DIFFERENCES.read(SLOPE))


def _approaching() -> Entry:
    forms = ("printed", "corrected")
    return SECTION.settled(
        "5-approaching-side",
        APPROACH,
        r"\text{other trajectories that are in the critical manifold for }p<0",
        "The other trajectories that come to the G-spot, and are followed as p → 0, are in the slow manifold for p < 0",
        Rung.EXACT.check(
            "the ansatz (-t)^r for them, with p = α_1* t, α_1* < 0",
            mended(*map(ansatz_is_on_the_side, forms)),
            "(-t)^r is real for every r > 0 at t < 0 alone, and there p > 0",
        ),
        Rung.EXACT.check(
            "the rate of p², 2 p α_1*, α_1* < 0",
            mended(*map(comes_to_the_g_spot_on_the_side, forms)),
            "for p < 0 it is positive: such trajectories move away from p = 0",
        ),
        corrected="for p > 0",
    )


def consists_of_equilibria() -> bool | None:
    """Whether the rates of y_o, v_o, z_o times ε vanish on the manifold of line 1969, with b = p q."""
    on_it = {"b": "p*q", "y": "2*q", "v": "0*q", "z": "q"}
    return all(section_5_outer.put(side, **on_it).is_zero() for side in _fast_rates())


def has_others_near_by() -> bool | None:
    """Whether the fast system has other equilibria: its determinant is 0; with p or -p it has none for p not 0."""
    rows = [[side.derivative(name) for name in "yvz"] for side in _fast_rates()]
    determinant = section_5_outer.ALGEBRA.determinant(rows)
    if determinant.is_zero():
        return True
    return False if (determinant**2 - section_5_outer.ALGEBRA.symbols["p"] ** 2).is_zero() else None


def _fast_rates() -> list[fmpq_mpoly]:
    outer, read = section_5_outer.PRINTED["5-outer-system"], section_5_outer.ALGEBRA.read
    return [section_5_outer.put(read(outer[name]), lam=outer["lambda"]) for name in "yvz"]


def is_invariant() -> bool | None:
    """Whether on it 2b/p has the rate 0, as y_o has with v_o = 0 for ε > 0: p² times d(b/p)/dt along the slow flow."""
    read = section_5_outer.ALGEBRA.read
    return (read(section_5_outer.PRINTED["5-slow-manifold"]["b"]) - read("b*alpha1")).is_zero()


def name_at_epsilon_0(word: str | None) -> bool | None:
    """Whether the manifold of ε = 0 is critical: equilibria at ε = 0; or slow: invariant for ε > 0."""
    return {"critical": consists_of_equilibria(), "slow": is_invariant()}.get(word or "")


def name_near_by(word: str | None) -> bool | None:
    """Whether other manifolds near by are critical: more equilibria; or slow, as that of ε = 0 is not invariant."""
    return {"critical": has_others_near_by(), "slow": not is_invariant()}.get(word or "")


def _names() -> Entry:
    return SECTION.settled(
        "5-manifold-names",
        MANIFOLDS,
        r"\text{slow manifold for }\epsilon=0,\quad\text{critical manifolds close to it}",
        "The manifold of ε = 0 is the slow manifold, and the invariant ones near by for ε > 0 are critical manifolds, "
        "in the words of the theory that is cited: a critical manifold consists of the equilibria of the fast system "
        "at ε = 0, a slow one is locally invariant for ε > 0",
        Rung.EXACT.check(
            "the manifold of line 1969: the rates of the fast system on it, and the rate of 2b/p",
            mended(name_at_epsilon_0(said(MANIFOLDS, AT_EPSILON_0)), name_at_epsilon_0(NAMES["ε = 0"])),
            "it consists of the equilibria at ε = 0, and is in general not invariant for ε > 0",
        ),
        Rung.EXACT.check(
            "the manifolds near by: other equilibria would need a determinant 0 of the fast system",
            mended(name_near_by(said(MANIFOLDS, NEAR_BY)), name_near_by(NAMES["near by"])),
            "the determinant is -p: at ε = 0 there is one manifold of equilibria and no other near by",
        ),
        corrected="the critical manifold is that of ε = 0, and slow manifolds are O(ε) close to it (lines 1913 to 1920 "
        "too)",
    )


ENTRIES: Builders = {
    "5-synchronised": _synchronised,
    "5-locally-unique": _unique,
    "5-kinds": _kinds,
    "5-typesetting": _typesetting,
    "5-approaching-side": _approaching,
    "5-manifold-names": _names,
    "5-letters": _letters,
    "5-brackets": _brackets,
}
"""Sentences of Sec. 5."""
