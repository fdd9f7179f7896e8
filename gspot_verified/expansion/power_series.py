"""Power series in delta of functions of the state, one order at a time.

Each operation has its recurrence (differentiate with respect to delta; for powers this is Euler's rule): the term of
order n needs the terms of its parts up to order n. The terms may be polynomials in s or plain numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from flint import fmpq

from gspot_verified.expansion.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.expansion.rings import Ring


class Terms(Protocol):
    """Arithmetic of the terms. The term of order 0 is a number of the ring, given and taken as one."""

    def constant(self, value: Any) -> Any:
        """A number as a term."""
        ...

    def zero(self, order: int) -> Any:
        """The zero term of this order."""
        ...

    def scale(self, term: Any, factor: Any) -> Any:
        """A term times a number of the ring."""
        ...

    def is_zero(self, term: Any) -> bool:
        """Whether the term vanishes, so that its products can be left out."""
        ...

    def at_start(self, term: Any) -> Any:
        """The number that a term of order 0 is."""
        ...


class SeriesOfFunctions:
    """The series of several functions of the state; :meth:`extend` adds one order.

    ``state(n)`` must give the terms of order n of all components of the state.
    """

    def __init__(self, roots: Sequence[Expression], terms: Terms, numbers: Ring) -> None:
        companions = [Cosine(e.argument) for e in in_order(roots) if isinstance(e, Sine)]
        companions += [Sine(e.argument) for e in in_order(roots) if isinstance(e, Cosine)]
        self._nodes = in_order([*roots, *companions])
        self._terms, self._numbers = terms, numbers
        self._series: dict[Expression, list[Any]] = {node: [] for node in self._nodes}
        self._rules: dict[type, Callable[[Any, int], Any]] = {
            Sum: self._sum,
            Product: self._product,
            Power: self._power,
            Sine: lambda node, n: self._rotated(node, Cosine(node.argument), 1, n),
            Cosine: lambda node, n: self._rotated(node, Sine(node.argument), -1, n),
            Exponential: lambda node, n: self._rotated(node, node, 1, n),
        }

    def __getitem__(self, root: Expression) -> list[Any]:
        return self._series[root]

    def extend(self, state: Sequence[Any]) -> None:
        """Add the next order, ``state`` being the terms of that order of the components of the state."""
        n = len(self._series[self._nodes[0]])
        for node in self._nodes:
            if isinstance(node, Variable):
                term = state[node.index]
            elif isinstance(node, Constant):
                term = self._terms.constant(node.value) if n == 0 else self._terms.zero(n)
            else:
                term = self._rules[type(node)](node, n)
            self._series[node].append(term)

    def drop_last(self) -> None:
        """Forget the last order."""
        for series in self._series.values():
            series.pop()

    def _sum(self, node: Sum, n: int) -> Any:
        total = self._terms.zero(n)
        for part in node.terms:
            total = total + self._series[part][n]
        return total

    def _product(self, node: Product, n: int) -> Any:
        left, right = self._series[node.left], self._series[node.right]
        return self._convolved(left, right, n, range(n + 1))

    def _convolved(self, left: list[Any], right: list[Any], n: int, orders: range) -> Any:
        is_zero = self._terms.is_zero
        total = self._terms.zero(n)
        for k in orders:
            if not is_zero(left[k]) and not is_zero(right[n - k]):
                total = total + left[k] * right[n - k]
        return total

    def _power(self, node: Power, n: int) -> Any:
        """f = u^r: u f' = r u' f gives n u_0 f_n = sum over k >= 1 of (r k - (n - k)) u_k f_(n-k)."""
        base, own = self._series[node.base], self._series[node]
        start = self._terms.at_start(base[0])
        if n == 0:
            return self._terms.constant(self._numbers.power(start, node.exponent))
        total = self._terms.zero(n)
        for k in range(1, n + 1):
            if not self._terms.is_zero(base[k]) and not self._terms.is_zero(own[n - k]):
                factor = self._numbers.number(node.exponent * k - (n - k))
                total = total + self._terms.scale(base[k] * own[n - k], factor)
        return self._terms.scale(total, self._numbers.number(fmpq(1, n)) / start)

    def _rotated(self, node: Any, partner: Expression, sign: int, n: int) -> Any:
        """f' = sign u' g, so n f_n = sign sum over k >= 1 of k u_k g_(n-k)."""
        argument = self._series[node.argument]
        if n == 0:
            start = self._terms.at_start(argument[0])
            if isinstance(node, Exponential):
                return self._terms.constant(self._numbers.exponential(start))
            sine, cosine = self._numbers.sine_cosine(start)
            return self._terms.constant(sine if isinstance(node, Sine) else cosine)
        other = self._series[partner]
        total = self._terms.zero(n)
        for k in range(1, n + 1):
            if not self._terms.is_zero(argument[k]) and not self._terms.is_zero(other[n - k]):
                factor = self._numbers.number(fmpq(sign * k, n))
                total = total + self._terms.scale(argument[k] * other[n - k], factor)
        return total
