"""Ledger of Section 1: how rigid slip ends with constant α's: it leaves, lifts off, or reaches the G-spot.

Gspot1, Gspot2: p = q e^(α_1 s), q > 0, and b = c p + K e^(α_3 s), c (α_1 - α_3) = α_2, or
b = (K + α_2 q s) e^(α_1 s) for α_1 = α_3. Signs stand for the α's: 1, 0, -1; u, w, m, r are positive.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.section_1.section_1_cases import CASES, RATES, is_stable, reaches

SECTION = Section("Section 1")
ALGEBRA = Algebra("p b c K q s E lam alpha1 alpha2 alpha3 u w m r")
_SYMBOLS = ALGEBRA.symbols
SIGNS = (1, -1)
"""Of α_1 and of α_3: none is 0."""
JORDAN = "(K + alpha2*q*s)*E"
"""b for α_1 = α_3, where E is e^(α_1 s) and p is q E."""
LEAVES, G_SPOT = "leaves", "G-spot"
FOURTH = {"alpha1": "-w", "alpha2": "m", "alpha3": "-u-w"}
"""α_1, α_3 < 0 in none of the Cases I, II, III: α_2 > 0 and α_3 < α_1."""
RESTS = (
    ({"alpha1": -1, "alpha2": -1, "alpha3": 0}, {"p": "q*E", "b": "K + q*E"}),
    ({"alpha1": 0, "alpha2": -1, "alpha3": -1}, {"p": "q + 0*E", "b": "K*E - q"}),
)
"""α_1 α_3 = 0: α's and a motion, with E = e^(-s), that ends at a point other than the G-spot; q is p(0)."""
UNSTABLE = ({"alpha1": 1, "alpha2": 1, "alpha3": 2}, {"p": "-q*E", "b": "(q + K*E)*E"})
"""α's of no Case, and a motion with p < 0 < b, E = e^s: t rises as s and E fall; K >= 0 for b >= -p."""
LINE = {"alpha1": "-w", "alpha3": "u"}
"""Signs with which the states of one line alone go to the G-spot."""


def _rates() -> dict[str, fmpq_mpoly]:
    return {name: ALGEBRA.read(text) for name, text in RATES.items()}


def solutions_are_right() -> bool | None:
    """Whether the line b = c p is invariant, deviations from it grow like e^(α_3 s), and the form for α_1 = α_3 is one.

    p grows like e^(α_1 s).
    """
    rates, p = _rates(), _SYMBOLS["p"]
    on_line = ALGEBRA.substitute(rates["b"], {"b": _SYMBOLS["c"] * p})
    line = _SYMBOLS["c"] * rates["p"] - on_line - p * ALGEBRA.read("c*(alpha1 - alpha3) - alpha2")
    growth = rates["b"].derivative("b") - _SYMBOLS["alpha3"], rates["p"] - _SYMBOLS["alpha1"] * p
    value = ALGEBRA.read(JORDAN)
    slope = ALGEBRA.derivative(value, {"s": ALGEBRA.constant(1), "E": ALGEBRA.read("alpha1*E")})
    equal = {"b": value, "p": ALGEBRA.read("q*E"), "alpha3": _SYMBOLS["alpha1"]}
    jordan = slope - ALGEBRA.substitute(rates["b"], equal)
    return all(found.is_zero() for found in (line, *growth, jordan))


def end_of(first: int, third: int, apart: bool) -> str | None:
    """Where a state goes as s → ∞ for these signs of α_1 and α_3, K not 0 where ``apart``, if it does not lift off.

    ``None``: to a point that is not the G-spot.
    """
    if first > 0 or (apart and third > 0):
        return LEAVES  # p → ∞, or p → 0 and |b| → ∞
    if first < 0 and not (apart and third == 0):
        return G_SPOT
    return None


def ends_by_the_solution() -> bool | None:
    """Whether every state leaves or goes to the G-spot, for all signs of α_1 and α_3."""
    ends = [end_of(first, third, apart) for first, third, apart in product(SIGNS, SIGNS, (True, False))]
    return None if None in ends else solutions_are_right()


def others_end_elsewhere() -> bool | None:
    """Whether both motions of ``RESTS`` solve Gspot1 and Gspot2, for every K, and end at a point with b not 0."""
    answers = []
    for alphas, texts in RESTS:
        motion = {name: ALGEBRA.read(text) for name, text in texts.items()}
        numbers = {name: ALGEBRA.constant(value) for name, value in alphas.items()}
        for name, rate in _rates().items():
            slope = ALGEBRA.derivative(motion[name], {"E": -_SYMBOLS["E"]})
            answers.append((slope - ALGEBRA.substitute(rate, numbers | motion)).is_zero())
        answers.append(not ALGEBRA.substitute(motion["b"], {"E": ALGEBRA.constant(0)}).is_zero())
    return all(answers)


def none_leaves_in_the_cases() -> bool | None:
    """Whether α_1, α_3 < 0 in Cases I, II and III, so that each part of the solution tends to 0."""
    ends = {end_of(-1, -1, apart) for apart in (True, False)}
    return ends == {G_SPOT} and all_of(reaches(images) for images in CASES.values())


def bounded_states_go_to_the_g_spot() -> bool | None:
    """Whether the matrix of the flow has the eigenvalues α_1 and α_3 alone: real, and not 0.

    A linear flow without an eigenvalue on the imaginary axis is hyperbolic: what stays bounded tends to the origin.
    """
    rates = _rates()
    rows = [
        [rates[name].derivative(other) - (_SYMBOLS["lam"] if name == other else 0) for other in "pb"] for name in "pb"
    ]
    polynomial = ALGEBRA.determinant(rows) - ALGEBRA.read("(alpha1 - lam)*(alpha3 - lam)")
    return (polynomial.is_zero() and 0 not in SIGNS) or None


def keeps_the_sign_of_p() -> bool | None:
    """Whether the rate of p is a multiple of p: p = 0 is never reached, and p never changes its sign."""
    rate = _rates()["p"]
    return ALGEBRA.substitute(rate, {"p": ALGEBRA.constant(0)}).is_zero()


def p_is_an_exponential() -> bool | None:
    """Whether p = q E, E = e^(α_1 s), solves Gspot1, with q > 0 positive for every s."""
    value = ALGEBRA.read("q*E")
    slope = ALGEBRA.derivative(value, {"E": ALGEBRA.read("alpha1*E")})
    return (slope - ALGEBRA.substitute(_rates()["p"], {"p": value})).is_zero() and rising_signs(value)


def in_finite_time() -> bool | None:
    """Whether p falls at the constant rate α_1 in t, dt = p ds: p is 0 at the time p(0)/|α_1|, and not before s = ∞."""
    rate = _rates()["p"] - _SYMBOLS["alpha1"] * _SYMBOLS["p"]
    return rate.is_zero() and keeps_the_sign_of_p()


def time_is_an_exponential() -> bool | None:
    """The same from p = q E: t = (q E - q)/α_1 has the derivative p in s, and is 0 at E = 1."""
    value = ALGEBRA.read("q*E - q")  # α_1 t
    slope = ALGEBRA.derivative(value, {"E": ALGEBRA.read("alpha1*E")})
    starts = ALGEBRA.substitute(value, {"E": ALGEBRA.constant(1)})
    return (slope - ALGEBRA.read("alpha1*q*E")).is_zero() and starts.is_zero()


def _outcomes() -> Entry:
    return SECTION.settled(
        "1-three-outcomes",
        "lines 261 to 265",
        r"\text{from slip there are three outcomes: it leaves, it lifts off, it reaches the G-spot}",
        "Rigid slip with constant α's, α_1 α_3 not 0: from p > 0, b < 0, as long as slip is positive, the state "
        "leaves every bounded set with b < 0 < p, or reaches b = 0 with p > 0, or tends to the G-spot, which it does "
        "in a finite time t; in Cases I, II and III it does not leave",
        Rung.EXACT.check(
            "the solutions for α_1 ≠ α_3 and for α_1 = α_3: each part tends to 0 or is unbounded, p > 0 for ever; t; "
            "two solutions for α_1 α_3 = 0",
            all_of(
                [
                    *(ends_by_the_solution(), p_is_an_exponential(), time_is_an_exponential()),
                    *(none_leaves_in_the_cases(), others_end_elsewhere()),
                ]
            ),
        ),
        Rung.EXACT.check(
            "the eigenvalues of the flow are α_1 and α_3: no bounded state but those that tend to the origin; dp/dt is "
            "α_1; in the Cases both are negative, by the trace and the determinant",
            all_of([bounded_states_go_to_the_g_spot(), in_finite_time(), *map(is_stable, CASES)]),
        ),
        note="For α_1 α_3 = 0 there can be a fourth outcome: with α = (-1, -1, 0) p tends to 0 and b to b(0) - p(0); "
        "with α = (0, -1, -1) p is constant and b tends to -p. At b = 0 db/ds is α_2 p; where b has risen to 0, α_2 "
        "> 0, so that b becomes positive while p > 0, and no force keeps contact: lift-off.",
    )


def _rescaled_time() -> Entry:
    return SECTION.settled(
        "1-rescaled-time",
        "lines 1000 to 1003",
        r"\text{the system can only be defined for }p>0",
        "With constant α's, in the time of eq. time_rescale a state with p > 0 has p > 0 for ever: the rescaled "
        "system says nothing beyond the G-spot; its formulas are defined for p < 0 too, where that time runs "
        "backwards",
        Rung.EXACT.check("Gspot1: the rate of p is a multiple of p, a polynomial", keeps_the_sign_of_p()),
        Rung.EXACT.check("p = p(0) e^(α_1 s) for every p(0): it has the sign of p(0)", p_is_an_exponential()),
    )


def fourth_lifts_off() -> bool | None:
    """Whether r = λ_N = -b/p falls at a rate below -m for every r > 0: b = 0 is reached at a finite s, with p > 0."""
    images = {name: ALGEBRA.read(text) for name, text in FOURTH.items()}
    rates, p = _rates(), _SYMBOLS["p"]
    at_force = {"b": -_SYMBOLS["r"] * p}
    slope = ALGEBRA.substitute(-(rates["b"] * p - _SYMBOLS["b"] * rates["p"]), at_force)  # p² dr/ds
    found = ALGEBRA.substitute(slope, images)
    below = -found - _SYMBOLS["m"] * p**2
    return rising_signs(below)


def fourth_goes_above() -> bool | None:
    """Whether the slope c of the line that all states approach is positive there: b > 0 in the end."""
    images = {name: ALGEBRA.read(text) for name, text in FOURTH.items()}
    drift, second = (ALGEBRA.substitute(ALGEBRA.read(text), images) for text in ("alpha1 - alpha3", "alpha2"))
    return rising_signs(drift) and rising_signs(second)


def ordered(images: Mapping[str, str]) -> tuple[bool, int] | None:
    """Whether α_1 < α_3, and the sign of α_2; ``None``: one is open, or α_1 and α_3 are not both negative."""
    first, second, third = (ALGEBRA.read(images[f"alpha{n}"]) for n in (1, 2, 3))
    below, above = rising_signs(third - first), rising_signs(first - third)
    up, down = rising_signs(second), rising_signs(-second)
    if not (rising_signs(-first) and rising_signs(-third) and below != above and up != down):
        return None
    return below, 1 if up else -1


def unstable_slip_reaches_it() -> bool | None:
    """Whether the motion of ``UNSTABLE`` solves Gspot1 and Gspot2, has p < 0 < b, and is at p = b = 0 where E is 0."""
    alphas, texts = UNSTABLE
    motion = {name: ALGEBRA.read(text) for name, text in texts.items()}
    numbers = {name: ALGEBRA.constant(value) for name, value in alphas.items()}
    answers = [rising_signs(-motion["p"]), rising_signs(motion["b"])]
    for name, rate in _rates().items():
        slope = ALGEBRA.derivative(motion[name], {"E": _SYMBOLS["E"]})
        answers.append((slope - ALGEBRA.substitute(rate, numbers | motion)).is_zero())
        answers.append(ALGEBRA.substitute(motion[name], {"E": ALGEBRA.constant(0)}).is_zero())
    return all(answers)


def others_are_cases() -> bool | None:
    """Whether ``FOURTH`` is the one of the four orders and signs with α_1, α_3 < 0 that none of the Cases has."""
    found = [ordered(images) for images in (*CASES.values(), FOURTH)]
    if None in found:
        return None
    ends = [end_of(first, third, True) for first, third in product(SIGNS, SIGNS) if (first, third) != (-1, -1)]
    return len(found) == 4 and set(found) == set(product((True, False), SIGNS)) and ends == [LEAVES] * 3


def one_line_alone() -> bool | None:
    """Whether of the signs not both negative those of ``LINE`` alone lead the line b = c p to the G-spot.

    Whether it is slip there, c = -r < 0, exactly for α_2 = c (α_1 - α_3) > 0.
    """
    ends = [pair for pair in product(SIGNS, SIGNS) if end_of(*pair, False) == G_SPOT and pair != (-1, -1)]
    first, third = (ALGEBRA.read(LINE[name]) for name in ("alpha1", "alpha3"))
    signs = [1 if rising_signs(value) else -1 if rising_signs(-value) else 0 for value in (first, third)]
    return ends == [tuple(signs)] and rising_signs(-_SYMBOLS["r"] * (first - third))


def _attracting() -> Entry:
    return SECTION.settled(
        "1-attracting-signs",
        "lines 269 to 273",
        r"\text{the third possibility can only occur under specific sign combinations: Cases I, II, III}",
        "Rigid slip with constant α's, none of them 0, α_1 ≠ α_3: outside Cases I, II and III no state of slip with "
        "p > 0 reaches the G-spot, but for those of one line (α_1 < 0 < α_3 and α_2 > 0)",
        Rung.EXACT.check(
            "states off the line leave unless α_1, α_3 < 0; there λ_N' < -α_2 in the fourth one: lift-off; the line",
            all_of([solutions_are_right(), others_are_cases(), one_line_alone(), fourth_lifts_off()]),
        ),
        Rung.EXACT.check(
            "the solutions, the list of the other signs and the line as above; the fourth one by another way: the line "
            "that states approach has b > 0; a motion with p < 0 < b",
            all_of(
                [
                    *(solutions_are_right(), others_are_cases(), one_line_alone()),
                    *(fourth_goes_above(), unstable_slip_reaches_it()),
                ]
            ),
        ),
        note="That the three Cases do: 1-case-I, 1-case-II, 1-case-III. From p < 0 < b, where slip is unstable, the "
        "G-spot is reached with other signs too: for α = (1, 1, 2) from every state with b >= -p. Between the Cases "
        "it attracts open sets too: for α_1 = α_3 < 0, α_2 <= 0, and for α_2 = 0, α_1, α_3 < 0.",
    )


ENTRIES: Builders = {
    "1-three-outcomes": _outcomes,
    "1-attracting-signs": _attracting,
    "1-rescaled-time": _rescaled_time,
}
"""How rigid slip ends."""
