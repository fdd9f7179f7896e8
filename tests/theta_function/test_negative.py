"""The enveloping series at minus infinity.

Page: proofs/negative.md.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from strategies import near_integers, small_heights, to_fmpq
from witness import contains_witness, theta_witness

from gspot_verified.balls import relative_bits
from gspot_verified.theta_function.integer import polynomial_value
from gspot_verified.theta_function.negative import negative_sum

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
