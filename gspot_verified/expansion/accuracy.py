"""How accurate the coefficients of an expansion in balls are, and the precision raised until that is enough."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import ClassVar, TypeVar

from flint import arb

from gspot_verified.numbers.balls import MAX_WORKING_BITS, bits_for_digits, relative_bits, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

_COMPARED_BITS = 64  # for sizes alone
_LEAST_GAIN = 4  # certain bits that an attempt must win, or it was the last
_ROOM = 32  # bits beyond those that were missing
_MOST_TIMES_FIRST = 16  # the first precision, against endless work; then AccuracyWarning

T = TypeVar("T")


class AccuracyWarning(UserWarning):
    """A result in balls is valid, and wider than was asked."""


@dataclass(frozen=True, slots=True)
class Accuracy(NoTruthValue, Written):
    """What was asked and what was reached.

    ``certain_bits`` is that of the least accurate coefficient, see :func:`certain_bits`. ``attempts`` counts how often
    the expansion was computed.
    """

    ask: ClassVar[str] = ".reached says whether the asked accuracy was reached"
    written: ClassVar[str] = "digits reached certain_bits working_bits"

    digits: int
    certain_bits: int
    working_bits: int
    attempts: int

    @property
    def reached(self) -> bool:
        """Whether every coefficient has the asked accuracy."""
        return self.certain_bits >= bits_for_digits(self.digits)

    def __str__(self) -> str:
        bits = f"the least accurate coefficient has {max(self.certain_bits, 0)} certain bits"
        if self.reached:
            return f"accuracy of {self.digits} digits reached: {bits}"
        return f"ACCURACY NOT REACHED: {self.digits} digits were asked, {bits}"


def certain_bits(orders: Iterable[Sequence[arb]]) -> int:
    """The certain bits of the least accurate coefficient; ``orders`` has the coefficients of each order of delta.

    A coefficient that is certainly not zero counts relative to itself. One whose ball holds zero counts relative to
    the largest coefficient of its order and the orders before: it may be exactly zero.

    >>> from flint import fmpq
    >>> with working_bits(60):
    ...     certain_bits([[arb(1000)], [arb(1, fmpq(1, 1024)), arb(0, fmpq(1, 1024))]])
    9
    """
    worst, scale = MAX_WORKING_BITS, arb(0)
    with working_bits(_COMPARED_BITS):
        for coefficients in orders:
            for value in coefficients:
                if not value.is_finite():
                    return -MAX_WORKING_BITS
                scale = max(scale, value.abs_lower().lower())  # exact numbers: their order is certain
            for value in coefficients:
                holds_zero = value.contains(0) and not value.is_exact()
                worst = min(worst, relative_bits(arb(scale, value.rad()) if holds_zero else value))
    return worst


def until_accurate(
    attempt: Callable[[int], tuple[T, int | None]], digits: int, first_bits: int
) -> tuple[T, Accuracy | None]:
    """``attempt(bits)`` with more bits each time, until its result has the asked digits or more bits do not help.

    ``attempt`` gives a result and its :func:`certain_bits`, or None where the result is exact. Where the accuracy is
    not reached an :class:`AccuracyWarning` says so.
    """
    goal, bits, attempts = bits_for_digits(digits), first_bits, 1
    result, certain = attempt(bits)
    while certain is not None and certain < goal:
        following = min(bits + goal - certain + _ROOM, 4 * bits)
        if following > _MOST_TIMES_FIRST * first_bits:
            break
        better, more = attempt(following)
        attempts += 1
        if more is None or more < certain + _LEAST_GAIN:
            break
        result, certain, bits = better, more, following
    if certain is None:
        return result, None
    accuracy = Accuracy(digits, certain, bits, attempts)
    if not accuracy.reached:
        warnings.warn(str(accuracy), AccuracyWarning, stacklevel=3)
    return result, accuracy
