"""Analytic alphas (proofs/from_state.md, section 8): their Taylor polynomials and what these leave, beside mpmath."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from mpmath import mpf

from gspot_verified.expansion.chart.cone import Cone, rational_of
from gspot_verified.expansion.chart.taylor_rest import NoTaylorError
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.from_state.slow_manifold import RING, H, L, R
from gspot_verified.functions.ball_polynomials import constant
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
from gspot_verified.numbers.balls import ball, working_bits
from tests.expansion.from_state.test_barrier_numbers import in_mpmath, number

P, B, Y, V = (Variable(i) for i in range(4))


def rational(*value: int) -> Expression:
    return Constant(fmpq(*value))


ONE = rational(1)


def whole(alpha: Analytic, p: Any, b: Any, y: Any = 0 * L, v: Any = 0 * L) -> Any:
    """The Taylor polynomial where p, b, y, v are polynomials."""
    return constant(RING, alpha.value) + alpha.above((p, b, y, v))


def reach(p: fmpq, force: arb) -> Cone:
    """With y = v = 0."""
    return Cone(fmpq(0), p, fmpq(0), rational_of(force.upper()), fmpq(0), fmpq(0))


MOVING: list[tuple[Expression, Callable[..., mpf]]] = [
    (Sine(P + rational(2) * V) + Y * B - ONE, lambda p, b, y, v: mpmath.sin(p + 2 * v) + y * b - 1),
    (Power(ONE + P - B + V, fmpq(-1)) + Y, lambda p, b, y, v: 1 / (1 + p - b + v) + y),
    (Exponential(P * B + Y) * Cosine(V) + P * V, lambda p, b, y, v: mpmath.exp(p * b + y) * mpmath.cos(v) + p * v),
    (rational(3) * V * B - Y * rational(1, 7) + V * V, lambda _, b, y, v: 3 * v * b - y / 7 + v * v),
]


@pytest.mark.parametrize(("function", "value"), MOVING)
@pytest.mark.parametrize("order", [2, 3, 4])
def test_with_y_and_v_what_is_left_is_within_the_bound(
    function: Expression, value: Callable[..., mpf], order: int
) -> None:
    """At random states, and how far the polynomial is from the one with other y, v."""
    draw, alpha = random.Random(7), Analytic(function, order, "f")
    assert alpha.moves
    with mpmath.workdps(40), working_bits(128):
        given = Cone(fmpq(0), fmpq(1, 20), fmpq(0), fmpq(2), fmpq(3), fmpq(4))
        ((key, bound),) = alpha.rest(given).items()
        by_y, by_v = alpha.moved(given)
        assert key == (0, 2 * order)
        terms = whole(alpha, H, R, L, H * R * L**4).to_dict()

        def polynomial(p: mpf, b: mpf, y: mpf, v: mpf) -> mpf:
            total = mpf(0)
            for (i, j, k), c in terms.items():  # v alone makes h r L^4
                times = int(k) // 4
                total += number(fmpq(c)) * p ** (int(i) - times) * b ** (int(j) - times) * y ** (int(k) % 4) * v**times
            return total

        seen = mpf(0)
        for _ in range(200):
            p = mpf(draw.random()) / 20
            most = 2 * p, 3 * p**3, 4 * p**2
            b, y, v = (draw.choice([mpf(1), mpf(-1), mpf(draw.uniform(-1, 1))]) * one for one in most)
            left = abs(value(p, b, y, v) - polynomial(p, b, y, v))
            seen = max(seen, left / p**order)
            assert left <= in_mpmath(bound) * p**order * (1 + mpf(10) ** -30)
            other_y, other_v = y * draw.uniform(-1, 1), v * draw.uniform(-1, 1)
            sizes = [
                sum((in_mpmath(c) * p ** (mpf(int(n)) / 2) for (_, n), c in one.items()), mpf(0))
                for one in (by_y, by_v)
            ]
            moved = abs(polynomial(p, b, y, v) - polynomial(p, b, other_y, other_v))
            assert moved <= (sizes[0] * abs(y - other_y) + sizes[1] * abs(v - other_v)) * (1 + mpf(10) ** -30)
        assert in_mpmath(bound) < 100 * seen + mpf(10) ** -20


def test_only_weights_below_the_order_are_in_the_polynomial() -> None:
    """y has the weight 3, v the weight 2."""
    alpha = Analytic(ONE + Y * rational(2) + V * rational(3) + P * V + V * V + Y * P, 4, "f")
    assert whole(alpha, H, R, L, H * R * L**4) == 1 + 2 * L + 3 * H * R * L**4 + H**2 * R * L**4
    assert whole(Analytic(alpha.function, 3, "f"), H, R, L, H) == 1 + 3 * H
    assert whole(Analytic(alpha.function, 2, "f"), H, R, L, H) == RING.constant(1)
    for function in (Y, P * V):
        with pytest.raises(ValueError, match="at most 4"):
            Analytic(function - ONE, 5, "f")
    assert not Analytic(P - ONE, 5, "f").moves


CASES: list[tuple[Expression, Callable[[mpf, mpf], mpf]]] = [
    (Sine(P + rational(2) * B) - ONE, lambda p, b: mpmath.sin(p + 2 * b) - 1),
    (Power(ONE + P - B, fmpq(-1)), lambda p, b: 1 / (1 + p - b)),
    (Power(rational(4) + B, fmpq(1, 2)) * Cosine(P), lambda p, b: mpmath.sqrt(4 + b) * mpmath.cos(p)),
    (Exponential(P * B) + Logarithm(ONE + B), lambda p, b: mpmath.exp(p * b) + mpmath.log(1 + b)),
    (rational(3) * P * P * B - B * B + rational(1, 7), lambda p, b: 3 * p * p * b - b * b + mpf(1) / 7),
]


@pytest.mark.parametrize(("function", "value"), CASES)
@pytest.mark.parametrize("order", [2, 3, 5])
def test_the_polynomial_has_the_derivatives_of_the_function(
    function: Expression, value: Callable[[mpf, mpf], mpf], order: int
) -> None:
    """Coefficients of p^j b^k by mpmath; none is left out below the order, none is added."""
    with mpmath.workdps(60):
        found = whole(Analytic(function, order, "f"), H, R).to_dict()
        for j in range(order + 1):
            for k in range(order + 1 - j):
                wanted = mpmath.diff(value, (0, 0), (j, k)) / mpmath.factorial(j) / mpmath.factorial(k)
                coefficient = number(fmpq(found.pop((j, k, 0), fmpq(0))))
                assert abs(coefficient - (wanted if j + k < order else 0)) < mpf(10) ** -15
        assert not found


@pytest.mark.parametrize(("function", "value"), CASES)
@pytest.mark.parametrize("order", [2, 4])
@pytest.mark.parametrize("force", ["1/3", "5"])
def test_what_is_left_is_within_the_bound(
    function: Expression, value: Callable[[mpf, mpf], mpf], order: int, force: str
) -> None:
    """At random states with 0 <= p' <= p, |b| <= force p', and at the corners."""
    draw, most, alpha = random.Random(2), fmpq(1, 30), Analytic(function, order, "f")
    with mpmath.workdps(40), working_bits(128):
        ((key, bound),) = alpha.rest(reach(most, arb(fmpq(force)))).items()
        assert key == (0, 2 * order)
        polynomial = whole(alpha, H, R).to_dict()
        for _ in range(200):
            p = number(most) * draw.choice([mpf(1), mpf(draw.random())])
            b = number(fmpq(force)) * p * draw.choice([mpf(1), mpf(-1), mpf(draw.uniform(-1, 1))])
            part = sum((number(fmpq(c)) * p ** int(j) * b ** int(k) for (j, k, _), c in polynomial.items()), mpf(0))
            assert abs(value(p, b) - part) <= in_mpmath(bound) * p**order * (1 + mpf(10) ** -30)


def test_the_bound_is_attained() -> None:
    """2 b^2 + p^2 with |b| <= 3 p leaves at most 19 p^2; 1/(1 - p) leaves p^2/(1 - p), the bound is 1/(1 - p_1)^3."""
    square = Analytic(rational(2) * B * B + P * P, 2, "f").rest(reach(fmpq(1, 9), arb(3)))
    assert abs(square[0, 4] - 19) < arb("1e-6")
    tail = Analytic(Power(ONE - P, fmpq(-1)), 2, "f").rest(reach(fmpq(1, 2), arb(3)))
    assert abs(tail[0, 4] - 8) < arb("1e-6")


def test_the_bound_is_attained_by_powers_of_y_and_v() -> None:
    """y = Y' p^3, v = V' p^2, Y' = 2, V' = 3, b = 5 p: of (p + t)^n the coefficient of t^4 is that of a binomial."""
    most = fmpq(1, 7)
    given = Cone(fmpq(0), most, fmpq(0), fmpq(5), fmpq(2), fmpq(3))
    for function, factor, power in (
        (Y * Y, 4, 6),
        (V * V, 9, 4),
        (V * V * V, 27, 6),
        (Y * V, 6, 5),
        (P * Y, 2, 4),
        (B * Y, 10, 4),
        (P * P * V, 3, 4),
        (Y * Y * V, 12, 8),
    ):
        ((key, bound),) = Analytic(function, 4, "f").rest(given).items()
        wanted = factor * math.comb(power, 4) * most ** (power - 4)
        assert key == (0, 8)
        assert wanted * (1 - fmpq(1, 10**6)) <= bound <= wanted * (1 + fmpq(1, 10**6))


def test_a_polynomial_below_the_order_leaves_nothing() -> None:
    bound = Analytic(rational(3) * P * P * B - B * B - ONE, 4, "f").rest(reach(fmpq(1, 2), arb(7)))
    assert bound == {(0, 8): 0}


def test_where_p_and_b_are_polynomials() -> None:
    alpha = Analytic(Power(ONE - P, fmpq(-1)) + B * B * B, 3, "f")
    assert whole(alpha, R * R, H - L) == 1 + R**2 + R**4
    cubic = Analytic(B * B * B - ONE, 4, "b^3 - 1")
    assert whole(cubic, R, H + 2) == (H + 2) ** 3 - RING.constant(1)
    assert (cubic.value, cubic.expression, cubic.text) == (-1, cubic.function, "b^3 - 1")
    assert alpha.value == 1


@pytest.mark.parametrize("pole", [fmpq(1, 10), fmpq(-1, 10), fmpq(1, 7)])
def test_a_box_that_may_hold_a_pole_is_refused(pole: fmpq) -> None:
    """1/(pole - b) and log(pole - b), |b| <= 2 p, on both sides of the edge p = |pole|/2."""
    inverse = Power(Constant(pole) - B, fmpq(-1))
    scaled = Logarithm((Constant(abs(pole)) - B) * Power(Constant(abs(pole)), fmpq(-1)))
    for function in (inverse, scaled):
        alpha = Analytic(function, 3, "f")
        with pytest.raises(NoTaylorError):
            alpha.rest(reach(abs(pole) / 2, arb(2)))
        assert alpha.rest(reach(abs(pole) * fmpq(49, 100), arb(2)))[0, 6].is_finite()


@pytest.mark.parametrize(
    ("function", "value"),
    [
        (Exponential(ONE + P) * B - ONE, lambda p, b: mpmath.exp(1 + p) * b - 1),
        (Power(rational(2) + P * B, fmpq(1, 2)) + B, lambda p, b: mpmath.sqrt(2 + p * b) + b),
        (Sine(P + ONE) * Cosine(B - ONE), lambda p, b: mpmath.sin(p + 1) * mpmath.cos(b - 1)),
        (Constant(arb("1.5", "1e-30")) * P * P + B, lambda p, b: mpf("1.5") * p * p + b),
    ],
)
def test_coefficients_that_are_not_rational_lie_in_balls(
    function: Expression, value: Callable[[mpf, mpf], mpf]
) -> None:
    alpha = Analytic(function, 4, "f")
    assert not alpha.is_exact
    with mpmath.workdps(60), working_bits(200):
        found = whole(alpha, H, R).to_dict()
        for j in range(4):
            for k in range(4 - j):
                wanted = mpmath.diff(value, (0, 0), (j, k)) / mpmath.factorial(j) / mpmath.factorial(k)
                coefficient = ball(found.pop((j, k, 0), fmpq(0)))
                assert abs(in_mpmath(coefficient.mid()) - wanted) <= in_mpmath(coefficient.rad()) + mpf(10) ** -15
                assert coefficient.rad() < arb("1e-29")
        assert not found


@pytest.mark.parametrize("function", [Power(P, fmpq(-1)), Logarithm(P), Power(B, fmpq(1, 2))])
def test_without_a_taylor_polynomial_it_is_refused(function: Expression) -> None:
    with pytest.raises(ValueError, match=r"vanish|positive"):
        Analytic(function, 3, "f")


@pytest.mark.parametrize("order", [1, 0, -2])
def test_an_order_below_two_is_refused(order: int) -> None:
    with pytest.raises(ValueError, match="at least 2"):
        Analytic(P - ONE, order, "f")
