"""Taylor coefficients of a solution and of its derivatives against the matrix exponential and a closed form."""

from __future__ import annotations

import math

import pytest
from flint import arb, arb_mat, fmpq

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.box_steps.approximation import taylor
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import working_bits

ROWS = [[1, -2, 3], [0, 1, 1], [5, 0, -1]]


@pytest.mark.parametrize("order", [0, 1, 2, 3, 7, 12, 17])
def test_a_linear_field_has_the_series_of_the_matrix_exponential(order: int) -> None:
    """A^k/k! in the derivatives, up to half the order at least, and A^k x/k! in the solution; all exact balls."""
    functions: list[Expression] = []
    for row in ROWS:
        a, b, c = (Constant(fmpq(entry)) * Variable(j) for j, entry in enumerate(row))
        functions.append(a + b + c)
    start = [arb(2), arb(-1), arb(3)]
    with working_bits(200):
        solution, flow = taylor(VectorField(functions), start, order)
        assert [len(row) for row in solution] == [order + 1] * 3
        known = {len(entry) for row in flow for entry in row}
        assert len(known) == 1
        assert (order + 1) // 2 <= min(known)
        power = arb_mat(3, 3, [int(i == j) for i in range(3) for j in range(3)])
        for k in range(order + 1):
            state = (power * arb_mat([[value] for value in start])).entries()
            for i in range(3):
                assert solution[i][k].is_exact()
                assert abs(solution[i][k] - state[i] / math.factorial(k)) < arb(2) ** -180
                for j in range(3 if k < min(known) else 0):
                    assert flow[i][j][k].is_exact()
                    assert abs(flow[i][j][k] - power[i, j] / math.factorial(k)) < arb(2) ** -180
            power = power * arb_mat(ROWS)


def test_a_quadratic_field() -> None:
    """x' = x^2 from 1/2: x = 1/(2 - t), and its derivative with respect to the start is 4/(2 - t)^2."""
    x = Variable(0)
    with working_bits(200):
        solution, flow = taylor(VectorField([x * x]), [arb(0.5)], 20)
        for k, value in enumerate(solution[0]):
            assert abs(value - arb(2) ** (-k - 1)) < arb(2) ** -180
        for k, value in enumerate(flow[0][0]):
            assert abs(value - (k + 1) * arb(2) ** -k) < arb(2) ** -180
