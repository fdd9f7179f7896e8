"""Tests of what proofs/initial_values.md states."""

from __future__ import annotations

from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.gamma.reduced_gamma import pays, reduced_initial_values


@given(st.integers(-400, 400), st.sampled_from([5, 7, 9, 11, 13]), st.sampled_from([2_100, 5_100]))
def test_many_digits_form_equals_the_entire_form(numerator: int, denominator: int, bits: int) -> None:
    beta = fmpq(numerator, denominator)
    if not pays(beta):
        return
    with working_bits(bits):
        reduced = reduced_initial_values(beta, bits)
    direct = initial_values(arb(beta) if beta.q == 1 else beta, 300)
    for fast, plain in zip(reduced, direct, strict=True):
        assert relative_bits(fast) > bits - 60
        assert fast.overlaps(plain)
        assert relative_bits(plain) > 250
