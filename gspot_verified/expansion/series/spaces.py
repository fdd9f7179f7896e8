"""The spaces P_n of Theorem 1: polynomials in s with the exponents n, n - 3, n - 6, ... only.

Paper, Sec. 5 (before th:1). For n < 0 the space holds only zero.

Derivative and integral of their elements s^e c(s^3), e = 0, 1, 2, are given and returned as the polynomial c in s^3.

Over the rationals in integers: one fraction is reduced, and not one for each coefficient.
"""

from __future__ import annotations

import math
from typing import Any

from flint import fmpq_poly, fmpz, fmpz_poly

from gspot_verified.functions.rings import RATIONALS, Rationals, Ring


def derivative(cubic: Any, e: int, ring: Ring) -> Any:
    """The derivative; it begins with s^(e - 1), or with s^2 where e = 0.

    >>> from gspot_verified.functions.rings import RATIONALS
    >>> derivative(fmpq_poly([7, 5]), 0, RATIONALS), derivative(fmpq_poly([7, 5]), 1, RATIONALS)
    (15, 20*x + 7)
    """
    exponents = range(e, e + 3 * cubic.length(), 3)
    lost = 0 if e else 1
    if isinstance(ring, Rationals):
        numerators = [value * k for value, k in zip(cubic.numer().coeffs(), exponents, strict=True)]
        return fmpq_poly(fmpz_poly(numerators[lost:]), cubic.denom())
    return ring.polynomial([value * ring.number(k) for value, k in zip(cubic.coeffs(), exponents, strict=True)][lost:])


def integral(cubic: Any, e: int, ring: Ring) -> Any:
    """The integral from 0; it begins with s^(e + 1), or with s^0 where e = 2.

    >>> from gspot_verified.functions.rings import RATIONALS
    >>> integral(fmpq_poly([7, 5]), 2, RATIONALS), integral(fmpq_poly([7, 5]), 0, RATIONALS)
    (5/6*x^2 + 7/3*x, 5/4*x + 7)
    """
    divisors = range(e + 1, e + 1 + 3 * cubic.length(), 3)
    gained = 1 if e == 2 and divisors else 0
    if isinstance(ring, Rationals):
        common = math.lcm(*divisors)
        numerators = [value * (common // k) for value, k in zip(cubic.numer().coeffs(), divisors, strict=True)]
        return fmpq_poly(fmpz_poly([0] * gained + numerators), cubic.denom() * common)
    values = [value / ring.number(k) for value, k in zip(cubic.coeffs(), divisors, strict=True)]
    return ring.polynomial([ring.number(0)] * gained + values)


class NoCommonSpace(ValueError):
    """A sum of elements of spaces P_m and P_n with no common space."""


class SpacePolynomial:
    """An element of P_n: s^(n mod 3) times a polynomial in s^3, of degree at most n in s.

    ``cubic`` is the polynomial in s^3. Membership is checked when an element is made.

    :raises ValueError: the degree is larger than n.

    >>> one, s = SpacePolynomial.from_list(0, [1]), SpacePolynomial.from_list(1, [0, 1])
    >>> (s * s + SpacePolynomial.from_list(2, [0, 0, 3])).coefficients()
    [0, 0, 4]
    >>> SpacePolynomial.from_list(2, [1])
    Traceback (most recent call last):
    ...
    ValueError: s^0 is not in P_2
    """

    __slots__ = ("_integers", "cubic", "n", "ring")

    def __init__(self, n: int, cubic: Any, ring: Ring = RATIONALS) -> None:
        length = cubic.length()
        if length and (n < 0 or 3 * (length - 1) + n % 3 > n):
            raise ValueError(f"a polynomial of degree {3 * (length - 1) + n % 3} is not in P_{n}")
        self.n, self.cubic, self.ring = n, cubic, ring
        self._integers: tuple[fmpz_poly, fmpz] | None = None

    def integers(self) -> tuple[fmpz_poly, fmpz]:
        """Numerator and denominator of ``cubic``, over the rationals; made once."""
        if self._integers is None:
            self._integers = self.cubic.numer(), self.cubic.denom()
        return self._integers

    @classmethod
    def zero(cls, n: int, ring: Ring = RATIONALS) -> SpacePolynomial:
        """The zero of P_n."""
        return cls(n, ring.polynomial([]), ring)

    @classmethod
    def from_list(cls, n: int, coefficients: list[Any], ring: Ring = RATIONALS) -> SpacePolynomial:
        """The element with the coefficients of s^0, s^1, ...

        :raises ValueError: a coefficient belongs to an exponent that P_n does not have.
        """
        for k, value in enumerate(coefficients):
            if (k - n) % 3 and not ring.is_zero(ring.number(value)):
                raise ValueError(f"s^{k} is not in P_{n}")
        return cls(n, ring.polynomial([ring.number(value) for value in coefficients[n % 3 :: 3]]), ring)

    def coefficients(self) -> list[Any]:
        """The coefficients of s^0, s^1, ..., up to the highest that is not zero."""
        coefficients: list[Any] = []
        for value in self.cubic.coeffs():
            coefficients += [self.ring.number(0)] * ((self.n - len(coefficients)) % 3) + [value]
        return coefficients

    def is_zero(self) -> bool:
        """Whether every coefficient is zero."""
        return bool(self.cubic.length() == 0)

    def in_space(self, n: int) -> SpacePolynomial:
        """The same polynomial as an element of P_n.

        :raises ValueError: it is not one.
        """
        if (n - self.n) % 3 and not self.is_zero():
            raise ValueError(f"an element of P_{self.n} other than 0 is not in P_{n}")
        return SpacePolynomial(n, self.cubic, self.ring)

    def __add__(self, other: SpacePolynomial) -> SpacePolynomial:
        if self.is_zero():
            return other
        if other.is_zero():
            return self
        if (self.n - other.n) % 3:
            raise NoCommonSpace(f"elements of P_{self.n} and P_{other.n} have no common space")
        return SpacePolynomial(max(self.n, other.n), self.cubic + other.cubic, self.ring)

    def __neg__(self) -> SpacePolynomial:
        return SpacePolynomial(self.n, -self.cubic, self.ring)

    def __sub__(self, other: SpacePolynomial) -> SpacePolynomial:
        return self + (-other)

    def __mul__(self, other: SpacePolynomial) -> SpacePolynomial:
        """P_a times P_b is in P_(a+b)."""
        n = self.n + other.n
        if self.is_zero() or other.is_zero():
            return SpacePolynomial.zero(n, self.ring)
        product = self.cubic * other.cubic
        if self.n % 3 + other.n % 3 >= 3:
            product = product * self.ring.polynomial([self.ring.number(0), self.ring.number(1)])
        return SpacePolynomial(n, product, self.ring)

    def scale(self, factor: Any) -> SpacePolynomial:
        """The product with a number of the ring."""
        return SpacePolynomial(self.n, self.cubic * factor, self.ring)

    def derivative(self) -> SpacePolynomial:
        """d/ds: P_n to P_(n-1)."""
        return SpacePolynomial(self.n - 1, derivative(self.cubic, self.n % 3, self.ring), self.ring)

    def integral(self) -> SpacePolynomial:
        """The integral from 0: P_n to P_(n+1)."""
        return SpacePolynomial(self.n + 1, integral(self.cubic, self.n % 3, self.ring), self.ring)

    def at_zero(self) -> Any:
        """The value at s = 0."""
        return self.cubic.coeffs()[0] if self.n % 3 == 0 and not self.is_zero() else self.ring.number(0)

    def __call__(self, s: Any) -> Any:
        """The value at s, a number of the ring (or a ball)."""
        total = self.ring.number(0)
        for value in reversed(self.cubic.coeffs()):
            total = total * (s * s * s) + value
        return total * s ** (self.n % 3)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SpacePolynomial):
            return NotImplemented
        if self.is_zero() or other.is_zero():
            return self.is_zero() and other.is_zero()
        return (self.n - other.n) % 3 == 0 and bool(self.cubic == other.cubic)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"SpacePolynomial.from_list({self.n}, {self.coefficients()})"
