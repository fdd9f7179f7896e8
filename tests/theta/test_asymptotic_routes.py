"""The enveloping series (negative), the saddle point (positive), the Laplace integral: their bounds by value."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import near_integers, small_heights, to_fmpq
from witness import contains_witness, laplace_witness, theta_witness

from gspot_verified.balls import relative_bits
from gspot_verified.theta.finite_part import near_integers as integers_next_to
from gspot_verified.theta.finite_part import series_part, weight
from gspot_verified.theta.integer import polynomial_value
from gspot_verified.theta.laplace import LaplacePlan, laplace_sum
from gspot_verified.theta.negative import negative_sum
from gspot_verified.theta.positive import SaddlePlan, positive_sum

_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 20)


@given(st.integers(2, 30), _BETAS, st.integers(1, 30))
def test_enveloping_series_contains_the_witness(x: int, beta: Fraction, terms: int) -> None:
    value = negative_sum(fmpq(-x), to_fmpq(beta), terms, 300)
    if 3 * terms <= beta:
        assert not value.is_finite()
    else:
        assert value.is_finite()
        assert contains_witness(value, theta_witness(Fraction(-x), beta), 58)


@given(st.integers(2, 20), st.integers(0, 12), st.integers(0, 12))
def test_enveloping_series_at_integers_is_the_polynomial(x: int, n: int, extra: int) -> None:
    value = negative_sum(fmpq(-x), fmpq(n), n // 3 + 1 + extra, 300)
    exact = polynomial_value(fmpq(-x), n)
    assert relative_bits(value) > 200
    assert value.contains(exact) or value.overlaps(arb(exact))


def test_enveloping_series_wants_tau_certainly_negative() -> None:
    assert not negative_sum(arb(0, 1), fmpq(1, 2), 5, 100).is_finite()
    assert not negative_sum(fmpq(1), fmpq(1, 2), 5, 100).is_finite()
    assert not negative_sum(fmpq(-5), arb(15, 1), 5, 100).is_finite()


_DISCS = st.integers(5, 80).map(lambda n: fmpq(n, 100))


@given(st.integers(9, 40), _BETAS, st.integers(1, 25), _DISCS, st.integers(1, 100))
def test_saddle_point_contains_the_witness(tau: int, beta: Fraction, terms: int, disc: fmpq, share: int) -> None:
    plan = SaddlePlan(terms, disc, min(1 - disc, fmpq(9, 20)), fmpq(share, 101))
    value = positive_sum(fmpq(tau), to_fmpq(beta), plan, 400)
    assume(value.is_finite())
    assert contains_witness(value, theta_witness(Fraction(tau), beta), 58)


@pytest.mark.parametrize(
    "plan",
    [
        SaddlePlan(0, fmpq(1, 2), fmpq(1, 4)),
        SaddlePlan(5, fmpq(1), fmpq(1, 4)),
        SaddlePlan(5, fmpq(1, 2), fmpq(3, 5)),
        SaddlePlan(5, fmpq(1, 2), fmpq(0)),
        SaddlePlan(5, fmpq(1, 2), fmpq(1, 4), fmpq(1)),
        SaddlePlan(500, fmpq(1, 2), fmpq(1, 4)),  # lambda sigma^2 < 2N
        SaddlePlan(5, fmpq(-1, 2), fmpq(1, 4)),
    ],
)
def test_saddle_point_refuses_a_plan_outside_its_hypotheses(plan: SaddlePlan) -> None:
    assert not positive_sum(fmpq(20), fmpq(1, 2), plan, 100).is_finite()


def test_saddle_point_wants_tau_certainly_positive() -> None:
    plan = SaddlePlan(3, fmpq(1, 2), fmpq(1, 4))
    assert not positive_sum(arb(1, 2), fmpq(1, 2), plan, 100).is_finite()
    assert not positive_sum(fmpq(-20), fmpq(1, 2), plan, 100).is_finite()
    # beta so negative that 2 lambda sigma > -beta - 1 fails
    assert not positive_sum(fmpq(9), fmpq(-1000), plan, 100).is_finite()


@given(st.integers(10, 30), st.integers(0, 10))
def test_saddle_point_at_integers_is_the_polynomial(tau: int, n: int) -> None:
    value = positive_sum(fmpq(tau), fmpq(n), SaddlePlan(3, fmpq(1, 2), fmpq(1, 4)), 200)
    assert relative_bits(value) > 150
    assert value.overlaps(arb(polynomial_value(fmpq(tau), n)))


@given(st.integers(-60, 24), _BETAS, st.integers(1, 8), st.integers(20, 60))
def test_laplace_integral_contains_the_witness(tau: int, beta: Fraction, cut: int, terms: int) -> None:
    point = Fraction(tau, 4)
    plan = LaplacePlan(fmpq(cut, 4), fmpq(12), 2 * terms, fmpq(1))
    value = laplace_sum(to_fmpq(point), to_fmpq(beta), plan, 160)
    assert value.is_finite()
    assert contains_witness(value, theta_witness(point, beta), 58)


@pytest.mark.parametrize(
    "plan",
    [
        LaplacePlan(fmpq(0), fmpq(5), 30, fmpq(1)),
        LaplacePlan(fmpq(3), fmpq(2), 30, fmpq(1)),
        LaplacePlan(fmpq(1), fmpq(2), 30, fmpq(1)),  # R^2 <= tau
        LaplacePlan(fmpq(1), fmpq(9), 30, fmpq(0)),
        LaplacePlan(fmpq(1), fmpq(9), 3, fmpq(1)),  # beta > terms - 1
    ],
)
def test_laplace_integral_refuses_a_plan_outside_its_hypotheses(plan: LaplacePlan) -> None:
    assert not laplace_sum(fmpq(5), fmpq(7, 2), plan, 100).is_finite()


@pytest.mark.parametrize(("tau", "beta"), [(-3, Fraction(-1, 2)), (0, Fraction(-7, 3)), (4, Fraction(-5, 4))])
def test_laplace_integral_against_another_quadrature(tau: int, beta: Fraction) -> None:
    plan = LaplacePlan(fmpq(1, 2), fmpq(12), 80, fmpq(1))
    value = laplace_sum(fmpq(tau), to_fmpq(beta), plan, 160)
    assert relative_bits(value) > 100
    assert contains_witness(value, laplace_witness(Fraction(tau), beta), 28)


def test_few_evaluations_give_a_wide_ball_and_no_error() -> None:
    value = laplace_sum(fmpq(-3), fmpq(-1, 2), LaplacePlan(fmpq(1, 2), fmpq(12), 80, fmpq(1), 1), 160)
    assert not value.is_finite() or relative_bits(value) < 100


@given(st.integers(0, 30), st.one_of(small_heights(), near_integers(20)))
def test_weights_by_their_two_forms(n: int, beta: Fraction) -> None:
    b = to_fmpq(beta)
    assume(b != n)
    value = weight(n, b, 200)
    quotient = arb(-b).rgamma() / (n - b)
    assert value.is_finite()
    assert quotient.is_finite()
    assert value.overlaps(quotient)


def test_integers_next_to_a_ball() -> None:
    assert list(integers_next_to(fmpq(-3))) == []
    assert 2 in integers_next_to(fmpq(7, 3))
    assert set(range(1, 5)) <= set(integers_next_to(arb(fmpq(5, 2), fmpq(3, 2))))
    assert 0 in integers_next_to(fmpq(-1, 2))


def test_finite_part_wants_a_certain_cut() -> None:
    assert not series_part(fmpq(1), fmpq(1, 2), arb(0, 1), 20, 100).is_finite()
