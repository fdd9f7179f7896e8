"""The recurrences in integers against Newton's method on ball series, and functions that have no value at the start."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Sine,
    Variable,
)
from gspot_verified.integrator.box_steps.approximation import taylor
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.field.no_series import NoSeriesError
from gspot_verified.integrator.norm_steps.taylor_recurrence import TaylorRecurrence, _squared, fixed
from gspot_verified.numbers.balls import working_bits

x, y = Variable(0), Variable(1)
THIRD, BALL = Constant(fmpq(1, 3)), Constant(arb(3) / 8)
BITS = 200
FIELDS: list[list[Expression]] = [
    [Power(x, fmpq(1, 2)) * y, Power(y, fmpq(-1))],
    [Exponential(-y) * Sine(x) + Logarithm(x), Cosine(y + x) * Power(x, fmpq(5, 3))],
    [x * x * y - Constant(fmpq(7, 3)) * x, -(x * y) + Power(x, fmpq(-2))],
    [Constant(fmpq(1)), Constant(fmpq(1, 3)) * y + x],
    [Sine(THIRD) * x + Exponential(THIRD), Cosine(THIRD) + Logarithm(THIRD) * y],
    [Power(x + Constant(fmpq(1)), fmpq(2)), Sine(y) * Cosine(y) + Power(x, fmpq(2)) * Sine(x * y)],
    [Constant(fmpq(1, 7)), Power(x, fmpq(2)) + Power(Power(x, fmpq(2)), fmpq(2)) - x * Power(x, fmpq(2))],
    [Power(THIRD, fmpq(1, 2)) * y, Power(THIRD, fmpq(5, 3)) * x + Power(THIRD, fmpq(-1)) + Power(THIRD, fmpq(2))],
    [BALL * THIRD * y, (BALL * Constant(arb(5)) + THIRD) * x * y],
]


@pytest.mark.parametrize("functions", FIELDS)
@pytest.mark.parametrize("step", [fmpq(1), fmpq(3, 8)])
def test_against_newtons_method(functions: list[Expression], step: fmpq) -> None:
    with working_bits(BITS):
        known, _ = taylor(VectorField(functions), [arb(5) / 4, arb(2)], 20)
        start = [5 << (BITS - 2), 2 << BITS]
        length = (int(step.p) << BITS) // int(step.q)
        found = TaylorRecurrence(functions).coefficients(start, length, 20, BITS)
        for row, integers in zip(known, found, strict=True):
            assert len(integers) == 21
            for k, integer in enumerate(integers):
                value = arb(integer) * arb((1, -BITS))
                assert value.is_finite()
                assert abs(value - row[k] * arb(step) ** k) < arb(2) ** (50 - BITS)


@pytest.mark.parametrize("length", range(1, 8))
def test_a_square_is_a_product_of_equal_factors(length: int) -> None:
    """Each coefficient, whichever the last one is that does not vanish."""
    row = [3, -7, 11, 2**40 + 1, 5, -1, 9][:length] + [0] * (7 - length)
    for k in range(7):
        assert _squared(row[: k + 1], min(length - 1, k), k) == sum(row[j] * row[k - j] for j in range(k + 1))


@pytest.mark.parametrize("function", [Logarithm(x), Power(x, fmpq(1, 3)), Power(x, fmpq(1, 2)), Power(x, fmpq(-1))])
def test_no_value_at_the_start(function: Expression) -> None:
    start = 0 if function == Power(x, fmpq(-1)) else -(1 << 40)
    with pytest.raises(NoSeriesError):
        TaylorRecurrence([function]).coefficients([start], 1 << 40, 4, 40)


def test_a_state_too_large_for_the_precision_has_no_series() -> None:
    recurrence = TaylorRecurrence([Variable(0)])
    with pytest.raises(NoSeriesError, match="no bits are left"):
        recurrence.coefficients([1], 1, 4, -1)


def test_what_is_not_finite_has_no_series() -> None:
    assert fixed(arb(3), 4) == 48
    with pytest.raises(NoSeriesError, match="not finite"):
        fixed(arb("nan"), 4)


def test_an_operation_that_it_does_not_know_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    recurrence = TaylorRecurrence([x * y, x])
    monkeypatch.setattr(recurrence._code, "definition", lambda _name: ("tangent", ("x0",)))
    with pytest.raises(TypeError, match="no recurrence of tangent"):
        recurrence._compiled()
