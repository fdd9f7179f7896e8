"""Brackets hold one zero each: against exact signs at their ends, the count law, and brackets of more digits."""

from __future__ import annotations

from itertools import pairwise

import pytest
from flint import arb, fmpq

from gspot_verified import evaluate, number_of_zeros
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.signs.cover.pieces import number_of_zeros as number_of_zeros_of_column
from gspot_verified.signs.cover.zero_column import zero_column
from gspot_verified.signs.zeros import brackets
from gspot_verified.signs.zeros.brackets import _cell_by_newton, _one_each, _tail_tube, zeros_at
from gspot_verified.signs.zeros.slope_at import SlopeAt, UndecidedError

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


def test_one_zero_is_no_plural() -> None:
    assert str(zeros_at("3/2", 3)).splitlines()[0] == "β = 3/2: one real zero of dΘ/dτ, simple"
    assert str(zeros_at("5/2", 3)).splitlines()[0] == "β = 5/2: 2 real zeros of dΘ/dτ, all simple"


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


@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(23, 4), fmpq(31, 4), 3 - NEAR, 6 + NEAR])
def test_brackets_with_and_without_a_column_are_the_same(beta: fmpq, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two routes to the intervals: the count law with changes of sign, and a column of pieces."""
    found = zeros_at(beta, 12)
    assert number_of_zeros_of_column(found.column) == len(found.brackets)
    monkeypatch.setattr(brackets, "_changes", lambda *_: [])
    assert zeros_at(beta, 12).brackets == found.brackets


def test_fewer_changes_of_sign_than_zeros_are_not_taken() -> None:
    """Next to an integer one zero is far out, beyond the grid."""
    assert brackets._changes(SlopeAt(2 + fmpq(1, 10**40), fmpq(8), 9)) == []
    assert len(brackets._changes(SlopeAt(fmpq(7, 3), fmpq(9), 9))) == 2


@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(6_001, 1_000), fmpq(-1, 100) + 9])
@pytest.mark.parametrize("digits", [1, 15, 60])
def test_newtons_method_and_bisection_find_the_same_cells(
    beta: fmpq, digits: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    quick = zeros_at(beta, digits)
    monkeypatch.setattr(brackets, "_cell_by_newton", lambda *_: None)
    assert zeros_at(beta, digits) == quick


def test_a_column_with_another_number_of_zeros_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    found = zeros_at("5/2", 5)
    monkeypatch.setattr(brackets, "number_of_zeros", lambda _: 1)
    with pytest.raises(ArithmeticError, match="not that of the brackets"):
        _ = found.column


@pytest.mark.parametrize("digits", [9, 60])
def test_the_slope_at_points(digits: int) -> None:
    """Carried, beyond the reach, and by evaluation alone (many digits): the signs of another route."""
    slope = SlopeAt(fmpq(31, 4), fmpq(5), digits)
    for k in range(-9, 30):
        value = evaluate(fmpq(k, 3), fmpq(31, 4), derivative=1, digits=10).value
        assert slope.sign(fmpq(k, 3)) == (1 if value > 0 else -1)
    lower, upper = zeros_at(fmpq(31, 4), 20).brackets[0]
    guess = slope.newton(lower + fmpq(1, 1000), 20)
    assert abs(guess - arb(upper)) < 1e-4


def test_a_last_zero_that_is_not_met_is_left_open() -> None:
    class Slope:
        def sign(self, tau: fmpq) -> int:
            return -1 if tau > 0 else 1

    column = zero_column(fmpq(3), 3 + fmpq(1, 10**40))
    assert column is not None
    with pytest.raises(UndecidedError, match="too far out"):
        brackets._tail_tube(Slope(), column)  # type: ignore[arg-type]


class _Slope:
    """A slope with one change of sign at ``zero``, and a step of Newton's method that says nothing."""

    def __init__(self, zero: fmpq) -> None:
        self.zero = zero

    def sign(self, tau: fmpq) -> int:
        return 1 if tau > self.zero else -1

    def newton(self, *_: object) -> arb:
        return arb.nan()


def test_the_tube_of_the_last_zero_begins_where_the_tail_does() -> None:
    """F has the sign of (-1)^(n+1) at infinity, and n = 0 for 1 < beta < 2: dTheta/dtau > 0 there."""
    pieces = (ColumnPiece(Kind.SIGN, fmpq(1), fmpq(3), 1), ColumnPiece(Kind.RIGHT, fmpq(3), None, 1))
    column = Column(fmpq(3, 2), fmpq(3, 2), pieces)
    assert _tail_tube(_Slope(fmpq(4)), column) == (3, 6)  # type: ignore[arg-type]
    assert _tail_tube(_Slope(fmpq(10)), column) == (6, 12)  # type: ignore[arg-type]


def test_a_step_of_newtons_method_that_is_not_finite_finds_no_cell() -> None:
    assert _cell_by_newton(_Slope(fmpq(1, 3)), fmpq(0), fmpq(1), -1, 5) is None  # type: ignore[arg-type]


def test_newtons_method_finds_the_cell() -> None:
    slope = SlopeAt(fmpq(5, 2), fmpq(4), 8)
    cell = _cell_by_newton(slope, fmpq(1), fmpq(2), slope.sign(fmpq(1)), 8)
    assert cell == (fmpq(153171613, 10**8), fmpq(153171614, 10**8))
