"""Expressions as a Python function of floats: for simulation only, nothing is bounded."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.translation import Target, translated
from gspot_verified.numbers.balls import approximate

FloatFunction = Callable[[Sequence[float]], list[float]]


def float_function(functions: Sequence[Expression]) -> FloatFunction:
    """The values of the functions at a state given by floats; shared parts are computed once.

    :raises TypeError: a constant that is no number.

    >>> from gspot_verified.functions.expressions import Sine, Variable
    >>> x = Variable(0)
    >>> float_function([x * x, Sine(x)])([0.0])
    [0.0, 0.0]
    """
    lines = ["def run(x):"]

    def named(text: str) -> str:
        name = f"v{len(lines)}"
        lines.append(f"    {name} = {text}")
        return name

    target = Target(
        variable=lambda index: named(f"x[{index}]"),
        constant=lambda value: named(repr(approximate(value))),
        sum=lambda parts: named(" + ".join(parts)),
        product=lambda left, right: named(f"{left} * {right}"),
        power=lambda base, exponent: named(f"{base} ** {approximate(exponent)!r}"),
        function=lambda name, part: named(f"math.{name}({part})"),
    )
    results = translated(functions, target)
    lines.append(f"    return [{', '.join(results)}]")
    space: dict[str, object] = {"math": math}
    exec("\n".join(lines), space)
    made: FloatFunction = space["run"]  # type: ignore[assignment]
    return made
