"""The terms of successive orders of a series as one integer polynomial, so that one product gives those of all orders.

In a series of Theorem 1 the exponents of s^k delta^n obey k + n = c mod 3, with one c for the whole series. So the
column (k + n - c)/3 is an integer, and columns add up in products as orders do (Kronecker's substitution for delta):
s^k delta^n goes to X^(W r + column), n = first + r, columns counted from that of ``first``, a multiple of 3. The width
W is large enough that no two orders of the product meet. Page: proofs/expansion.md, section 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

from flint import fmpz, fmpz_poly

from gspot_verified.expansion.series.fraction_sum import Fraction
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.functions.series import Series


def exponent_class(series: Series) -> int:
    """The class c, from the first term that is not zero."""
    n, term = next(iter(series.nonzero.items()))
    return int(term.n + n) % 3


@dataclass(frozen=True, slots=True)
class Block:
    """The terms of the orders from ``first`` on, of the class c, with rational coefficients."""

    terms: Sequence[SpacePolynomial]
    first: int
    c: int

    @property
    def length(self) -> int:
        """The coefficients of the longest term, one for each power of s^3; 0 when all terms vanish."""
        return max(int(term.cubic.length()) for term in self.terms)

    def packed(self, width: int, times_order: bool = False) -> Fraction:
        """The block as a polynomial in X; ``times_order``: with each term multiplied by its order.

        :raises ValueError: the exponents of a term are not of the class.
        """
        common = reduce(fmpz.lcm, (term.integers()[1] for term in self.terms))
        coefficients: list[fmpz] = []
        for r, term in enumerate(self.terms):
            n = self.first + r
            if term.is_zero():
                continue
            if (term.n + n - self.c) % 3:
                raise ValueError(f"an element of P_{term.n} has no place at order {n}")
            numerator, denominator = term.integers()
            place = width * r + (term.n % 3 + r - self.c) // 3
            coefficients += [fmpz(0)] * (place - len(coefficients))
            coefficients += (numerator * (common // denominator * (n if times_order else 1))).coeffs()
        return fmpz_poly(coefficients), common


class PackedProduct:
    """A sum of products of packed blocks, of the class c and from one order on; ``width``: W."""

    __slots__ = ("_c", "_coefficients", "_denominator", "_width")

    def __init__(self, fraction: Fraction, c: int, width: int) -> None:
        numerator, self._denominator = fraction
        # The smallest exponent k >= 0 of the class may have column -1 where c = c_1 + c_2 > 2.
        self._coefficients = [fmpz(0), *numerator.coeffs()]
        self._c, self._width = c, width

    def at_order(self, r: int) -> Fraction:
        """The term of the order r after the first, as a polynomial in s^3."""
        return fmpz_poly(self._coefficients[self._place(r) : self._place(r + 1)]), self._denominator

    def _place(self, r: int) -> int:
        """Where the smallest exponent k >= 0 with k + r = c mod 3 stands."""
        smallest = (self._c - r) % 3
        return self._width * r + (smallest + r - self._c) // 3 + 1
