"""What the integrator chooses: laws of the choices, not their numbers, which may be any."""

from __future__ import annotations

import math
import random

import pytest
from flint import arb

from gspot_verified.integrator.box_steps.choice import (
    flow_step_length,
    limited_by_growth,
    log2_of,
    order_for,
    plan_for,
    scaled_curve,
    step_length,
    turned_basis,
    weights_for,
)
from gspot_verified.numbers.balls import working_bits


@pytest.mark.parametrize("value", ["1", "-1", "0.75", "1024", "-3e-40", "7e200"])
def test_the_binary_logarithm(value: str) -> None:
    with working_bits(60):
        found = log2_of(arb(value))
        assert abs(found - float(abs(arb(value)).log().mid()) / math.log(2)) < 1e-9
        assert log2_of(arb(value) * arb((1, 10**6))) == pytest.approx(found + 10**6)
        assert log2_of(arb(0)) == -1e9
        assert log2_of(arb("nan")) == math.inf


@pytest.mark.parametrize("ratio", [0.25, 1.0, 3.0])
def test_the_length_of_a_step(ratio: float) -> None:
    """Of a geometric series each of the last four terms is 2^-60 of the first one at most: of 20 terms the term 17."""
    with working_bits(60):
        row = [arb(5) * arb(ratio) ** k for k in range(21)]
        small = [value / 8 for value in row]
        assert step_length([row, small], 60) * ratio == pytest.approx(2 ** (-60 / 17), rel=1e-6)
        assert step_length([[arb(1)] + [arb(0)] * 20], 60) == 1024
        unit = [arb(1), *[arb(ratio) ** k for k in range(1, 13)]]
        assert flow_step_length([[unit]]) * ratio == pytest.approx(2 ** (-24 / 9), rel=1e-6)


def test_the_order_grows_with_the_precision() -> None:
    assert [order_for(bits) for bits in (1, 20, 100, 1000)] == [12, 12, 35, 350]


def test_weights_are_near_those_of_the_least_norm() -> None:
    """For entries >= 0 off the diagonal the least norm is the largest eigenvalue: here 1 + (4 * 9)^(1/2)."""
    weights, norm = weights_for([[arb(1), arb(4)], [arb(9), arb(1)]])
    assert norm == pytest.approx(7, rel=1e-2)
    assert weights[1] / weights[0] == pytest.approx(1.5, rel=1e-2)
    _, signed = weights_for([[arb(1), arb(-4)], [arb(9), arb(1)]])
    assert signed == norm
    assert weights_for([[arb("nan")]]) == ([1.0], 1.0)


def test_a_step_is_limited_by_the_growth_of_errors() -> None:
    narrow, wide, middle = [arb((1, -60))], [arb(1)], [arb((1, -6)), arb(0)]
    assert limited_by_growth(10.0, 2.0, narrow) == 4.0
    assert limited_by_growth(10.0, 2.0, wide) == 0.5
    assert limited_by_growth(10.0, 2.0, middle) == pytest.approx(1.5 * math.log(2))
    assert limited_by_growth(0.1, 2.0, wide) == 0.1
    assert limited_by_growth(10.0, 0.0, wide) == limited_by_growth(10.0, -3.0, wide) == 10.0


def test_a_curve_is_scaled_to_the_unit_step() -> None:
    """Coefficients times h^k, exact; the start stays as it is, and the flow starts at the unit matrix."""
    with working_bits(80):
        h = arb(3) / 7
        solution = [[arb(9), *(arb(k) for k in range(1, 5))], [arb(8), *(arb(-k) / 3 for k in range(1, 5))]]
        flow = [[[arb(7), arb(i + 2 * j + 1), arb(5)] for j in range(2)] for i in range(2)]
        middle = [arb(1) / 8, arb(-2)]
        curve = scaled_curve(solution, flow, middle, h)
        for p, row, start in zip(curve.solution, solution, middle, strict=True):
            assert p.coeffs()[0] == start
            for k in range(1, 5):
                assert p.coeffs()[k].is_exact()
                assert abs(p.coeffs()[k] - row[k] * h**k) < arb(2) ** -70
        for i in range(2):
            for j in range(2):
                coefficients = curve.flow[i][j].coeffs()
                assert len(coefficients) == 3 or (i == j) is False
                assert curve.flow[i][j](arb(0)) == int(i == j)
                for k in (1, 2):
                    assert abs(coefficients[k] - flow[i][j][k] * h**k) < arb(2) ** -70


def test_a_plan_has_room_for_what_is_expected() -> None:
    """The tube is at least 8 e times the deviations, the rounding errors and what the radius of h moves."""
    with working_bits(80):
        weights, middle, h = [1.0, 0.25], [arb(1), arb(-100)], arb(1) / 2
        for deviation, speed, step, least in [
            ([arb(0, 1) / 8, arb(0)], [arb(0), arb(0)], h, arb(1) / 8),
            ([arb(0), arb(0, 1) / 8], [arb(0), arb(0)], h, arb(1) / 2),
            ([arb(0), arb(0)], [arb(0), arb(-3)], arb(h.mid(), 0.01), arb("0.12")),
            ([arb(0), arb(0)], [arb(0), arb(0)], h, 404 * arb(2) ** -68),
        ]:
            for norm, factor in [(-1.0, 1.0), (0.0, 1.0), (2.0, math.e)]:
                plan = plan_for(weights, middle, deviation, speed, step, norm, 20)
                assert plan.tube.is_finite()
                assert 0.99 < float((plan.tube / (8 * arb(1).exp() * least * factor)).mid()) < 1.01
                assert [float(w.mid()) for w in plan.weights] == weights
                assert plan.disc == 4
                assert plan.length == 40 > 20
                assert plan.length // 2 <= plan.flow_length < plan.length


@pytest.mark.parametrize("size", [1, 2, 4])
def test_turned_directions_are_orthonormal_the_longest_first(size: int) -> None:
    chance = random.Random(size)
    columns = [[arb(chance.uniform(-1, 1)) for _ in range(size)] for _ in range(size)]
    radii = [arb((1, -5 * j)) for j in range(size)]
    for rows in (columns, [[arb(0)] * size for _ in range(size)], [[arb("nan")] * size for _ in range(size)]):
        found = [[float(entry.mid()) for entry in row] for row in turned_basis(rows, radii)]
        for a in range(size):
            for b in range(size):
                assert sum(found[i][a] * found[i][b] for i in range(size)) == pytest.approx(int(a == b), abs=1e-12)
    first = [float(row[0].mid()) for row in turned_basis(columns, radii)]
    along = sum(a * float(row[0].mid()) for a, row in zip(first, columns, strict=True))
    assert along == pytest.approx(math.hypot(*(float(row[0].mid()) for row in columns)))
    if size > 1:
        last = [float(row[0].mid()) for row in turned_basis(columns, radii[::-1])]
        along = sum(a * float(row[-1].mid()) for a, row in zip(last, columns, strict=True))
        assert along == pytest.approx(math.hypot(*(float(row[-1].mid()) for row in columns)))
