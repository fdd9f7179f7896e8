"""The saddle point at plus infinity with its explicit remainder.

Page: proofs/positive.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import near_integers, small_heights, to_fmpq
from witness import contains_witness, theta_witness

from gspot_verified.balls import relative_bits, working_bits
from gspot_verified.theta_function.asymptotic_coefficients import coefficient
from gspot_verified.theta_function.integer import polynomial_value
from gspot_verified.theta_function.positive import SaddlePlan, _saddle_series, positive_sum

_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 20)


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


@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(-1, 2), fmpq(25, 2)])
@pytest.mark.parametrize("terms", [1, 2, 64, 65, 66, 130])
def test_a_long_sum_is_the_exact_one_and_keeps_its_accuracy(terms: int, beta: fmpq) -> None:
    """The coefficients as polynomials in beta, in exact rationals; later blocks have fewer bits."""
    large = fmpq(10**4)
    exact = sum((coefficient(k)(beta) * fmpq(3, 2) ** k / large**k for k in range(terms)), fmpq(0))
    with working_bits(2_000):
        value = _saddle_series(arb(large), beta, terms)
        assert relative_bits(value) > 1_980 or terms == 1
        assert value.contains(exact)
    with working_bits(3_000):
        assert abs(value.mid() - arb(exact)) <= value.rad()


def test_a_sum_over_a_wide_ball_contains_the_sums() -> None:
    with working_bits(200):
        value = _saddle_series(arb(100, 1), fmpq(7, 3), 150)
        assert value.is_finite()
        for large in (fmpq(99), fmpq(100), fmpq(101)):
            assert value.contains(_saddle_series(arb(large), fmpq(7, 3), 150))
    assert not _saddle_series(arb(0, 1), fmpq(7, 3), 150).is_finite()
