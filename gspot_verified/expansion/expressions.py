"""Analytic functions of the state, as a graph of few operations whose power series have exact recurrences."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from flint import fmpq


@dataclass(frozen=True)
class Expression:
    """A function of the state. Equal expressions are equal objects for a dictionary, so shared parts are found."""

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


@dataclass(frozen=True)
class Constant(Expression):
    """A number of the ring: a rational, a ball, or a symbol such as chi."""

    value: Any

    def __hash__(self) -> int:
        try:
            return hash(self.value)
        except ValueError:  # flint's answer for a ball that is not exact, which equals nothing but itself
            return id(self.value)


@dataclass(frozen=True)
class Variable(Expression):
    """The component ``index`` of the state."""

    index: int


@dataclass(frozen=True)
class Sum(Expression):
    """The sum of its terms."""

    terms: tuple[Expression, ...]

    def parts(self) -> tuple[Expression, ...]:
        """The terms."""
        return self.terms


@dataclass(frozen=True)
class Product(Expression):
    """The product of two expressions."""

    left: Expression
    right: Expression

    def parts(self) -> tuple[Expression, ...]:
        """The factors."""
        return (self.left, self.right)


@dataclass(frozen=True)
class Power(Expression):
    """A rational power; the base must not vanish at the point of expansion unless the exponent is 0, 1, 2, ..."""

    base: Expression
    exponent: fmpq

    @property
    def is_natural(self) -> bool:
        """Whether the exponent is 0, 1, 2, ..., so that the power is a product."""
        return bool(self.exponent.q == 1 and self.exponent >= 0)

    def parts(self) -> tuple[Expression, ...]:
        """The base."""
        return (self.base,)


@dataclass(frozen=True)
class Sine(Expression):
    """The sine."""

    argument: Expression

    def parts(self) -> tuple[Expression, ...]:
        """The argument, and the cosine that its series needs."""
        return (self.argument,)


@dataclass(frozen=True)
class Cosine(Expression):
    """The cosine."""

    argument: Expression

    def parts(self) -> tuple[Expression, ...]:
        """The argument."""
        return (self.argument,)


@dataclass(frozen=True)
class Exponential(Expression):
    """The exponential."""

    argument: Expression

    def parts(self) -> tuple[Expression, ...]:
        """The argument."""
        return (self.argument,)


def _remember_hash(cls: Any) -> None:
    """Compute the hash of an object once: that of a whole asks for those of its parts, which may be shared."""
    computed = cls.__hash__

    def remembered(self: Any) -> int:
        value = self.__dict__.get("_hash")
        if value is None:
            value = computed(self)
            object.__setattr__(self, "_hash", value)
        return int(value)

    cls.__hash__ = remembered


for _class in (Constant, Variable, Sum, Product, Power, Sine, Cosine, Exponential):
    _remember_hash(_class)


def in_order(roots: Iterable[Expression]) -> list[Expression]:
    """All expressions that the roots are made of, each once, parts before wholes."""
    found: dict[Expression, None] = {}
    waiting = [(root, False) for root in roots]
    while waiting:
        node, ready = waiting.pop()
        if node in found:
            continue
        if ready:
            found[node] = None
        else:
            waiting.append((node, True))
            waiting += [(part, False) for part in node.parts()]
    return list(found)
