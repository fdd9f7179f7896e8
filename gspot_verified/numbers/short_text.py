"""Exact rationals as short texts."""

from __future__ import annotations

import decimal
import math
from fractions import Fraction

from flint import fmpq

_SHOWN_BITS = 512  # of a decimal's mantissa; a longer number is shown as a fraction
_MOST_PLACES = 2_000  # of a decimal; beyond them a fraction
_CONTEXT = decimal.Context(prec=decimal.MAX_PREC, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN)
"""Nothing is rounded in it."""


def short_text(value: fmpq) -> str:
    """A decimal fraction exactly, as a decimal or with an exponent; another rational as it is.

    >>> short_text(fmpq(-1, 8)), short_text(fmpq(10) ** -300), short_text(fmpq(1, 3)), short_text(fmpq(1200))
    ('-0.125', '1e-300', '1/3', '1200')
    """
    denominator = int(value.q)
    twos = (denominator & -denominator).bit_length() - 1
    odd = denominator >> twos
    fives = round(odd.bit_length() * math.log(2, 5))  # 5^n has more than n log2(5) bits, at most one more
    places = max(twos, fives)
    mantissa = int(value.p) * 10**places // denominator
    if 5**fives != odd or mantissa.bit_length() > _SHOWN_BITS:
        return str(value)
    number = _CONTEXT.normalize(_CONTEXT.scaleb(decimal.Decimal(mantissa), -places))
    return f"{number:f}" if -7 <= number.adjusted() <= 20 else f"{number:g}"


def decimal_text(lower: fmpq, upper: fmpq) -> str:
    """``lower..upper`` in decimals when both are decimal fractions, else as rationals.

    >>> decimal_text(fmpq(-1, 4), fmpq(1, 2)), decimal_text(fmpq(1, 3), fmpq(1, 2))
    ('-0.25..0.50', '1/3..1/2')
    """
    places = next((k for k in range(_MOST_PLACES + 1) if 10**k % math.lcm(int(lower.q), int(upper.q)) == 0), None)
    if places is None:
        return f"{lower}..{upper}"
    return "..".join(_decimal(Fraction(int(end.p), int(end.q)), places) for end in (lower, upper))


def _decimal(value: Fraction, places: int) -> str:
    digits = f"{abs(int(value * 10**places)):0{places + 1}d}"
    text = f"{digits[:-places]}.{digits[-places:]}" if places else digits
    return f"-{text}" if value < 0 else text
