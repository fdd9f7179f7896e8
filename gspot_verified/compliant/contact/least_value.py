"""The least value of the slow contact force on a half-line at one epsilon, by branch and bound with Taylor polynomials.

Proof page: ``proofs/monotone.md``, section 5.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.contact.taylor_cell import TaylorCell
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.balls import approximate, bits_for_digits, working_bits
from gspot_verified.numbers.evidence import at_most, cover, equal, every, less
from gspot_verified.numbers.verdict import Evidence

MAX_CELLS = 2_000  # against endless work; the enclosure is then wider than asked for
MAX_RIGHT = fmpq(10**4)  # tau up to which a rising f is looked for; then None
_FAR = 8  # |tau| beyond which points for a rising f are looked for in longer and longer steps
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right
_SPARE_DIGITS = 4  # beyond those asked for, on the cells


@dataclass(frozen=True, slots=True)
class LeastValue:
    """``lower`` <= f(tau) for every tau >= start, and f(``place``) <= ``upper``, place >= start. Exact balls.

    ``evidence``: f rises from a point on, and the cells that cover what is before it have the lower bound."""

    lower: arb
    upper: arb
    place: fmpq
    evidence: Evidence | None


def least_value(profile: Profile, start: fmpq, digits: int = 8) -> LeastValue | None:
    """The least value of f on [start, infinity), to the relative accuracy 10^-digits unless it is nearly 0 or
    :data:`MAX_CELLS` cells do not suffice; None when no point was found beyond which f certainly increases.

    >>> least = least_value(Profile.at_root(fmpq(5, 2), fmpq(1, 2)), fmpq(-10))
    >>> bool(least.upper - least.lower < fmpq(1, 10**7)), bool(least.upper < 0)
    (True, True)
    """
    accuracy = digits + _SPARE_DIGITS
    rising_tail = rising_from(profile, start, accuracy)
    if rising_tail is None:
        return None
    right, rises = rising_tail
    with working_bits(bits_for_digits(accuracy) + _GUARD_BITS):
        end, first = profile.value(right, accuracy), profile.value(start, accuracy)
        settled = end.lower()  # a lower bound of f beyond ``right`` and on the cells that are done
        upper, place = (end.upper(), right) if end.upper() < first.upper() else (first.upper(), start)
        waiting: list[tuple[float, int, TaylorCell]] = []
        fresh = [TaylorCell(profile, start, right, accuracy)] if right > start else []
        number = 0
        done: list[TaylorCell] = []
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
                done.append(cell)
            else:
                fresh = [TaylorCell(profile, *ends, accuracy) for ends in halves(cell.lower, cell.upper)]
        least = settled.lower()
        evidence = every([
            rises, cover([(right, None), *((cell.lower, cell.upper) for cell in done)], (start, None)),
            at_most(least, end.lower()), *(at_most(least, cell.least) for cell in done),
        ])  # fmt: skip
        return LeastValue(least, upper, place, evidence)


def halves(lower: fmpq, upper: fmpq) -> tuple[tuple[fmpq, fmpq], tuple[fmpq, fmpq]]:
    """The two halves of an interval."""
    middle = (lower + upper) / 2
    return (lower, middle), (middle, upper)


def rising_from(profile: Profile, start: fmpq, digits: int) -> tuple[fmpq, Evidence] | None:
    """A point >= start at which f', ..., f^(n) are certainly > 0, so that f increases from there on."""
    step = fmpq(1)
    point = start
    while point <= max(MAX_RIGHT, start):
        slopes = profile.derivatives(point, range(1, profile.order + 1), digits)
        rises = every([equal(len(slopes), profile.order), *(less(0, slope) for slope in slopes)])
        if rises is not None:
            return point, rises
        point += step if point > -_FAR else (-point / 4).floor()
        if point > _FAR:
            step *= 2
    return None
