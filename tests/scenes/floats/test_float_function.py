"""Expressions in floats, against Python's own arithmetic."""

from __future__ import annotations

import math

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.expressions import Constant, Cosine, Power, Product, Sine, Sum, Variable
from gspot_verified.scenes.floats.float_function import float_function

X, Y = Variable(0), Variable(1)
ANY = st.floats(min_value=0.125, max_value=8)


@given(ANY, ANY)
def test_each_kind_of_expression(x: float, y: float) -> None:
    third = Constant(fmpq(1, 3))
    shared = Sum((X, Y, third))
    functions = [
        third, X, Y, shared, Product(X, Y), Power(X, fmpq(-2)), Power(Y, fmpq(1, 2)), Sine(shared), Cosine(shared),
        Product(shared, shared), Constant(fmpq(-5)),
    ]  # fmt: skip
    total = x + y + 1 / 3
    expected = [1 / 3, x, y, total, x * y, x**-2, math.sqrt(y), math.sin(total), math.cos(total), total**2, -5.0]
    assert float_function(functions)([x, y]) == pytest.approx(expected, rel=1e-14)


def test_a_shared_part_is_computed_once_and_a_constant_may_be_a_ball() -> None:
    calls: list[int] = []

    class Counted(list[float]):
        def __getitem__(self, index: int) -> float:  # type: ignore[override]
            calls.append(index)
            return super().__getitem__(index)

    part = Sine(X)
    assert float_function([part, Product(part, part), Product(Constant(arb("0.5")), part)])(Counted([1.0])) == [
        math.sin(1.0),
        math.sin(1.0) ** 2,
        0.5 * math.sin(1.0),
    ]
    assert calls == [0]
    assert float_function([])([1.0]) == []
