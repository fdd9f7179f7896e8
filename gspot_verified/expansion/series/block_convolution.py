"""The product of two series with rational terms in the spaces P_n: products of blocks of L orders, each made once.

The blocks i, j >= 1 with i + j = m are known when order m L is asked for, and their product begins there. Together they
are the row m, which gives a share of the orders m L, ..., (m + 2) L - 2. What is left are the products with a term of
the first block, short times long. The middle pairs come first in every sum: coefficients of order n have about n^2
bits, so that f_j g_k has the smallest denominator where j = k.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq_poly

from gspot_verified.expansion.series.fraction_sum import Fraction, sum_of_fractions
from gspot_verified.expansion.series.packed_orders import Block, PackedProduct, exponent_class
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.functions.convolution import Weights
from gspot_verified.functions.series import Series

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
        found = SpacePolynomial((c - n) % 3 + 3 * numerator.degree(), fmpq_poly(numerator, denominator))
        return found if self._for_all is None else found.scale(self._for_all * n)

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
