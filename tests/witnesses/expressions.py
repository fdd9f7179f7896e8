"""Functions of the state in the numbers of another program, by a walk that shares no code with the package."""

from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any

import mpmath
import sympy
from flint import arb, fmpq

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
)

BALLS = SimpleNamespace(sin=arb.sin, cos=arb.cos, exp=arb.exp, log=arb.log)


def mp(value: Any) -> Any:
    """The number of mpmath next to an exact one."""
    value = fmpq(value)
    return mpmath.mpf(int(value.p)) / int(value.q)


def letter_number(value: Any) -> Any:
    """The number of sympy that is an exact one."""
    value = fmpq(value)
    return sympy.Rational(int(value.p), int(value.q))


def value_of(node: Expression, state: Sequence[Any], number: Callable[[Any], Any] = mp, program: Any = mpmath) -> Any:
    """The function at ``state``; ``number`` turns an exact number into one of the program that has the sines."""

    def of(part: Expression) -> Any:
        match part:
            case Constant(value):
                return number(value)
            case Variable(index):
                return state[index]
            case Sum(terms):
                return sum((of(term) for term in terms), number(0))
            case Product(left, right):
                return of(left) * of(right)
            case Power(base, exponent):
                return of(base) ** number(exponent)
            case Sine(argument):
                return program.sin(of(argument))
            case Cosine(argument):
                return program.cos(of(argument))
            case Exponential(argument):
                return program.exp(of(argument))
            case Logarithm(argument):
                return program.log(of(argument))
        raise TypeError(part)

    return of(node)
