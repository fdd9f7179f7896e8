"""One translation for all targets: what every node becomes, shared parts once, what has no form refused."""

from __future__ import annotations

import math
import operator

import pytest
from flint import fmpq

from gspot_verified.functions.expressions import Constant, Cosine, Exponential, Expression, Power, Sine, Variable
from gspot_verified.functions.translation import Target, translated

x, y = Variable(0), Variable(1)


def in_floats(functions: list[Expression], at: tuple[float, float]) -> list[float]:
    target = Target(
        variable=lambda index: at[index],
        constant=lambda value: int(value.p) / int(value.q),
        sum=sum,
        product=operator.mul,
        power=lambda base, exponent: base ** (int(exponent.p) / int(exponent.q)),
        function=lambda name, part: getattr(math, name)(part),
    )
    return translated(functions, target)


def test_every_kind_of_node() -> None:
    a, b = 0.75, 2.5
    half = Constant(fmpq(1, 2))
    found = in_floats([Sine(x) + Cosine(y) * half, Power(y, fmpq(-3, 2)), Exponential(x * y), x], (a, b))
    expected = [math.sin(a) + math.cos(b) / 2, b**-1.5, math.exp(a * b), a]
    assert found == pytest.approx(expected, rel=1e-15)


def test_a_shared_part_is_translated_once() -> None:
    made: list[str] = []

    def function(name: str, part: str) -> str:
        made.append(name)
        return f"{name}({part})"

    words = Target("x{}".format, str, " + ".join, "{}*{}".format, "{}^{}".format, function)
    shared = Sine(x)
    assert translated([shared * shared, shared], words) == ["sin(x0)*sin(x0)", "sin(x0)"]
    assert made == ["sin"]


def test_what_has_no_form_is_refused() -> None:
    class Other(Variable):
        pass

    class Strange(Expression):
        pass

    assert in_floats([Other(0)], (1.5, 0.0)) == [1.5]
    with pytest.raises(TypeError, match="no form of a Strange"):
        in_floats([Strange()], (0.0, 0.0))
