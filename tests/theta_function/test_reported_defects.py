"""Each defect that a review found, as the test that would have caught it."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified import BudgetError, Reason, evaluate, initial_values, theta
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.arrays.arrays import theta_array
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.sums.finite_part import weight


def test_long_doubles_in_arrays_are_taken_exactly() -> None:
    entry = np.array([np.longdouble(1) / 3])
    exact = Fraction(*entry[0].as_integer_ratio())
    assert theta_array(entry, "1/2", digits=30)[0].overlaps(theta(exact, "1/2", digits=30))
    assert not theta_array(np.array([np.longdouble("1e-400")]), 1)[0].is_zero()


@pytest.mark.parametrize("tau", ["1e-300", Fraction(1, 10**250), "-1e-1000"])
@pytest.mark.parametrize("beta", ["1/2", -3, "123/10"])
def test_tiny_tau(tau: Fraction, beta: str) -> None:
    result = evaluate(tau, beta, digits=30)
    assert result.reached
    assert result.value.overlaps(evaluate(0, beta, digits=30).value)


def test_tiny_floats_in_arrays() -> None:
    assert all(value.is_finite() for value in theta(np.array([1e-300, 5e-324, -1e-310]), "1/2"))


@pytest.mark.parametrize("tau", [10**6, 10**12, -(10**12)])
def test_json_of_huge_values(tau: int) -> None:
    assert evaluate(tau, "1/2").to_json()["enclosure"].startswith("[")


@pytest.mark.parametrize("radius", [1, 3, 4, 6, 20])
def test_wide_balls_of_beta_have_finite_values(radius: int) -> None:
    assert all(value.is_finite() for value in initial_values(arb(0, radius), 64))
    for digits in (3, 15, 40):
        wide = evaluate(1, arb(0, radius), digits=digits)
        assert wide.value.is_finite()
        assert wide.reason is Reason.WIDE_INPUT
        for n in range(-radius, radius + 1):
            assert wide.value.overlaps(evaluate(1, fmpq(n) + (fmpq(1, 3) if n < 0 else 0), digits=30).value)


@pytest.mark.parametrize("radius", [1, 3])
def test_reciprocal_gamma_of_wide_balls_contains_its_points(radius: int) -> None:
    with working_bits(64):
        wide = reciprocal_gamma(arb(-2, radius), 64)
        assert wide.is_finite()
        for n in range(-10 * radius, 10 * radius + 1):
            inside = reciprocal_gamma(fmpq(-2) + fmpq(n, 10), 64)
            assert wide.contains(inside.mid())


def test_wide_ball_of_beta_far_out() -> None:
    """1/Gamma(-beta) and the weights next to several integers at once; once this filled the memory."""
    for tau, beta in ((173876207, arb(253, fmpq(1, 1000))), (181839, arb(0, fmpq(6, 5))), (10**9, arb(1207, "0.6"))):
        wide = evaluate(tau, beta)
        assert wide.value.is_finite()
        assert wide.value.overlaps(evaluate(tau, beta.mid(), digits=30).value)


@pytest.mark.parametrize("n", range(6))
def test_weights_over_balls_that_hold_the_integer(n: int) -> None:
    with working_bits(128):
        wide = weight(n, arb(n, 1), 128)
        assert wide.is_finite()
        for share in range(-9, 10):
            assert wide.contains(weight(n, fmpq(n) + fmpq(share, 10), 128).mid())


@pytest.mark.parametrize("derivative", [1, 2, 10])
def test_exact_balls_keep_their_accuracy_under_derivatives(derivative: int) -> None:
    with working_bits(400):
        third = arb(fmpq(1, 3)).mid()
    for beta in (third, arb((1234567, -20))):
        result = evaluate(1, beta, derivative=derivative, digits=50)
        assert result.reached
        assert relative_bits(result.value) > 160


def test_there_is_a_reason_whenever_the_accuracy_is_not_reached() -> None:
    for result in (evaluate(arb(1, "1e-9"), arb(2, "1e-9")), evaluate(1, arb(0, 20)), evaluate(arb(0, 1), 1)):
        assert not result.reached
        assert result.reason is not None


def test_low_accuracy_at_large_beta() -> None:
    """At 7 bits a ball for beta once hid 3N > beta, and no route was left."""
    assert evaluate("-255343359437151/500", "61319/10", digits=1).reached


@pytest.mark.parametrize("beta", ["0." + "3" * 30_000, fmpq(1, 2) + fmpq(1, 10**16_000)])
def test_numbers_too_long_to_be_worth_it_are_refused(beta: object) -> None:
    with pytest.raises(ValueError, match="at most"):
        evaluate("-20", beta)  # type: ignore[arg-type]


def test_a_large_prime_denominator_at_many_digits() -> None:
    assert evaluate("1/2", fmpq(1, 16777213), digits=1_600).reached


def test_a_failed_second_attempt_keeps_the_first_answer() -> None:
    beta = fmpq(1, 2) + fmpq(1, 10**400)
    assert evaluate(1, beta, digits=1000).reached
    with pytest.raises(BudgetError):
        evaluate(1, beta, digits=900_000)


def test_disjoint_enclosures_are_an_error_and_never_an_answer() -> None:
    from gspot_verified.theta_function.value.approach import tighter

    with pytest.raises(ArithmeticError, match="disjoint"):
        tighter(arb(1, 0.25), arb(2, 0.25))
    assert tighter(arb.nan(), arb(2)).overlaps(arb(2))
    assert tighter(arb(2), arb.nan()).overlaps(arb(2))


@pytest.mark.parametrize("digits", [15, 100])
def test_very_wide_beta_beyond_the_saddle(digits: int) -> None:
    """5,000 integers in the ball: once a quadratic loop over all of them."""
    for tau in (1000, 10**6):
        assert evaluate(tau, arb(0, 5000), digits=digits).value.is_finite()


@pytest.mark.parametrize("tau", [-1000, 1000, -(10**9)])
@pytest.mark.parametrize("sign", [-1, 1])
def test_next_to_a_large_integer_with_a_long_denominator(tau: int, sign: int) -> None:
    beta = 9999 + sign * Fraction(1, 10**4000)
    long, short = evaluate(tau, beta, digits=20), evaluate(tau, 9999, digits=40)
    assert long.reached
    assert tau > 0 or abs(long.value - short.value) <= abs(short.value) * 1e-19
