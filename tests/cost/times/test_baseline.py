from __future__ import annotations

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.cost.times.baseline import flint_attempt, flint_theta, mpmath_theta, right_digits
from gspot_verified.numbers.balls import bits_for_digits, relative_bits, working_bits
from gspot_verified.theta_function.theta import theta

BETAS = (fmpq(1, 2), fmpq(7, 3), fmpq(-5, 2))
TAUS = (fmpq(1, 10), fmpq(-7, 3), fmpq(10), fmpq(-50))


@pytest.mark.parametrize("digits", [15, 50, 400])
@pytest.mark.parametrize("beta", BETAS, ids=str)
@pytest.mark.parametrize("tau", TAUS, ids=str)
def test_flint_agrees_with_theta_and_reaches_the_digits(tau: fmpq, beta: fmpq, digits: int) -> None:
    for derivative in (0, 1, 2):
        answer, ours = flint_theta(tau, beta, derivative, digits), theta(tau, beta, derivative, digits)
        assert answer is not None
        assert answer.value.is_finite()
        assert ours.is_finite()
        assert relative_bits(answer.value) >= bits_for_digits(digits) - 2
        assert answer.value.overlaps(ours)


@pytest.mark.parametrize("digits", [15, 60])
@pytest.mark.parametrize("beta", BETAS, ids=str)
@pytest.mark.parametrize("tau", TAUS, ids=str)
def test_mpmath_agrees_with_theta(tau: fmpq, beta: fmpq, digits: int) -> None:
    for derivative in (0, 1):
        value = mpmath_theta(tau, beta, derivative, digits)
        assert value is not None
        assert right_digits(value, theta(tau, beta, derivative, digits + 5), digits) >= digits - 2


def test_the_precision_doubles_until_it_is_enough() -> None:
    easy, hard = (flint_theta(tau, fmpq(1, 2), digits=20) for tau in (fmpq(1), fmpq(-50)))
    start = bits_for_digits(20) + 16
    assert easy is not None
    assert hard is not None
    assert (easy.attempts, easy.bits) == (1, start)
    assert hard.attempts > 1
    assert hard.bits == start << (hard.attempts - 1)


def test_the_budget_of_bits_ends() -> None:
    start = bits_for_digits(20) + 16
    assert flint_theta(fmpq(-50), fmpq(1, 2), digits=20, max_bits=start) is None
    assert flint_theta(fmpq(1), fmpq(1, 2), digits=20, max_bits=start - 1) is None
    assert flint_theta(fmpq(10**6), fmpq(1, 2), digits=50, max_bits=2_000) is None


def test_the_budget_of_terms_ends() -> None:
    assert mpmath_theta(fmpq(10), fmpq(1, 2), digits=200, max_terms=5) is None
    assert mpmath_theta(fmpq(10), fmpq(1, 2), digits=200, max_terms=10_000) is not None


@pytest.mark.parametrize("beta", [0, 1, 2, 3, 7])
def test_the_printed_initial_values_are_not_defined_at_integers(beta: int) -> None:
    assert flint_theta(fmpq(1), fmpq(beta)) is None
    assert mpmath_theta(fmpq(1), fmpq(beta)) is None
    # d^k Theta/dtau^k is a multiple of Theta(beta - k): defined again once beta - k < 0.
    answer = flint_theta(fmpq(1), fmpq(beta), derivative=beta + 1)
    assert answer is not None
    assert answer.value.contains(0)


def test_one_attempt_encloses_also_where_it_is_wide() -> None:
    wide = flint_attempt(fmpq(-20), fmpq(1, 2), 64)
    assert wide.is_finite()
    assert relative_bits(wide) < 40
    assert wide.overlaps(theta(-20, "1/2", digits=30))


def test_mpmath_leaves_its_precision_alone() -> None:
    before = mpmath.mp.prec
    mpmath_theta(fmpq(1), fmpq(1, 2), digits=100)
    mpmath_theta(fmpq(1), fmpq(1), digits=100)
    assert mpmath.mp.prec == before


def test_right_digits() -> None:
    with working_bits(200):
        third = arb(1) / 3
        minus_third = -third
    assert right_digits("0.33333", third, 50) == 5
    assert right_digits("-0.33333", third, 50) == 0
    assert right_digits("0.33333333333333333333333333", third, 10) == 10
    assert right_digits("nan", third, 10) == 0
    with mpmath.workdps(30):
        assert right_digits(mpmath.mpf(1) / 3, third, 20) == 20
        assert right_digits(-mpmath.mpf(1) / 3, minus_third, 20) == 20
        assert right_digits(-mpmath.mpf(1) / 3, third, 20) == 0
