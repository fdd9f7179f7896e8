from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from samples.piece_samples import assert_column, sign_of_f
from samples.strategies import to_fmpq

from gspot_verified.signs.cover.column_models import ColumnModels
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, number_of_zeros
from gspot_verified.signs.cover.zero_column import grid, right_tail, zero_column
from gspot_verified.signs.gamma import count_law

TINY = fmpq(1, 10**40)


def assert_counts(column: Column) -> None:
    """The number is that of the count law, at an inner point."""
    assert column.lower is not None
    assert number_of_zeros(column) == count_law.number_of_zeros((column.lower + column.upper) / 2)


@pytest.mark.parametrize(
    ("lower", "upper"),
    [
        (fmpq(5, 2), fmpq(5, 2)),
        (fmpq(5, 2), fmpq(21, 8)),
        (fmpq(95, 32), fmpq(3)),
        (fmpq(3), fmpq(49, 16)),
        (fmpq(3) - TINY, fmpq(3)),
        (fmpq(3), fmpq(3) + TINY),
        (fmpq(2) - TINY, fmpq(2)),
        (fmpq(2), fmpq(2) + TINY),
        (fmpq(2) + TINY, fmpq(2) + TINY),
        (fmpq(63, 16), fmpq(4)),
        (fmpq(4), fmpq(65, 16)),
        (fmpq(1), fmpq(17, 16)),
        (fmpq(0), fmpq(1)),
        (fmpq(191, 32), fmpq(6)),
        (fmpq(38, 3), fmpq(38, 3)),
        (fmpq(3) - fmpq(1, 10**400), fmpq(3)),
        (fmpq(3), fmpq(3) + fmpq(1, 10**400)),
    ],
)
def test_columns_at_hard_places(lower: fmpq, upper: fmpq) -> None:
    column = zero_column(lower, upper)
    assert column is not None
    assert (column.lower, column.upper) == (lower, upper)
    assert_column(column, None, None)
    assert_counts(column)


@settings(max_examples=15)
@given(st.fractions(Fraction(1), 9, max_denominator=30), st.fractions(0, Fraction(1, 20), max_denominator=100))
def test_random_columns(lower: Fraction, width: Fraction) -> None:
    upper = min(lower + width, Fraction(lower.numerator // lower.denominator + 1))
    assume(lower < upper or lower.denominator > 1)
    column = zero_column(to_fmpq(lower), to_fmpq(upper))
    assume(column is not None)
    assert column is not None
    assert_column(column, None, None)
    assert_counts(column)
    assert column.lower is not None
    for start, end in column.tubes():
        for beta in (column.lower, column.upper):
            assert sign_of_f(start, beta - 1) == -(sign_of_f(end, beta - 1) or 0)


def test_a_wide_range_has_no_column_and_no_wrong_one() -> None:
    assert zero_column(fmpq(2), fmpq(3)) is None
    with pytest.raises(ValueError, match="between two neighbouring integers"):
        zero_column(fmpq(5, 2), fmpq(7, 2))


def test_a_fold_needs_width_and_its_signs() -> None:
    models = ColumnModels(fmpq(2), fmpq(33, 16), fmpq(8))
    assert models.fold(fmpq(-1, 4), fmpq(1, 4))
    assert not ColumnModels(fmpq(2), fmpq(2), fmpq(8)).fold(fmpq(-1, 4), fmpq(1, 4))
    # Around b = 1 and b = 3 there is no fold.
    for b in (1, 3):
        assert not ColumnModels(fmpq(b), b + fmpq(1, 16), fmpq(8)).fold(fmpq(-1, 4), fmpq(1, 4))


def test_models_beyond_their_reach_say_nothing_wrong() -> None:
    models = ColumnModels(fmpq(3, 2), fmpq(25, 16), fmpq(2))
    for tau in (1, 3, 8, 20, 60):
        assert models.sign(fmpq(tau), fmpq(tau)) in (None, sign_of_f(fmpq(tau), fmpq(49, 32)))


def test_right_tail_is_the_least_of_the_grid() -> None:
    models = ColumnModels(fmpq(3, 2), fmpq(25, 16), fmpq(8))
    found = right_tail(models, 1, fmpq(8), 0)
    assert found is not None
    assert models.changes(found, 1) == 0
    assert models.changes(found - fmpq(1, 2), 1) != 0


def test_grid() -> None:
    assert grid(fmpq(-1, 3), fmpq(1))[::-1] == [
        (fmpq(-1, 3), fmpq(0)), (fmpq(0), fmpq(1, 2)), (fmpq(1, 2), fmpq(1)),
    ]  # fmt: skip
    assert grid(fmpq(1, 8), fmpq(1, 4)) == [(fmpq(1, 8), fmpq(1, 4))]


def test_pieces_of_a_fold_column() -> None:
    kinds = {
        beta: zero_column(*ends) for beta, ends in {0: (fmpq(95, 32), fmpq(3)), 1: (fmpq(3), fmpq(49, 16))}.items()
    }
    for column in kinds.values():
        assert column is not None
        assert [piece.kind for piece in column.pieces].count(Kind.FOLD) == 1


@pytest.mark.parametrize(("lower", "upper"), [(fmpq(95, 32), fmpq(3)), (fmpq(3), fmpq(49, 16))])
def test_no_column_at_a_fold_whose_hypotheses_fail(monkeypatch: pytest.MonkeyPatch, lower: fmpq, upper: fmpq) -> None:
    assert zero_column(lower, upper) is not None
    monkeypatch.setattr(ColumnModels, "fold", lambda *_: False)
    assert zero_column(lower, upper) is None


class _OneZeroBefore:
    """Certain signs of a function whose changes beyond tau = 3 are none."""

    def sign(self, *_: object) -> int | None:
        return None

    def changes(self, tau: fmpq, *_: object) -> int | None:
        return 0 if tau >= 3 else 1


def test_the_tail_of_another_column_is_taken_where_it_is_one() -> None:
    """Only the last piece counts, and only if it is a tail on the right; else the least place of the grid is sought."""
    before = ColumnPiece(Kind.SIGN, fmpq(7, 2), fmpq(4), 1)
    along = Column(fmpq(2), fmpq(5, 2), (before, ColumnPiece(Kind.RIGHT, fmpq(4), None, 0)))
    assert right_tail(_OneZeroBefore(), 1, fmpq(8), 0, along) == 4
    no_tail = Column(fmpq(2), fmpq(5, 2), (before, ColumnPiece(Kind.LAPLACE, None, None)))
    assert right_tail(_OneZeroBefore(), 1, fmpq(8), 0, no_tail) == 3
    assert right_tail(_OneZeroBefore(), 1, fmpq(8), 0) == 3
