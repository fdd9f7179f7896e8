from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.signs.cover.pieces import (
    Column,
    ColumnPiece,
    Kind,
    cell_of,
    end_signs,
    fold_integer,
    monotone_runs,
    number_of_zeros,
)

LEFT = ColumnPiece(Kind.LEFT, None, fmpq(-2))


def sign(lower: int, upper: int, mark: int) -> ColumnPiece:
    return ColumnPiece(Kind.SIGN, fmpq(lower), fmpq(upper), mark)


def monotone(lower: int, upper: int, mark: int) -> ColumnPiece:
    return ColumnPiece(Kind.MONOTONE, fmpq(lower), fmpq(upper), mark)


def right(lower: int, mark: int = 0) -> ColumnPiece:
    return ColumnPiece(Kind.RIGHT, fmpq(lower), None, mark)


def column(lower: str | int, upper: str | int, *pieces: ColumnPiece) -> Column:
    ends = [fmpq(*map(int, str(end).split("/"))) for end in (lower, upper)]
    return Column(ends[0], ends[1], pieces)


def test_the_form_in_a_certificate() -> None:
    pieces = [
        ColumnPiece(Kind.LAPLACE, None, None), ColumnPiece(Kind.TAYLOR, fmpq(0), None), LEFT, right(3, 1),
        ColumnPiece(Kind.FOLD, fmpq(-1, 2), fmpq(1, 2)), ColumnPiece(Kind.HINGE, fmpq(0), fmpq(1, 3)),
        sign(1, 2, -1), monotone(-1, 1, 1),
    ]  # fmt: skip
    assert [piece.to_list() for piece in pieces] == [
        ["laplace"], ["taylor"], ["left", "-2"], ["right", "3", 1], ["fold", "-1/2", "1/2"], ["hinge", "0", "1/3"],
        ["sign", "1", "2", -1], ["monotone", "-1", "1", 1],
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("lower", "upper", "cell"),
    [
        (fmpq(2), fmpq(3), 1), (fmpq(5, 2), fmpq(5, 2), 1), (fmpq(3), fmpq(3), 1), (fmpq(3), fmpq(7, 2), 2),
        (fmpq(0), fmpq(1), -1), (fmpq(1), fmpq(1), -1), (fmpq(0), fmpq(0), -2), (fmpq(-1, 2), fmpq(-1, 3), -2),
    ],
)  # fmt: skip
def test_cells(lower: fmpq, upper: fmpq, cell: int) -> None:
    assert cell_of(lower, upper) == cell


@pytest.mark.parametrize(("lower", "upper"), [(fmpq(3, 2), fmpq(5, 2)), (fmpq(3), fmpq(4) + fmpq(1, 10**40))])
def test_a_range_across_an_integer_has_no_cell(lower: fmpq, upper: fmpq) -> None:
    with pytest.raises(ValueError, match="between two neighbouring integers"):
        cell_of(lower, upper)


@pytest.mark.parametrize(
    ("lower", "upper", "integer"),
    [
        ("2", "3", 2), ("3", "4", 2), ("5/2", "3", 2), ("3", "7/2", 2), ("3", "3", 2), ("5", "6", 5), ("6", "7", 5),
        ("0", "1", None), ("1", "2", None), ("4", "5", None), ("5/2", "14/5", None), ("0", "0", None),
    ],
)  # fmt: skip
def test_the_integer_of_a_fold_at_either_end(lower: str, upper: str, integer: int | None) -> None:
    found = column(lower, upper)
    assert found.lower is not None
    assert fold_integer(found.lower, found.upper) == integer


def test_fixed_signs_at_the_ends_of_pieces() -> None:
    assert end_signs(sign(0, 1, -1), 3) == (-1, -1)
    assert [end_signs(right(1, v), n) for n in (0, 1) for v in (0, 1)] == [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    for kind in (Kind.LEFT, Kind.FOLD, Kind.LAPLACE, Kind.TAYLOR):
        assert end_signs(ColumnPiece(kind, None, None), 1) == (1, 1)
    for kind in (Kind.MONOTONE, Kind.HINGE):
        with pytest.raises(ValueError, match="fixes no sign"):
            end_signs(ColumnPiece(kind, fmpq(0), fmpq(1)), 1)


# All in the cell 2 < beta < 3 (n = 1, F > 0 at both ends of the axis) unless the column says otherwise.
COUNTS: list[tuple[Column, int | None]] = [
    (column("21/10", "29/10", LEFT, monotone(-2, 0, -1), sign(0, 1, -1), monotone(1, 2, 1), right(2)), 2),
    (column("21/10", "29/10", LEFT, sign(-2, 2, 1), right(2)), 0),
    (column("21/10", "29/10", LEFT, monotone(-2, 0, -1), sign(0, 1, -1), right(1, 1)), 2),
    # two neighbouring monotone pieces of one direction are one run
    (column("21/10", "29/10", LEFT, monotone(-2, -1, -1), monotone(-1, 0, -1), sign(0, 1, -1), right(1, 1)), 2),
    # no change of sign over a monotone piece: no zero
    (column("21/10", "29/10", LEFT, monotone(-2, 0, -1), sign(0, 1, 1), right(1)), 0),
    # two directions in one run: there may be none or two
    (column("21/10", "29/10", LEFT, monotone(-2, 0, -1), monotone(0, 1, 1), right(1)), None),
    # the direction is against the change of sign
    (column("21/10", "29/10", LEFT, monotone(-2, 0, 1), sign(0, 1, -1), right(1, 1)), None),
    # two signs that meet must be equal
    (column("21/10", "29/10", LEFT, sign(-2, 0, -1), right(0, 1)), None),
    (column("21/10", "29/10", LEFT, sign(-2, 0, 1), right(0, 1)), None),
    # a monotone piece without a sign before or after it
    (column("21/10", "29/10", monotone(-2, 0, -1), sign(0, 1, -1), right(1, 1)), None),
    (column("21/10", "29/10", LEFT, monotone(-2, 0, -1)), None),
    # folds: two zeros below the integer b = 2, none above it
    (column("5/2", 3, LEFT, sign(-2, -1, 1), ColumnPiece(Kind.FOLD, fmpq(-1), fmpq(1)), right(1)), 2),
    (column(2, 3, LEFT, sign(-2, -1, 1), ColumnPiece(Kind.FOLD, fmpq(-1), fmpq(1)), right(1)), 2),
    (column(3, "7/2", LEFT, sign(-2, -1, 1), ColumnPiece(Kind.FOLD, fmpq(-1), fmpq(1)), right(1, 1)), 1),
    (column(0, 1, ColumnPiece(Kind.LAPLACE, None, None)), 0),
]


@pytest.mark.parametrize(("found", "zeros"), COUNTS)
def test_counting(found: Column, zeros: int | None) -> None:
    assert number_of_zeros(found) == zeros


def test_a_column_from_minus_infinity_has_no_zeros() -> None:
    whole = Column(None, fmpq(0), (ColumnPiece(Kind.LAPLACE, None, None),))
    assert number_of_zeros(whole) == 0
    assert whole.tubes() == []


def test_tubes_are_the_runs_with_a_change_of_sign() -> None:
    found, _ = COUNTS[0]
    assert found.tubes() == [(fmpq(-2), fmpq(0)), (fmpq(1), fmpq(2))]
    assert COUNTS[4][0].tubes() == []
    # Nothing fixes the sign before or after the run, or its direction is against the change: no zero is certain.
    assert [COUNTS[k][0].tubes() for k in (6, 9, 10)] == [[], [], []]
    assert column("21/10", "29/10", monotone(-2, 0, -1), sign(0, 1, -1)).tubes() == []
    assert column("21/10", "29/10", LEFT, monotone(-2, 0, 1), sign(0, 1, 1), right(1)).tubes() == []
    runs = monotone_runs(COUNTS[3][0].pieces, 1)
    assert [(len(run), before, after) for run, before, after in runs] == [(2, 1, -1)]
