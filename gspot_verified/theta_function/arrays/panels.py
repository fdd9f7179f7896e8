"""Theta at one beta on a cover of [-64, 64] by panels, each with its Taylor series: for many values of tau.

Where the panels lie and how long the series are is a heuristic; each series carries its own bound
(``proofs/local_series.md``).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, approximate, digits_for_bits, working_bits
from gspot_verified.theta_function.sums.local_series import LocalSeries, local_series
from gspot_verified.theta_function.sums.taylor import taylor_derivatives
from gspot_verified.theta_function.value import choice
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.routes import shifted_parameter

FARTHEST = 64
"""Panels cover -FARTHEST <= tau < FARTHEST."""

_NEAR = 8  # |tau| up to which each panel has its own value from the series at 0
_CANCELLATION_PAYS = 24  # -tau up to which the series at 0 is worth its lost digits
_GUARD = 40  # bits that the derivatives and the series lose; any number is right
_LOST_IN_A_CELL = 16  # bits, from the middle of a cell to its panels; any number is right


class Layout(NamedTuple):
    """The number of equal panels in each unit interval [j, j + 1), j = -FARTHEST .. FARTHEST - 1, all powers of two."""

    counts: tuple[int, ...]


@lru_cache(maxsize=64)
def layout(size: int) -> Layout:
    """For |beta| <= ``size``: Theta changes by about e^(1/2) in half of a panel, so that doubles lose nothing."""
    counts = []
    for cell in range(-FARTHEST, FARTHEST):
        turning = size ** (2 / 3)
        rate = 1.0 if cell < -2 * turning - 2 else math.sqrt(max(cell + 1, 0) + turning + 0.5)
        counts.append(1 << max(0, math.ceil(math.log2(rate))))
    return Layout(tuple(counts))


COARSE = Layout((1,) * (2 * FARTHEST))
"""One panel in each unit interval: longer series, fewer of them, for balls at a few thousand points."""


PER_FINE_CELL = 32
"""Panels in each unit interval of ``FINE``."""

FINE = Layout((PER_FINE_CELL,) * (2 * FARTHEST))
"""Short series, more of them, for doubles at many thousands of points; a multiple of every :func:`layout`."""


@lru_cache(maxsize=4_096)
def panel(beta: fmpq, derivative: int, cell: int, number: int, count: int, goal: int) -> LocalSeries:
    """The series of d^k Theta/dtau^k on panel ``number`` of ``count`` in [cell, cell + 1], for ``goal`` bits."""
    half_width = fmpq(1, 2 * count)
    centre = cell + (2 * number + 1) * half_width
    shifted = beta - derivative
    bits = goal + _GUARD
    if count == 1 or abs(centre) <= _NEAR:
        values = _values(centre, shifted, bits)
        factor = shifted_parameter(beta, derivative, bits)[1]
        with working_bits(bits):
            values = (values[0] * factor, values[1] * factor, values[2] * factor)
    else:
        # One value that costs serves the whole unit interval.
        return panel_around(beta, derivative, cell, centre, half_width, goal)
    return local_series(values, centre, half_width, shifted, _length(centre, half_width, shifted, goal), bits)


def panel_around(beta: fmpq, derivative: int, cell: int, centre: fmpq, half_width: fmpq, goal: int) -> LocalSeries:
    """The series around any centre in [cell, cell + 1]; not finite where it lies outside."""
    values = panel(beta, derivative, cell, 0, 1, goal + _LOST_IN_A_CELL).values_at(centre)
    shifted = beta - derivative
    return local_series(values, centre, half_width, shifted, _length(centre, half_width, shifted, goal), goal + _GUARD)


def _values(centre: fmpq, beta: fmpq, bits: int) -> tuple[arb, arb, arb]:
    """Theta, Theta' and Theta'' with about ``bits`` bits."""
    farthest = _NEAR * math.ceil(abs(approximate(centre)) / _NEAR)
    if centre > 0 or farthest <= _CANCELLATION_PAYS:
        # One length for many centres, so that they share their polynomial.
        plan = choice.taylor_plan(math.copysign(farthest, approximate(centre)), approximate(beta), bits)
        return taylor_derivatives(centre, beta, plan.length, plan.bits)
    digits = digits_for_bits(bits)
    values = [evaluate(centre, beta, derivative, digits).value for derivative in range(3)]
    return values[0], values[1], values[2]


def _length(centre: fmpq, half_width: fmpq, beta: fmpq, goal: int) -> int:
    """Coefficients until their terms fall below 2^-goal of the first: the growth of the recurrence, in floats."""
    c, h, b = abs(approximate(centre)), approximate(half_width), abs(approximate(beta))
    bits, k = 0.0, 0
    while bits > -goal - 4 or k < 6:
        step = c * h * h / ((k + 2) * (k + 3))
        other = (k + b) * h**3 / ((k + 1) * (k + 2) * (k + 3))
        bits += 3 * math.log2(max(step**0.5, other ** (1 / 3)))
        k += 3
    return k + 3


def is_tame(beta: Exact) -> bool:
    """Where panels pay: a rational beta of small size and height."""
    return isinstance(beta, fmpq) and abs(beta) <= 100 and beta.height_bits() <= 256
