"""Rewrite graphs of expressions in the form of :mod:`simplify`: replaced parts, Lie derivatives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gspot_verified.functions.derivative import lie_derivative
from gspot_verified.functions.expressions import (
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Product,
    Sine,
    Sum,
    in_order,
)
from gspot_verified.mechanisms.formulas.simplify import (
    cosine_of,
    exponential_of,
    logarithm_of,
    power_of,
    product_of,
    sine_of,
    sum_of,
)


def rebuilt(node: Expression, made: Mapping[Expression, Expression]) -> Expression:
    """The node with its parts replaced, simplified."""
    match node:
        case Sum(terms):
            return sum_of(*(made[part] for part in terms))
        case Product(left, right):
            return product_of(made[left], made[right])
        case Power(base, exponent):
            return power_of(made[base], exponent)
        case Sine(argument):
            return sine_of(made[argument])
        case Cosine(argument):
            return cosine_of(made[argument])
        case Exponential(argument):
            return exponential_of(made[argument])
        case Logarithm(argument):
            return logarithm_of(made[argument])
    return node


def replaced(roots: Sequence[Expression], table: Mapping[Expression, Expression]) -> list[Expression]:
    """The functions with what the table says in the place of its keys, simplified.

    :raises ZeroDivisionError: something divides by zero then.
    :raises NoNumberError: a number becomes too large, or is not real.

    >>> from gspot_verified.functions.derivative import ZERO
    >>> from gspot_verified.functions.expressions import Variable
    >>> replaced([Sine(Variable(0))], {Variable(0): ZERO})
    [Constant(value=0)]
    """
    made: dict[Expression, Expression] = {}
    for node in in_order(roots):
        made[node] = table[node] if node in table else rebuilt(node, made)
    return [made[root] for root in roots]


def simplified(*roots: Expression) -> list[Expression]:
    """The same functions simplified."""
    return replaced(roots, {})


def along(field: Sequence[Expression], function: Expression) -> Expression:
    """The Lie derivative, simplified.

    >>> from gspot_verified.functions.expressions import Variable
    >>> from gspot_verified.mechanisms.formulas.simplify import constant
    >>> along([Variable(1), constant(-1)], Variable(0))
    Variable(index=1)
    """
    (derivative,) = simplified(lie_derivative(function, field))
    return derivative
