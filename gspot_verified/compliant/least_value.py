"""The least value of the slow contact force on a half-line at one epsilon, by branch and bound with Taylor polynomials.

Proof page: ``proofs/monotone.md``, section 5.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.balls import approximate, bits_for_digits, working_bits
from gspot_verified.compliant.profile import Profile
from gspot_verified.compliant.taylor_cell import TaylorCell

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
        end, first = profile.value(right, accuracy), profile.value(start, accuracy)
        settled = end.lower()  # a lower bound of f beyond ``right`` and on the cells that are done
        upper, place = (end.upper(), right) if end.upper() < first.upper() else (first.upper(), start)
        waiting: list[tuple[float, int, TaylorCell]] = []
        fresh = [TaylorCell(profile, start, right, accuracy)] if right > start else []
        number = 0
        goal = arb(10) ** -digits
        while True:
            for cell in fresh:
                if cell.taylor[0].upper() < upper:
                    upper, place = cell.taylor[0].upper(), cell.middle
                number += 1
                heapq.heappush(waiting, (approximate(cell.least), number, cell))
            if not waiting:
                break
            cell = heapq.heappop(waiting)[2]
            if number >= MAX_CELLS or cell.least >= upper - goal * abs(upper):
                settled, fresh = settled.min(cell.least), []
            else:
                fresh = [TaylorCell(profile, *ends, accuracy) for ends in halves(cell.lower, cell.upper)]
        return LeastValue(settled.lower(), upper, place)


def halves(lower: fmpq, upper: fmpq) -> tuple[tuple[fmpq, fmpq], tuple[fmpq, fmpq]]:
    """The two halves of an interval."""
    middle = (lower + upper) / 2
    return (lower, middle), (middle, upper)


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
