"""Brackets hold one zero each: against exact signs at their ends, the count law, and brackets of more digits."""

from __future__ import annotations

from itertools import pairwise

import pytest
from flint import arb, fmpq

from gspot_verified import evaluate, number_of_zeros, zeros_at
from gspot_verified.signs.brackets import UndecidedError, _one_each, decimal_text

NEAR = fmpq(1, 10**8)


@pytest.mark.parametrize("digits", [1, 2, 9])
@pytest.mark.parametrize(
    "beta", [fmpq(1, 2), fmpq(3, 2), fmpq(5, 2), 3 - NEAR, 3 + NEAR, fmpq(23, 4), 6 - NEAR, fmpq(31, 4), 12 - NEAR]
)
def test_one_zero_in_each(beta: fmpq, digits: int) -> None:
    found = zeros_at(beta, digits).brackets
    finer = zeros_at(beta, 25).brackets
    assert len(found) == len(finer) == number_of_zeros(beta)
    for (lower, upper), (left, right) in zip(found, finer, strict=True):
        assert lower <= left < right <= upper
        assert 0 < upper - lower <= fmpq(1, 10**digits)
        ends = [evaluate(tau, beta, derivative=1, digits=10).value for tau in (lower, upper)]
        assert (ends[0] > 0 > ends[1]) or (ends[0] < 0 < ends[1])
    assert all(before[1] <= after[0] for before, after in pairwise(found))


def test_brackets_that_overlap_or_miss_one_are_refused() -> None:
    apart = ((fmpq(0), fmpq(1)), (fmpq(1), fmpq(2)))
    assert _one_each(apart, 2) == apart
    with pytest.raises(UndecidedError, match="overlap"):
        _one_each(((fmpq(0), fmpq(3, 2)), (fmpq(1), fmpq(2))), 2)
    with pytest.raises(UndecidedError, match="overlap"):
        _one_each(((fmpq(0), fmpq(1)), (fmpq(0), fmpq(1))), 2)
    for number in (1, 3, None):
        with pytest.raises(ArithmeticError, match="number of zeros"):
            _one_each(apart, number)


def test_decimal_text() -> None:
    assert decimal_text(fmpq(-3, 2), fmpq(-1, 8)) == "-1.500..-0.125"
    assert decimal_text(fmpq(2), fmpq(3)) == "2..3"
    assert decimal_text(fmpq(-1, 3), fmpq(0)) == "-1/3..0"


@pytest.mark.parametrize(
    ("beta", "digits"), [(3, 5), (0, 5), (-1, 5), ("401/2", 5), (arb(2, 1), 5), ("5/2", 0), ("5/2", 2001), ("5/2", 1.0)]
)
def test_bad_input(beta: object, digits: object) -> None:
    with pytest.raises(ValueError, match=r"beta|digits"):
        zeros_at(beta, digits)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("beta", "known"),
    [(-3, "none \\(dΘ/dτ > 0\\)"), (0, "at beta = 0 dΘ/dτ is 0 everywhere"), (201, "201$")],
)
def test_beyond_the_range_the_message_says_what_is_known(beta: int, known: str) -> None:
    with pytest.raises(ValueError, match="the real zeros are sought for 0 < beta <= 200, got .*" + known):
        zeros_at(beta)
