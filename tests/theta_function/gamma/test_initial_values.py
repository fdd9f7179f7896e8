"""Tests of what proofs/initial_values.md states."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, near_integers, small_heights, to_fmpq
from witnesses.theta import contains_witness, theta_witness

from gspot_verified.numbers.balls import relative_bits
from gspot_verified.theta_function.gamma.initial_values import initial_values, paper_initial_values
from gspot_verified.theta_function.value.integer import polynomial


@given(small_heights())
def test_paper_form_equals_entire_form_where_it_is_defined(beta: Fraction) -> None:
    b = to_fmpq(beta)
    ours, printed = initial_values(b, 200), paper_initial_values(b, 200)
    for j in range(3):
        assert ours[j].is_finite()
        if b.q != 1 or b < 0:
            assert printed[j].is_finite()
            assert ours[j].overlaps(printed[j])
            assert min(relative_bits(ours[j]), relative_bits(printed[j])) > 150


@pytest.mark.parametrize("n", range(25))
def test_integer_values_are_the_polynomials(n: int) -> None:
    coefficients = polynomial(n)
    for j, value in enumerate(initial_values(fmpq(n), 200)):
        exact = coefficients[j] * (2 if j == 2 else 1)
        assert holds(value, Fraction(int(exact.p), int(exact.q)))
        assert relative_bits(value) > 150
        if exact == 0:
            assert value.is_zero()


def test_printed_form_is_not_finite_where_it_is_not_defined() -> None:
    assert not paper_initial_values(fmpq(3), 100)[0].is_finite()
    assert not paper_initial_values(fmpq(4), 100)[1].is_finite()
    assert not paper_initial_values(arb(5, 0.5), 100)[2].is_finite()


@given(near_integers(40))
def test_next_to_integers_the_relative_accuracy_stays(beta: Fraction) -> None:
    for value in initial_values(to_fmpq(beta), 128):
        assert relative_bits(value) > 90


@given(st.integers(-12, 12), st.integers(0, 60))
def test_wide_balls_of_beta_contain_their_points(center: int, share: int) -> None:
    wide = initial_values(arb(center, 1), 100)
    inside = initial_values(fmpq(center) + fmpq(share - 30, 30), 100)
    for outer, inner in zip(wide, inside, strict=True):
        assert outer.is_finite()
        assert outer.contains(inner)


def test_mpmath_witness_at_zero() -> None:
    for beta in (Fraction(-7, 3), Fraction(1, 2), Fraction(22, 7), Fraction(100, 3)):
        value = initial_values(to_fmpq(beta), 256)[0]
        assert contains_witness(value, theta_witness(Fraction(0), beta), 60)
