"""One value of the Taylor series, term by term.

Page: proofs/taylor.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, near_integers, small_heights, to_fmpq, to_fraction
from witnesses.theta import contains_witness, theta_witness

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.sums.taylor import taylor_sum
from gspot_verified.theta_function.value.chains import _chains, chain_sum
from gspot_verified.theta_function.value.integer import polynomial_value

_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 20)


@given(st.fractions(-12, 12, max_denominator=9), _BETAS, st.integers(3, 400))
def test_the_ball_contains_the_witness_or_says_nothing(tau: Fraction, beta: Fraction, length: int) -> None:
    value = chain_sum(to_fmpq(tau), to_fmpq(beta), length, 250)
    if value.is_finite():
        assert contains_witness(value, theta_witness(tau, beta), 58)
        assert value.overlaps(taylor_sum(to_fmpq(tau), to_fmpq(beta), length + 30, 300))
    else:
        assert length < 100


@given(st.fractions(-3, 3, max_denominator=9), st.integers(0, 9), st.integers(9, 24))
def test_few_terms_leave_their_bound(tau: Fraction, n: int, length: int) -> None:
    value = chain_sum(to_fmpq(tau), fmpq(n), length, 100)
    if value.is_finite():
        lower, upper = ends(value)
        assert lower <= to_fraction(polynomial_value(to_fmpq(tau), n)) <= upper


def test_the_bound_is_that_of_the_page() -> None:
    tau, beta, length = fmpq(5, 2), fmpq(7, 3), 12
    omitted = fmpq(0)
    values = initial_values(beta, 200)
    with working_bits(200):
        page = arb(0)
        for j in range(3):
            term = values[j] * (tau**j / (1 + (j > 1)))
            for k in range(j, length + j, 3):
                term = term * (k - beta) * tau**3 / ((k + 1) * (k + 2) * (k + 3))
            page += 2 * abs(term)
        radius = chain_sum(tau, beta, length, 200).rad()
        assert omitted == 0
        assert abs(radius / page - 1) < arb(2) ** -20


@given(
    st.fractions(-6, 6, max_denominator=9),
    st.fractions(-20, 20, max_denominator=9),
    st.integers(1, 40),
    st.integers(0, 12),
)
def test_the_bound_on_rounding_and_rest_holds_for_short_integers(
    tau: Fraction, beta: Fraction, terms: int, scale: int
) -> None:
    length = 3 * terms
    cube = tau**3
    sums, bounds = _chains(-beta.numerator, beta.denominator, cube.numerator, beta.denominator * cube.denominator,
                           length, scale)  # fmt: skip
    small = (1 + abs(beta) / length) * abs(cube) / ((length + 1) * (length + 2)) <= Fraction(1, 2)
    for j in range(3):
        term, total = Fraction(2) ** scale, Fraction(0)
        for k in range(j, length + j, 3):
            total += term
            term *= (k - beta) * cube / ((k + 1) * (k + 2) * (k + 3))
        assert abs(total - sums[j]) <= bounds[j] - 2 * abs(term)  # what rounding did
        if small:
            for k in range(length + j, length + j + 90, 3):
                total += term
                term *= (k - beta) * cube / ((k + 1) * (k + 2) * (k + 3))
            assert abs(total - sums[j]) <= bounds[j]


def test_long_series_and_the_hypothesis() -> None:
    assert relative_bits(chain_sum(fmpq(50), fmpq(7, 3), 1_200, 200)) > 150
    # beta = 0: 2 K X^3 = K (K+1)(K+2) holds for X = 1, K = 0 only; K = 3, X^3 = 10 is the border, 11 beyond it
    assert chain_sum(fmpq(2), fmpq(0), 3, 100).is_finite()
    assert not chain_sum(fmpq(9, 4), fmpq(0), 3, 100).is_finite()


@pytest.mark.parametrize("tau", [fmpq(0), fmpq(-1, 10**9)])
def test_at_zero(tau: fmpq) -> None:
    assert chain_sum(tau, fmpq(1, 2), 3, 100).overlaps(taylor_sum(tau, fmpq(1, 2), 9, 100))
