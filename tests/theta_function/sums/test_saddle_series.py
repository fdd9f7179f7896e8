"""The series of the saddle point, summed by its recurrence and by binary splitting.

Page: proofs/asymptotic_coefficients.md.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.sums.saddle_series import saddle_series, split_length, split_saddle_series
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient


@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(-1, 2), fmpq(25, 2)])
@pytest.mark.parametrize("terms", [1, 2, 64, 65, 66, 130])
def test_a_long_sum_is_the_exact_one_and_keeps_its_accuracy(terms: int, beta: fmpq) -> None:
    """The coefficients as polynomials in beta, in exact rationals; later blocks have fewer bits."""
    large = fmpq(10**4)
    exact = sum((coefficient(k)(beta) * fmpq(3, 2) ** k / large**k for k in range(terms)), fmpq(0))
    with working_bits(2_000):
        value = saddle_series(arb(large), beta, terms)
        assert relative_bits(value) > 1_980 or terms == 1
        assert value.contains(exact)
    with working_bits(3_000):
        assert abs(value.mid() - arb(exact)) <= value.rad()


def test_a_sum_over_a_wide_ball_contains_the_sums() -> None:
    with working_bits(200):
        value = saddle_series(arb(100, 1), fmpq(7, 3), 150)
        assert value.is_finite()
        for large in (fmpq(99), fmpq(100), fmpq(101)):
            assert value.contains(saddle_series(arb(large), fmpq(7, 3), 150))
    assert not saddle_series(arb(0, 1), fmpq(7, 3), 150).is_finite()


@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(-1, 2), fmpq(25, 2), fmpq(355, 113), fmpq(3)])
@pytest.mark.parametrize("tau", [fmpq(100), fmpq(441, 4)])
@pytest.mark.parametrize("terms", [8, 24, 104])
def test_splitting_sums_the_exact_coefficients(terms: int, tau: fmpq, beta: fmpq) -> None:
    """lambda is rational here, so that the sum is one rational; the coefficients are those of the other derivation."""
    root = fmpq({100: 10, 441: 21}[int(tau.p)], {1: 1, 4: 2}[int(tau.q)])
    assert root * root == tau
    large = root**3
    exact = sum((coefficient(k)(beta) * fmpq(3, 2) ** k / large**k for k in range(terms)), fmpq(0))
    with working_bits(1_500):
        value = split_saddle_series(tau, beta, terms)
        assert relative_bits(value) > 1_400
    with working_bits(4_000):
        assert abs(value.mid() - arb(exact)) <= value.rad()


@given(st.integers(50, 10**7), st.integers(1, 30), small_heights(), st.integers(1, 60))
def test_splitting_and_the_recurrence_agree(above: int, below: int, beta: object, terms: int) -> None:
    tau, b = fmpq(above, below), to_fmpq(beta)  # type: ignore[arg-type]
    with working_bits(700):
        split = split_saddle_series(tau, b, terms)
        plain = saddle_series(arb(tau) * arb(tau).sqrt(), b, split_length(terms))
        assert split.is_finite()
        assert plain.is_finite()
        assert split.overlaps(plain)
        assert split.rad() < (abs(split) + 1) * arb(2) ** -600


def test_the_length_is_whole_blocks() -> None:
    assert [split_length(n) for n in (1, 8, 9, 16, 17)] == [8, 8, 16, 16, 24]
