"""The two kinds of terms that a power series in delta may have: polynomials in the spaces P_n, and numbers."""

from __future__ import annotations

from typing import Any

from gspot_verified.expansion.series.block_convolution import BlockConvolution
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.functions.convolution import Convolution, TermByTerm, Weights
from gspot_verified.functions.rings import Rationals, Ring
from gspot_verified.functions.series import Series


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
