"""The Taylor series at 0 in floating balls; where it shares its bound with binary splitting, both.

Page: proofs/taylor.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq
from witnesses.theta import contains_witness, theta_witness

from gspot_verified import evaluate
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.sums.splitting import splitting_sum
from gspot_verified.theta_function.sums.taylor import taylor_coefficients, taylor_derivatives, taylor_sum, taylor_values

_TAUS = st.builds(Fraction, st.integers(-80, 80), st.integers(8, 40))


@given(_TAUS, small_heights(), st.integers(30, 120))
def test_both_contain_the_witness(tau: Fraction, beta: Fraction, length: int) -> None:
    witness = theta_witness(tau, beta)
    for value in (
        taylor_sum(to_fmpq(tau), to_fmpq(beta), 3 * length, 300),
        splitting_sum(to_fmpq(tau), to_fmpq(beta), 3 * length, 300, 4),
    ):
        assert value.is_finite()
        assert contains_witness(value, witness, 58)


def test_too_few_terms_are_not_finite() -> None:
    # K = 3, X = 8: the ratio bound is far above 1.
    assert not taylor_sum(fmpq(8), fmpq(1, 2), 3, 100).is_finite()
    assert not splitting_sum(fmpq(8), fmpq(1, 2), 3, 100, 1).is_finite()


def test_ratio_bound_exactly_one_is_refused() -> None:
    # beta = 0, K = 3, X^3 = 20 = (K+1)(K+2): q = 1 is not below 1; a ball for X = 20^(1/3) cannot decide it.
    assert not taylor_sum(arb(20).root(3), fmpq(0) + fmpq(0), 3, 100).is_finite()


@given(st.integers(-16, 16), small_heights(), st.integers(0, 20), st.integers(0, 20))
def test_inclusion_under_widening(tau: int, beta: Fraction, left: int, right: int) -> None:
    wide = taylor_sum(arb(fmpq(tau, 4), fmpq(1, 2)), arb(to_fmpq(beta), fmpq(1, 2)), 90, 200)
    inside = taylor_sum(fmpq(tau, 4) + fmpq(left - 10, 20), to_fmpq(beta) + fmpq(right - 10, 20), 90, 200)
    assert wide.is_finite()
    assert inside.is_finite()
    assert wide.overlaps(inside)
    assert wide.contains(inside.mid())


@given(small_heights())
def test_coefficients_satisfy_the_differential_equation(beta: Fraction) -> None:
    a = taylor_coefficients(to_fmpq(beta), 40, 200)
    with working_bits(200):
        for k in range(37):
            residual = (k + 1) * (k + 2) * (k + 3) * a[k + 3] - (k - to_fmpq(beta)) * a[k]
            assert residual.is_finite()
            assert residual.contains(0)
            assert residual.rad() <= abs(a[k]) * fmpq(1, 10**40)


@pytest.mark.parametrize("n", [0, 1, 5, 12])
def test_polynomials_at_integers_have_no_rest(n: int) -> None:
    assert relative_bits(taylor_sum(fmpq(7, 3), fmpq(n), 3 * (n + 2), 100)) > 60


@given(st.integers(-40, 40), small_heights(), st.integers(3, 150))
def test_three_derivatives_of_one_polynomial(tau: int, beta: Fraction, length: int) -> None:
    point, b = fmpq(tau, 8), to_fmpq(beta)
    found = taylor_derivatives(point, b, length, 200)
    for k, value in enumerate(found):
        if value.is_finite():
            assert value.overlaps(evaluate(point, b, k, 40).value)
        else:
            assert length < 60
    assert not any(value.is_finite() for value in taylor_derivatives(fmpq(8), b, 3, 100))


def test_many_points_have_one_rest() -> None:
    points = [0.5, -1.25, 2.0, 2.5]
    found = taylor_values(points, 2.0, fmpq(7, 3), 60, 150)
    assert not found[3].is_finite()
    for point, value in zip(points[:3], found[:3], strict=True):
        assert value.is_finite()
        assert value.overlaps(taylor_sum(fmpq(*point.as_integer_ratio()), fmpq(7, 3), 90, 300))
        assert relative_bits(value) > 100
    assert not taylor_values([8.0], 8.0, fmpq(1, 2), 3, 100)[0].is_finite()
