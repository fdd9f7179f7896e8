"""Rectangles of (beta, epsilon): the numbers against single points, folds, rows, journals, bad input.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.zeros import zero_map as module
from gspot_verified.compliant.zeros.fold_column import (
    fold_column,
    numbers_of_zeros,
)
from gspot_verified.compliant.zeros.zero_count import slow_zeros
from gspot_verified.compliant.zeros.zero_map import Row, ZeroMap, examine, least_work, zero_map
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.cover.journal import _to_json
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.work.ranges import Range

BELOW_FOLD = ("43/8..11/2", "19/20..1")


def test_two_columns_for_a_range_of_epsilon_against_points() -> None:
    found = zero_map(*BELOW_FOLD)
    assert found.verdict.outcome is Outcome.PROVED
    [row] = found.rows
    assert row.stretches() == [(fmpq(43, 8), fmpq(11, 2), (3,))]
    for beta in ("5.376", "5.5"):
        for epsilon in ("0.95", "1"):
            assert slow_zeros(beta, epsilon, digits=2).number == 3


@pytest.mark.slow
def test_a_fold_beyond_the_beginning_of_the_tail() -> None:
    """The fold that leaves (9, 0) passes beta = 7 at epsilon = 17.55: there it reaches into the tail on the right."""
    found = examine(fmpq(7167, 1024), fmpq(7), epsilon_lower=fmpq(970299, 62500), epsilon_upper=fmpq(281216, 15625))
    assert found is not None
    assert [piece.kind for piece in found.pieces].count(Kind.FOLD) == 1


@pytest.mark.slow
def test_the_fold_for_all_small_epsilon() -> None:
    """For 0 < epsilon <= 1/1000 at once: three zeros, and one beyond the fold next to beta = 6."""
    found = zero_map("47/8..6", "0..1/1000")
    assert found.verdict.outcome is Outcome.PROVED
    assert found.rows[0].stretches() == [(fmpq(47, 8), fmpq(6), (3, 1))]


@pytest.mark.slow
def test_the_law_between_4_and_5_up_to_epsilon_32() -> None:
    """Theorem D (b): at epsilon = 32 the only double zero is that of beta = 5, so there are two zeros for beta < 5."""
    [row] = zero_map("4..5", "32").rows
    assert not row.unfinished
    *plain, last = row.stretches()
    assert [numbers for _, _, numbers in plain] == [(2,)]
    assert last[1:] == (5, (2, 0))


def test_a_column_across_the_fold_against_points() -> None:
    """epsilon = 1: beta_f = 5.670239. It is found where pieces of one sign each do not suffice."""
    lower, upper = fmpq(565, 100), fmpq(569, 100)
    column = fold_column(lower, upper, 4, fmpq(1), fmpq(1), fmpq(1, 128))
    assert column is not None
    assert examine(lower, upper, epsilon_lower=fmpq(1), epsilon_upper=fmpq(1)) == column
    assert examine(lower, upper, column, epsilon_lower=fmpq(1), epsilon_upper=fmpq(1)) == column
    assert numbers_of_zeros(column, fmpq(1), fmpq(1)) == (3, 1)
    assert (slow_zeros(lower, 1, 2).number, slow_zeros(upper, 1, 2).number) == (3, 1)


def test_from_6_on_the_fold_is_behind() -> None:
    """For all 0 < epsilon <= 1/1000: G at its minimum tends to 0 with epsilon at beta = 6, and stays positive."""
    column = fold_column(fmpq(6), fmpq(49, 8), 5, fmpq(0), fmpq(1, 1000), fmpq(1, 128))
    assert column is not None
    assert numbers_of_zeros(column, fmpq(0), fmpq(1, 1000)) == (2,)
    assert [slow_zeros(beta, "1/1000", 2).number for beta in ("6.001", "6.125")] == [2, 2]


def test_the_fold_from_9_against_points() -> None:
    """epsilon = 1: beta_f = 8.173525."""
    lower, upper = fmpq(65, 8), fmpq(33, 4)
    column = fold_column(lower, upper, 7, fmpq(1), fmpq(1), fmpq(1, 128))
    assert column is not None
    assert numbers_of_zeros(column, fmpq(1), fmpq(1)) == (4, 2)
    assert [slow_zeros(beta, 1, 2).number for beta in ("8.1735", "8.1736")] == [4, 2]


@pytest.mark.slow
def test_from_9_on_the_fold_is_behind() -> None:
    column = fold_column(fmpq(9), fmpq(1153, 128), 8, fmpq(0), fmpq(1, 1000), fmpq(1, 128))
    assert column is not None
    assert numbers_of_zeros(column, fmpq(0), fmpq(1, 1000)) == (3,)
    assert [slow_zeros(beta, "1/1000", 2).number for beta in ("9.001", "9.007")] == [3, 3]


def test_below_4_the_theorem_tells() -> None:
    found = zero_map("1..4", "0..100")
    assert found.verdict.outcome is Outcome.PROVED
    assert "β < 4, every ε > 0, by theorem: 1 on (1, 2), 2 on (2, 3), 1 on (3, 4)" in str(found)
    assert len(str(found).splitlines()) == 2  # no rows of ε: there is nothing in them
    assert found.examined == 0


def test_from_a_column_beyond_the_fold_there_is_no_way_back() -> None:
    """Columns (5, 3) after a column of 3 zeros that ends where they begin; not across an integer, nor across a gap."""
    plain = (ColumnPiece(Kind.LEFT, None, fmpq(-1)), ColumnPiece(Kind.MONOTONE, fmpq(-1), fmpq(2), -1))
    fold = (plain[0], ColumnPiece(Kind.FOLD, fmpq(-1), fmpq(1)), ColumnPiece(Kind.MONOTONE, fmpq(1), fmpq(2), -1))
    rest = (
        ColumnPiece(Kind.SIGN, fmpq(2), fmpq(3), -1),
        ColumnPiece(Kind.MONOTONE, fmpq(3), fmpq(4), 1),
        ColumnPiece(Kind.RIGHT, fmpq(4), None, 1),
    )
    ends = [fmpq(n, 2) for n in (17, 18, 19)]

    def numbers(*columns: Column) -> list[tuple[int, ...]]:
        return [found for _, _, found in Row(fmpq(13), fmpq(14), columns, ()).stretches()]

    first, second = Column(fmpq(37, 4), ends[2], plain + rest), Column(ends[2], fmpq(39, 4), fold + rest)
    assert numbers(first, second) == [(3,)]
    assert numbers(Column(fmpq(37, 4), ends[2], fold + rest), second) == [(5, 3)]
    assert numbers(Column(fmpq(37, 4), fmpq(75, 8), plain + rest), second) == [(3,), (5, 3)]
    assert numbers(second, Column(fmpq(39, 4), fmpq(10), plain + rest)) == [(5, 3), (3,)]
    before = Column(ends[0], ends[1], (plain[0], *fold[1:], *rest[:2], ColumnPiece(Kind.RIGHT, fmpq(4), None, 0)))
    assert numbers(before, Column(ends[1], fmpq(37, 4), fold + rest))[-1] == (5, 3)


def test_before_a_column_with_both_there_is_no_fold_yet() -> None:
    """A column (3, 1) has 3 if one of 3 zeros begins where it ends; not across an integer, nor across a gap."""
    numbers = {(0, 1): (3, 1), (1, 2): (3, 1), (2, 3): (3,), (3, 4): (3, 1), (4, 5): (1,), (6, 7): (3, 1), (8, 9): (3,)}
    assert told(numbers, 5) == [(0, 3, (3,)), (3, 4, (3, 1)), (4, 5, (1,)), (6, 7, (3, 1)), (8, 9, (3,))]
    across = {(14, 15): (3, 1), (15, 16): (3, 1), (16, 17): (3,)}
    assert told(across, 5) == [(14, 16, (3, 1)), (16, 17, (3,))]


def told(numbers: dict[tuple[int, int], tuple[int, ...]], start: int) -> list[tuple[int, int, tuple[int, ...]]]:
    return [(a, b, each) for a, b, each, _ in told_of_folds(numbers, start)]


def told_of_folds(
    numbers: dict[tuple[int, int], tuple[int, ...]], start: int
) -> list[tuple[int, int, tuple[int, ...], bool]]:
    """The stretches at epsilon = 1 of columns whose ends are counted in sixteenths from ``start``, an integer, from
    which on there is one zero in the tail; whether a fold is said to lie in them."""
    tails = {ends: (ColumnPiece(Kind.RIGHT, fmpq(1), None, int(ends[0] == 0)),) for ends in numbers}
    columns = tuple(Column(start + fmpq(a, 16), start + fmpq(b, 16), tails[a, b]) for a, b in numbers)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(module, "numbers_of_zeros", lambda column, *_: numbers[ends_of(column, start)])
        found = Row(fmpq(1), fmpq(1), columns, ()).stretch_rows
    ends = [[int(16 * (end - start)) for end in one.beta] for one in found]
    return [(a, b, one.numbers, one.fold_inside) for (a, b), one in zip(ends, found, strict=True)]


@pytest.mark.parametrize(
    ("numbers", "inside"),
    [
        ({(1, 2): (3,), (2, 3): (3, 1), (3, 4): (1,)}, True),
        ({(1, 2): (3,), (2, 3): (3, 1), (4, 5): (1,)}, False),
        ({(0, 1): (3,), (2, 3): (3, 1), (3, 4): (1,)}, False),
        ({(2, 3): (3, 1), (3, 4): (1,)}, False),
        ({(1, 2): (3,), (2, 3): (3, 1)}, False),
        ({(0, 1): (3, 1), (1, 2): (1,)}, True),  # F_4 has two zeros, and one more comes in from +inf
        ({(0, 1): (4, 2), (1, 2): (2,)}, False),
        ({(14, 15): (3,), (15, 16): (3, 1)}, True),  # F_5 has one
        ({(14, 15): (4,), (15, 16): (4, 2)}, False),
        ({(0, 16): (3, 1)}, True),
    ],
)
def test_where_a_fold_lies(numbers: dict[tuple[int, int], tuple[int, ...]], inside: bool) -> None:
    """By what ends where a stretch with two numbers begins and ends, and by the polynomials F_4 and F_5 there."""
    assert [one[3] for one in told_of_folds(numbers, 5) if len(one[2]) == 2] == [inside]


def ends_of(column: Column, start: int) -> tuple[int, int]:
    assert column.lower is not None
    return int(16 * (column.lower - start)), int(16 * (column.upper - start))


@pytest.mark.parametrize(
    ("beta", "true"), [("5670236/1000000..5670238/1000000", 3), ("5670240/1000000..5670242/1000000", 1)]
)
def test_a_fold_next_to_the_range_is_not_said_to_lie_in_it(beta: str, true: int) -> None:
    """epsilon = 1: beta_f = 5.6702389. A column across the fold is found there too; it does not tell the side."""
    found = zero_map(beta, "1")
    [stretch] = found.rows[0].stretch_rows
    assert slow_zeros(found.beta[0], 1, 2).number == true
    assert stretch.numbers == (3, 1)
    assert not stretch.fold_inside
    assert "3 or 1 on" in str(found)
    assert "β_f may lie outside of it" in str(found)
    assert "inside of it" not in str(found)
    assert "two numbers" in found.verdict.statement


def test_a_fold_between_ranges_with_both_numbers_lies_in_its_own() -> None:
    found = zero_map("45/8..47/8", "1")
    stretches = found.rows[0].stretch_rows
    assert [(stretch.numbers, stretch.fold_inside) for stretch in stretches] == [((3, 1), False), ((1,), False)]
    found = zero_map("11/2..47/8", "1")
    stretches = found.rows[0].stretch_rows
    assert [(each.numbers, each.fold_inside) for each in stretches] == [((3,), False), ((3, 1), True), ((1,), False)]
    assert "3 | 1 on (45/8, 23/4)" in str(found)
    assert "there is one β_f inside of it" in str(found)
    assert "may lie outside" not in str(found)


def test_a_journal_by_hand_cannot_place_a_fold(tmp_path: Path) -> None:
    """The true column across the fold, for a range before it."""
    beta, ends = "565/100..566/100", (fmpq(113, 20), fmpq(283, 50))
    column = fold_column(*ends, 4, fmpq(1), fmpq(1), fmpq(1, 128))
    assert column is not None
    zero_map(beta, "1", budget=0, journal=tmp_path / "map")
    with (tmp_path / "map.0").open("a", encoding="utf-8") as file:
        file.write(json.dumps([*map(str, ends), _to_json(column)]) + "\n")
    found = zero_map(beta, "1", journal=tmp_path / "map")
    [stretch] = found.rows[0].stretch_rows
    assert stretch.numbers == (3,) or not stretch.fold_inside


def test_rows_cover_the_range_and_are_joined() -> None:
    rows = zero_map("1..2", "1/100..10").rows
    assert (rows[0].lower, rows[-1].upper) == (fmpq(1, 100), 10)
    assert all(first.upper == second.lower for first, second in pairwise(rows))
    assert len(rows) > 5


def test_what_does_not_cover_the_rectangle_is_not_proved() -> None:
    found = zero_map("17/4..9/2", "1/10")
    assert found.verdict.outcome is Outcome.PROVED
    (row,) = found.rows
    first, *others = row.columns
    assert others
    shorter = replace(first, pieces=first.pieces[:1])
    for columns in ((), tuple(others), (shorter, *others)):
        verdict = replace(found, rows=(replace(row, columns=columns),)).verdict
        assert verdict.outcome is Outcome.UNDECIDED
        assert "leave a part" in verdict.detail
    wider = (fmpq(1, 10), fmpq(1, 9))
    assert replace(found, epsilon=wider).verdict.outcome is Outcome.UNDECIDED


def test_a_killed_run_goes_on(tmp_path: Path) -> None:
    journal = tmp_path / "map"
    first = zero_map(*BELOW_FOLD, budget=0, journal=journal)
    assert first.verdict.outcome is Outcome.UNDECIDED
    whole = zero_map(*BELOW_FOLD, journal=journal)
    kept = (tmp_path / "map.0").read_bytes()
    assert kept.count(b"\n") == 1 + whole.examined
    again = zero_map(*BELOW_FOLD, journal=journal)
    assert (again, (tmp_path / "map.0").read_bytes()) == (whole, kept)
    with pytest.raises(ValueError, match="not a journal of this question"):
        zero_map(BELOW_FOLD[0], "1", journal=journal)


def test_the_budget_is_of_all_rows_and_what_is_left_is_joined() -> None:
    found = zero_map("17/4..9/2", "1/1000..1/50", budget=1)
    assert (found.examined, len(found.rows)) == (1, 3)
    assert [len(row.unfinished) for row in found.rows] == [1, 2, 2]
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "5 ranges of β left in 3 rows of ε" in str(found)
    assert str(found).splitlines()[-1].endswith(": ? on (17/4, 9/2)")
    assert least_work("17/4..9/2", "1/1000..1/50") == (3, 2)


def test_a_journal_is_named_by_a_text_too(tmp_path: Path) -> None:
    found = zero_map("17/4..35/8", "1/10", journal=str(tmp_path / "map.x"))
    assert (tmp_path / "map.x.0").read_bytes().count(b"\n") == 1 + found.examined


def test_a_journal_of_a_later_row_is_refused_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "map.1").write_text("a letter\n")

    def told(_: object) -> None:
        raise AssertionError("the work was started")

    with pytest.raises(ValueError, match=r"map\.1 is not a journal of this question"):
        zero_map("17/4..35/8", "1/1000..1/50", journal=tmp_path / "map", progress=told)
    with pytest.raises(ValueError, match=r"map\.1 is not a journal"):  # and none is left locked
        zero_map("17/4..35/8", "1/1000..1/50", journal=tmp_path / "map", progress=told)


def test_data() -> None:
    found = zero_map("5..41/8", "1/10", budget=0)
    data = json.loads(json.dumps(found.to_json()))
    assert data["verdict"]["outcome"] == "undecided"
    assert data["rows"] == [{"epsilon": ["1/10", "1/10"], "stretches": [], "unfinished": [["5", "41/8"]]}]
    assert "? on (5, 41/8)" in str(found)
    with pytest.raises(TypeError, match="verdict"):
        bool(found)


@pytest.mark.parametrize(
    ("beta", "epsilon", "message"),
    [
        ("0..2", "1", "beta: the range must lie inside"), ("5..11", "1", "beta: the range must lie inside"),
        ("5", "1", "beta: expected a range"), ("5..inf", "1", "beta"), ("6..5", "1", "beta"),
        ("5..6", "0", "epsilon: expected a number > 0"), ("5..6", "-1..1", "epsilon: the range must lie inside"),
        ("5..6", "1..101", "epsilon: the range must lie inside"), ("5..6", "x", "epsilon"),
    ],
)  # fmt: skip
def test_refused(beta: str, epsilon: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        zero_map(beta, epsilon)


@pytest.mark.parametrize("ends", [(None, fmpq(6)), (fmpq(5), None)])
def test_an_infinite_end_is_refused(ends: tuple[fmpq | None, fmpq | None]) -> None:
    for beta, epsilon, name in (
        (Range(*ends, False, False), "1", "beta"),
        ("5..6", Range(*ends, False, False), "epsilon"),
    ):
        with pytest.raises(ValueError, match=f"{name}: the range must lie inside"):
            zero_map(beta, epsilon)


def test_a_ball_is_refused() -> None:
    with pytest.raises(TypeError, match="epsilon"):
        zero_map("5..6", arb(1))  # type: ignore[arg-type]


def test_stretches_end_at_integers_and_where_a_range_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "numbers_of_zeros", lambda *_: (2,))
    ends = [(9, 10), (10, 11), (12, 14), (14, 16)]  # over 2: 11/2 to 6 is left out, 5 and 7 are integers
    columns = tuple(Column(fmpq(lower, 2), fmpq(upper, 2), ()) for lower, upper in ends)
    found = Row(fmpq(0), fmpq(1), columns, ()).stretches()
    assert found == [(fmpq(lower, 2), fmpq(upper, 2), (2,)) for lower, upper in ends]
    halves = tuple(Column(fmpq(lower, 4), fmpq(lower + 1, 4), ()) for lower in (17, 18, 20))
    assert [stretch[:2] for stretch in Row(fmpq(0), fmpq(1), halves, ()).stretches()] == [
        (fmpq(17, 4), fmpq(19, 4)),
        (fmpq(5), fmpq(21, 4)),
    ]


def test_columns_and_rows_are_those_of_the_rectangle() -> None:
    assert module._columns(fmpq(3), fmpq(67, 16)) == [(fmpq(4), fmpq(33, 8)), (fmpq(33, 8), fmpq(67, 16))]
    first = 2 * module._FIRST_ETA**3
    assert module._rows(fmpq(0), first) == [(fmpq(0), first)]
    assert module._rows(fmpq(0), first + 1)[0] == (fmpq(0), first)
    assert module._rows(first, first) == [(first, first)]


@pytest.mark.parametrize(
    ("beta", "text"),
    [("1..2", "1 on (1, 2)"), ("2..5/2", "2 on (2, 5/2)"), ("3/2..4", "1 on (3/2, 2), 2 on (2, 3), 1 on (3, 4)")],
)
def test_the_law_below_4_in_words(beta: str, text: str) -> None:
    assert str(zero_map(beta, "1")).splitlines()[1] == f"  β < 4, every ε > 0, by theorem: {text}"


def test_the_rows_are_named_exactly() -> None:
    """The number is proved up to their ends; with four digits the first began at 0.3333, below the 1/3 asked for."""
    found = zero_map("17/4..35/8", "1/3..1/2")
    (row,) = [line for line in str(found).splitlines() if "ε in [1/3" in line and ": 2 on (17/4, 35/8)" in line]
    assert row.startswith(f"  ε in [1/3, {short_text(found.rows[0].upper)}]: ")


def test_nothing_is_said_at_epsilon_0() -> None:
    """A row from 0 on holds for epsilon > 0, as the statement says."""
    row = Row(fmpq(0), fmpq(1, 2), (), ())
    found = ZeroMap((fmpq(17, 4), fmpq(35, 8)), (fmpq(0), fmpq(1, 2)), (row,), 0)
    assert "every ε in (0, 1/2]" in str(found)
    assert "\n  ε in (0, 0.5]: " in str(found)
    assert "and at ε = 1/2" in replace(found, epsilon=(fmpq(1, 2), fmpq(1, 2))).verdict.statement
