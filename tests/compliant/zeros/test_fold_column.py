"""Columns across a fold: nothing that the page asks for is left out, seen on patches made by hand.

Page: proofs/finite_epsilon_zeros.md, section 6.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.compliant.patches.slow_patch import SlowPatch
from gspot_verified.compliant.slow.slow_signs import CELL
from gspot_verified.compliant.zeros import fold_column as module
from gspot_verified.compliant.zeros.fold_column import (
    fold_column,
    fold_parts,
    is_fold,
    nearest_minimum,
    numbers_of_zeros,
)
from gspot_verified.numbers.evidence import cover
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind

LOWER, UPPER, SMALL, LEAST = fmpq(11, 2), fmpq(45, 8), fmpq(1, 10), fmpq(1, 2**20)
Signs = Callable[[fmpq, fmpq, int], int | None]


class Patch:
    """Signs as a function of the interval and the order of the derivative, and the tail by its place."""

    def __init__(self, sign: Signs, tail: Callable[[fmpq], int | None] = lambda _: None) -> None:
        self.sign_of, self.tail = sign, tail

    def sign(self, lower: fmpq, upper: fmpq, order: int = 0) -> int | None:
        return self.sign_of(lower, upper, order)

    def changes(self, place: fmpq, _: int) -> int | None:
        return self.tail(place)


@pytest.mark.parametrize(("begin", "end"), [(fmpq(1, 8), fmpq(3, 8)), (fmpq(-1, 3), fmpq(7, 5))])
def test_the_parts_of_a_fold_leave_nothing_out(begin: fmpq, end: fmpq) -> None:
    parts = fold_parts(begin, end)
    assert cover(parts, (begin, end)) is not None
    assert all(begin <= a < b <= end and b - a <= CELL / 3 for a, b in parts)
    assert all((b / CELL).ceil() - (a / CELL).floor() == 1 for a, b in parts)


def test_a_fold_asks_for_each_of_its_signs() -> None:
    begin, end = fmpq(1, 8), fmpq(11, 8)
    parts = fold_parts(begin, end)
    honest = Patch(lambda *_: 1)
    assert is_fold(honest, honest, begin, end)  # type: ignore[arg-type]

    def wrong(place: tuple[fmpq, fmpq], at: int) -> Patch:
        return Patch(lambda a, b, order: None if ((a, b), order) == (place, at) else 1)

    for one in (wrong((begin, begin), 0), wrong((end, end), 0), *(wrong(part, 2) for part in parts)):
        assert not is_fold(one, honest, begin, end)  # type: ignore[arg-type]
    for part in parts:
        assert not is_fold(honest, wrong(part, 0), begin, end)  # type: ignore[arg-type]


class Staged:
    """fold_column on a patch on which all succeeds, but for what a test changes: a minimum at 1, ends at -2 and 3."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.left, self.right, self.serves = fmpq(-2), fmpq(3), True
        self.least = SMALL
        self.fold, self.value, self.numbers, self.gap = True, 0.0, True, ""
        stand_ins: dict[str, Any] = {
            "SlowPatch": self.patch,
            "nearest_minimum": self.minimum,
            "left_end": lambda *_: self.left,
            "right_end": lambda *_: self.right,
            "tails": lambda *_: (1,),
            "is_fold": lambda *_: self.fold,
            "cover": self.covered,
            "numbers_of_zeros": lambda *_: (2, 0) if self.numbers else None,
        }
        for name, stand_in in stand_ins.items():
            monkeypatch.setattr(module, name, stand_in)

    def patch(self, *given: fmpq) -> Staged:
        assert given == (LOWER - 1, UPPER - 1, self.least, SMALL)
        return self

    def minimum(self, b: fmpq, epsilon: fmpq) -> tuple[fmpq, float]:
        assert b in (LOWER - 1, UPPER - 1)
        assert 0 < epsilon <= SMALL
        return fmpq(1), self.value

    def signs(self, *given: fmpq) -> Patch:
        assert given == (LOWER - 1, UPPER - 1)
        return Patch(lambda *_: 1, lambda place: 1 if self.serves and place >= self.right else None)

    slopes = signs

    def covered(self, _: Any, lower: fmpq, upper: fmpq, *__: Any) -> tuple[ColumnPiece, ...] | None:
        assert lower < upper
        failed = {"before": upper <= 1, "after": lower >= 1}.get(self.gap, False)
        return None if failed else (ColumnPiece(Kind.SIGN, lower, upper, 1),)

    def found(self) -> Column | None:
        return fold_column(LOWER, UPPER, 4, self.least, SMALL, LEAST)


@pytest.mark.parametrize("least", [SMALL, fmpq(0)])
def test_a_column_covers_the_line_in_order(least: fmpq, monkeypatch: pytest.MonkeyPatch) -> None:
    staged = Staged(monkeypatch)
    staged.least = least
    column = staged.found()
    assert column is not None
    assert (column.lower, column.upper) == (LOWER, UPPER)
    kinds = [piece.kind for piece in column.pieces]
    assert kinds == [Kind.LEFT, Kind.SIGN, Kind.FOLD, Kind.SIGN, Kind.RIGHT]
    assert [piece.upper for piece in column.pieces] == [fmpq(-2), fmpq(3, 4), fmpq(5, 4), fmpq(3), None]
    assert all(one.upper == other.lower for one, other in pairwise(column.pieces))
    assert column.pieces[-1].mark == 1


@pytest.mark.parametrize(
    ("name", "value"),
    [("fold", False), ("left", None), ("right", None), ("numbers", False), ("gap", "before"), ("gap", "after")],
)
def test_without_one_of_its_parts_there_is_no_column(name: str, value: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    staged = Staged(monkeypatch)
    setattr(staged, name, value)
    assert staged.found() is None


def test_where_no_minimum_is_near_0_nothing_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    staged = Staged(monkeypatch)
    for staged.value in (-10.0, 10.0):
        assert staged.found() is None


def test_a_tail_begins_behind_the_fold_where_it_serves_there(monkeypatch: pytest.MonkeyPatch) -> None:
    staged = Staged(monkeypatch)
    staged.right = fmpq(1)
    column = staged.found()
    assert column is not None
    assert column.pieces[-1].lower == fmpq(3, 2)
    assert column.pieces[-2].upper == fmpq(3, 2)
    staged.serves = False
    assert staged.found() is None


def test_a_left_end_behind_the_fold_begins_with_it(monkeypatch: pytest.MonkeyPatch) -> None:
    staged = Staged(monkeypatch)
    staged.left = fmpq(9, 10)
    column = staged.found()
    assert column is not None
    assert [piece.kind for piece in column.pieces[:2]] == [Kind.LEFT, Kind.FOLD]
    assert column.pieces[0].upper == column.pieces[1].lower == fmpq(3, 4)


def test_a_fold_is_behind_an_integer_only_where_the_polynomial_has_no_more_zeros() -> None:
    """F_8 has two zeros up to epsilon = 13.75; two more at that epsilon meet: nothing is said about a range that holds
    it, nor about a column that begins elsewhere."""
    pieces = (
        ColumnPiece(Kind.LEFT, None, fmpq(-1)), ColumnPiece(Kind.FOLD, fmpq(-1), fmpq(1)),
        ColumnPiece(Kind.MONOTONE, fmpq(1), fmpq(2), -1), ColumnPiece(Kind.SIGN, fmpq(2), fmpq(3), -1),
        ColumnPiece(Kind.MONOTONE, fmpq(3), fmpq(4), 1), ColumnPiece(Kind.RIGHT, fmpq(4), None, 1),
    )  # fmt: skip
    column = Column(fmpq(9), fmpq(73, 8), pieces)
    assert numbers_of_zeros(column, fmpq(0), fmpq(13)) == (3,)
    assert numbers_of_zeros(column, fmpq(13), fmpq(14)) == (5, 3)
    assert numbers_of_zeros(column, fmpq(14), fmpq(15)) == (5, 3)
    assert numbers_of_zeros(Column(fmpq(145, 16), fmpq(73, 8), pieces), fmpq(0), fmpq(13)) == (5, 3)
    without = (pieces[0], ColumnPiece(Kind.SIGN, fmpq(-1), fmpq(1), 1), *pieces[2:])
    assert numbers_of_zeros(Column(fmpq(145, 16), fmpq(73, 8), without), fmpq(0), fmpq(13)) == (3,)


def test_no_fold_is_found_where_there_is_none() -> None:
    """At 4.75, 1/10 and at 7/2, 1 G is negative at its minimum; at 4 it has none."""
    for lower, upper, n, epsilon in (
        (fmpq(4), fmpq(4), 2, fmpq(1)),
        (fmpq(19, 4), fmpq(77, 16), 3, fmpq(1, 10)),
        (fmpq(7, 2), fmpq(57, 16), 2, fmpq(1)),
    ):
        assert fold_column(lower, upper, n, epsilon, epsilon, fmpq(1, 128)) is None


def test_a_fold_needs_its_signs_on_every_part() -> None:
    """beta from 8.125 to 8.25, epsilon = 1: G > 0 left and right of two more zeros; between them it is not convex."""
    lower, upper = fmpq(57, 8), fmpq(58, 8)
    patch = SlowPatch(lower, upper, fmpq(1), fmpq(1))
    signs, slopes = patch.signs(lower, upper), patch.slopes(lower, upper)
    place, _ = nearest_minimum((lower + upper) / 2, fmpq(1))
    assert place is not None
    begin, end = place - fmpq(1, 4), place + fmpq(13, 2)
    assert signs.sign(begin, begin) == signs.sign(end, end) == 1
    assert {signs.sign(a, b, 2) for a, b in fold_parts(begin, end)} > {1}
    assert not is_fold(signs, slopes, begin, end)
    assert is_fold(signs, slopes, begin, place + fmpq(1, 2))
