"""The least value of the slow contact force on a half-line at one epsilon, by branch and bound with Taylor polynomials.

Proof page: ``proofs/monotone.md``, section 5.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from math import factorial

from flint import arb, fmpq

from gspot_verified.balls import approximate, bits_for_digits, working_bits
from gspot_verified.compliant.profile import Profile

MAX_CELLS = 2_000
MAX_RIGHT = fmpq(10**4)
_GUARD_BITS = 64
_SPARE_DIGITS = 4


@dataclass(frozen=True, slots=True)
class LeastValue:
    """``lower`` <= f(tau) for every tau >= start, and f(``place``) <= ``upper``, place >= start. Exact balls."""

    lower: arb
    upper: arb
    place: fmpq


@dataclass(frozen=True, slots=True)
class _Cell:
    lower: fmpq
    upper: fmpq
    least: arb
    centre: arb

    @property
    def middle(self) -> fmpq:
        return (self.lower + self.upper) / 2


def least_value(profile: Profile, start: fmpq, digits: int = 8) -> LeastValue | None:
    """The least value of f on [start, infinity), to the relative accuracy 10^-digits unless it is nearly 0 or
    :data:`MAX_CELLS` cells do not suffice; None when no point was found beyond which f certainly increases.

    >>> found = least_value(Profile.at_root(fmpq(5, 2), fmpq(1, 2)), fmpq(-10))
    >>> bool(found.upper - found.lower < fmpq(1, 10**7)), bool(found.upper < 0)
    (True, True)
    """
    accuracy = digits + _SPARE_DIGITS
    right = rising_from(profile, start, accuracy)
    if right is None:
        return None
    with working_bits(bits_for_digits(accuracy) + _GUARD_BITS):
        end = profile.value(right, accuracy)
        lower, upper, place = end.lower(), end.upper(), right
        if right == start:
            return LeastValue(lower, upper, place)
        settled = lower  # a lower bound of f beyond ``right`` and on the cells that are done
        waiting: list[tuple[float, int, _Cell]] = []
        number = 0

        def add(left: fmpq, wide: fmpq) -> None:
            nonlocal upper, place, settled, number
            cell = _cell(profile, left, left + wide, accuracy)
            if cell.centre.upper() < upper:
                upper, place = cell.centre.upper(), cell.middle
            number += 1
            heapq.heappush(waiting, (approximate(cell.least.lower()), number, cell))

        add(start, right - start)
        first = profile.value(start, accuracy)
        if first.upper() < upper:
            upper, place = first.upper(), start
        goal = arb(10) ** -digits
        while waiting and number < MAX_CELLS:
            cell = heapq.heappop(waiting)[2]
            if cell.least.is_finite() and cell.least >= upper - goal * abs(upper):
                settled = settled.min(cell.least.lower())
                continue
            half = (cell.upper - cell.lower) / 2
            add(cell.lower, half)
            add(cell.lower + half, half)
        for _, _, cell in waiting:
            settled = settled.min(cell.least.lower())
        return LeastValue(settled.lower(), upper, place)


def rising_from(profile: Profile, start: fmpq, digits: int) -> fmpq | None:
    """A point >= start at which f', ..., f^(n) are certainly > 0, so that f increases from there on."""
    step = fmpq(1)
    point = start
    while point <= max(MAX_RIGHT, start):
        slopes = profile.derivatives(point, range(1, profile.order + 1), digits)
        if all(slope > 0 for slope in slopes):
            return point
        point += step
        if point > 8:
            step *= 2
    return None


def _cell(profile: Profile, lower: fmpq, upper: fmpq, digits: int) -> _Cell:
    """A lower bound of f on [lower, upper] from its derivatives at the middle (proofs/monotone.md, section 5)."""
    n = profile.order
    half = arb((upper - lower) / 2)
    slopes = profile.derivatives((lower + upper) / 2, range(n + 1), digits)
    taylor = [slope / factorial(k) for k, slope in enumerate(slopes)]
    centre = taylor[0]
    bound = _parabola(taylor[:n], half)
    for k in range(3, n):
        bound -= abs(taylor[k]) * half**k
    if n % 2:
        bound -= taylor[n] * half**n
    increase = taylor[1] - sum((k * abs(taylor[k]) * half ** (k - 1) for k in range(2, n)), arb(0)) if n > 1 else arb(1)
    if n > 1 and n % 2 == 0:
        increase -= n * taylor[n] * half ** (n - 1)
    if increase > 0:
        bound = _larger(bound, profile.value(lower, digits))
    return _Cell(lower, upper, bound, centre)


def _parabola(taylor: list[arb], half: arb) -> arb:
    """A lower bound of a_0 + a_1 t + a_2 t^2, |t| <= half; terms that are missing count as 0."""
    padded = [*taylor, arb(0), arb(0), arb(0)][:3]
    at_ends = padded[0] - abs(padded[1]) * half + padded[2].min(arb(0)) * half * half
    if padded[2] > 0:
        return _larger(at_ends, padded[0] - padded[1] * padded[1] / (4 * padded[2]))
    return at_ends


def _larger(left: arb, right: arb) -> arb:
    """The larger one of two lower bounds, whichever is finite."""
    if not right.is_finite():
        return left
    return left.lower().max(right.lower()) if left.is_finite() else right
