"""Coefficients in balls have the asked digits, or it is said that they have not."""

from __future__ import annotations

import warnings

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.accuracy import AccuracyWarning, certain_bits, until_accurate
from gspot_verified.numbers.balls import bits_for_digits, working_bits


def test_certain_bits_of_a_coefficient_and_of_one_that_may_be_zero() -> None:
    narrow, wide = arb((1, 0), (1, -40)), arb((1, 0), (1, -20))
    assert certain_bits([[arb(1)]]) > 10**6  # exact
    assert 39 <= certain_bits([[narrow]]) <= 41
    assert 19 <= certain_bits([[narrow, wide]]) <= 21
    assert 19 <= certain_bits([[wide], [narrow]]) <= 21
    # [+-2^-40] beside 2^10: relative to the largest coefficient so far, not to later ones.
    assert 49 <= certain_bits([[arb((1, 10))], [arb(0, fmpq(1, 2**40))]]) <= 51
    assert certain_bits([[arb(0, fmpq(1, 2**40))], [arb((1, 10))]]) <= 0
    assert certain_bits([[arb("nan")]]) < -(10**6)
    assert certain_bits([[arb("inf")], [arb(1)]]) < -(10**6)


def test_the_working_precision_of_the_caller_does_not_matter() -> None:
    with working_bits(2):
        assert 39 <= certain_bits([[arb((2**50 + 1, -50), (1, -40))]]) <= 41


def test_bits_are_raised_until_they_suffice() -> None:
    asked: list[int] = []

    def attempt(bits: int) -> tuple[str, int | None]:
        asked.append(bits)
        return f"with {bits}", bits - 300  # 300 bits are lost

    result, accuracy = until_accurate(attempt, 30, 200)
    assert accuracy is not None
    assert accuracy.reached
    assert accuracy.certain_bits >= bits_for_digits(30)
    assert (accuracy.attempts, accuracy.working_bits) == (2, asked[-1])
    assert result == f"with {asked[-1]}"


def test_where_more_bits_do_not_help_it_is_said_and_not_tried_for_ever() -> None:
    asked: list[int] = []

    def attempt(bits: int) -> tuple[int, int | None]:
        asked.append(bits)
        return bits, 3

    with pytest.warns(AccuracyWarning, match="ACCURACY NOT REACHED: 15 digits were asked, .* 3 certain bits"):
        _, accuracy = until_accurate(attempt, 15, 100)
    assert accuracy is not None
    assert not accuracy.reached
    assert accuracy.to_json()["reached"] is False
    assert len(asked) == 2


def test_the_bits_are_bounded() -> None:
    asked: list[int] = []

    def attempt(bits: int) -> tuple[int, int | None]:
        asked.append(bits)
        return bits, -(10**6) + 5 * len(asked)

    with pytest.warns(AccuracyWarning):
        until_accurate(attempt, 15, 100)
    assert max(asked) <= 16 * 100
    assert len(asked) <= 3


def test_an_exact_result_is_found_once_without_a_word() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert until_accurate(lambda bits: (bits, None), 15, 100) == (100, None)
