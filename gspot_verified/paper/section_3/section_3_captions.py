"""Ledger of Section 3: the captions of the simulations held against the text, and the Cases of their panels."""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.formulas import mended
from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.checks.words import Place, said
from gspot_verified.paper.section_3 import section_3_sentences

SECTION = Section("Section 3")
ALGEBRA = Algebra("p b y v z lam alpha1 alpha2 alpha3")
BETAS = {"a": fmpq(1, 2), "b": fmpq(3, 2), "c": fmpq(5, 2)}
ALPHA_1, ALPHA_2, FIRST_P = fmpq(-1), fmpq(-1), fmpq(1, 2)
NU = (fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(2), fmpq(4))
"""The caption of fig. varsim1: α_3 = -β, p(0) = 1/2."""
SHOWN = "lines 734 to 737 and 766 to 767"
CAPTION = Place("caption", r"In (each) plot, a dot-dashed \(green online\) line depicts the trivial solution")
PANEL_A = Place("panel (a)", r"The trivial solution in this case is unphysical \(.*?\) and is (not) shown")
DRAWN = {"printed": "abc", "corrected": "bc"}
"""The panels with the trivial solution."""
EQUATIONS = {
    "modelsys1": ("p", "alpha1"), "modelsys2": ("b", "alpha2 - alpha3*lam"), "modelsys3": ("y", "v"),
    "modelsys4": ("v", "b + p*lam"), "modelsys5": ("z", "-z - lam"),
}  # fmt: skip
"""Whose rate an equation has (that of z times ε, ε² λ_N as λ_N), and the rate."""
FORCE = "z - y"
"""ε² λ_N of compl2."""
LAST = {"printed": "modelsys4", "corrected": "modelsys5"}
"""The last equation that the captions name."""
STARTS = ("p", "b", "y", "v", "z")
"""The initial values that the caption gives."""
CASES = {"a": "I", "b": "III", "c": "III"}


def shown(form: str) -> bool | None:
    """Whether panel (a) is among the panels with the trivial solution exactly when the text does not deny it."""
    each, denied = said(SHOWN, CAPTION), said(SHOWN, PANEL_A)
    if each != "each" or denied != "not":
        return None
    return "a" not in DRAWN[form]


def first_b(panel: str, nu: fmpq) -> fmpq:
    """b(0) of a run: -|ν p(0) α_2/(α_3 - α_1)|."""
    return -abs(nu * FIRST_P * ALPHA_2 / (-BETAS[panel] - ALPHA_1))


def trivial_is_a_run(panel: str) -> bool:
    """Whether one of the five starts lies on b = α_2/(α_1 - α_3) p."""
    slope = ALPHA_2 / (ALPHA_1 + BETAS[panel])
    return any(first_b(panel, nu) == slope * FIRST_P for nu in NU)


def among_the_runs(form: str) -> bool | None:
    """Whether the panels with the trivial solution are those where it is one of the runs."""
    return {panel for panel in BETAS if trivial_is_a_run(panel)} == set(DRAWN[form])


def _trivial_shown() -> Entry:
    forms = ("printed", "corrected")
    return SECTION.settled(
        "3-trivial-shown",
        SHOWN,
        r"\text{In each plot, a dot-dashed line depicts the trivial solution}",
        "By the text, and by the five starts of the caption, each of the panels (a), (b), (c) of Figure 6 has the "
        "trivial solution as a dot-dashed line",
        Rung.EXACT.check(
            "the text on panel (a)",
            mended(*map(shown, forms)),
            "it is unphysical there, and is not shown (lines 766 to 767)",
        ),
        Rung.EXACT.check(
            "the five starts of each panel: which one has b(0) = α_2/(α_1 - α_3) p(0)",
            mended(*map(among_the_runs, forms)),
            f"panel (a): none, as all b(0) < 0 and the trivial solution has b(0) = {-ALPHA_2 * FIRST_P / fmpq(1, 2)}; "
            "panels (b) and (c): ν = 1",
        ),
        corrected="In panels (b) and (c) a dot-dashed line depicts the trivial solution",
    )


def is_closed(last: str) -> bool | None:
    """Whether the named equations have the rate of every variable that they contain."""
    named = list(EQUATIONS)[: list(EQUATIONS).index(last) + 1]
    rates = {EQUATIONS[name][0] for name in named}
    images = {"lam": ALGEBRA.read(FORCE)}
    found: list[fmpq_mpoly] = [ALGEBRA.substitute(ALGEBRA.read(EQUATIONS[name][1]), images) for name in named]
    used = {name for name in ("p", "b", "y", "v", "z") if any(not value.derivative(name).is_zero() for value in found)}
    return used <= rates


def has_all_starts(last: str) -> bool | None:
    """Whether they have the rates of the variables whose initial values the caption gives."""
    named = list(EQUATIONS)[: list(EQUATIONS).index(last) + 1]
    return {EQUATIONS[name][0] for name in named} == set(STARTS)


def _equations() -> Entry:
    lasts = (LAST["printed"], LAST["corrected"])
    return SECTION.settled(
        "3-caption-equations",
        "lines 728 to 733 and 822 to 825",
        r"\text{numerical simulation of eqs. (22) to (25)}",
        "Figures 6 and 7 are simulations of eqs. modelsys1 to modelsys4",
        Rung.EXACT.check(
            "the variables in these equations, with λ_N of eq. compl2",
            mended(*map(is_closed, lasts)),
            "λ_N depends on z, and no equation among them says how z moves",
        ),
        Rung.EXACT.check(
            "the initial values of the caption",
            mended(*map(has_all_starts, lasts)),
            "five are given, z(0) among them; the equations have four rates",
        ),
        corrected="modelsys1 to modelsys5, with compl2",
    )


def is_in_case(panel: str) -> bool | None:
    """Whether the α's have the signs of the Case."""
    third = -BETAS[panel]
    return {
        "I": ALPHA_2 < 0 and ALPHA_1 < third < 0,
        "II": ALPHA_2 > 0 and ALPHA_1 < third < 0,
        "III": ALPHA_2 < 0 and third < ALPHA_1 < 0,
    }[CASES[panel]]


def force_is_that_of_the_case(panel: str) -> bool | None:
    """Whether λ_N = α_2/(α_3 - α_1) of the trivial solution is negative in Case I, positive in Cases II and III.

    For α_1, α_3 < 0; α_2 < 0 leaves Cases I and III, which this sign tells apart.
    """
    force = ALPHA_2 / (-BETAS[panel] - ALPHA_1)
    negative = max(ALPHA_1, ALPHA_2, -BETAS[panel]) < 0
    return negative and (force < 0) == (CASES[panel] == "I") and CASES[panel] != "II"


def _panels() -> Entry:
    named = ", ".join(f"({panel}) Case {case}" for panel, case in CASES.items())
    return SECTION.settled(
        "3-panels",
        "lines 762 to 763 and 772 to 774",
        r"\text{panel (a): Case I; panels (b), (c): Case III}",
        f"The α's of the caption of Figure 6 are in these Cases: {named}",
        Rung.EXACT.check("the signs and the order of α_1, α_2, α_3", all_of(is_in_case(panel) for panel in BETAS)),
        Rung.EXACT.check(
            "the sign of λ_N on the trivial solution, α_2/(α_3 - α_1), all three α's negative",
            all_of(force_is_that_of_the_case(panel) for panel in BETAS),
        ),
    )


def rate_in_flight() -> bool | None:
    """Whether modelsys2 is b' = α_2 and modelsys4 v' = b where λ_N = 0."""
    none = {"lam": ALGEBRA.constant(0)}
    rates = {name: ALGEBRA.substitute(ALGEBRA.read(EQUATIONS[name][1]), none) for name in ("modelsys2", "modelsys4")}
    wanted = {"modelsys2": "alpha2", "modelsys4": "b"}
    return all((value - ALGEBRA.read(wanted[name])).is_zero() for name, value in rates.items())


def flight_has_these_rates() -> bool | None:
    """Whether the flight of 3-flight-ends, u after lift-off, has b' = α_2 and v' = b at its begin and later."""
    algebra, read = section_3_sentences.ALGEBRA, section_3_sentences.ALGEBRA.read
    b, v = (read(section_3_sentences.FLIGHT[name]) for name in "bv")
    return (b.derivative("u") - algebra.symbols["alpha2"]).is_zero() and (v.derivative("u") - b).is_zero()


def _after_contact() -> Entry:
    return SECTION.settled(
        "3-after-contact",
        "lines 911 to 912",
        r"\text{after lift-off }\lambda_N=0,\ \dot b=\alpha_2^*",
        "Without contact the force λ_N is 0 (compl2), and so db/dt is α_2* and dv/dt is b",
        Rung.EXACT.check("modelsys2 and modelsys4 with λ_N = 0", rate_in_flight()),
        Rung.EXACT.check("the flight of 3-flight-ends, derived", flight_has_these_rates()),
    )


ENTRIES: Builders = {
    "3-trivial-shown": _trivial_shown,
    "3-caption-equations": _equations,
    "3-panels": _panels,
    "3-after-contact": _after_contact,
}
"""The captions and the panels."""
