"""The Laplace integral by quadrature.

Page: proofs/laplace.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights, to_fmpq
from witnesses.theta import contains_witness, laplace_witness, theta_witness

from gspot_verified.numbers.balls import relative_bits
from gspot_verified.theta_function.sums.laplace import LaplacePlan, laplace_sum

_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 20)


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
