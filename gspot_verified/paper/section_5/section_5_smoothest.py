"""Ledger of Section 5: which trajectory of the rigid equations near the G-spot has the smoothest graph b(p).

Gspot1, Gspot2: p' = α_1 p, b' = α_2 p + α_3 b, α_1 = -y < 0, α_3 = β α_1. The number k = m + 1 is the first integer
above β = m + f, m = 0, 1, ... the integer part; f = 1/(1 + x) in (0, 1) for x > 0. d = b - a p.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs

SECTION = Section("Section 5")
ALGEBRA = Algebra("p b a q w j k m x y r E0 E1 E2 K beta alpha1 alpha2 alpha3")
_SYMBOLS = ALGEBRA.symbols
SLIP = {"p": "alpha1*p", "b": "alpha2*p + alpha3*b"}
"""Gspot1 and Gspot2."""
LINE = ("alpha2", "alpha1 - alpha3")
"""a as a quotient: the graph b = a p."""
GRAPH = "a*p + K*w"
"""b(p) with w = p^β; K tells the trajectories with p > 0 apart, as the equation of b(p) is linear of first order."""
LOGARITHMIC = {"q": "-q", "w": "beta*q"}
"""q = 1/p, w = p^β: their derivatives in p over themselves."""
FRACTION = ("1+0*x", "1 + x")
"""f, the fractional part of β, as a quotient."""
FIRST_ABOVE = "m + 1"
"""The k that tells the trajectories apart."""
RATE = "alpha3 - k*alpha1"
"""r of r(k): the k-th derivative of d in p grows along a trajectory like e^(r s)."""


def times_the_denominator(value: fmpq_mpoly) -> fmpq_mpoly:
    """(1 + x) times a value of degree 1 in β, at β = m + f."""
    part, whole = (ALGEBRA.read(text) for text in FRACTION)
    free = ALGEBRA.substitute(value, {"beta": ALGEBRA.constant(0)})
    return free * whole + value.derivative("beta") * (_SYMBOLS["m"] * whole + part)


def graphs_solve() -> bool | None:
    """Whether α_1 p db/dp = α_2 p + α_3 b on b = a p + K p^β, where α_3 = β α_1, up to the factor α_1 - α_3 of a."""
    graph = ALGEBRA.read(GRAPH)
    slope = graph.derivative("p") + graph.derivative("w") * _SYMBOLS["w"] * _SYMBOLS["beta"] * _SYMBOLS["q"]
    # p q = 1: α_1 p db/dp, by the parts with and without w.
    by_p = _SYMBOLS["p"] * slope.derivative("a") * _SYMBOLS["a"]
    by_w = ALGEBRA.coefficient_of(slope, "q", 1)
    rates = {name: ALGEBRA.read(text) for name, text in SLIP.items()}
    left = ALGEBRA.coefficient_of(rates["p"], "p", 1) * (by_p + by_w)
    residual = left - ALGEBRA.substitute(rates["b"], {"b": graph})
    top, bottom = (ALGEBRA.read(text) for text in LINE)
    free = ALGEBRA.substitute(residual, {"a": ALGEBRA.constant(0)})
    cleared = free * bottom + residual.derivative("a") * top
    image = {"alpha3": _SYMBOLS["beta"] * _SYMBOLS["alpha1"]}
    return bool(ALGEBRA.substitute(cleared, image).is_zero())


def next_derivative() -> bool | None:
    """Whether d/dp of p^(β - j) is (β - j) p^(β - j - 1), for every j: the logarithmic derivative of q^j w."""
    found = {name: ALGEBRA.read(text) for name, text in LOGARITHMIC.items()}
    step = _SYMBOLS["j"] * found["q"] + found["w"] - (_SYMBOLS["beta"] - _SYMBOLS["j"]) * _SYMBOLS["q"]
    return bool(step.is_zero())


def factors_do_not_vanish() -> bool | None:
    """Whether β - j > 0 for j = 0, ..., k - 1, with j = k - 1 - i: β - j for every i >= 0 is β - k + 1 + i."""
    last = times_the_denominator(_SYMBOLS["beta"] - ALGEBRA.read(FIRST_ABOVE) + 1)
    return rising_signs(last)


def power_is_unbounded() -> bool | None:
    """Whether the exponent β - k is negative: p^(β - k) is unbounded at p = 0; and β - (k - 1) is positive."""
    exponent = times_the_denominator(_SYMBOLS["beta"] - ALGEBRA.read(FIRST_ABOVE))
    before = times_the_denominator(_SYMBOLS["beta"] - ALGEBRA.read(FIRST_ABOVE) + 1)
    return rising_signs(-exponent) and rising_signs(before)


def deviation_decays() -> bool | None:
    """Whether d = b - a p has d' = r(0) d along the trajectories, up to the factor α_1 - α_3 of a."""
    rates = {name: ALGEBRA.read(text) for name, text in SLIP.items()}
    at_zero = ALGEBRA.substitute(ALGEBRA.read(RATE), {"k": ALGEBRA.constant(0)})
    residual = rates["b"] - _SYMBOLS["a"] * rates["p"] - at_zero * (_SYMBOLS["b"] - _SYMBOLS["a"] * _SYMBOLS["p"])
    top, bottom = (ALGEBRA.read(text) for text in LINE)
    free = ALGEBRA.substitute(residual, {"a": ALGEBRA.constant(0)})
    return bool((free * bottom + residual.derivative("a") * top).is_zero())


def derivatives_obey() -> bool | None:
    """Whether α_1 p E_1 = r E_0 for a function of p gives α_1 p E_2 = (r - α_1) E_1, and r(k + 1) = r(k) - α_1."""
    first = ALGEBRA.read("alpha1*p*E1 - r*E0")
    images = {"p": ALGEBRA.constant(1), "E0": _SYMBOLS["E1"], "E1": _SYMBOLS["E2"]}
    following = ALGEBRA.derivative(first, images) - ALGEBRA.read("alpha1*p*E2 - (r - alpha1)*E1")
    rate = ALGEBRA.read(RATE)
    step = ALGEBRA.substitute(rate, {"k": _SYMBOLS["k"] + 1}) - rate + _SYMBOLS["alpha1"]
    return following.is_zero() and step.is_zero()


def grows_at_the_first_above() -> bool | None:
    """Whether r(k) > 0, so that the k-th derivative grows without bound as s → ∞, and r(j) < 0 for j = 0, ..., k - 1.

    None of these r(j) is 0: where d is not 0 no derivative up to the k-th is.
    """
    images = {"alpha1": -_SYMBOLS["y"], "alpha3": -_SYMBOLS["y"] * _SYMBOLS["beta"]}
    rate = ALGEBRA.substitute(ALGEBRA.read(RATE), images)
    first = ALGEBRA.read(FIRST_ABOVE)
    here, before = (ALGEBRA.substitute(rate, {"k": first - i}) for i in (0, 1))
    return rising_signs(times_the_denominator(here)) and rising_signs(-times_the_denominator(before))


def _smoothest() -> Entry:
    return SECTION.settled(
        "5-smoothest-graph",
        "lines 1469 to 1470",
        r"\text{exactly one graph }b(p)\text{ is }C^{k},\ \beta<k\leq\beta+1",
        "α_1, α_3 < 0, β = α_3/α_1 not an integer: of the trajectories of eqs. Gspot1 and Gspot2 with p > 0 exactly "
        "one has a graph b(p) that is C^k at p = 0 for the integer k between β and β + 1, the line "
        "b = α_2 p/(α_1 - α_3); the graphs of all others are C^(k-1) and not C^k; so it is for p < 0",
        Rung.EXACT.check(
            "b = α_2 p/(α_1 - α_3) + K p^β: the derivative of order k is K times non-zero factors times p^(β-k)",
            all_of([graphs_solve(), next_derivative(), factors_do_not_vanish(), power_is_unbounded()]),
        ),
        Rung.EXACT.check(
            "along a trajectory the derivative of order j of b(p) minus the line grows like e^((α_3 - j α_1) s), "
            "s → ∞ at p = 0: the first rate that is positive is that of j = k, and none before it is 0",
            all_of([deviation_decays(), derivatives_obey(), grows_at_the_first_above()]),
        ),
        note="So it is with C^(β+1) in the sense of Hölder, as the line is analytic. For an integer β >= 2 the powers "
        "p^β are polynomials: every graph is smooth, and the sentence fails; Theorem 1 leaves these β out.",
    )


ENTRIES: Builders = {"5-smoothest-graph": _smoothest}
"""The smoothest graph."""
