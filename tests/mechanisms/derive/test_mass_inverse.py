"""M^-1 in both ways, against exact linear algebra."""

from __future__ import annotations

import random

import pytest
from flint import fmpq, fmpq_mat

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.derivative import ONE, ZERO
from gspot_verified.functions.expressions import Expression, Power, Variable, in_order
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import RATIONALS
from gspot_verified.mechanisms.derive.mass_inverse import MassInverse, SingularMatrixError
from gspot_verified.mechanisms.formulas.simplify import constant, power_of, product_of, sum_of


def at(expressions: list[Expression], point: list[fmpq]) -> list[fmpq]:
    series = SeriesOfFunctions(expressions, NumberTerms(RATIONALS), RATIONALS)
    series.extend(point)
    return [series[expression][0] for expression in expressions]


@pytest.mark.parametrize("size", range(1, 8))
@pytest.mark.parametrize("dense", [True, False])
def test_against_exact_linear_algebra(size: int, dense: bool) -> None:
    """Entries are components of the state; the point makes the matrix diagonally dominant."""
    source = random.Random(size)
    index: dict[tuple[int, int], int] = {}
    rows: list[list[Expression]] = [[ZERO] * size for _ in range(size)]
    for i in range(size):
        for j in range(i + 1):
            if dense or i == j or (i + j) % 3 == 0:
                index[i, j] = len(index)
                rows[i][j] = rows[j][i] = Variable(index[i, j])
    point = [fmpq(0)] * len(index)
    for (i, j), k in index.items():
        point[k] = fmpq(source.randint(1, 9), 7) + (9 * size if i == j else 0)
    numbers = fmpq_mat([at(row, point) for row in rows])
    left, right = ([fmpq(source.randint(-9, 9), 5) for _ in range(size)] for _ in range(2))
    a, b = ([constant(value) for value in vector] for vector in (left, right))
    inverse = MassInverse(rows)
    wanted = numbers.solve(fmpq_mat(size, 1, right))
    assert at(inverse.times(b), point) == [wanted[i, 0] for i in range(size)]
    assert at([inverse.form(a, b)], point) == [sum((left[i] * wanted[i, 0] for i in range(size)), fmpq(0))]


def test_small_ones_divide_by_the_determinant_alone() -> None:
    rows = [[Variable(0), Variable(1), ZERO], [Variable(1), Variable(2), ONE], [ZERO, ONE, Variable(3)]]
    found = MassInverse(rows).form([ONE, ONE, ONE], [ONE, ZERO, Variable(4)])
    assert sum(isinstance(node, Power) and node.exponent < 0 for node in in_order([found])) == 1


@pytest.mark.parametrize("size", [2, 4])
def test_singular_for_every_state(size: int) -> None:
    s = Variable(0)
    rows = [[power_of(s, fmpq(i + j)) for j in range(size)] for i in range(size)]
    with pytest.raises(SingularMatrixError):
        MassInverse(rows)
    with pytest.raises(SingularMatrixError):
        MassInverse([[sum_of(s, product_of(constant(-1), s))]])
