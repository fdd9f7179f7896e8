"""Where the slow contact force first falls to 0 on the side C_1/Gamma(-beta) < 0, at one epsilon: a certified bracket.

Proof page: ``proofs/monotone.md``, section 7.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.balls import bits_for_digits, sign_of, working_bits
from gspot_verified.compliant.least_value import MAX_RIGHT, halves, rising_from
from gspot_verified.compliant.profile import Profile
from gspot_verified.compliant.taylor_cell import TaylorCell
from gspot_verified.signs.stretches import Level, narrowed

MAX_CELLS = 2_000
_CELL_DIGITS = 15
_GUARD_BITS = 64
_SPARE_DIGITS = 12
_TRIES = 3


class NotBelow(ValueError):
    """f is certainly above the level at the start already."""


@dataclass(frozen=True, slots=True)
class Crossing:
    """f < level on [start, lower], and f reaches the level in (lower, upper), where it increases."""

    lower: fmpq
    upper: fmpq


def first_crossing(profile: Profile, start: fmpq, level: Level, digits: int) -> Crossing | None:
    """The first point of [start, infinity) at which f is the level (> 0 or < 0), to ``digits`` decimals.

    None when balls cannot tell, which is so next to a greatest value that nearly is the level.

    :raises NotBelow: f is above the level at the start.
    """
    beyond = _beyond(profile, level, digits)
    if beyond(start) is not False:
        if beyond(start):
            raise NotBelow
        return None
    right = rising_from(profile, start, _CELL_DIGITS)
    if right is None:
        return None
    with working_bits(bits_for_digits(_CELL_DIGITS) + _GUARD_BITS):
        bound = level(_CELL_DIGITS)
        waiting = [(start, right)] if right > start else []
        examined = 0
        while waiting:
            cell = TaylorCell(profile, *waiting.pop(), _CELL_DIGITS)
            examined += 1
            if cell.greatest < bound:
                continue
            if cell.rising:
                answer = beyond(cell.upper)
                if answer:
                    return Crossing(*narrowed(beyond, cell.lower, cell.upper, digits))
                if answer is False:
                    continue
            if examined >= MAX_CELLS:
                return None
            waiting += reversed(halves(cell.lower, cell.upper))
    step = fmpq(1)
    while right + step < MAX_RIGHT:
        if beyond(right + step):
            return Crossing(*narrowed(beyond, right, right + step, digits))
        step *= 2
    return None


def _beyond(profile: Profile, level: Level, digits: int) -> Callable[[fmpq], bool | None]:
    """Whether f is above the level at a point, certainly, with a few rising accuracies."""

    def beyond(tau: fmpq) -> bool | None:
        for attempt in range(_TRIES):
            accuracy = (digits + _SPARE_DIGITS) * 2**attempt
            value, bound = profile.value(tau, accuracy), level(accuracy)
            with working_bits(bits_for_digits(accuracy) + _GUARD_BITS):
                sign = sign_of(value - bound)
            if sign:
                return sign > 0
        return None

    return beyond
