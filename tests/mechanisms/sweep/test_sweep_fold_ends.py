"""The ends of a continued spot on a line: what lies behind a fold says so, and no more. Page: proofs/sweep.md.

The folds themselves are those of tests/mechanisms/sweep/test_sweep_fold.py; here they are given.
"""

from __future__ import annotations

import json
from typing import Any

import pytest
from flint import arb, fmpq
from samples.families import family

from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep import sweep_fold
from gspot_verified.mechanisms.sweep.sweep_findings import equations
from gspot_verified.mechanisms.sweep.sweep_fold import Fold, with_folds, without_gaps
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece, TubeRecord
from gspot_verified.mechanisms.sweep.sweep_pieces import PieceStore, packed
from gspot_verified.mechanisms.zeros.tube import Tube
from gspot_verified.numbers.dyadic import Dyadic

SYSTEM = parametric_system(family("q^2 - k", "1"), ["k"], ["x", "u"])
Plain = list[tuple[int | fmpq, int | fmpq, Kind]]


def piece(lower: int, upper: int, kind: Kind = Kind.SETTLED) -> SweepPiece:
    box = (fmpq(lower),), (fmpq(upper),)
    tube = Tube(*box, (arb(lower),), ((arb(0),),), (arb(0, 1),), (arb(0, 1),))
    return SweepPiece(*box, kind, record=None if kind is Kind.NO_TUBE else TubeRecord.of(tube))


LINE = [
    piece(-1, 0, Kind.OPEN), piece(0, 1, Kind.NO_TUBE), piece(1, 2, Kind.OPEN), piece(2, 3), piece(3, 4), piece(4, 5),
    piece(5, 6), piece(6, 7),
]  # fmt: skip


def stored(line: list[SweepPiece]) -> PieceStore:
    store = PieceStore(Grid((Axis("k", fmpq(-1), fmpq(7), 1),)))
    store.add(packed([line]))
    return store


def folded(line: list[SweepPiece], own: list[int]) -> tuple[list[SweepPiece], list[Fold]]:
    store = stored(line)
    mine = [number in own for number in range(len(line))]
    order, folds = with_folds(SYSTEM, equations(SYSTEM), store, range(len(line)), mine, 7)
    return [store[number] for number in order], folds


def after(folds: dict[int, Fold], own: list[int], monkeypatch: pytest.MonkeyPatch) -> tuple[Plain, list[Fold]]:
    """The line's pieces when behind these ends there are these folds; which tube is asked for is checked."""

    def given(system: Any, _: Any, tube: Tube, end: fmpq, digits: int) -> Fold | None:
        assert (system, digits) == (SYSTEM, 7)
        assert end in (tube.lower[0], tube.upper[0])
        assert tube.lower[0] == LINE[min(own) if end == LINE[min(own)].lower[0] else max(own)].lower[0]
        return folds.get(int(end.p))

    monkeypatch.setattr(sweep_fold, "fold_next_to", given)
    pieces, found = folded(LINE, own)
    return [(one.lower[0], one.upper[0], one.kind) for one in pieces], found


def fold(lower: int, upper: int, opens: int, reach: int) -> Fold:
    """Between these quarters."""
    return Fold("k", Dyadic(lower, upper, -2), opens, fmpq(reach), ())


OWN: Plain = [(2, 3, Kind.SETTLED), (3, 4, Kind.SETTLED)]
BEFORE: Plain = [(-1, 0, Kind.OPEN), (0, 1, Kind.NO_TUBE), (1, 2, Kind.OPEN)]
AFTER: Plain = [(4, 5, Kind.SETTLED), (5, 6, Kind.SETTLED), (6, 7, Kind.SETTLED)]


def test_no_fold_leaves_the_pieces_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    assert after({}, [3, 4], monkeypatch) == ([*BEFORE, *OWN, *AFTER], [])
    assert after({2: fold(6, 7, 1, 2)}, [], monkeypatch) == ([*BEFORE, *OWN, *AFTER], [])


def test_before_a_fold_that_opens_upwards_there_is_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The spots meet in [3/2, 7/4]: below 3/2 there is none of the two, between it and the tube they may or may not."""
    known = fold(6, 7, 1, 2)
    pieces, folds = after({2: known}, [3, 4], monkeypatch)
    assert pieces == [(-1, fmpq(3, 2), Kind.BEYOND), (fmpq(3, 2), 2, Kind.FOLD), *OWN, *AFTER]
    assert folds == [known]


def test_behind_a_fold_that_opens_downwards_there_is_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    known = fold(17, 18, -1, 4)
    pieces, folds = after({4: known}, [3, 4], monkeypatch)
    assert pieces == [*BEFORE, *OWN, (4, fmpq(9, 2), Kind.FOLD), (fmpq(9, 2), 7, Kind.BEYOND)]
    assert folds == [known]


def test_both_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    low, high = fold(6, 7, 1, 2), fold(17, 18, -1, 4)
    pieces, folds = after({2: low, 4: high}, [3, 4], monkeypatch)
    assert [kind for *_, kind in pieces] == [Kind.BEYOND, Kind.FOLD, Kind.SETTLED, Kind.SETTLED, Kind.FOLD, Kind.BEYOND]
    assert folds == [low, high]


def test_a_fold_that_opens_to_the_other_side_is_another_one(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = {2: fold(6, 7, -1, 2), 4: fold(17, 18, 1, 4)}
    assert after(wrong, [3, 4], monkeypatch) == ([*BEFORE, *OWN, *AFTER], [])


@pytest.mark.parametrize(("low", "high"), [(-8, 3), (-4, 2), (-12, -8), (8, 9)])
def test_a_fold_at_an_end_of_the_range_leaves_no_piece_behind_it(
    low: int, high: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The range is [-1, 2]: the fold is said to be in it, and no piece is empty."""
    pieces, _ = after({2: fold(low, high, 1, 2)}, [3, 4], monkeypatch)
    assert pieces == [(-1, 2, Kind.FOLD), *OWN, *AFTER]


@pytest.mark.parametrize("opens", [1, -1])
def test_an_end_of_the_line_has_nothing_behind_it(opens: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep_fold, "fold_next_to", lambda *_: fold(6, 7, opens, 2))
    line = [piece(0, 1), piece(1, 2)]
    assert folded(line, [0, 1]) == (line, [])


def test_a_piece_without_a_tube_has_no_fold_next_to_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep_fold, "fold_next_to", lambda *_: fold(6, 7, 1, 2))
    line = [piece(0, 1), piece(1, 2, Kind.NO_TUBE), piece(2, 3)]
    assert folded(line, [1]) == (line, [])


def test_neighbours_without_a_tube_are_one_piece() -> None:
    none, settled = Kind.NO_TUBE, Kind.SETTLED
    kinds = [settled, none, none, none, Kind.OPEN, Kind.OPEN, none, none, settled, settled, none]
    store = stored([piece(i, i + 1, kind) for i, kind in enumerate(kinds)])
    found = [store[number] for number in without_gaps(store, range(len(kinds)))]
    assert [(one.lower[0], one.upper[0], one.kind) for one in found] == [
        (0, 1, settled), (1, 4, none), (4, 5, Kind.OPEN), (5, 6, Kind.OPEN), (6, 8, none), (8, 9, settled),
        (9, 10, settled), (10, 11, none),
    ]  # fmt: skip
    assert json.loads(json.dumps([one.to_json() for one in found]))
