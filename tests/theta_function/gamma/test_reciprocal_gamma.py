"""Tests of what proofs/initial_values.md states."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights, to_fmpq
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma


@given(st.one_of(small_heights(), near_integers(30)))
def test_reciprocal_gamma_against_mpmath(z: Fraction) -> None:
    with working_bits(160):
        value = reciprocal_gamma(to_fmpq(z), 160)
    with mpmath.workdps(400):
        witness = to_fraction(mpmath.rgamma(mpmath.mpf(z.numerator) / z.denominator))
    assert contains_witness(value, witness, 80)
    assert relative_bits(value) > 120


def test_reciprocal_gamma_is_exactly_zero_at_its_zeros() -> None:
    with working_bits(100):
        assert all(reciprocal_gamma(fmpq(-n), 100).is_zero() for n in range(5))
