"""How (0, delta_0] is divided into ranges, each followed by itself. Heuristic: any ranges that cover it are correct."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from flint import fmpq

T = TypeVar("T")
_FIRST = tuple(fmpq(1, 8 * 4**k) for k in range(7))  # up to which all delta are followed at once: the first that does
_FACTORS = (fmpq(2), fmpq(5, 4), fmpq(11, 10), fmpq(31, 30))  # from one end to the next, as far as each one goes
_FINENESS = 4  # ends other than delta_0 are 4 over a whole number


def in_ranges(follow: Callable[[fmpq, fmpq], T | str], top: fmpq) -> tuple[list[T], str]:
    """What ``follow`` found for ranges from 0 upwards, and by what the next one failed; "" if they reach ``top``.

    Without a first range: by what (0, ``smallest(top)``] failed.
    """
    failed = ""
    for delta in _tried(top):
        first = follow(fmpq(0), delta)
        if not isinstance(first, str):
            return _upwards(follow, first, delta, top)
        failed = first
    return [], failed


def smallest(top: fmpq) -> fmpq:
    """The smallest delta that is tried before ``top`` is given up."""
    return _tried(top)[-1]


def _tried(top: fmpq) -> list[fmpq]:
    """Not multiples of ``top``: the ranges below a larger delta are those below a smaller one."""
    return [top, *(delta for delta in _FIRST if delta < top)]


def _upwards(follow: Callable[[fmpq, fmpq], T | str], first: T, delta: fmpq, top: fmpq) -> tuple[list[T], str]:
    found, failed = [first], ""
    for factor in _FACTORS:
        while delta < top:
            count = (_FINENESS / (delta * factor)).floor()
            larger = fmpq(_FINENESS, count) if top * count > _FINENESS else top
            more = follow(delta, larger)
            if isinstance(more, str):
                failed = more
                break
            found.append(more)
            delta = larger
    return found, failed if delta < top else ""
