"""How fast dΘ/dτ grows as τ → +∞, without its saddle point: the mean of r under its integrand grows like sqrt(τ).

Transcribes the steps of the second proof in the last section of proofs/signs.md. M is the integral of
r^(a-1) e^(rτ - r³/3), 0 < a < 1; M0, M1, M2 are M, M', M'', and I is 1/M. q = M'/M, s = M''/M.
"""

from __future__ import annotations

from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.checks.page import Page

ALGEBRA = Algebra("tau r a q s M0 M1 M2 I")
_SYMBOLS = ALGEBRA.symbols
EXPONENT = "r*tau - r^3/3"
THIRD = "a*M0 + tau*M1"
"""M'''."""
RATES = {"q": "s - q^2", "s": "a + tau*q - s*q"}
"""q' and s'."""
ROOT = "1/2"
"""q ~ τ^ROOT: from some τ on q² lies between τ - E - 1 and τ + D."""


def third_moment_is_known() -> bool:
    """The derivative of r^a e^(rτ - r³/3), over r^(a-1) e^(rτ - r³/3), is a + τ r - r³: the integral of it is 0."""
    slope = _SYMBOLS["a"] + _SYMBOLS["r"] * ALGEBRA.read(EXPONENT).derivative("r")
    moments = ALGEBRA.substitute(ALGEBRA.read(THIRD), {"M0": ALGEBRA.constant(1), "M1": _SYMBOLS["r"]})
    return bool((slope - moments + _SYMBOLS["r"] ** 3).is_zero())


def means_move_so() -> bool:
    """q' and s' from the derivatives of the moments, at a τ where M is scaled to 1: the equation is linear."""
    motion = {"M0": "M1", "M1": "M2", "M2": THIRD, "I": "-I^2*M1", "tau": "1+0*a"}
    images = {name: ALGEBRA.read(text) for name, text in motion.items()}
    one = {"M0": ALGEBRA.constant(1), "I": ALGEBRA.constant(1)}
    found = {
        name: ALGEBRA.substitute(ALGEBRA.derivative(ALGEBRA.read(text), images), one)
        for name, text in (("q", "M1*I"), ("s", "M2*I"))
    }
    means = {"q": _SYMBOLS["M1"], "s": _SYMBOLS["M2"]}
    wanted = {name: ALGEBRA.substitute(ALGEBRA.read(text), means) for name, text in RATES.items()}
    return all((found[name] - wanted[name]).is_zero() for name in RATES)


def distance_moves_so() -> bool:
    """d = s - τ: d' = -q d - (1 - a). So d falls for d >= 0, and rises for d < -(1 - a)/q(0), as q >= q(0) > 0."""
    distance = ALGEBRA.read("s - tau")
    images = {"s": ALGEBRA.read(RATES["s"]), "tau": ALGEBRA.constant(1)}
    return bool((ALGEBRA.derivative(distance, images) + _SYMBOLS["q"] * distance + ALGEBRA.read("1 - a")).is_zero())


GROWS = Page("signs", (third_moment_is_known, means_move_so, distance_moves_so))
"""The page with the steps of its second proof."""
