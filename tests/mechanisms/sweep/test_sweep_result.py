"""The texts of a sweep: brackets are rounded outward, neighbours of one answer are one stretch."""

from __future__ import annotations

import pickle
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.sweep import sweep_result
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_cell import BOXES, BOXES_BEYOND
from gspot_verified.mechanisms.sweep.sweep_grid import Axis
from gspot_verified.mechanisms.sweep.sweep_piece import ENDED, NUMBERS, Kind, Passing, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_result import Sweep, ZeroOnLine
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.evidence import Box, cover_by_boxes
from gspot_verified.numbers.packed import PackedIntervals
from gspot_verified.numbers.verdict import Evidence, Outcome, Reason
from gspot_verified.signs.gamma.side import side_text


@given(st.fractions(-10, 10), st.fractions(0, Fraction(1, 10**6)), st.sampled_from([1, -1]))
def test_a_bracket_is_shown_outward(lower: Fraction, width: Fraction, direction: int) -> None:
    upper = lower + width
    ends = [fmpq(end.numerator, end.denominator) for end in (lower, upper)]
    crossing = ZeroOnLine("beta - 3", *ends, direction, -direction, direction)
    text = crossing.text("k")
    assert text.startswith("beta passes 3 in k = [")
    assert text.endswith(", exactly once")
    shown = [Fraction(word) for word in text.partition("[")[2].partition("]")[0].split(", ")]
    assert shown[0] <= lower
    assert upper <= shown[1]
    assert shown[1] - shown[0] <= width + 2 * Fraction(1, 10**16)


def test_what_is_not_certain_is_not_called_once() -> None:
    for before, after in ((None, 1), (-1, None), (1, 1), (-1, -1), (1, -1)):
        crossing = ZeroOnLine("alpha_1", fmpq(0), fmpq(1), 1, before, after)
        assert not crossing.proved
        assert "at most once" in crossing.text("k")


def test_the_range_is_looked_through_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The verdict stays, also in another process; a result that is made of this one has its own."""
    asked: list[int] = []

    def counted(parts: Iterable[Box], whole: Box) -> Evidence | None:
        asked.append(1)
        return cover_by_boxes(parts, whole)

    monkeypatch.setattr(sweep_result, "cover_by_boxes", counted)
    result = sweep(shipped_mechanism("oscillator"), {"beta": "9/4..11/4:4"})
    assert str(result).startswith(str(result.verdict))
    assert result.verdict.outcome is Outcome.PROVED
    assert len(asked) == 1
    again = pickle.loads(pickle.dumps(result))
    assert again == result
    assert again.verdict == result.verdict
    assert len(asked) == 1
    assert replace(result, pieces=result.pieces[:-1]).verdict.outcome is Outcome.UNDECIDED


def test_stretches_join_neighbours() -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "9/4..15/4:6"})
    stretches = result.stretches()
    assert (stretches[0][0], stretches[-1][1]) == (fmpq(9, 4), fmpq(15, 4))
    for (_, end, first), (begin, _, second) in pairwise(stretches):
        assert end == begin
        assert (first.kind, first.answer) != (second.kind, second.answer)
    settled = [piece.answer for _, _, piece in stretches if piece.kind is Kind.SETTLED]
    assert settled == [("III", 1, -1), ("III", -1, 1), ("none", None, None)]
    lines = str(result).splitlines()  # verdict, spot, stretches, crossings, and that u = -3/5
    assert len(lines) == 2 + 3 + 2 + 1
    assert lines[-1].startswith("  warning: u <= 0")


def test_json_holds_every_piece_without_its_tube() -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "9/4..11/4:2"})
    data = result.to_json()
    assert [piece["lower"] for piece in data["pieces"]] == [["9/4"], ["5/2"]]
    assert "tube" not in data["pieces"][0]
    assert data["verdict"]["outcome"] == "proved"


def line(*pieces: SweepPiece, upper: int = 12) -> Sweep:
    return Sweep("line", (Axis("k", fmpq(10), fmpq(upper), 1),), (fmpq(11),), {"x": "0"}, pieces)


def piece(lower: int | fmpq, upper: int | fmpq, kind: Kind, passing: Passing | None = None) -> SweepPiece:
    return SweepPiece((fmpq(lower),), (fmpq(upper),), kind, "III", 1, -1, passing=passing)


def test_a_place_is_answered_by_a_piece_that_holds_it() -> None:
    parts = piece(10, 11, Kind.SETTLED), piece(11, 12, Kind.OPEN)
    result = line(*parts)
    assert result.at(k=fmpq(21, 2)) == parts[0]
    assert result.at(k=fmpq(23, 2)) == parts[1]
    for value in (9, 13):
        with pytest.raises(ValueError, match=r"k: a rational in \[10, 12\] is needed"):
            result.at(k=value)


def test_the_case_is_named_once() -> None:
    """What follows in Case III has its name; what follows in Cases I and II is said of both."""
    third = piece(10, 12, Kind.SETTLED)
    assert side_text(1, -1).startswith("Case III, by the paper's rule as ε → 0: ")
    assert f"]: {side_text(1, -1)}" in str(line(third))
    second = SweepPiece(third.lower, third.upper, Kind.SETTLED, "II", None, -1)
    assert ": Case II, by the paper's rule as ε → 0: C1 < 0 takes an IWC" in str(line(second))


TINY = fmpq(1, 10**6)


@pytest.mark.parametrize(
    ("pieces", "proved"),
    [
        ((piece(10, 12, Kind.SETTLED),), True),
        ((piece(10, 12, Kind.OPEN),), False),
        ((), False),
        ((piece(10, 11, Kind.SETTLED), piece(11 + TINY, 12, Kind.SETTLED)), False),
        ((piece(10, 11, Kind.SETTLED), piece(11, 12, Kind.NO_TUBE)), False),
        ((piece(10, 10 + TINY, Kind.FOLD), piece(10 + TINY, 12, Kind.SETTLED)), True),
        ((piece(10, 10 + 3 * TINY, Kind.FOLD), piece(10 + 3 * TINY, 12, Kind.SETTLED)), False),
        ((piece(10, 11, Kind.BEYOND), piece(11, 11 + TINY, Kind.FOLD), piece(11 + TINY, 12, Kind.SETTLED)), True),
        ((piece(10, 11, Kind.CROSSING, Passing("beta - 2", 0, 1, -1, 1)), piece(11, 12, Kind.SETTLED)), True),
        ((piece(10, 11, Kind.CROSSING, Passing("beta - 2", 0, 1, None, 1)), piece(11, 12, Kind.SETTLED)), False),
    ],
)
def test_what_is_left_decides_the_verdict(pieces: tuple[SweepPiece, ...], proved: bool) -> None:
    """A piece next to a fold counts as a bracket up to a millionth of the range."""
    verdict = line(*pieces).verdict
    assert verdict.outcome is (Outcome.PROVED if proved else Outcome.UNDECIDED)
    assert "except in the brackets where" in verdict.statement
    axes = (Axis("k", fmpq(0), fmpq(1), 1), Axis("l", fmpq(0), fmpq(1), 1))
    empty = Sweep("map", axes, (fmpq(0), fmpq(0)), {}, ()).verdict
    assert "pieces along curves" in empty.statement
    assert empty.outcome is Outcome.UNDECIDED
    assert "leave a part" in empty.detail


def test_what_is_left_says_how_to_go_on() -> None:
    """On a coarse grid all pieces may be left: then it is not the mechanism, but the cells."""
    axes = (Axis("k", fmpq(1, 2), fmpq(1), 12), Axis("l", fmpq(0), fmpq(1), 8))
    left = SweepPiece((fmpq(1, 2), fmpq(0)), (fmpq(1), fmpq(1)), Kind.OPEN, None, None, None, unsure=("the spot",))
    verdict = Sweep("map", axes, (fmpq(1), fmpq(0)), {}, (left,)).verdict
    in_vain = "dividing it again has not settled it; more cells may: k=1/2..1:24, l=0..1:16"
    assert (verdict.detail, verdict.reason) == (f"the only piece is left; {in_vain}", Reason.HYPOTHESIS)
    verdict = Sweep("map", axes, (fmpq(1), fmpq(0)), {}, (left, left), budget=1).verdict
    assert (
        verdict.detail == "2 of 2 pieces are left; the budget of one divided piece ended: a larger one may settle them"
    )
    assert verdict.reason is Reason.BUDGET


def test_a_result_whose_verdict_was_asked_for_is_the_same() -> None:
    asked, other = (line(piece(10, 12, Kind.SETTLED)) for _ in range(2))
    assert asked.verdict.outcome is Outcome.PROVED
    assert asked == other


def test_a_slip_velocity_is_wrong_or_not_known() -> None:
    """Of six pieces u > 0 on one, u < 0 on one, u = 0 on one, and it is not known on the others."""
    velocities = (Dyadic(1, 2), Dyadic(-2, -1), Dyadic(0, 0), Dyadic(-1, 2), Dyadic(0, 1), None)
    packed = [PackedIntervals([None] * (len(NUMBERS) - 1) + [velocity]) for velocity in velocities]
    parts = (replace(piece(10 + k, 11 + k, Kind.SETTLED), numbers=each) for k, each in enumerate(packed))
    found = line(*parts, upper=16)
    (warning,) = found.warnings
    assert "on 2 pieces, perhaps on 3 more" in warning


def test_the_slip_velocity_of_pieces_whose_case_is_open_counts_too() -> None:
    """They may be in a Case; those that are in none, and those without a spot, do not count."""
    wrong = PackedIntervals([None] * (len(NUMBERS) - 1) + [Dyadic(-2, -1)])
    kinds = (Kind.SETTLED, Kind.CROSSING, Kind.OPEN, Kind.NO_TUBE)
    parts = [replace(piece(10 + k, 11 + k, kind), numbers=wrong) for k, kind in enumerate(kinds)]
    none = replace(piece(14, 15, Kind.SETTLED), numbers=wrong, case="none", lift_off_sign=None, impact_sign=None)
    (warning,) = line(*parts, none, upper=15).warnings
    assert warning.startswith("u <= 0 at the G-spot on 3 pieces, perhaps on 0 more")


def test_the_boxes_of_a_cell_and_the_budget_may_end_both() -> None:
    """Each reason is said once, apart from the other."""
    ended = SweepPiece((fmpq(10),), (fmpq(11),), Kind.NO_TUBE, unsure=(ENDED,))
    whole = line(ended, piece(11, 12, Kind.SETTLED))
    boxes = f"{ENDED}, {BOXES} and {BOXES_BEYOND} divided beyond them; more cells may settle it: k=10..12:2"
    assert (whole.verdict.detail, whole.verdict.reason) == (f"1 of 2 pieces is left; {boxes}", Reason.BUDGET)
    budget = "the budget of 3 divided pieces ended: a larger one may settle it"
    both = Sweep(whole.name, whole.axes, whole.start, {}, whole.pieces, budget=3).verdict
    assert (both.detail, both.reason) == (f"1 of 2 pieces is left; {budget}; {boxes}", Reason.BUDGET)


def test_where_a_spot_may_end_at_a_fold_more_cells_are_not_advised() -> None:
    """The start is k = 0, l = 0: along k the spot is lost, along l it is not."""
    here = SweepPiece((fmpq(0), fmpq(0)), (fmpq(1), fmpq(1)), Kind.SETTLED, "III", 1, -1)
    lost = SweepPiece((fmpq(1), fmpq(0)), (fmpq(2), fmpq(1)), Kind.NO_TUBE)
    detail = plane(here, lost).verdict.detail
    assert "on one piece no continued spot was found: it may end before, at a fold" in detail
    assert detail.endswith("over two parameters folds are not sought, over k alone they are")
    assert "more cells may" not in detail
    beside = SweepPiece((fmpq(1), fmpq(1, 2)), (fmpq(2), fmpq(1)), Kind.NO_TUBE)
    assert plane(here, beside).verdict.detail.endswith("over k or l alone they are")
    assert "more cells may" in line(piece(10, 11, Kind.SETTLED), piece(11, 12, Kind.NO_TUBE)).verdict.detail


def plane(*pieces: SweepPiece) -> Sweep:
    axes = (Axis("k", fmpq(0), fmpq(2), 1), Axis("l", fmpq(0), fmpq(1), 1))
    return Sweep("map", axes, (fmpq(0), fmpq(0)), {}, pieces)


def test_of_a_curve_on_a_map_it_is_not_said_that_it_is_there() -> None:
    """On such a piece beta - 2 is monotone; that it vanishes on it is not shown."""
    zero, one, two = fmpq(0), fmpq(1), fmpq(2)
    passing = Passing("beta - 2", 0, 1)
    crossings = [
        SweepPiece((a, zero), (b, one), Kind.CROSSING, unsure=("beta - 2",), passing=passing)
        for a, b in ((zero, one), (one, two))
    ]
    settled = SweepPiece((one, zero), (two, one), Kind.SETTLED, "III", 1, -1)
    half = plane(crossings[0], settled)
    assert half.verdict.outcome is Outcome.PROVED
    assert "pieces along curves where one quantity may pass zero" in half.verdict.statement
    assert half.verdict.detail == "1 of 2 pieces are open"
    assert "one piece: beta may pass 2" in str(half)
    nothing = plane(*crossings).verdict
    assert nothing.outcome is Outcome.UNDECIDED
    assert "no piece is settled" in nothing.detail


def test_a_range_of_brackets_alone_is_not_proved() -> None:
    whole = line(piece(10, 12, Kind.CROSSING, Passing("beta - 2", 0, 1, -1, 1)))
    assert whole.crossings[0].proved
    assert whole.verdict.outcome is Outcome.UNDECIDED


def test_only_brackets_of_one_quantity_are_joined() -> None:
    def crossing(lower: int, quantity: str, direction: int) -> SweepPiece:
        before, after = (-direction, None) if lower == 10 else (None, direction)
        return piece(lower, lower + 1, Kind.CROSSING, Passing(quantity, 0, direction, before, after))

    same = line(crossing(10, "alpha_1", 1), crossing(11, "alpha_1", 1)).crossings
    assert same == (ZeroOnLine("alpha_1", fmpq(10), fmpq(12), 1, -1, 1),)
    assert same[0].proved
    for second in (crossing(11, "alpha_2", 1), crossing(11, "alpha_1", -1), crossing(12, "alpha_1", 1)):
        found = line(crossing(10, "alpha_1", 1), second, upper=13).crossings
        assert len(found) == 2
        assert not any(one.proved for one in found)


def test_the_table_has_a_name_for_every_column() -> None:
    result = line(piece(10, 11, Kind.CROSSING, Passing("beta - 2", 0, 1, -1, 1)), piece(11, 12, Kind.SETTLED))
    head, *rows = result.to_csv().splitlines()
    assert head.split(",") == [
        "k_lower", "k_lower_exact", "k_upper", "k_upper_exact", "kind", "case", "lift_off_sign_of_C1",
        "impact_sign_of_C1", "unsure", *(f"{name}_{end}" for name in NUMBERS for end in ("lower", "upper")),
    ]  # fmt: skip
    assert rows[1].startswith("11.0,11,12.0,12,settled,III,1,-1,,")
    assert {len(row.split(",")) for row in (head, *rows)} == {9 + 2 * len(NUMBERS)}
    first, second = result.to_json()["pieces"]
    assert first["passing"] == {"quantity": "beta - 2", "along": 0, "direction": 1}
    assert second["passing"] is None
