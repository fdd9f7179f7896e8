"""Tests of what proofs/initial_values.md states."""

from __future__ import annotations

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.gamma.initial_values import initial_values, paper_initial_values
from gspot_verified.theta_function.gamma.reduced_gamma import pays, reduced_initial_values


@given(st.integers(-400, 400), st.sampled_from([4, 5, 7, 9, 11, 13]), st.sampled_from([2_100, 5_100]))
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


@pytest.mark.parametrize("numerator", [-9, -7, -3, -1, 1, 3, 5, 7, 21])
def test_quarters_pay_at_both_fractions(numerator: int) -> None:
    beta = fmpq(numerator, 4)
    assert pays(beta)
    with working_bits(4_000):
        reduced = reduced_initial_values(beta, 4_000)
        # By Gamma of balls: none of the formulas for twelfths.
        papers = paper_initial_values(beta, 4_000)
    for fast, plain in zip(reduced, papers, strict=True):
        assert relative_bits(fast) > 3_950
        assert relative_bits(plain) > 3_900
        assert fast.overlaps(plain)


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(-5, 2), fmpq(3), fmpq(201, 2)])
def test_cheap_ones_and_far_ones_do_not_pay(beta: fmpq) -> None:
    assert not pays(beta)
