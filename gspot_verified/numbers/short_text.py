"""Exact rationals as short texts, and numbers of a table."""

from __future__ import annotations

import decimal
import math
from fractions import Fraction

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, ball_text, relative_bits

_SHOWN_BITS = 512  # of a decimal's mantissa; a longer number is shown as a fraction
_MOST_PLACES = 2_000  # of a decimal; beyond them a fraction
_CONTEXT = decimal.Context(prec=decimal.MAX_PREC, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN)
"""Nothing is rounded in it."""
_LONGEST = 9  # characters of an exact number in a table
_TABLE_DIGITS = 6  # of any other number there
_NEARLY_ZERO = fmpq(1, 10**6)  # what is all nearer to 0 has six decimals 0
_TABLE_BITS = 24  # certain bits that a ball needs for these digits


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


def table_text(value: Exact) -> str:
    """For a table: an exact number where it is short, else six digits, off by at most one in the last of them.

    A ball with fewer certain digits is written as a ball; one that is all nearer to 0 than 10^-6 as 0.000000.

    >>> table_text(fmpq(18, 55)), table_text(fmpq(186037, 99144)), table_text(arb(1) / 3), table_text(arb(0, "0.01"))
    ('18/55', '1.87643', '0.333333', '[-0.0101, 0.0101]')
    """
    if isinstance(value, arb) and value.is_exact():
        mantissa, exponent = value.man_exp()
        value = fmpq(mantissa) * fmpq(2) ** int(exponent)
    if isinstance(value, fmpq):
        text = short_text(value)
        return text if len(text) <= _LONGEST else arb(value).str(_TABLE_DIGITS, radius=False)
    if value.contains(0) and abs(value) < _NEARLY_ZERO:
        return "0.000000"
    if relative_bits(value) < _TABLE_BITS:
        return ball_text(value, 3)
    return value.str(_TABLE_DIGITS, radius=False)
