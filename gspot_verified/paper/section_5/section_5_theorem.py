"""Ledger of Section 5: existence, uniqueness and orders in Theorem 1. Page: proofs/expansion.md.

Each unknown of order n is found by one division: the divisors must be products of factors that a hypothesis keeps from
0. Which orders of the terms an order of the residual knows says how far truncation can be felt.
"""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpq, fmpq_mat, fmpq_mpoly

from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, readable, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_5 import explicit_expansions as explicit
from gspot_verified.paper.section_5.section_5_recursion import ALGEBRA as RECURSION
from gspot_verified.paper.section_5.section_5_recursion import CORRECTED, PRINTED
from gspot_verified.paper.section_5.section_5_spaces import UNSCALED, dependence

SECTION = Section("Section 5, Theorem 1")
ALGEBRA = Algebra("alpha1 alpha3 beta k u0 u3 jacobian n M")
HYPOTHESES = {
    "alpha1": "α_1* < 0",
    "alpha3": "α_3* < 0",
    "k - beta": "β is not an integer, k = 0, 1, 2, ...",
    "jacobian": "the Jacobian of (P, B, Y, V, J) at ξ* is regular",
    "k + 1": "k = 0, 1, 2, ...",
}
"""Factors that are not 0, and why: the hypotheses of Theorem 1 and what a power of s is."""
RESIDUAL_ORDERS = {"equations": "M", "conditions": "M + 2"}
"""Theorem 1: eqs. specialX to specialL up to O(delta^M), pbc to Jbc up to O(delta^(M+2))."""
KNOWN_BEFORE = {
    "equations": {"xi": 0, "p": 0, "b": 0, "y": 0, "v": 0, "z": 0, "lambda_n": 0, "z of delta z'": 1, "xi in f": 2},
    "conditions": {name: UNSCALED[name] for name in ("xi", "p", "b", "y", "v")},
}
"""Order m of the residual has a term of order m - this of the variable, and terms of lower orders.

The conditions are specialInitialFirst to Jbc; pbc is 0 for the sums.
"""


def divisors() -> dict[str, fmpq_mpoly]:
    """What is divided by to find each unknown of order n, for every n (alpha3 = beta alpha1 for b)."""
    image = ALGEBRA.bring(RECURSION.read({**PRINTED["5-monomial"], **CORRECTED["5-monomial"]}["image"]))
    diagonal = ALGEBRA.substitute(image.derivative("u3"), {"alpha3": ALGEBRA.read("beta*alpha1")})
    alpha3, power = ALGEBRA.symbols["alpha3"], ALGEBRA.read("k + 1")
    by_step_3 = dict.fromkeys(("y", "v", "lambda"), alpha3)
    return {
        "p_n, each power s^(k+1)": power, "b_n, each power s^k": diagonal,
        **{f"{name}_n": value for name, value in by_step_3.items()}, "z_n": alpha3,
        "ξ_n, each power s^(k+1)": power, "ξ_n(0)": ALGEBRA.symbols["jacobian"],
    }  # fmt: skip


def unjustified() -> list[str]:
    """The divisors with a factor that no hypothesis keeps from 0."""
    allowed = [ALGEBRA.read(text) for text in HYPOTHESES]
    found = []
    for name, value in divisors().items():
        number, factors = value.factor()
        if number == 0 or any(all(factor not in (a, -a) for a in allowed) for factor, _ in factors):
            found.append(f"{name}: {readable(value)}")
    return found


def divisors_are_justified() -> bool:
    """Whether every divisor is a product of factors that a hypothesis keeps from 0."""
    return not unjustified()


def is_triangular() -> bool:
    """Whether the operator of b_n takes s^k to its multiple and a multiple of s^(k-3), which is 0 for k < 3."""
    image = RECURSION.read({**PRINTED["5-monomial"], **CORRECTED["5-monomial"]}["image"])
    same, lower = image.derivative("u3"), image.derivative("u0")
    rest = image - same * RECURSION.symbols["u3"] - lower * RECURSION.symbols["u0"]
    ends = [RECURSION.substitute(lower, {"k": RECURSION.constant(k)}) for k in range(3)]
    return all(value.is_zero() for value in (rest, *ends))


def rank_defect(degree: int, alpha_1: fmpq, alpha_3: fmpq) -> int:
    """Of the matrix of eqs. specialBn to specialLn: 0 when every right side has exactly one solution."""
    rows = homogeneous(degree, alpha_1, alpha_3)
    return rows.ncols() - rows.rank()


def homogeneous(degree: int, alpha_1: fmpq, alpha_3: fmpq) -> fmpq_mat:
    """Eqs. specialBn to specialLn for polynomials: b of this degree, lambda, y, z one lower, v two lower.

    The columns are the coefficients of b, lambda, y, z, v, from s^0 on. As many equations as unknowns, no elimination.
    """
    degrees = {"b": degree, "l": degree - 1, "y": degree - 1, "z": degree - 1, "v": degree - 2}
    unknowns = [(name, k) for name, top in degrees.items() for k in range(top + 1)]
    place = {unknown: i for i, unknown in enumerate(unknowns)}
    # Each term: (variable, factor, derivatives, further powers of s).
    lines: list[tuple[int, list[tuple[str, fmpq, int, int]]]] = [
        (degree - 1, [("b", fmpq(1), 1, 0), ("l", alpha_3, 0, 0)]),
        (degree - 2, [("y", fmpq(1), 1, 0), ("v", fmpq(-1), 0, 0)]),
        (degree, [("v", fmpq(1), 1, 0), ("b", fmpq(-1), 0, 0), ("l", -alpha_1, 0, 1)]),
        (degree - 1, [("z", fmpq(-1), 0, 0), ("l", fmpq(-1), 0, 0)]),
        (degree - 1, [("l", fmpq(1), 0, 0), ("z", fmpq(-1), 0, 0), ("y", fmpq(1), 0, 0)]),
    ]
    rows = []
    for top, terms in lines:
        for power in range(top + 1):
            row = [fmpq(0)] * len(unknowns)
            for name, factor, slopes, shift in terms:
                k = power - shift + slopes
                if (name, k) in place:
                    row[place[name, k]] += factor * (k if slopes else 1)
            rows.append(row)
    return fmpq_mat(rows)


def determined() -> bool | None:
    """Whether no divisor can be 0; False where β may be an integer k: the triangular operator of b_n is singular."""
    if divisors_are_justified():
        return True
    factors = divisors()["b_n, each power s^k"].factor()[1]
    gap = ALGEBRA.read("k - beta")
    unstated = "k - beta" not in HYPOTHESES and any(value in (gap, -gap) for value, _ in factors)
    return False if unstated and is_triangular() else None


def unique_by_rank() -> bool | None:
    """For polynomials of degree 5: regular at five β that are no integers, singular at β = 1, ..., 5.

    False where that is so and no hypothesis excludes these integers; None where a rank is another one.
    """
    alpha_1 = fmpq(-3, 7)
    others = (fmpq(1, 2), fmpq(3, 2), fmpq(7, 3), fmpq(22, 5), fmpq(41, 8))
    at_others = all(rank_defect(5, alpha_1, beta * alpha_1) == 0 for beta in others)
    at_integers = all(rank_defect(5, alpha_1, beta * alpha_1) == 1 for beta in range(1, 6))
    if not (at_others and at_integers):
        return None
    return "k - beta" in HYPOTHESES


def orders_by_dependence() -> bool | None:
    """Whether, for every M, the stated orders are the first ones that know a term of order M; False: they are later."""
    answers: list[bool | None] = []
    for kind, stated in RESIDUAL_ORDERS.items():
        room = ALGEBRA.read(stated) - ALGEBRA.symbols["M"] - min(KNOWN_BEFORE[kind].values())
        answers.append(True if room.is_zero() else False if rising_signs(room) else None)
    return all_of(answers)


def residual_begins(recursion: Recursion, terms: int) -> int:
    """The first order of specialX to specialL that does not vanish for the sums of the first terms."""
    orders = len(recursion.p)
    rows = explicit.residuals(recursion, terms, orders)
    return next((n for n, row in enumerate(rows) if any(not value.is_zero() for value in row)), orders)


def conditions_begin(recursion: Recursion, terms: int) -> int:
    """The same for conditions pbc to Jbc at s = 0: ξ - ξ* holds p, b, y, v and w, with J = w."""
    orders = len(recursion.p) + max(UNSCALED.values())
    rest = [[fmpq(0)] * orders for _ in range(6)]
    for n in range(terms):
        rest[5][n] += explicit.plain(recursion.p[n])[0]
        for i, row in enumerate(rest[:5]):
            row[n + UNSCALED["xi"]] += explicit.plain(recursion.xi[n][i])[0]
        for name, row in zip("pbyv", rest, strict=False):
            row[n + UNSCALED[name]] -= explicit.plain(getattr(recursion, name)[n])[0]
    return next((n for n in range(orders) if any(row[n] != 0 for row in rest)), orders)


def begins_as_stated(kind: str, begins: Iterable[tuple[int, int]]) -> bool | None:
    """Whether no residual of M terms begins before the stated order, and one begins there; pairs of its first and M."""
    stated = ALGEBRA.read(RESIDUAL_ORDERS[kind])
    room = [first - ALGEBRA.substitute(stated, {"M": ALGEBRA.constant(terms)}) for first, terms in begins]
    if any(not value.is_zero() and rising_signs(-value) for value in room):
        return False
    return True if any(value.is_zero() for value in room) else None


def orders_in_systems() -> bool | None:
    """Whether the residuals in the nonlinear systems begin as stated, for M = 2, 4, 6."""
    tried = [(recursion, terms) for recursion in explicit.recursions() for terms in (2, 4, 6)]
    found = {"equations": residual_begins, "conditions": conditions_begin}
    return all_of(begins_as_stated(kind, [(begin(*run), run[1]) for run in tried]) for kind, begin in found.items())


def _existence() -> Entry:
    found = explicit.recursions()
    return SECTION.settled(
        "5-theorem-1",
        "th:1",
        r"\exists!\ \xi_n,p_n,b_n,y_n,v_n,z_n,\lambda_n\text{ polynomials in }s",
        "For functions of ξ that are smooth near ξ*, α_1*, α_3* < 0, β not an integer and a regular Jacobian of "
        "(P, B, Y, V, J) at ξ* the equations and conditions have exactly one expansion in polynomials of s",
        Page("expansion", (dependence, is_triangular)).carries(
            Rung.EXACT.check(
                "sections 2 and 3, induction over n: the terms of functions are known, the operator of b_n is "
                "triangular, and every divisor is a product of factors that a hypothesis keeps from 0 (with entries "
                "5-orders, 5-third-order, 5-monomial, 5-step-3, 5-lemma-orders)",
                determined(),
                "" if determined() else "at β = k the operator of b_n has 0 on its diagonal: not one solution",
            )
        ),
        Rung.POINTS.check(
            "eqs. specialBn to specialLn without elimination, degree 5: regular at five β, singular at β = 1, ..., 5",
            unique_by_rank(),
            "" if unique_by_rank() else "at β = 1, ..., 5 a polynomial can be added to b_n",
        ),
        Rung.POINTS.check(
            f"existence in {len(found)} nonlinear systems, all orders below {len(found[0].p)}: eqs. specialX to "
            "specialL and the conditions of eqs. pbc to Jbc, by ordinary polynomials",
            all_of((explicit.equations_hold(r) and explicit.synchronised(r)) or None for r in found),
        ),
        note="Unique among polynomials: the paper's argument is that th:3 leaves no other smooth solution. For an "
        "integer β > 0 the polynomial Θ(κ s, β), of degree β, can be added to b_n wherever there is a b_n; it is in "
        "the space of Theorem 1 where that has s^β. Of the signs it is used that α_1* and α_3* are not 0. The paper "
        "says of x and y (lines 434, 447) that they are smooth, and of f in Lemma 2.",
    )


def _orders() -> Entry:
    return SECTION.settled(
        "5-theorem-1-orders",
        "th:1, the orders of the residuals",
        r"O(\delta^M),\quad O(\delta^{M+2})",
        "Under the hypotheses of 5-theorem-1 the sums of the first M terms satisfy specialX to specialL up to O(δ^M), "
        "and eqs. pbc to Jbc up to O(δ^(M+2))",
        Page("expansion", (dependence,)).carries(
            Rung.EXACT.check(
                "section 3, orders: for all but eq. pbc the orders below know terms of orders below M only, the "
                "stated ones know the term of order M, for every M; eq. pbc has p~ without δ²: the sums leave "
                "nothing of it, as each p_n(0) is 0; a constant: proofs/residual.md",
                orders_by_dependence(),
            )
        ),
        Rung.POINTS.check(
            "three nonlinear systems, M = 2, 4, 6: no residual of specialX to specialL begins before δ^M, none of "
            "eqs. pbc to Jbc before δ^(M+2), and some begin there",
            orders_in_systems(),
        ),
        note="O is uniform for s in bounded sets. The conditions of orders 0 and 1 hold as ξ* is a G-spot.",
    )


ENTRIES: Builders = {"5-theorem-1": _existence, "5-theorem-1-orders": _orders}
"""The theorem, except its spaces."""
