"""The series of dTheta/dbeta at 0: against quotients of Theta by other routes, against its page, and its hypothesis.

Page: proofs/beta_series.md.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, small_heights, to_fmpq

from gspot_verified import theta
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.sums.beta_series import beta_derivative_sum, initial_slopes
from gspot_verified.theta_function.sums.taylor import taylor_coefficients

_TAUS = st.builds(Fraction, st.integers(-80, 80), st.integers(8, 40))


@given(_TAUS, small_heights(), st.integers(12, 40), st.integers(2, 40))
def test_the_mean_value_theorem(tau: Fraction, beta: Fraction, thirds: int, exponent: int) -> None:
    """A difference of Theta is h times the derivative somewhere between: a ball of betas must hold that."""
    step = fmpq(1, 2**exponent)
    with working_bits(200):
        between = arb(to_fmpq(beta) + step / 2) + arb(0, 1) * arb(step) / 2 * fmpq(1025, 1024)
    derivative = beta_derivative_sum(to_fmpq(tau), between, 3 * thirds, 200)
    first, second = (theta(to_fmpq(tau), to_fmpq(beta) + part, digits=40) for part in (0, step))
    with working_bits(200):
        quotient = (second - first) / arb(step)
        if derivative.is_finite():
            assert derivative.overlaps(quotient)
        assert derivative.is_finite() or thirds < 30 or abs(beta) > 10


@given(_TAUS, small_heights())
def test_a_central_quotient(tau: Fraction, beta: Fraction) -> None:
    """Its error is of order h^2 = 10^-60."""
    step = fmpq(1, 10**30)
    found = beta_derivative_sum(to_fmpq(tau), to_fmpq(beta), 240, 300)
    below, above = (theta(to_fmpq(tau), to_fmpq(beta) + part, digits=100) for part in (-step, step))
    with working_bits(400):
        quotient = (above - below) / arb(2 * step)
        assert found.is_finite()
        assert abs(found - quotient) < abs(quotient) * arb(10) ** -40 + arb(10) ** -40


@pytest.mark.parametrize("beta", [Fraction(1, 2), Fraction(-7, 2), Fraction(7, 3), Fraction(29, 4)])
def test_the_first_one_by_the_papers_formula(beta: Fraction) -> None:
    """The logarithmic derivative of t01: -log(3)/3 - psi(-beta/3)/3 + psi(-beta)."""
    with mpmath.workdps(50):
        b = mpmath.mpf(beta.numerator) / beta.denominator
        value = 3 ** (-b / 3 - 1) * mpmath.gamma(-b / 3) / mpmath.gamma(-b)
        slope = value * (-mpmath.log(3) / 3 - mpmath.digamma(-b / 3) / 3 + mpmath.digamma(-b))
        lower, upper = ends(initial_slopes(to_fmpq(beta), 150)[0])
        middle = (lower + upper) / 2
        assert abs(mpmath.mpf(middle.numerator) / middle.denominator - slope) < 1e-38 * abs(slope)
    at_zero = beta_derivative_sum(fmpq(0), to_fmpq(beta), 3, 150)
    assert at_zero.overlaps(initial_slopes(to_fmpq(beta), 150)[0])
    assert relative_bits(at_zero) > 120


@pytest.mark.parametrize("beta", [Fraction(1, 2), Fraction(-7, 2), Fraction(7, 3), Fraction(2)])
@pytest.mark.parametrize(("tau", "length"), [(Fraction(2), 6), (Fraction(-3), 9), (Fraction(1, 3), 3)])
def test_the_bound_is_that_of_the_page(beta: Fraction, tau: Fraction, length: int) -> None:
    value = beta_derivative_sum(to_fmpq(tau), to_fmpq(beta), length, 600)
    with working_bits(600), mpmath.workdps(60):
        a = [_number(c) for c in taylor_coefficients(to_fmpq(beta), length + 3, 600)]
        d = [_number(c) for c in initial_slopes(to_fmpq(beta), 600)]
        d[2] /= 2
        b, x, k = _fraction(beta), _fraction(abs(tau)), mpmath.mpf(length)
        for i in range(length):
            d.append(((i - b) * d[i] - a[i]) / ((i + 1) * (i + 2) * (i + 3)))
        q, r = (1 + abs(b) / k) * x**3 / ((k + 1) * (k + 2)), x**3 / ((k + 1) * (k + 2) * (k + 3))
        own, omitted = (sum(abs(c[length + j]) * x ** (length + j) for j in range(3)) for c in (d, a))
        page = (own + r * omitted / (1 - q)) / (1 - q)
        lower, upper = ends(value)
        assert 0 < page * (1 - mpmath.mpf("1e-15")) <= _fraction((upper - lower) / 2) <= page * (1 + mpmath.mpf("1e-7"))
    longer = beta_derivative_sum(to_fmpq(tau), to_fmpq(beta), length + 90, 600)
    assert value.contains(longer)


def _fraction(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def _number(value: arb) -> mpmath.mpf:
    lower, upper = ends(value)
    return _fraction((lower + upper) / 2)


def test_too_few_terms_are_not_finite() -> None:
    """q is certainly below 1, or there is no answer: K = 3, beta = 0, X^3 = 20 is the edge."""
    with working_bits(100):
        edge = arb(20).root(3)
    assert not beta_derivative_sum(fmpq(8), fmpq(1, 2), 3, 100).is_finite()
    assert not beta_derivative_sum(edge, fmpq(0), 3, 100).is_finite()
    assert not beta_derivative_sum(edge, fmpq(1), 3, 100).is_finite()
    assert beta_derivative_sum(edge - arb(fmpq(1, 1000)), fmpq(0), 3, 100).is_finite()
