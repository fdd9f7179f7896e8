"""Pieces over the whole line for functions with known zeros: where the tails begin, what is missing, which tail.

Page: proofs/finite_epsilon_zeros.md, sections 1 and 2.
"""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq

from gspot_verified.compliant.slow.slow_signs import CELL
from gspot_verified.compliant.zeros.slow_zero_column import left_end, right_end, slow_zero_column, tails
from gspot_verified.numbers.evidence import cover
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, number_of_zeros

BETA = fmpq(3, 2)


class _Falling:
    """A function that falls through 0 at ``zero``, in the cell n = 0."""

    def __init__(self, zero: fmpq, left: fmpq | int = 0) -> None:
        self.zero, self.left = zero, fmpq(left)
        self.asked: list[fmpq] = []

    def positive_before(self, tau: fmpq, n: int) -> bool:
        self.asked.append(tau)
        return n == 0 and tau <= self.left and tau < self.zero

    def sign(self, lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        if derivative:
            return -1
        return 1 if upper < self.zero else -1 if lower > self.zero else None

    def changes(self, tau: fmpq, n: int) -> int | None:
        return n if n else int(tau <= self.zero)


def _column(signs: Any, lower: fmpq | None = None, **options: Any) -> Column | None:
    return slow_zero_column(signs, lower or BETA, BETA, 0, fmpq(1, 128), **options)


@pytest.mark.parametrize("zero", [fmpq(-1, 3), fmpq(7, 3), fmpq(25)])
def test_the_pieces_cover_the_line_and_hold_the_zero(zero: fmpq) -> None:
    found = _column(_Falling(zero, -1))
    assert found is not None
    assert number_of_zeros(found) == 1
    assert cover(((piece.lower, piece.upper) for piece in found.pieces), (None, None)) is not None
    first, *_, last = found.pieces
    assert (first.kind, first.upper) == (Kind.LEFT, -1)
    assert (last.kind, last.mark) == (Kind.RIGHT, 0)
    assert last.lower is not None
    assert max(zero, fmpq(0)) < last.lower <= max(zero, fmpq(0)) + CELL
    [(lower, upper)] = found.tubes()
    assert lower < zero < upper
    assert _column(_Falling(zero, -1), along=found) == found


def test_without_an_end_or_a_middle_there_is_no_column(monkeypatch: pytest.MonkeyPatch) -> None:
    assert _column(_Falling(fmpq(1), -300)) is None
    assert _column(_Falling(fmpq(1), -20), reach=16) is None
    assert _column(_Falling(fmpq(1), -20), reach=32) is not None
    beyond = _column(_Falling(fmpq(20)), reach=16)
    assert beyond is not None
    assert beyond.pieces[-1].mark == 1  # the zero is left to the tail
    monkeypatch.setattr(_Falling, "sign", lambda *_: None)
    assert _column(_Falling(fmpq(1))) is None
    monkeypatch.setattr(_Falling, "sign", lambda *_: -1)  # negative from a point on where it is positive
    assert _column(_Falling(fmpq(1))) is None


def test_from_an_integer_on_one_zero_stays_in_the_tail() -> None:
    for n in (0, 1, 5):
        assert tails(fmpq(n + 1), n) == (1,)
        assert tails(n + fmpq(1, 9), n) == tails(n + fmpq(5, 4), n) == (0, 1)
    found = _column(_Falling(fmpq(7, 3)), lower=fmpq(1))
    assert found is not None
    assert (found.pieces[-1].kind, found.pieces[-1].mark) == (Kind.RIGHT, 1)
    assert number_of_zeros(found) == 1


@pytest.mark.parametrize("left", [fmpq(-1, 2), fmpq(-2), fmpq(-31, 2), fmpq(-200)])
def test_the_left_end_is_the_first_place_that_serves(left: fmpq) -> None:
    """At multiples of the cell, each at most a quarter further than the last one and a cell; the reach is included."""
    signs = _Falling(fmpq(1), left)
    found = left_end(signs, 0, 256)  # type: ignore[arg-type]
    assert found is not None
    assert found <= left
    assert signs.asked[0] == -CELL
    assert signs.asked[-1] == found
    for first, second in zip(signs.asked, signs.asked[1:], strict=False):
        assert (second / CELL).q == 1
        assert second < first
        assert first > left
        assert second >= min(first - CELL, first * fmpq(5, 4))
    assert left_end(_Falling(fmpq(1), found), 0, int((-found).ceil())) == found  # type: ignore[arg-type]
    assert left_end(_Falling(fmpq(1), -1), 0, 1) == -1  # type: ignore[arg-type]
    assert left_end(_Falling(fmpq(1), -1), 1, 256) is None  # type: ignore[arg-type]


def test_the_right_end_is_sought_up_to_its_reach() -> None:
    for zero, reach, wanted in ((5, 8, fmpq(11, 2)), (5, 7, None), (12, 16, fmpq(25, 2)), (12, 15, None)):
        assert right_end(_Falling(fmpq(zero)), 0, 0, reach) == wanted  # type: ignore[arg-type]
    assert right_end(_Falling(fmpq(5)), 0, 1, 8) == CELL  # type: ignore[arg-type]


def test_the_right_end_is_sought_from_near_on() -> None:
    """Far out the models are too wide to tell a sign, for large epsilon from tau = 6 on."""

    class Blurred(_Falling):
        def changes(self, tau: fmpq, n: int) -> int | None:
            return super().changes(tau, n) if tau <= 6 else None

    for zero, wanted in ((fmpq(1), fmpq(3, 2)), (fmpq(3), fmpq(7, 2))):
        assert right_end(Blurred(zero), 0, 0, 16) == wanted  # type: ignore[arg-type]
    assert right_end(Blurred(fmpq(7)), 0, 0, 16) is None  # type: ignore[arg-type]


def test_a_right_end_that_is_given_is_tried_alone() -> None:
    pieces = (ColumnPiece(Kind.LEFT, None, fmpq(-1)), ColumnPiece(Kind.RIGHT, fmpq(7), None, 0))
    along = Column(fmpq(3, 2), fmpq(3, 2), pieces)
    assert right_end(_Falling(fmpq(5)), 0, 0, 8, along) == 7  # type: ignore[arg-type]
    assert right_end(_Falling(fmpq(5)), 0, 1, 8, along) is None  # type: ignore[arg-type]
    assert right_end(_Falling(fmpq(15, 2)), 0, 0, 8, along) is None  # type: ignore[arg-type]
