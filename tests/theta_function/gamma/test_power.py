"""Powers of positive balls with rational exponents."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, to_fmpq

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.gamma.power import positive_power


@given(
    st.fractions(Fraction(1, 1000), 10**9, max_denominator=1000),
    st.integers(-60, 60),
    st.sampled_from([1, 2, 3, 5, 16, 17, 113]),
    st.sampled_from([64, 700]),
)
def test_the_power_to_the_denominator_is_an_integer_power(base: Fraction, above: int, below: int, bits: int) -> None:
    exponent = fmpq(above, below)
    with working_bits(bits):
        value = positive_power(arb(to_fmpq(base)), exponent)
        assert relative_bits(value) > bits - 30
    lower, upper = ends(value)
    exact = base ** int(exponent.p)
    assert lower ** int(exponent.q) <= exact <= upper ** int(exponent.q)


@pytest.mark.parametrize("base", [arb(0), arb(-2), arb(1, 2), arb.nan()])
@pytest.mark.parametrize("exponent", [fmpq(1, 3), fmpq(2), arb(0.5)])
def test_only_a_certainly_positive_base(base: arb, exponent: fmpq | arb) -> None:
    for bits in (64, 700):
        with working_bits(bits):
            assert not positive_power(base, exponent).is_finite()
