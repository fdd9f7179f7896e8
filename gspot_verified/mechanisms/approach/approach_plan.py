"""How far a run of slip goes on towards a G-spot before its numbers are read off: heuristics, any answer is correct."""

from __future__ import annotations

from gspot_verified.mechanisms.approach.capture import Capture
from gspot_verified.numbers.balls import approximate


def exponent_for(neighbourhood: Capture, bits: int) -> float:
    """How many bits p is to lose before C_1 is read off."""
    beta = approximate(neighbourhood.numbers.alpha_3) / approximate(neighbourhood.numbers.alpha_1)
    if beta <= 1:
        return min(bits - 35.0, 48 / max(min(beta, 1 - beta), 0.01))
    return max(6.0, min(46.0, (bits - 64) / beta))


def last_exponent_for(neighbourhood: Capture, exponent: float, bits: int, dimension: int) -> float:
    """The same for the place of the G-spot, where it is not isolated and so known only by going there."""
    if dimension == 4:
        return exponent
    beta = max(approximate(neighbourhood.numbers.alpha_3) / approximate(neighbourhood.numbers.alpha_1), 1.0)
    return min(bits - 45.0, exponent * beta + bits / 5)
