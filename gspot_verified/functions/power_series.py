"""Power series in delta of functions of the state, one order at a time.

Each operation has its recurrence (differentiate with respect to delta; for powers this is Euler's rule): the term of
order n needs the terms of its parts up to order n. The terms may be polynomials in s or plain numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from flint import fmpq

from gspot_verified.functions.convolution import Convolution, Series, Weights
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.functions.rings import Ring


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

    def convolution(self, left: Series, right: Series, weights: Weights | None = None) -> Convolution:
        """The terms of the product of two series."""
        ...

    def is_zero(self, term: Any) -> bool:
        """Whether the term vanishes, so that its products can be left out."""
        ...

    def at_start(self, term: Any) -> Any:
        """The number that a term of order 0 is."""
        ...


Rule = Callable[[int], Any]
"""The term of order n of one function, from the terms of its parts."""


class SeriesOfFunctions:
    """The series of several functions of the state; :meth:`extend` adds one order."""

    def __init__(self, roots: Sequence[Expression], terms: Terms, numbers: Ring) -> None:
        self._terms, self._numbers = terms, numbers
        self._state: Sequence[Any] = ()
        self._order = 0
        made: dict[Expression, Series] = {}
        companions: list[Expression] = [
            Cosine(e.argument) if isinstance(e, Sine) else Sine(e.argument)
            for e in in_order(roots)
            if isinstance(e, Sine | Cosine)
        ]
        companions += [Power(e.argument, fmpq(-1)) for e in in_order(roots) if isinstance(e, Logarithm)]
        for node in in_order([*roots, *companions]):
            made[node] = Series(terms.is_zero)
        self._steps: list[tuple[Series, Rule]] = []
        self._convolutions: list[Convolution] = []
        for node, series in made.items():
            rule = self._rule(node, series, made)
            self._steps.append((series, rule))
        self._roots = {root: made[root] for root in roots}

    def __getitem__(self, root: Expression) -> list[Any]:
        """The terms found so far; the list grows with each order."""
        return self._roots[root].terms

    def series(self, root: Expression) -> Series:
        """The terms found so far as a series, which grows with each order."""
        return self._roots[root]

    def extend(self, state: Sequence[Any]) -> None:
        """Add the next order, ``state`` being the terms of that order of the components of the state."""
        self._state = state
        n = self._order
        for series, rule in self._steps:
            series.append(rule(n))
        self._order += 1

    def drop_last(self) -> None:
        """Forget the last order."""
        self._order -= 1
        for series, _ in self._steps:
            series.drop_last()
        for convolution in self._convolutions:
            convolution.forget(self._order)

    def _rule(self, node: Expression, own: Series, made: dict[Expression, Series]) -> Rule:
        match node:
            case Variable(index):
                return lambda _: self._state[index]
            case Constant(value):
                return lambda n: self._terms.zero(n) if n else self._terms.constant(value)
            case Sum(parts):
                series = [made[part] for part in parts]
                return lambda n: self._sum(series, n)
            case Product(left, right):
                return self._convolution(made[left], made[right])
            case Power(base, exponent) if node.is_natural:
                return self._natural_power(made[base], int(exponent.p))
            case Power(base, exponent):
                return self._power(made[base], own, exponent)
            case Sine(argument):
                return self._rotated(made[argument], made[Cosine(argument)], 1, lambda x: self._sine_cosine(x)[0])
            case Cosine(argument):
                return self._rotated(made[argument], made[Sine(argument)], -1, lambda x: self._sine_cosine(x)[1])
            case Exponential(argument):
                return self._rotated(made[argument], own, 1, self._numbers.exponential)
            case Logarithm(argument):
                return self._rotated(made[argument], made[Power(argument, fmpq(-1))], 1, self._numbers.logarithm)
            case _:
                raise TypeError(f"no rule for {type(node).__name__}")

    def _sine_cosine(self, value: Any) -> tuple[Any, Any]:
        return self._numbers.sine_cosine(value)

    def _sum(self, parts: list[Series], n: int) -> Any:
        total = self._terms.zero(n)
        for part in parts:
            if n in part.nonzero:
                total = total + part.nonzero[n]
        return total

    def _convolution(self, left: Series, right: Series, weights: Weights | None = None) -> Convolution:
        self._convolutions.append(self._terms.convolution(left, right, weights))
        return self._convolutions[-1]

    def _natural_power(self, base: Series, exponent: int) -> Rule:
        """A product of equal factors, which may vanish at the point; the partial products are series of their own."""
        if exponent == 0:
            return lambda n: self._terms.zero(n) if n else self._terms.constant(1)
        power = base
        for _ in range(exponent - 1):
            longer = Series(self._terms.is_zero)
            self._steps.append((longer, self._convolution(power, base)))
            power = longer
        return lambda n: power.terms[n]

    def _power(self, base: Series, own: Series, exponent: fmpq) -> Rule:
        """f = u^r: u f' = r u' f gives n u_0 f_n = sum over k >= 1 of (r k - (n - k)) u_k f_(n-k)."""
        known = self._convolution(base, own, (exponent, fmpq(-1)))  # f_n is not known yet: k >= 1

        def term(n: int) -> Any:
            start = self._terms.at_start(base.terms[0])
            if n == 0:
                return self._terms.constant(self._numbers.power(start, exponent))
            return self._terms.scale(known(n), self._numbers.number(fmpq(1, n)) / start)

        return term

    def _rotated(self, argument: Series, other: Series, sign: int, value: Callable[[Any], Any]) -> Rule:
        """f' = sign u' g, so n f_n = sign sum over k of k u_k g_(n-k); f_0 is ``value`` of u_0."""
        known = self._convolution(argument, other, (fmpq(sign), fmpq(0)))

        def term(n: int) -> Any:
            if n == 0:
                return self._terms.constant(value(self._terms.at_start(argument.terms[0])))
            return self._terms.scale(known(n), self._numbers.number(fmpq(1, n)))

        return term
