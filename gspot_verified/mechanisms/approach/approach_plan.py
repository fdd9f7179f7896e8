"""How far a run of slip goes on towards a G-spot before its numbers are read off: heuristics, any answer is correct."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from gspot_verified.mechanisms.approach.capture import Capture
from gspot_verified.numbers.balls import approximate

_NEAR = 32  # p is to be so much smaller than where power series end; up to twice as large the first state is taken


def exponent_for(neighbourhood: Capture, bits: int) -> float:
    """How many bits p is to lose before C_1 is read off."""
    beta = approximate(neighbourhood.numbers.alpha_3) / approximate(neighbourhood.numbers.alpha_1)
    if beta <= 1:
        return min(bits - 35.0, 48 / max(min(beta, 1 - beta), 0.01))
    # From 14 bits on a quotient's disc in p is small enough, where the precision allows it.
    return max(6.0, min(46.0, (bits - 64) / beta), min(14.0, (bits - 24) / beta))


def last_exponent_for(neighbourhood: Capture, exponent: float, bits: int, dimension: int) -> float:
    """The same for the place of the G-spot, where it is not isolated and so known only by going there."""
    if dimension == 4:
        return exponent
    beta = max(approximate(neighbourhood.numbers.alpha_3) / approximate(neighbourhood.numbers.alpha_1), 1.0)
    return min(bits - 45.0, exponent * beta + bits / 5)


def state_to_start_from(sizes: Sequence[arb], radius: float) -> int:
    """Which state of a path is to be the start of a compliant motion, ``sizes`` being p and ``radius`` where the power
    series in p end."""
    goal, known = radius / _NEAR, [approximate(value) for value in sizes]
    if known[0] <= 2 * goal:
        return 0
    return next((i for i, size in enumerate(known) if size <= goal), len(known) - 1)
