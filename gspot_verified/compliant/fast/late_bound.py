"""A bound of the fast solution P_+ after the G-spot, T >= 0, in terms of slow solutions: closed forms, no quadrature.

Proof page: ``proofs/fast_part.md``, section 7.
"""

from __future__ import annotations

import math

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import approximate, ball, nonfinite

_DIGITS = 6  # of one part of a bound, of which a few count


_POWERS = {"b": (0, fmpq(1)), "force": (1, fmpq(1)), "Z": (1, fmpq(4, 3)), "V": (2, fmpq(7, 3))}
"""|multiplier| <= factor |r|^power on the path."""


def late_bounds(beta: fmpq, epsilon: fmpq, time: fmpq, names: tuple[str, ...] = tuple(_POWERS)) -> list[arb]:
    """Bounds of |P_+(T)|, T >= 0, with the multipliers of the named hats without 1/(epsilon beta)."""
    if not time >= 0:
        return [nonfinite()] * len(names)
    radius = _radius(epsilon, time)
    return [_late(beta, epsilon, time, *_POWERS[name], radius) for name in names]


def _radius(epsilon: fmpq, time: fmpq) -> arb:
    """delta <= 1/4, of the size of eta, and about half the place of the peak for large T: a heuristic."""
    eta = scale(epsilon)
    tau = approximate(eta * arb(time))
    place = 1.0 if tau < 1 else max(1 / tau, 0.45 * math.sqrt(tau))
    return (eta * place).min(arb(fmpq(1, 4))).mid()


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
