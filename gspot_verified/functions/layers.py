"""Power series in (t, epsilon) of functions of the state, filled layer by layer.

A layer is a power of epsilon; inside a layer the coefficients of t^0, t^1, ... are added one by one. In the layer of
epsilon^m the product f g is f_0 g_m + f_m g_0 + (what complete layers give), so each coefficient is one short sum.
Analytic functions follow from their derivative with respect to epsilon, in the first layer with respect to t.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from flint import fmpq

from gspot_verified.functions.derivative import powers_as_products
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    FunctionOfOne,
    Logarithm,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
    in_order,
    partner,
)
from gspot_verified.functions.rings import Ring


def dot(left: Sequence[Any], right: Sequence[Any], k: int, zero: Any, first: int = 0) -> Any:
    """The sum of left_l right_(k-l) for l from ``first`` to k."""
    total = zero
    for i in range(first, k + 1):
        total = total + left[i] * right[k - i]
    return total


class Layers:
    """One series: ``rows[m][k]`` is the coefficient of t^k epsilon^m. Only the last row may be incomplete."""

    def __init__(self, ring: Ring) -> None:
        self._ring = ring
        self.rows: list[list[Any]] = []
        self._complete: list[Any] = []

    def open(self) -> None:
        """Begin the next power of epsilon."""
        if self.rows:
            self._complete.append(self._ring.polynomial(self.rows[-1]))
        self.rows.append([])

    def middle(self, other: Layers, m: int, weight: Callable[[int], Any] | None = None) -> list[Any]:
        """The sum over 0 < j < m of weight(j) f_j g_(m-j), as coefficients of t^0, t^1, ..."""
        total = self._ring.polynomial([])
        for j in range(1, m):
            product = self._complete[j] * other._complete[m - j]
            total = total + (product if weight is None else product * weight(j))
        return list(total.coeffs())


def entry(values: Sequence[Any], k: int, zero: Any) -> Any:
    """The coefficient k, zero beyond the end."""
    return values[k] if k < len(values) else zero


def product_coefficient(left: Layers, right: Layers, middle: Sequence[Any], k: int, zero: Any) -> Any:
    """The coefficient k of the last layer of a product, when both factors have theirs."""
    if len(left.rows) == 1:
        return dot(left.rows[0], right.rows[0], k, zero)
    known = entry(middle, k, zero)
    return known + dot(left.rows[0], right.rows[-1], k, zero) + dot(left.rows[-1], right.rows[0], k, zero)


class LayeredFunctions:
    """The series of several functions of the state.

    :meth:`open_layer` begins the next power of epsilon; :meth:`push` adds the next power of t in it.
    """

    def __init__(self, roots: Sequence[Expression], ring: Ring) -> None:
        self._graph = powers_as_products(roots)
        roots = [self._graph[root] for root in roots]
        nodes = in_order(roots)
        companions: list[Expression] = [Cosine(node.argument) for node in nodes if isinstance(node, Sine)]
        companions += [Sine(node.argument) for node in nodes if isinstance(node, Cosine)]
        companions += [Power(node.argument, fmpq(-1)) for node in nodes if isinstance(node, Logarithm)]
        self._nodes = in_order([*roots, *companions])
        self._ring, self._zero = ring, ring.number(0)
        self._series = {node: Layers(ring) for node in self._nodes}
        self._middle: dict[Expression, list[Any]] = {}
        self._layer = -1

    def __getitem__(self, root: Expression) -> Layers:
        return self._series[self._graph[root]]

    def open_layer(self) -> None:
        """Begin the next power of epsilon."""
        self._layer += 1
        for series in self._series.values():
            series.open()
        self._middle = {node: self._complete_part(node, self._layer) for node in self._nodes}

    def push(self, state: Sequence[Any]) -> None:
        """Add the next power of t; ``state`` holds the coefficients of the components of the state."""
        k = len(self._series[self._nodes[0]].rows[-1])
        for node in self._nodes:
            self._series[node].rows[-1].append(self._coefficient(node, k, state))

    def pop(self) -> None:
        """Forget the last power of t."""
        for series in self._series.values():
            series.rows[-1].pop()

    def _complete_part(self, node: Expression, m: int) -> list[Any]:
        number, series = self._ring.number, self._series
        if isinstance(node, Product):
            return series[node.left].middle(series[node.right], m)
        if isinstance(node, Power):
            r = node.exponent
            return series[node.base].middle(series[node], m, lambda j: number((r * j - (m - j)) / m))
        if isinstance(node, FunctionOfOne):
            other, sign = partner(node)
            return series[node.argument].middle(series[other], m, lambda j: number(fmpq(sign * j, m)))
        return []

    def _coefficient(self, node: Expression, k: int, state: Sequence[Any]) -> Any:
        first_of_all = self._layer == 0 and k == 0
        if isinstance(node, Variable):
            return state[node.index]
        if isinstance(node, Constant):
            return self._ring.number(node.value) if first_of_all else self._zero
        if isinstance(node, Sum):
            return sum((self._series[part].rows[-1][k] for part in node.terms), self._zero)
        if isinstance(node, Product):
            left, right = self._series[node.left], self._series[node.right]
            return product_coefficient(left, right, self._middle[node], k, self._zero)
        if isinstance(node, Power):
            return self._power(node, k, first_of_all)
        assert isinstance(node, FunctionOfOne)
        return self._start(node) if first_of_all else self._rotated(node, k)

    def _start(self, node: FunctionOfOne) -> Any:
        value = self._series[node.argument].rows[0][0]
        if isinstance(node, Exponential):
            return self._ring.exponential(value)
        if isinstance(node, Logarithm):
            return self._ring.logarithm(value)
        return self._ring.sine_cosine(value)[0 if isinstance(node, Sine) else 1]

    def _rotated(self, node: FunctionOfOne, k: int) -> Any:
        """In the first layer k f_k = sum of l u_l g_(k-l), later f_m = u_m g_0 + the complete part."""
        derivative, sign = partner(node)
        argument, other = self._series[node.argument].rows, self._series[derivative].rows[0]
        if self._layer:
            both = dot(argument[-1], other, k, self._zero)
            return entry(self._middle[node], k, self._zero) + (both if sign > 0 else -both)
        slopes = [value * self._ring.number(i) for i, value in enumerate(argument[0])]
        return dot(slopes, other, k, self._zero, first=1) * self._ring.number(fmpq(sign, k))

    def _power(self, node: Power, k: int, first_of_all: bool) -> Any:
        """From u f' = r u' f; the derivative is that of the layers, in the first layer that of t."""
        ring, zero = self._ring, self._zero
        base, own = self._series[node.base].rows, self._series[node].rows
        start = base[0][0]
        if first_of_all:
            return ring.power(start, node.exponent)
        if self._layer == 0:
            weighted = [value * ring.number((node.exponent * i - (k - i)) / k) for i, value in enumerate(base[0])]
            return dot(weighted, own[0], k, zero, first=1) / start
        known = entry(self._middle[node], k, zero) + dot(base[-1], own[0], k, zero) * ring.number(node.exponent)
        return (known - dot(base[0], own[-1], k, zero, first=1)) / start
