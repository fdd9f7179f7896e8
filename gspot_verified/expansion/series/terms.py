"""The two kinds of terms that a power series in delta may have: polynomials in the spaces P_n, and numbers.

The product of two series with rational terms in the spaces P_n: products of blocks of L orders, each made once.

The blocks i, j >= 1 with i + j = m are known when order m L is asked for, and their product begins there. Together they
are the row m, which gives a share of the orders m L, ..., (m + 2) L - 2. What is left are the products with a term of
the first block, short times long. The middle pairs come first in every sum: coefficients of order n have about n^2
bits, so that f_j g_k has the smallest denominator where j = k.

The terms of successive orders of a series as one integer polynomial, so that one product gives those of all orders.

In a series of Theorem 1 the exponents of s^k delta^n obey k + n = c mod 3, with one c for the whole series. So the
column (k + n - c)/3 is an integer, and columns add up in products as orders do (Kronecker's substitution for delta):
s^k delta^n goes to X^(W r + column), n = first + r, columns counted from that of ``first``, a multiple of 3. The width
W is large enough that no two orders of the product meet. Page: proofs/expansion.md, section 6.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

from flint import fmpq_poly, fmpz, fmpz_poly

from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.functions.convolution import Convolution, Series, TermByTerm, Weights
from gspot_verified.functions.rings import Rationals, Ring

Fraction = tuple[fmpz_poly, fmpz]
"""Numerator and denominator, not reduced."""


def sum_of_fractions(fractions: Iterable[Fraction]) -> Fraction:
    """The sum, on the least common multiple of the denominators.

    Cheapest from the smallest denominator to the largest: then what is scaled again is no longer than the next summand.

    >>> sum_of_fractions([(fmpz_poly([0, 1]), fmpz(4)), (fmpz_poly([1]), fmpz(6))])
    (3*x + 2, 12)
    """
    summands = iter(fractions)
    numerator, denominator = next(summands, (fmpz_poly([]), fmpz(1)))
    for above, below in summands:
        missing = below // denominator.gcd(below)
        if missing != 1:
            numerator, denominator = numerator * missing, denominator * missing
        numerator += above * (denominator // below)
    return numerator, denominator


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


_LENGTH = 18
"""L, a multiple of 3."""

_FROM = 4 * _LENGTH
"""From this order on blocks are used; below, a row costs more than it saves."""


class BlockConvolution:
    """The sums over j + k = n of f_j g_k, with weights a j + b k where there are any, for rational coefficients."""

    def __init__(self, left: Series, right: Series, weights: Weights | None = None) -> None:
        # a = b: every product of order n counts a n times.
        self._for_all = weights[0] if weights is not None and weights[0] == weights[1] else None
        self._left, self._right, self._weights = left, right, weights if self._for_all is None else None
        self._rows: dict[int, PackedProduct | None] = {}

    def __call__(self, n: int) -> SpacePolynomial:
        """The sum of order n. The terms below order n are known; one of order n that is not counts as 0.

        :raises ValueError: terms below order n are missing, or the exponents of a series do not lie in one class.
        """
        if min(len(self._left.terms), len(self._right.terms)) < n:
            raise ValueError(f"the terms below order {n} must be known")
        if not (self._left.nonzero and self._right.nonzero):
            return SpacePolynomial.zero(-1)
        c = exponent_class(self._left) + exponent_class(self._right)
        numerator, denominator = sum_of_fractions([*self._near(n, c), *self._far(n, c)])
        if not numerator:
            return SpacePolynomial.zero(-1)
        total = SpacePolynomial((c - n) % 3 + 3 * numerator.degree(), fmpq_poly(numerator, denominator))
        return total if self._for_all is None else total.scale(self._for_all * n)

    def forget(self, n: int) -> None:
        """The terms from order n on are no longer those that they were."""
        for m in [m for m in self._rows if m * _LENGTH > n]:
            del self._rows[m]

    def _near(self, n: int, c: int) -> Iterator[Fraction]:
        """The products with a term of the first block; where blocks are not used yet, all."""
        longest = n // 2 if n < _FROM else _LENGTH - 1
        lefts, rights, weights = self._left.nonzero, self._right.nonzero, self._weights
        for shorter in range(longest, -1, -1):
            for j in (shorter,) if 2 * shorter == n else (shorter, n - shorter):
                if j not in lefts or n - j not in rights:
                    continue
                left, right = lefts[j], rights[n - j]
                if (left.n + right.n + n - c) % 3:
                    raise ValueError(f"a product of elements of P_{left.n} and P_{right.n} has no place at order {n}")
                (above, below), (other, divisor) = left.integers(), right.integers()
                product, denominator = above * other, below * divisor
                if left.n % 3 + right.n % 3 >= 3:
                    product = product.left_shift(1)
                if weights is not None:
                    weight = weights[0] * j + weights[1] * (n - j)
                    product, denominator = product * weight.p, denominator * weight.q
                yield product, denominator

    def _far(self, n: int, c: int) -> Iterator[Fraction]:
        """The share of the rows that reach order n."""
        for m in (n // _LENGTH - 1, n // _LENGTH) if n >= _FROM else ():
            if m not in self._rows:
                self._rows.pop(m - 2, None)  # no order from n on needs it
                self._rows[m] = self._row(m, c)
            row = self._rows[m]
            if row is not None:
                yield row.at_order(n - m * _LENGTH)

    def _row(self, m: int, c: int) -> PackedProduct | None:
        """The products of the blocks i, j >= 1 with i + j = m; None when all vanish."""
        middle_first = sorted(range(1, m), key=lambda i: abs(2 * i - m))
        pairs = [(_block(self._left, i), _block(self._right, m - i)) for i in middle_first]
        pairs = [(f, g) for f, g in pairs if f.length and g.length]
        if not pairs:
            return None
        width = max(f.length + g.length for f, g in pairs)
        products = (product for f, g in pairs for product in self._products(f, g, width))
        return PackedProduct(sum_of_fractions(products), c, width)

    def _products(self, f: Block, g: Block, width: int) -> Iterator[Fraction]:
        if self._weights is None:
            (above, below), (other, divisor) = f.packed(width), g.packed(width)
            yield above * other, below * divisor
            return
        for weight, weighted in zip(self._weights, (f, g), strict=True):
            if weight != 0:
                (above, below), (other, divisor) = (block.packed(width, block is weighted) for block in (f, g))
                yield above * other * weight.p, below * divisor * weight.q


def _block(series: Series, i: int) -> Block:
    first = i * _LENGTH
    return Block(series.terms[first : first + _LENGTH], first, exponent_class(series))


def function_space(n: int) -> int:
    """The index of the space that holds the term of order n of a function of the state.

    Paper, Lemma thm:expansion: P_nu for n = 2 nu, P_(nu-4) for n = 2 nu + 1.
    """
    return n // 2 if n % 2 == 0 else (n - 1) // 2 - 4


class PolynomialTerms:
    """Terms that are polynomials in s."""

    def __init__(self, ring: Ring) -> None:
        self._ring = ring
        self._zeros: list[SpacePolynomial] = []

    def constant(self, value: Any) -> SpacePolynomial:
        """An element of P_0."""
        number = self._ring.number(value)
        values = [] if self._ring.is_zero(number) else [number]
        return SpacePolynomial(0, self._ring.polynomial(values), self._ring)

    def zero(self, order: int) -> SpacePolynomial:
        """The zero of the space of this order."""
        for n in range(len(self._zeros), order + 1):
            self._zeros.append(SpacePolynomial.zero(function_space(n), self._ring))
        return self._zeros[order]

    def scale(self, term: SpacePolynomial, factor: Any) -> SpacePolynomial:
        """A multiple."""
        return term.scale(factor)

    def convolution(self, left: Series, right: Series, weights: Weights | None = None) -> Convolution:
        """The terms of the product of two series; over the rationals by blocks of orders."""
        if isinstance(self._ring, Rationals):
            return BlockConvolution(left, right, weights)
        return TermByTerm(left, right, self, self._ring, weights)

    def is_zero(self, term: SpacePolynomial) -> bool:
        """Whether every coefficient is zero."""
        return term.is_zero()

    def at_start(self, term: SpacePolynomial) -> Any:
        """The only coefficient of an element of P_0."""
        return term.at_zero()


class NumberTerms:
    """Terms that are numbers: the values at s = 0."""

    def __init__(self, ring: Ring) -> None:
        self._ring = ring

    def constant(self, value: Any) -> Any:
        """The number."""
        return self._ring.number(value)

    def zero(self, order: int) -> Any:
        """Zero, whatever the order."""
        del order
        return self._ring.number(0)

    def scale(self, term: Any, factor: Any) -> Any:
        """The product."""
        return term * factor

    def convolution(self, left: Series, right: Series, weights: Weights | None = None) -> Convolution:
        """The terms of the product of two series."""
        return TermByTerm(left, right, self, self._ring, weights)

    def is_zero(self, term: Any) -> bool:
        """Whether it is certainly zero."""
        return self._ring.is_zero(term)

    def at_start(self, term: Any) -> Any:
        """The number."""
        return term
