"""A named number in a formula: a parameter, a reference angle, or pi."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass

from gspot_verified.functions.expressions import Expression, Variable, in_order

PI = "pi"
SLIP_SPEED = "slip_speed"
"""The size of the slip velocity, in a formula of the friction coefficient."""


@dataclass(frozen=True, eq=False)
class Symbol(Expression):
    """A number that has a name and, in this formula, no value yet."""

    name: str

    def identity(self) -> tuple[Hashable, ...]:
        """The name."""
        return (self.name,)


def symbol_names(roots: Iterable[Expression]) -> set[str]:
    """The names of the symbols in the graphs.

    >>> symbol_names([Symbol("m") * Variable(0)])
    {'m'}
    """
    return {node.name for node in in_order(roots) if isinstance(node, Symbol)}


def variable_indices(roots: Iterable[Expression]) -> set[int]:
    """The components of the state in the graphs.

    >>> variable_indices([Symbol("m") * Variable(0)])
    {0}
    """
    return {node.index for node in in_order(roots) if isinstance(node, Variable)}


def count_operations(root: Expression) -> int:
    """How many operations a formula has; a part that occurs twice counts once.

    >>> count_operations(Symbol("m") * Variable(0) + Variable(1))
    2
    """
    return sum(max(1, len(node.parts()) - 1) for node in in_order([root]) if node.parts())
