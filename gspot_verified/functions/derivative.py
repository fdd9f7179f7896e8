"""Exact differentiation and substitution in graphs of expressions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from flint import fmpq

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
    partner,
)

ZERO, ONE = Constant(fmpq(0)), Constant(fmpq(1))


def lie_derivative(expression: Expression, field: Sequence[Expression]) -> Expression:
    """The derivative along a vector field: the sum of (d expression/d xi_i) field_i.

    >>> x, y = Variable(0), Variable(1)
    >>> lie_derivative(Sine(y), (x, ONE))
    Cosine(argument=Variable(index=1))
    """
    slopes: dict[Expression, Expression] = {}
    for node in in_order([expression]):
        slopes[node] = field[node.index] if isinstance(node, Variable) else _slope(node, slopes)
    return slopes[expression]


def partial_derivative(expression: Expression, index: int, dimension: int) -> Expression:
    """The derivative with respect to one component of the state.

    >>> partial_derivative(Variable(0) * Variable(1), 0, 2)
    Variable(index=1)
    """
    return lie_derivative(expression, [ONE if i == index else ZERO for i in range(dimension)])


def substitute(expression: Expression, values: Sequence[Expression]) -> Expression:
    """The expression with ``values[i]`` in the place of component i of the state.

    >>> substitute(Sine(Variable(0)), [Variable(2)])
    Sine(argument=Variable(index=2))
    """
    return rewritten([expression], lambda node: values[node.index] if isinstance(node, Variable) else None)[expression]


def rewritten(
    roots: Sequence[Expression], rule: Callable[[Expression], Expression | None]
) -> dict[Expression, Expression]:
    """All nodes of the graphs, each with its parts rewritten and then replaced by what the rule says (None: kept)."""
    made: dict[Expression, Expression] = {}
    for node in in_order(roots):
        rebuilt = _with_parts(node, made)
        changed = rule(rebuilt)
        made[node] = rebuilt if changed is None else changed
    return made


def powers_as_products(roots: Sequence[Expression]) -> dict[Expression, Expression]:
    """All nodes of the graphs, each with the powers 0, 1, 2, ... in it written as products: their bases may vanish."""
    return rewritten(roots, _as_product)


def _as_product(node: Expression) -> Expression | None:
    if not (isinstance(node, Power) and node.is_natural):
        return None
    power: Expression = ONE
    for digit in f"{int(node.exponent.p):b}":
        power = times(power, power)
        if digit == "1":
            power = times(power, node.base)
    return power


def _with_parts(node: Expression, made: Mapping[Expression, Expression]) -> Expression:
    match node:
        case Sum(terms):
            return plus(*(made[part] for part in terms))
        case Product(left, right):
            return times(made[left], made[right])
        case Power(base, _):
            return replace(node, base=made[base])
        case Sine(argument) | Cosine(argument) | Exponential(argument) | Logarithm(argument):
            return replace(node, argument=made[argument])
    return node


def _slope(node: Expression, slopes: Mapping[Expression, Expression]) -> Expression:
    match node:
        case Sum(terms):
            return plus(*(slopes[part] for part in terms))
        case Product(left, right):
            return plus(times(slopes[left], right), times(left, slopes[right]))
        case Power(base, exponent):
            lowered = base if exponent == 2 else ONE if exponent == 1 else Power(base, exponent - 1)
            return times(times(Constant(exponent), lowered), slopes[base]) if exponent != 0 else ZERO
        case Sine(argument) | Cosine(argument) | Exponential(argument) | Logarithm(argument):
            derivative, sign = partner(node)
            return times(times(Constant(fmpq(sign)), derivative), slopes[argument])
    return ZERO


def plus(*terms: Expression) -> Expression:
    """The sum, without zeros."""
    kept = tuple(term for term in terms if not _is(term, 0))
    if len(kept) == 1:
        return kept[0]
    return Sum(kept) if kept else ZERO


def times(left: Expression, right: Expression) -> Expression:
    """The product, without factors 1; zero when a factor is."""
    if _is(left, 0) or _is(right, 0):
        return ZERO
    if _is(left, 1):
        return right
    return left if _is(right, 1) else Product(left, right)


def _is(expression: Expression, value: int) -> bool:
    return isinstance(expression, Constant) and bool(expression.value == value)
