"""Analytic functions of the state, as a graph of few operations whose power series have exact recurrences."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, fields
from typing import Any
from weakref import WeakValueDictionary

from flint import arb, fmpq

_KNOWN: WeakValueDictionary[tuple[Hashable, ...], Any] = WeakValueDictionary()


class _Shared(type):
    """Making an expression that exists gives the one that exists: comparing two never walks through their graphs."""

    def __call__(cls, *args: Any, **named: Any) -> Any:
        made = super().__call__(*args, **named)
        return _KNOWN.setdefault((cls, *made.identity()), made)


@dataclass(frozen=True, eq=False)
class Expression(metaclass=_Shared):
    """A function of the state. Expressions made alike are one object, so shared parts are found."""

    def identity(self) -> tuple[Hashable, ...]:
        """What tells this expression from others of its class; parts are told apart as objects."""
        return ()

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), tuple(getattr(self, field.name) for field in fields(self))

    def __add__(self, other: Expression) -> Expression:
        return Sum((self, other))

    def __sub__(self, other: Expression) -> Expression:
        return Sum((self, Product(Constant(fmpq(-1)), other)))

    def __neg__(self) -> Expression:
        return Product(Constant(fmpq(-1)), self)

    def __mul__(self, other: Expression) -> Expression:
        return Product(self, other)

    def __truediv__(self, other: Expression) -> Expression:
        return Product(self, Power(other, fmpq(-1)))

    def parts(self) -> tuple[Expression, ...]:
        """The expressions this one is made of."""
        return ()


@dataclass(frozen=True, eq=False)
class Constant(Expression):
    """A number of the ring: a rational, a ball, or a symbol such as chi."""

    value: Any

    def identity(self) -> tuple[Hashable, ...]:
        """The number; a ball equals nothing but itself."""
        if isinstance(self.value, arb):
            return (id(self.value),)
        if isinstance(self.value, fmpq):
            return _numbers(self.value)
        return (type(self.value).__name__, self.value)


@dataclass(frozen=True, eq=False)
class Variable(Expression):
    """The component ``index`` of the state."""

    index: int

    def identity(self) -> tuple[Hashable, ...]:
        """The index."""
        return (self.index,)


@dataclass(frozen=True, eq=False)
class Sum(Expression):
    """The sum of its terms."""

    terms: tuple[Expression, ...]

    def identity(self) -> tuple[Hashable, ...]:
        """The terms in their order."""
        return self.terms

    def parts(self) -> tuple[Expression, ...]:
        """The terms."""
        return self.terms


@dataclass(frozen=True, eq=False)
class Product(Expression):
    """The product of two expressions."""

    left: Expression
    right: Expression

    def identity(self) -> tuple[Hashable, ...]:
        """The factors in their order."""
        return (self.left, self.right)

    def parts(self) -> tuple[Expression, ...]:
        """The factors."""
        return (self.left, self.right)


@dataclass(frozen=True, eq=False)
class Power(Expression):
    """A rational power; the base must not vanish at the point of expansion unless the exponent is 0, 1, 2, ..."""

    base: Expression
    exponent: fmpq

    def identity(self) -> tuple[Hashable, ...]:
        """The base and the exponent."""
        return (self.base, *_numbers(self.exponent))

    @property
    def is_natural(self) -> bool:
        """Whether the exponent is 0, 1, 2, ..., so that the power is a product."""
        return bool(self.exponent.q == 1 and self.exponent >= 0)

    def parts(self) -> tuple[Expression, ...]:
        """The base."""
        return (self.base,)


@dataclass(frozen=True, eq=False)
class FunctionOfOne(Expression):
    """An elementary function of one argument."""

    argument: Expression

    def identity(self) -> tuple[Hashable, ...]:
        """The argument."""
        return (self.argument,)

    def parts(self) -> tuple[Expression, ...]:
        """The argument."""
        return (self.argument,)


class Sine(FunctionOfOne):
    """The sine."""


class Cosine(FunctionOfOne):
    """The cosine."""


class Exponential(FunctionOfOne):
    """The exponential."""


class Logarithm(FunctionOfOne):
    """The natural logarithm; the argument must be positive at the point of expansion."""


FUNCTION_NAMES: dict[type[Expression], str] = {Sine: "sin", Cosine: "cos", Exponential: "exp", Logarithm: "log"}
"""The functions of one argument, as formulas, ``math`` and sympy name them."""


def partner(node: FunctionOfOne) -> tuple[Expression, int]:
    """The derivative by the argument is sign g: g, and the sign.

    >>> partner(Cosine(Variable(0)))
    (Sine(argument=Variable(index=0)), -1)
    """
    match node:
        case Sine(argument):
            return Cosine(argument), 1
        case Cosine(argument):
            return Sine(argument), -1
        case Logarithm(argument):
            return Power(argument, fmpq(-1)), 1
    return node, 1


def _numbers(value: fmpq) -> tuple[int, int]:
    """Numerator and denominator: hashing them needs nothing that Python has given up when it shuts down."""
    return int(value.p), int(value.q)


def in_order(roots: Iterable[Expression]) -> list[Expression]:
    """All expressions that the roots are made of, each once, parts before wholes."""
    ordered: dict[Expression, None] = {}
    waiting = [(root, False) for root in roots]
    while waiting:
        node, ready = waiting.pop()
        if node in ordered:
            continue
        if ready:
            ordered[node] = None
        else:
            waiting.append((node, True))
            waiting += [(part, False) for part in node.parts()]
    return list(ordered)
