"""Expressions in the words of another library: each node once, after its parts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn

from flint import fmpq

from gspot_verified.functions.expressions import (
    FUNCTION_NAMES,
    Constant,
    Expression,
    Power,
    Product,
    Sum,
    Variable,
    in_order,
)


def unknown(node: Expression) -> NoReturn:
    """For a target without other nodes.

    :raises TypeError: always.
    """
    raise TypeError(f"no form of a {type(node).__name__}")


@dataclass(frozen=True)
class Target:
    """What stands for each kind of node; a function by its name (sin, cos, exp, log), the rest by ``other``."""

    variable: Callable[[int], Any]
    constant: Callable[[Any], Any]
    sum: Callable[[Sequence[Any]], Any]
    product: Callable[[Any, Any], Any]
    power: Callable[[Any, fmpq], Any]
    function: Callable[[str, Any], Any]
    other: Callable[[Expression], Any] = unknown


def translated(functions: Sequence[Expression], target: Target) -> list[Any]:
    """The functions in the target's words; shared parts are translated once.

    >>> from gspot_verified.functions.expressions import Sine
    >>> words = Target(
    ...     variable="x{}".format, constant=str, sum=" + ".join, product="{}*{}".format, power="{}^{}".format,
    ...     function="{}({})".format,
    ... )
    >>> translated([Sine(Variable(0) * Variable(1)) + Constant(fmpq(1, 2))], words)
    ['sin(x0*x1) + 1/2']
    """
    made: dict[Expression, Any] = {}
    for node in in_order(functions):
        made[node] = _one(node, [made[part] for part in node.parts()], target)
    return [made[function] for function in functions]


def _one(node: Expression, parts: Sequence[Any], target: Target) -> Any:
    match node:
        case Variable(index):
            return target.variable(index)
        case Constant(value):
            return target.constant(value)
        case Sum():
            return target.sum(parts)
        case Product():
            return target.product(*parts)
        case Power(_, exponent):
            return target.power(parts[0], exponent)
    if type(node) in FUNCTION_NAMES:
        return target.function(FUNCTION_NAMES[type(node)], parts[0])
    return target.other(node)
