"""Power series in delta, one order at a time, and their products, as the terms of the factors become known."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from flint import fmpq

from gspot_verified.functions.rings import Ring


class Series:
    """All terms by order, and under their orders those that do not vanish; both grow."""

    __slots__ = ("_vanishes", "nonzero", "terms")

    def __init__(self, vanishes: Callable[[Any], bool]) -> None:
        self._vanishes = vanishes
        self.terms: list[Any] = []
        self.nonzero: dict[int, Any] = {}

    def append(self, term: Any) -> None:
        """Add the term of the next order."""
        if not self._vanishes(term):
            self.nonzero[len(self.terms)] = term
        self.terms.append(term)

    def drop_last(self) -> None:
        """Forget the term of the last order."""
        self.terms.pop()
        self.nonzero.pop(len(self.terms), None)


Weights = tuple[fmpq, fmpq]
"""(a, b): f_j g_k counts a j + b k times, as in a (delta df/ddelta) g + b f (delta dg/ddelta)."""


class Convolution(Protocol):
    """The sums over j + k = n of f_j g_k, with weights a j + b k where there are any."""

    def __call__(self, n: int) -> Any:
        """The sum of order n. The terms below order n are known; one of order n that is not counts as 0."""
        ...

    def forget(self, n: int) -> None:
        """The terms from order n on are no longer those that they were."""
        ...


class Sums(Protocol):
    """What a sum of products needs of its terms, besides + and *."""

    def zero(self, order: int) -> Any:
        """The empty sum of this order."""
        ...

    def scale(self, term: Any, factor: Any) -> Any:
        """A term times a number of the ring."""
        ...


class TermByTerm:
    """The sums as they stand, for terms of every kind: each product by itself."""

    def __init__(self, left: Series, right: Series, sums: Sums, ring: Ring, weights: Weights | None = None) -> None:
        self._left, self._right, self._sums, self._ring, self._weights = left, right, sums, ring, weights

    def __call__(self, n: int) -> Any:
        """The sum of order n."""
        total = self._sums.zero(n)
        others = self._right.nonzero
        for j, left in self._left.nonzero.items():
            weight = None if self._weights is None else self._weights[0] * j + self._weights[1] * (n - j)
            if n - j in others and weight != 0:
                product = left * others[n - j]
                total = total + (product if weight is None else self._sums.scale(product, self._ring.number(weight)))
        return total

    def forget(self, n: int) -> None:
        """Nothing is kept."""
