"""The plain alternative for a sign on a box: wide balls (tau, beta) through FLINT's 1F2, bisected until settled.

dTheta/dtau = -beta Theta(tau, beta - 1), Theta as in :mod:`gspot_verified.cost.times.baseline`, in ball arithmetic.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from functools import lru_cache
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.cost.times.baseline import LOWER
from gspot_verified.numbers.balls import approximate, sign_of, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import ByName, Written
from gspot_verified.theta_function.gamma.initial_values import paper_initial_values

_BITS = 64  # boxes are wide: more bits make hardly an enclosure narrower

Box = tuple[fmpq, fmpq, fmpq, fmpq]
"""tau from, tau to, beta from, beta to."""


class Choice(ByName):
    """Which side of a box is halved."""

    LONGER = "the longer side"
    BETTER = "the side whose halves give the narrower enclosures"


@dataclass(frozen=True, slots=True)
class Bisection(NoTruthValue, Written):
    """How far the bisection of one box came. ``settled`` is the part of the area where dTheta/dtau < 0 was shown."""

    ask: ClassVar[str] = ".finished says whether the whole box was settled"

    box: Box
    choice: Choice
    settled: float
    evaluations: int
    seconds: float
    finished: bool


def bisect(box: Box, choice: Choice, time_limit: float) -> Bisection:
    """Halve boxes until dTheta/dtau < 0 is certain on each, or the time is over. Depth first.

    >>> bisect((fmpq(0), fmpq(1), fmpq(1, 4), fmpq(3, 4)), Choice.BETTER, 60.0).finished
    True
    """
    start = time.perf_counter()
    _initial_values.cache_clear()
    whole, settled, evaluations = _area(box), fmpq(0), 1
    waiting = [(box, slope(box))]
    while waiting and time.perf_counter() - start < time_limit:
        current, value = waiting.pop()
        if sign_of(value) == -1:
            settled += _area(current)
            continue
        pairs = [halves(current, side) for side in _sides(current, choice)]
        values = [[slope(half) for half in pair] for pair in pairs]
        evaluations += 2 * len(pairs)
        best = min(range(len(pairs)), key=lambda i: _width(values[i]))
        waiting += zip(pairs[best], values[best], strict=True)
    seconds = time.perf_counter() - start
    return Bisection(box, choice, approximate(settled / whole), evaluations, seconds, not waiting)


def slope(box: Box) -> arb:
    """dTheta/dtau on the box by three 1F2 of balls; not finite where a ball is too wide for FLINT."""
    left, right, lower, upper = box
    values = _initial_values(lower - 1, upper - 1)
    with working_bits(_BITS):
        tau, b = arb(left).union(arb(right)), arb(lower - 1).union(arb(upper - 1))
        argument, total = tau**3 / 9, arb(0)
        for j in range(3):
            term = argument.hypgeom([(j - b) / 3], [arb(value) for value in LOWER[j]])
            total += values[j] * term * tau**j / (1 + (j > 1))
        return -(b + 1) * total


@lru_cache(maxsize=1 << 14)
def _initial_values(lower: fmpq, upper: fmpq) -> tuple[arb, arb, arb]:
    """t01-t03 on a range of b: many boxes share it."""
    with working_bits(_BITS):
        b = arb(lower).union(arb(upper))
    return paper_initial_values(b, _BITS)


def halves(box: Box, side: int) -> tuple[Box, Box]:
    """The box cut in the middle of tau (``side`` 0) or of beta (1)."""
    left, right, lower, upper = box
    if side == 0:
        middle = (left + right) / 2
        return (left, middle, lower, upper), (middle, right, lower, upper)
    middle = (lower + upper) / 2
    return (left, right, lower, middle), (left, right, middle, upper)


def _sides(box: Box, choice: Choice) -> tuple[int, ...]:
    if choice is Choice.BETTER:
        return (0, 1)
    left, right, lower, upper = box
    return (0,) if right - left >= upper - lower else (1,)


def _width(values: list[arb]) -> float:
    """Of both enclosures together; a ball without bounds is wider than any. (The wider of the two does far worse.)"""
    return sum(float(value.rad()) if value.is_finite() else float("inf") for value in values)


def _area(box: Box) -> fmpq:
    left, right, lower, upper = box
    return (right - left) * (upper - lower)
