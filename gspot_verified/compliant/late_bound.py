"""A bound of the fast solution P_+ after the G-spot, T >= 0, in terms of slow solutions: closed forms, no quadrature.

Proof page: ``proofs/fast_part.md``, section 7.
"""

from __future__ import annotations

import math

from flint import arb, fmpq

from gspot_verified.balls import approximate, ball, nonfinite
from gspot_verified.compliant.grid import scale
from gspot_verified.compliant.slow_solution import slow_value

_DIGITS = 6


def late_bounds(beta: fmpq, epsilon: fmpq, time: fmpq) -> list[arb]:
    """Bounds of |P_+(T)|, T >= 0, with the multipliers of b-hat, lambda-hat, Z-hat, V-hat without 1/(epsilon beta)."""
    if not time >= 0:
        return [nonfinite()] * 4
    radius = _radius(epsilon, time)
    return [_late(beta, epsilon, time, power, factor, radius) for power, factor in _POWERS]


_POWERS = ((0, fmpq(1)), (1, fmpq(1)), (1, fmpq(4, 3)), (2, fmpq(7, 3)))
"""|multiplier| <= factor |r|^power on the path."""


def _radius(epsilon: fmpq, time: fmpq) -> arb:
    """delta <= 1/4, delta <= eta and delta T <= 1 or near: a heuristic."""
    found = scale(epsilon).min(arb(fmpq(1, 4)))
    return (found.min(1 / arb(time)) if time > 0 else found).mid()


def _late(beta: fmpq, epsilon: fmpq, time: fmpq, power: int, factor: fmpq, radius: arb) -> arb:
    """From infinity on arg r = 2 pi/3 to |r| = delta, on the circle to delta, on the axis to +infinity."""
    if not (radius > 0 and radius <= fmpq(1, 4)):
        return nonfinite()
    exponent = power - beta - 1
    small, exact = ball(epsilon), arb(exponent)
    positive, negative = arb(max(exponent, fmpq(0))), arb(min(exponent, fmpq(0)))
    spread = (positive + 1) / 3
    ray = radius**negative * (small * fmpq(10, 3)) ** spread * spread.gamma() / 3
    arc = 2 * arb.pi() / 3 * radius ** (exact + 1) * (fmpq(3, 4) * radius**3 / small + radius * arb(time)).exp()
    steps = max(0, math.ceil(approximate(-exponent)))
    index = -(exponent + steps + 1)
    if not exponent + steps >= 0:
        return nonfinite()
    axis = radius**-steps * arb(-index).gamma() * slow_value(time, index, epsilon, digits=_DIGITS).value
    return (factor * (ray + arc + axis)).abs_upper()
