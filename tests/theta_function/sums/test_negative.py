"""The enveloping series at minus infinity.

Page: proofs/negative.md.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights, to_fmpq
from witnesses.theta import contains_witness, theta_witness

from gspot_verified.numbers.balls import relative_bits
from gspot_verified.theta_function.sums.negative import negative_split_sum, negative_sum
from gspot_verified.theta_function.value.integer import polynomial_value

_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 20)


@given(st.integers(2, 30), _BETAS, st.integers(1, 30))
def test_enveloping_series_contains_the_witness(x: int, beta: Fraction, terms: int) -> None:
    value = negative_sum(fmpq(-x), to_fmpq(beta), terms, 300)
    if 3 * terms <= beta:
        assert not value.is_finite()
    else:
        assert value.is_finite()
        assert contains_witness(value, theta_witness(Fraction(-x), beta), 58)


@given(st.integers(2, 20), st.integers(0, 12), st.integers(0, 12))
def test_enveloping_series_at_integers_is_the_polynomial(x: int, n: int, extra: int) -> None:
    value = negative_sum(fmpq(-x), fmpq(n), n // 3 + 1 + extra, 300)
    exact = polynomial_value(fmpq(-x), n)
    assert relative_bits(value) > 200
    assert value.contains(exact) or value.overlaps(arb(exact))


def test_enveloping_series_wants_tau_certainly_negative() -> None:
    assert not negative_sum(arb(0, 1), fmpq(1, 2), 5, 100).is_finite()
    assert not negative_sum(fmpq(1), fmpq(1, 2), 5, 100).is_finite()
    assert not negative_sum(fmpq(-5), arb(15, 1), 5, 100).is_finite()


@given(st.integers(10, 90), st.integers(1, 5), _BETAS, st.integers(1, 30))
@settings(max_examples=30)
def test_both_ways_of_summing_give_one_number(x: int, below: int, beta: Fraction, terms: int) -> None:
    tau, b = fmpq(-x, below), to_fmpq(beta)
    split = negative_split_sum(tau, b, terms, 300)
    whole = 8 * -(-terms // 8)
    if 3 * whole <= beta:
        assert not split.is_finite()
        return
    plain = negative_sum(tau, b, whole, 300)
    assert plain.is_finite()
    assert split.is_finite()
    assert split.overlaps(plain)
    assert split.rad() <= plain.rad() * fmpq(1_001, 1_000) + abs(plain.mid()) * arb(2) ** -250
    assert contains_witness(split, theta_witness(Fraction(-x, below), beta), 58)


def test_splitting_wants_tau_negative_and_enough_terms() -> None:
    assert not negative_split_sum(fmpq(1), fmpq(1, 2), 5, 100).is_finite()
    assert not negative_split_sum(fmpq(0), fmpq(1, 2), 5, 100).is_finite()
    assert not negative_split_sum(fmpq(-50), fmpq(24), 8, 100).is_finite()
    assert negative_split_sum(fmpq(-50), fmpq(24), 9, 100).is_finite()
