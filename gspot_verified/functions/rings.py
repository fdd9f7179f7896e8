"""The numbers an expansion is computed in: rationals, balls, rational functions of symbols.

A ring says how polynomials in one variable are made from a list of coefficients; the recursion is the same for all.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from flint import arb, arb_poly, fmpq, fmpq_poly, fmpz


class Ring(Protocol):
    """What the recursion needs of its numbers. Numbers have + - * and division by nonzero numbers."""

    def number(self, value: Any) -> Any:
        """The exact rational ``value`` as a number of the ring."""
        ...

    def polynomial(self, coefficients: Sequence[Any]) -> Any:
        """A polynomial with + - * and ``coeffs()``."""
        ...

    def is_zero(self, value: Any) -> bool:
        """Whether a number is certainly zero."""
        ...

    def is_nonzero(self, value: Any) -> bool:
        """Whether a number is certainly not zero."""
        ...

    def is_negative(self, value: Any) -> bool:
        """Whether a number is certainly negative (a symbol: assumed to be)."""
        ...

    def sine_cosine(self, value: Any) -> tuple[Any, Any]:
        """Sine and cosine of a number."""
        ...

    def exponential(self, value: Any) -> Any:
        """The exponential of a number."""
        ...

    def logarithm(self, value: Any) -> Any:
        """The natural logarithm of a positive number."""
        ...

    def power(self, value: Any, exponent: fmpq) -> Any:
        """A rational power of a number that is not zero."""
        ...


_NOT_RATIONAL = "the value at the point of expansion is not rational; use balls"


class Rationals:
    """Exact rational numbers."""

    def number(self, value: Any) -> fmpq:
        """The rational itself."""
        return fmpq(value)

    def polynomial(self, coefficients: Sequence[Any]) -> fmpq_poly:
        """A polynomial with rational coefficients."""
        return fmpq_poly(list(coefficients))

    def is_zero(self, value: Any) -> bool:
        """Exact."""
        return bool(value == 0)

    def is_nonzero(self, value: Any) -> bool:
        """Exact."""
        return bool(value != 0)

    def is_negative(self, value: Any) -> bool:
        """Exact."""
        return bool(value < 0)

    def sine_cosine(self, value: Any) -> tuple[fmpq, fmpq]:
        """Only at 0.

        :raises ValueError: elsewhere, where they are not rational.
        """
        if value != 0:
            raise ValueError(_NOT_RATIONAL)
        return fmpq(0), fmpq(1)

    def exponential(self, value: Any) -> fmpq:
        """Only at 0.

        :raises ValueError: elsewhere, where it is not rational.
        """
        if value != 0:
            raise ValueError(_NOT_RATIONAL)
        return fmpq(1)

    def logarithm(self, value: Any) -> fmpq:
        """Only at 1.

        :raises ValueError: elsewhere, where it is not rational or does not exist.
        """
        if value != 1:
            raise ValueError(_NOT_RATIONAL)
        return fmpq(0)

    def power(self, value: Any, exponent: fmpq) -> fmpq:
        """An integer power of a nonzero number, or the root of a perfect power.

        :raises ValueError: the base is 0, or the result is not rational.
        """
        if value == 0:
            raise ValueError("a power with a vanishing base has no power series at the point of expansion")
        number = fmpq(value)
        numerator, denominator = (_exact_root(part, int(exponent.q)) for part in (number.p, number.q))
        if numerator is None or denominator is None:
            raise ValueError(_NOT_RATIONAL)
        return fmpq(numerator, denominator) ** int(exponent.p)


class Balls:
    """Balls at the working precision in force: for points whose coordinates are not rational."""

    def number(self, value: Any) -> arb:
        """A ball that contains the rational."""
        return arb(value)

    def polynomial(self, coefficients: Sequence[Any]) -> arb_poly:
        """A polynomial with balls as coefficients."""
        return arb_poly(list(coefficients))

    def is_zero(self, value: Any) -> bool:
        """True only for the exact ball 0."""
        return bool(value.is_zero())

    def is_nonzero(self, value: Any) -> bool:
        """True only when the ball does not contain 0."""
        return bool(value > 0 or value < 0)

    def is_negative(self, value: Any) -> bool:
        """True only when every number of the ball is negative."""
        return bool(value < 0)

    def sine_cosine(self, value: arb) -> tuple[arb, arb]:
        """Enclosures of both."""
        return value.sin(), value.cos()

    def exponential(self, value: arb) -> arb:
        """An enclosure."""
        return value.exp()

    def logarithm(self, value: arb) -> arb:
        """An enclosure; the argument must be certainly positive.

        :raises ValueError: it may be zero or negative.
        """
        if not value > 0:
            raise ValueError("a logarithm of a number that may not be positive has no power series there")
        return value.log()

    def power(self, value: arb, exponent: fmpq) -> arb:
        """An enclosure; the base must be certainly positive unless the exponent is an integer.

        :raises ValueError: the base may vanish, or a root of a number that may be negative is asked for.
        """
        if not (value > 0 or (exponent.q == 1 and value < 0)):
            raise ValueError("a power with a base that may vanish has no power series at the point of expansion")
        return value ** int(exponent.p) if exponent.q == 1 else value ** arb(exponent)


def _exact_root(value: fmpz, degree: int) -> fmpz | None:
    """The root of an integer if it is one."""
    if degree == 1:
        return value
    if value < 0:
        return None
    low, high = 0, 1 << (int(value.bit_length()) // degree + 1)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if fmpz(middle) ** degree <= value else (low, middle - 1)
    return fmpz(low) if fmpz(low) ** degree == value else None


RATIONALS = Rationals()
BALLS = Balls()
