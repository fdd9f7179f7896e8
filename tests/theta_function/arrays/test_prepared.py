"""Prepared values are those of the evaluator.

Page: proofs/local_series.md.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, small_heights, to_fmpq

from gspot_verified import PreparedTheta, evaluate
from gspot_verified.numbers.balls import bits_for_digits, current_bits, relative_bits


@given(
    small_heights(),
    st.integers(0, 2),
    st.sampled_from([15, 40]),
    st.lists(st.fractions(-6, 6, max_denominator=64), max_size=4),
)
def test_values_contain_the_evaluator(beta: Fraction, derivative: int, digits: int, taus: list[Fraction]) -> None:
    prepared = PreparedTheta(beta, digits, 6, derivative)
    for tau in [*taus, Fraction(-6), Fraction(6), Fraction(0), Fraction(1, 2)]:
        value, exact = prepared(tau), evaluate(tau, beta, derivative, 2 * digits + 20).value
        lower, upper = ends(value)
        least, greatest = ends(exact)
        assert lower <= least
        assert greatest <= upper
        assert relative_bits(value) >= bits_for_digits(digits)


def test_far_reach_balls_and_zeros() -> None:
    prepared = PreparedTheta("5/2", 15, 64, derivative=1)
    for tau in (-64, 64, fmpq(-201, 4), "1.531716136412176", "1.5317161364121761"):
        value = prepared(tau)
        assert value.overlaps(evaluate(tau, "5/2", 1, 40).value)
        assert relative_bits(value) >= bits_for_digits(15)
    wide = prepared(arb(1, fmpq(1, 4)))
    assert wide.contains(prepared(1).mid())
    assert prepared(to_fmpq(Fraction(1))).overlaps(prepared(arb(1)))


BAD: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"beta": 0.5}, TypeError, "beta: a float"),
    ({"beta": arb(0, 1)}, ValueError, "beta: expected"),
    ({"beta": 1_000}, ValueError, "beta: expected"),
    ({"digits": 0}, ValueError, "digits must lie in"),
    ({"digits": 301}, ValueError, "digits must lie in"),
    ({"reach": 0}, ValueError, "reach must be"),
    ({"reach": 65}, ValueError, "reach must be"),
    ({"reach": 2.0}, ValueError, "reach must be"),
    ({"derivative": -1}, ValueError, "derivative must lie in"),
]


@pytest.mark.parametrize(("change", "error", "message"), BAD)
def test_bad_input(change: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        PreparedTheta(**{"beta": "1/2", "reach": 2, **change})


def test_bad_tau() -> None:
    prepared, before = PreparedTheta("1/2", reach=2), current_bits()
    with pytest.raises(TypeError, match="tau: a float"):
        prepared(0.5)  # type: ignore[arg-type]
    for tau in (3, "-2.0001", fmpq(2) + fmpq(1, 10**30)):
        with pytest.raises(ValueError, match="prepared for"):
            prepared(tau)
    assert current_bits() == before
