"""Expressions as a Python function of floats: for simulation only, nothing is bounded."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from gspot_verified.balls import approximate
from gspot_verified.expansion.expressions import (
    FUNCTION_NAMES,
    Constant,
    Expression,
    Power,
    Product,
    Sum,
    Variable,
    in_order,
)

FloatFunction = Callable[[Sequence[float]], list[float]]


def float_function(functions: Sequence[Expression]) -> FloatFunction:
    """The values of the functions at a state given by floats; shared parts are computed once.

    :raises TypeError: a constant that is no number.

    >>> from gspot_verified.expansion.expressions import Sine
    >>> x = Variable(0)
    >>> float_function([x * x, Sine(x)])([0.0])
    [0.0, 0.0]
    """
    names: dict[Expression, str] = {}
    lines = ["def run(x):"]
    for node in in_order(functions):
        names[node] = f"v{len(names)}"
        lines.append(f"    {names[node]} = {_line(node, [names[part] for part in node.parts()])}")
    lines.append(f"    return [{', '.join(names[function] for function in functions)}]")
    space: dict[str, object] = {"math": math}
    exec("\n".join(lines), space)
    made: FloatFunction = space["run"]  # type: ignore[assignment]
    return made


def _line(node: Expression, parts: Sequence[str]) -> str:
    match node:
        case Variable(index):
            return f"x[{index}]"
        case Constant(value):
            return repr(approximate(value))
        case Sum():
            return " + ".join(parts)
        case Product():
            return " * ".join(parts)
        case Power(_, exponent):
            return f"{parts[0]} ** {approximate(exponent)!r}"
    if type(node) in FUNCTION_NAMES:
        return f"math.{FUNCTION_NAMES[type(node)]}({parts[0]})"
    raise TypeError(f"no float function of a {type(node).__name__}")
