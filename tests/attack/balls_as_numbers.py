"""Balls of the package as exact numbers, to be compared with references."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from flint import arb, fmpq

_MARGIN = 40


def exactly(value: arb) -> mpmath.mpf:
    """The number of an exact ball, exactly (at any precision)."""
    mantissa, exponent = value.man_exp()
    with mpmath.workprec(max(64, int(mantissa).bit_length() + 8)):
        return mpmath.ldexp(mpmath.mpf(int(mantissa)), int(exponent))


def holds(ball: arb, value: mpmath.mpf, off: mpmath.mpf) -> bool:
    """Whether a finite ball holds a number that is known up to ``off``; a ball that is not finite holds nothing."""
    if not ball.is_finite():
        return False
    middle, radius = exactly(ball.mid()), exactly(ball.rad())
    bits = max(mpmath.mp.prec, *(int(part.man_exp[0]).bit_length() for part in (middle, value))) + _MARGIN
    with mpmath.workprec(bits):
        return bool(abs(middle - value) <= (radius + off) * (1 + mpmath.ldexp(1, -30)))


def accurate(ball: arb, digits: int) -> bool:
    """Whether the relative radius is at most 10^-digits."""
    middle, radius = exactly(ball.mid()), exactly(ball.rad())
    return bool(radius <= (abs(middle) - radius) * mpmath.mpf(10) ** -digits * (1 + mpmath.ldexp(1, -20)))


def to_fmpq(value: Fraction | int) -> fmpq:
    """The same number."""
    value = Fraction(value)
    return fmpq(value.numerator, value.denominator)


def to_fraction(value: fmpq) -> Fraction:
    """The same number."""
    return Fraction(int(value.p), int(value.q))
