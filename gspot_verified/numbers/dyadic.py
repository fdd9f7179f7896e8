"""Exact intervals in Python integers: what crosses a process, a file, a hash.

A flint ball cannot be pickled, hashed or written and read back unchanged. A :class:`Dyadic` can: it is the interval
``[lower * 2^exponent, upper * 2^exponent]`` with three Python integers in a canonical form.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flint import arb

# An exponent is only a number; endpoints as fractions need that many bits.
_MAX_EXPONENT = 10**24
_MAX_SHIFT = 10_000_000  # bits; beyond it ends are rounded outward, and no fraction is made
_KEPT = 1_000  # bits below the larger end, of a ball whose ends differ by more than that
_TEXT = re.compile(r"\[(-?0x[0-9a-f]+), (-?0x[0-9a-f]+)\]p(-?(?:0|[1-9][0-9]{0,23}))")


@dataclass(frozen=True, slots=True)
class Dyadic:
    """The closed interval ``[lower * 2^exponent, upper * 2^exponent]``.

    Canonical: not both integers are even, and the exponent is 0 for the point zero; so equal intervals are equal
    objects with equal hashes and equal texts.

    :raises TypeError: a field is not an int.
    :raises ValueError: ``lower > upper``, or the exponent is out of range.

    >>> Dyadic(2, 4, 0)
    Dyadic(lower=1, upper=2, exponent=1)
    >>> Dyadic.parse(str(Dyadic(-3, 5, -2))) == Dyadic(-3, 5, -2)
    True
    """

    lower: int
    upper: int
    exponent: int = 0

    def __post_init__(self) -> None:
        for name in ("lower", "upper", "exponent"):
            if type(getattr(self, name)) is not int:
                raise TypeError(f"{name} must be an int")
        if self.lower > self.upper:
            raise ValueError("the interval is reversed: lower > upper")
        both = self.lower | self.upper
        shift = (both & -both).bit_length() - 1 if both else 0
        exponent = self.exponent + shift if both else 0
        if abs(exponent) > _MAX_EXPONENT:
            raise ValueError(f"the exponent must lie within +-{_MAX_EXPONENT}")
        object.__setattr__(self, "lower", self.lower >> shift)
        object.__setattr__(self, "upper", self.upper >> shift)
        object.__setattr__(self, "exponent", exponent)

    @classmethod
    def from_ball(cls, value: arb) -> Dyadic:
        """The set of numbers in a finite ball, exactly; rounded outward, by less than 2^-1000 of the last binary place
        of the larger one, where midpoint and radius are more than 10^7 bits apart.

        :raises ValueError: the ball is not finite.

        >>> from flint import arb
        >>> Dyadic.from_ball(arb((1, 0), (1, -(10**9)))).contains_interval(Dyadic.from_ball(arb(1)))
        True
        """
        if not value.is_finite():
            raise ValueError("the ball must be finite")
        middle, middle_exponent = _man_exp(value.mid())
        radius, radius_exponent = _man_exp(value.rad())
        if radius == 0:
            return cls(middle, middle, middle_exponent)
        if middle == 0:
            return cls(-radius, radius, radius_exponent)
        exponent = min(middle_exponent, radius_exponent)
        if max(middle_exponent, radius_exponent) - exponent > _MAX_SHIFT:
            return cls._outward(middle, middle_exponent, radius, radius_exponent)
        middle <<= middle_exponent - exponent
        radius <<= radius_exponent - exponent
        return cls(middle - radius, middle + radius, exponent)

    @classmethod
    def _outward(cls, middle: int, middle_exponent: int, radius: int, radius_exponent: int) -> Dyadic:
        """An interval that holds the ball, in units of 2^(larger exponent - 1000): floor, ceiling, radius up."""
        exponent = max(middle_exponent, radius_exponent) - _KEPT
        lower, upper = _floor(middle, middle_exponent - exponent), -_floor(-middle, middle_exponent - exponent)
        width = -_floor(-radius, radius_exponent - exponent)
        return cls(lower - width, upper + width, exponent)

    @classmethod
    def parse(cls, text: str) -> Dyadic:
        """The interval whose ``str`` is ``text``.

        :raises ValueError: any other text, one that is not canonical included.
        """
        if text == "0":
            return cls(0, 0, 0)
        match = _TEXT.fullmatch(text)
        if match is None:
            raise ValueError(f"not a dyadic interval: {text[:60]!r}")
        interval = cls(int(match[1], 16), int(match[2], 16), int(match[3]))
        if str(interval) != text:
            raise ValueError(f"not in canonical form: {text[:60]!r}")
        return interval

    def __str__(self) -> str:
        return "0" if self.lower == self.upper == 0 else f"[{self.lower:#x}, {self.upper:#x}]p{self.exponent}"

    def to_ball(self) -> arb:
        """A ball that contains the interval; equal to it when midpoint and radius fit (a radius has 30 bits)."""
        from flint import arb, fmpz  # here alone: a verdict, which may hold intervals, loads no arithmetic

        middle, radius = self.lower + self.upper, self.upper - self.lower
        return arb((fmpz(middle), fmpz(self.exponent - 1)), (fmpz(radius), fmpz(self.exponent - 1)))

    def endpoints(self) -> tuple[Fraction, Fraction]:
        """Both endpoints as fractions.

        :raises ValueError: the exponent is beyond +-10^7, where a fraction would not fit in memory.
        """
        if abs(self.exponent) > _MAX_SHIFT:
            raise ValueError("the exponent is too large for a fraction")
        scale = Fraction(2) ** self.exponent
        return self.lower * scale, self.upper * scale

    def contains(self, value: Fraction | int) -> bool:
        """True when the number lies in the interval: decided exactly, never rounded."""
        lower, upper = self.endpoints()
        return lower <= value <= upper

    def contains_interval(self, other: Dyadic) -> bool:
        """True when ``other`` is a subset."""
        (lower, upper), (first, last) = self.endpoints(), other.endpoints()
        return lower <= first and last <= upper

    def overlaps(self, other: Dyadic) -> bool:
        """True when the two closed intervals share a point."""
        (lower, upper), (first, last) = self.endpoints(), other.endpoints()
        return lower <= last and first <= upper

    def sign(self) -> int | None:
        """1, -1 or 0 when every number of the interval has that sign, else ``None``."""
        if self.lower > 0:
            return 1
        if self.upper < 0:
            return -1
        return 0 if self.lower == self.upper == 0 else None


def _floor(number: int, shift: int) -> int:
    """The largest integer <= number * 2^shift."""
    return number << shift if shift >= 0 else number >> -shift


def _man_exp(exact_ball: arb) -> tuple[int, int]:
    mantissa, exponent = exact_ball.man_exp()
    return int(mantissa), int(exponent)
