"""Where the slow contact force first falls to 0 on the side C_1/Gamma(-beta) < 0, at one epsilon: a certified bracket.

Proof page: ``proofs/monotone.md``, section 7.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.contact.least_value import MAX_RIGHT, halves, rising_from
from gspot_verified.compliant.contact.taylor_cell import TaylorCell
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.stretches import Level, narrowed
from gspot_verified.numbers.balls import bits_for_digits, nonfinite, sign_of, working_bits
from gspot_verified.numbers.evidence import Ends, at_most, cover, every, less
from gspot_verified.numbers.verdict import Evidence

MAX_CELLS = 2_000  # against endless work; then None
_CELL_DIGITS = 15  # of f on whole cells: one that stays open is halved
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right
_SPARE_DIGITS = 12  # of f near its zero, where the difference loses them; any number is right
_TRIES = 3  # each with twice the digits; then the sign stays open


class NotBelow(ValueError):
    """f is certainly above the level at the start already, as ``evidence`` shows."""

    def __init__(self, evidence: Evidence) -> None:
        super().__init__(str(evidence))
        self.evidence = evidence


@dataclass(frozen=True, slots=True)
class LevelReached:
    """f < level on [start, lower], and f reaches the level in (lower, upper), where it increases; and what shows it."""

    lower: fmpq
    upper: fmpq
    evidence: Evidence


def first_crossing(profile: Profile, start: fmpq, level: Level, digits: int) -> LevelReached | None:
    """The first point of [start, infinity) at which f is the level (> 0 or < 0), to ``digits`` decimals.

    None when balls cannot tell, which is so next to a greatest value that nearly is the level.

    :raises NotBelow: f is above the level at the start.
    """
    excess = _excess(profile, level, digits)
    beyond = _beyond(excess)
    at_start = excess(start)
    if (above := less(0, at_start)) is not None:
        raise NotBelow(above)
    rising_tail = rising_from(profile, start, _CELL_DIGITS)
    if rising_tail is None:
        return None
    right, rises = rising_tail
    parts: list[Ends] = [(start, start)]
    shown = [less(at_start, 0)]

    def crossing(first: fmpq, last: fmpq, rising: Evidence) -> LevelReached | None:
        """Between two points between which f rises, the parts before the first one being settled."""
        lower, upper = narrowed(beyond, first, last, digits)
        before = cover([*parts, (first, lower)], (start, lower))
        ends = [less(excess(lower), 0), less(0, excess(upper)), at_most(upper, last)]
        evidence = every([*shown, before, rising, *ends])
        return None if evidence is None else LevelReached(lower, upper, evidence)

    with working_bits(bits_for_digits(_CELL_DIGITS) + _GUARD_BITS):
        bound = level(_CELL_DIGITS)
        waiting = [(start, right)] if right > start else []
        examined = 0
        while waiting:
            cell = TaylorCell(profile, *waiting.pop(), _CELL_DIGITS)
            examined += 1
            settled = less(cell.greatest, bound)
            if settled is None and cell.rising is not None:
                if beyond(cell.upper):
                    return crossing(cell.lower, cell.upper, cell.rising)
                settled = every([cell.rising, less(excess(cell.upper), 0)])
            if settled is not None:
                parts.append((cell.lower, cell.upper))
                shown.append(settled)
                continue
            if examined >= MAX_CELLS:
                return None
            waiting += reversed(halves(cell.lower, cell.upper))
    step = fmpq(1)
    while right + step < MAX_RIGHT:
        if beyond(right + step):
            return crossing(right, right + step, rises)
        step *= 2
    return None


def _excess(profile: Profile, level: Level, digits: int) -> Callable[[fmpq], arb]:
    """f - level at a point, with a few rising accuracies until its sign is certain."""

    def excess(tau: fmpq) -> arb:
        difference = nonfinite()
        for attempt in range(_TRIES):
            accuracy = (digits + _SPARE_DIGITS) * 2**attempt
            value, bound = profile.value(tau, accuracy), level(accuracy)
            with working_bits(bits_for_digits(accuracy) + _GUARD_BITS):
                difference = value - bound
            if sign_of(difference):
                break
        return difference

    return excess


def _beyond(excess: Callable[[fmpq], arb]) -> Callable[[fmpq], bool | None]:
    """Whether f is above the level at a point, certainly."""

    def beyond(tau: fmpq) -> bool | None:
        sign = sign_of(excess(tau))
        return sign > 0 if sign else None

    return beyond
