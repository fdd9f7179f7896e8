"""One straight-line code in three arithmetics: they agree, and give nothing where the function is singular."""

from __future__ import annotations

import random

import pytest
from flint import acb, arb, arb_series, fmpq

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
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import series_length, working_bits

x, y = Variable(0), Variable(1)
FUNCTIONS: list[list[Expression]] = [
    [x * y + Constant(fmpq(1, 3)), Sine(x) * Cosine(y)],
    [Power(x, fmpq(-2)) + y, Exponential(x * y)],
    [Power(x, fmpq(1, 2)) * y, Power(x + y, fmpq(-5, 3))],
    [Logarithm(x + y), Power(x, fmpq(3)) - Constant(fmpq(2))],
    [Constant(fmpq(7)), y],
]


@pytest.mark.parametrize("functions", FUNCTIONS)
def test_three_arithmetics(functions: list[Expression]) -> None:
    chance = random.Random(1)
    field = VectorField(functions)
    with working_bits(120), series_length(2):
        for _ in range(4):
            point = [arb(chance.randint(20, 60)) / 16 for _ in range(2)]
            slopes = [arb(chance.randint(-9, 9)) / 8 for _ in range(2)]
            values, rows = field.on_box(point)
            complex_values, complex_rows = field.on_complex_box([acb(value) for value in point])
            series, jacobian = field.series_with_jacobian(
                [arb_series([value, slope], 2) for value, slope in zip(point, slopes, strict=True)]
            )
            for i in range(2):
                assert values[i].is_finite()
                assert complex_values[i].real.overlaps(values[i])
                assert abs(complex_values[i].imag) < 1e-30
                terms = [*series[i].coeffs(), arb(0), arb(0)]
                assert terms[0].overlaps(values[i])
                # The chain rule: the series knows the slopes of f by its own recurrences.
                along = rows[i][0] * slopes[0] + rows[i][1] * slopes[1]
                assert along.is_finite()
                assert terms[1].overlaps(along)
                for j in range(2):
                    assert complex_rows[i][j].real.overlaps(rows[i][j])
                    assert [*jacobian[i][j].coeffs(), arb(0)][0].overlaps(rows[i][j])


@pytest.mark.parametrize("functions", FUNCTIONS)
def test_second_derivatives(functions: list[Expression]) -> None:
    """They enclose the divided differences of the Jacobian matrix (mean value theorem) on the box between."""
    field = VectorField(functions)
    with working_bits(120):
        first, second = [arb("1.5"), arb("2")], [arb("1.5"), arb("2.25")]
        table = field.second_derivatives([a.union(b) for a, b in zip(first, second, strict=True)])
        rows, others = field.on_box(first)[1], field.on_box(second)[1]
        for i in range(2):
            for j in range(2):
                quotient = (others[i][j] - rows[i][j]) * 4
                assert quotient.is_finite()
                assert table[i][j][1].is_finite()
                assert table[i][j][1].contains(quotient.mid()) or table[i][j][1].overlaps(quotient)
                assert table[i][j][0].overlaps(table[i][0][j])


def test_nothing_is_known_where_it_is_singular() -> None:
    with working_bits(80):
        for function in (Power(x, fmpq(-1)), Power(x, fmpq(1, 2)), Power(x, fmpq(2, 3)), Logarithm(x)):
            field = VectorField([function, y])
            assert not field.on_box([arb(0, 1), arb(1)])[0][0].is_finite()
            assert not field.on_complex_box([acb(arb(0, 1), arb(0, 1)), acb(1)])[0][0].is_finite()
            assert not field.values_on_complex_box([acb(arb(0, 1)), acb(1)])[0].is_finite()


def test_degrees_along_polynomials() -> None:
    """A sum or a product with one part that is no polynomial is none."""
    functions = [Constant(fmpq(7)), x * y + Constant(fmpq(1, 3)), Sine(x) + x, Sine(x) * y]
    field = VectorField([*functions, x + y])
    for _ in range(2):  # found, and kept
        assert field.degrees([2, 3, 0, 0, 0]) == [0, 5, None, None, 3]
    assert field.degrees([1, 1, 0, 0, 0]) == [0, 2, None, None, 1]


@pytest.mark.parametrize("functions", [[], [x + Variable(2), x], [y]])
def test_a_component_that_is_not_there(functions: list[Expression]) -> None:
    with pytest.raises(ValueError, match="functions of a state with component"):
        VectorField(functions)
