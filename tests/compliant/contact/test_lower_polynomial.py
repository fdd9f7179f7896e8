"""Theorem C for b > 4: f - P increases in eta, at random points; the exponential is bounded from below, exactly."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified import evaluate
from gspot_verified.compliant.contact.lower_polynomial import (
    drift,
    leading_derivatives,
    leading_enclosures,
    lower_terms,
)
from gspot_verified.compliant.slow.grid import cubic_exponent
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.balls import working_bits

PARAMETERS = st.fractions(Fraction(46, 9), 12, max_denominator=9).filter(lambda b: b.denominator > 1)
ROOTS = st.fractions(Fraction(1, 20), 1, max_denominator=40)
PLACES = st.fractions(-12, 8, max_denominator=30)


def test_the_terms_that_the_page_writes_out() -> None:
    eighth = [(1, 4, fmpq(1, 8)), (2, 5, fmpq(-1, 10)), (3, 6, fmpq(1, 12)), (4, 7, fmpq(-1, 14))]
    assert lower_terms(fmpq(7, 2)) == ()
    assert [tuple(term) for term in lower_terms(fmpq(11, 2))] == eighth[:2]
    assert [tuple(term) for term in lower_terms(fmpq(15, 2))] == eighth
    two = lower_terms(fmpq(23, 2))
    assert max(term.power for term in two if term.order == term.power + 3) == 8
    assert max(term.power for term in two if term.order == term.power + 6) == 5


@settings(max_examples=60, deadline=None)
@given(st.fractions(0, 14, max_denominator=7), st.fractions(0, 6, max_denominator=50), ROOTS, ROOTS)
def test_the_lemma_at_a_point(b: Fraction, rho: Fraction, root: Fraction, more: Fraction) -> None:
    """e^h - p is >= 1 and does not decrease in eta; what is left out is of the order that the integral needs."""
    if rho == 0 or b.denominator == 1:
        return
    terms = lower_terms(to_fmpq(b))
    with working_bits(200):
        place, values = arb(to_fmpq(rho)), []
        for eta in (arb(to_fmpq(root)), arb(to_fmpq(root + more))):
            exponential = (cubic_exponent(eta, (place,))[0] + place**3 / 3).exp()
            values.append(exponential - sum((c * eta**k * place**n for k, n, c in terms), arb(0)))
    assert values[0] > 1
    assert values[0] < values[1]


@settings(max_examples=40, deadline=None)
@given(PARAMETERS, ROOTS, ROOTS, PLACES)
def test_theorem_c(beta: Fraction, one: Fraction, more: Fraction, tau: Fraction) -> None:
    parameter, place = to_fmpq(beta), to_fmpq(tau)
    roots = (to_fmpq(one), to_fmpq(one + more))
    terms = lower_terms(parameter - 1)
    derivatives = leading_derivatives(parameter, place, 1 + max(term.order for term in terms))
    with working_bits(200):
        rests = [derivatives[0]]
        for root in roots:
            value = Profile.at_root(parameter, root).value(place, 30)
            rests.append(value - sum((c * root**k * derivatives[n] for k, n, c in terms), arb(0)))
    assert rests[0] < rests[1]
    assert rests[1] < rests[2]
    enclosures = leading_enclosures(parameter, place, place, 1 + max(term.order for term in terms))
    change = drift(parameter, 0, roots, enclosures)
    low, high = (Profile.at_root(parameter, root).value(place, 30) for root in roots)
    assert change <= 0
    assert low + change < high


@settings(max_examples=30, deadline=None)
@given(
    st.fractions(Fraction(11, 9), 12, max_denominator=9).filter(lambda b: b.denominator > 1),
    PLACES,
    st.fractions(Fraction(1, 30), 1, max_denominator=30),
    st.fractions(0, 1, max_denominator=20),
    st.integers(0, 14),
)
def test_enclosures_over_an_interval(beta: Fraction, left: Fraction, wide: Fraction, share: Fraction, k: int) -> None:
    parameter, lower, upper = to_fmpq(beta), to_fmpq(left), to_fmpq(left + wide)
    found = leading_enclosures(parameter, lower, upper, 15)[k]
    place = lower + to_fmpq(share) * (upper - lower)
    value = Profile.leading_order(parameter).direction * evaluate(place, parameter, derivative=k + 1, digits=15).value
    assert found.is_finite()
    assert found.overlaps(value)
    assert found.lower() <= value.upper()
    assert found.upper() >= value.lower()


@pytest.mark.parametrize("j", [0, 1, 2])
def test_the_polynomial_of_a_derivative(j: int) -> None:
    """f^(j) minus the terms for b - j increases."""
    beta, place, roots = fmpq(29, 4), fmpq(-3), (fmpq(1, 10), fmpq(1, 2))
    derivatives = leading_derivatives(beta, place, 20)
    with working_bits(200):
        rests = [
            Profile.at_root(beta, root).derivatives(place, range(j, j + 1), 30)[0]
            - sum((c * root**k * derivatives[n + j] for k, n, c in lower_terms(beta - 1 - j)), arb(0))
            for root in roots
        ]
    assert derivatives[j] < rests[0]
    assert rests[0] < rests[1]


def test_the_drift_is_near_the_difference_of_the_polynomial() -> None:
    """f_0^(5) = 1 alone, b = 9/2: P = -eta^2/10, so P(2) - P(1) = -3/10; the bound has (y - x)(y + y) for y^2 - x^2."""
    derivatives = [arb(0)] * 5 + [arb(1)]
    found = drift(fmpq(11, 2), 0, (fmpq(1), fmpq(2)), derivatives)
    assert -fmpq(401, 1000) < found <= -fmpq(3, 10)
    narrow = drift(fmpq(11, 2), 0, (fmpq(1), fmpq(1001, 1000)), derivatives)
    assert -fmpq(2003, 10**7) < narrow <= -fmpq(2001, 10**7)


def test_enclosures_are_as_wide_as_the_function_changes() -> None:
    """Over an interval of the length 2^-9 f_0 is off its value in the middle by 2^-10 |f_0'|, and little more."""
    beta, middle, half = fmpq(5, 2), fmpq(-2), fmpq(1, 2**10)
    found = leading_enclosures(beta, middle - half, middle + half, 2)
    slope = leading_derivatives(beta, middle, 2)[1]
    with working_bits(128):
        ratio = arb(found[0].rad()) / (abs(slope) * half)
    assert 0.99 < ratio < 1.05
