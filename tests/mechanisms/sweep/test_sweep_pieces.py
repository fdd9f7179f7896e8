"""Pieces come back from their blocks as they were, wherever they stand, and boxes are theirs. Page: proofs/sweep.md."""

from __future__ import annotations

import pickle
from itertools import product

import pytest
from flint import arb, fmpq

from gspot_verified.mechanisms.sweep import sweep_pieces
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_piece import NUMBERS, Kind, Passing, SweepPiece, TubeRecord
from gspot_verified.mechanisms.sweep.sweep_pieces import OTHER, PieceStore, Said, SweptPieces, packed
from gspot_verified.mechanisms.zeros.tube import Tube
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.packed import PackedIntervals
from gspot_verified.work import kept_blocks

GRID = Grid((Axis("k", fmpq(0), fmpq(3), 3), Axis("l", fmpq(1, 3), fmpq(2, 3), 2)))
CELLS = [GRID.ends(index) for index in GRID.indices()]


def piece(box: tuple[tuple[fmpq, ...], tuple[fmpq, ...]], number: int) -> SweepPiece:
    """All that a piece may hold, another for each number."""
    tube = Tube(*box, (arb(number),), ((arb(1, "0.1"), arb(2)),), (arb(0, 1),), (arb(0, "0.5"),))
    numbers = PackedIntervals([Dyadic(number, number + k) for k in range(5)] + [Dyadic(number - 2, number - 1)])
    assert len(numbers) == len(NUMBERS)
    if number % 4 == 0:
        return SweepPiece(*box, Kind.NO_TUBE, unsure=("some",))
    if number % 4 == 1:
        passing = Passing("beta - 2", 0, 1, -1, None)
        return SweepPiece(*box, Kind.CROSSING, unsure=("beta - 2",), passing=passing, record=TubeRecord.of(tube))
    return SweepPiece(*box, Kind.SETTLED, "III", 1, -1, numbers=numbers, record=TubeRecord.of(tube))


def halves(cell: tuple[tuple[fmpq, ...], tuple[fmpq, ...]]) -> list[tuple[tuple[fmpq, ...], tuple[fmpq, ...]]]:
    (left, low), (right, high) = cell
    return [((left, low), ((left + right) / 2, high)), (((left + right) / 2, low), (right, high))]


def by_cell() -> list[list[SweepPiece]]:
    """Every second cell in two pieces."""
    boxes = [halves(cell) if k % 2 else [cell] for k, cell in enumerate(CELLS)]
    return [[piece(box, 10 * k + i) for i, box in enumerate(own)] for k, own in enumerate(boxes)]


@pytest.fixture(params=[1, 10**6])
def store(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> PieceStore:
    """In two blocks of cells, and one of other pieces; in a file or in memory."""
    monkeypatch.setattr(kept_blocks, "_IN_MEMORY", request.param)
    made, pieces = PieceStore(GRID), by_cell()
    assert made.add(packed(pieces[:4], CELLS[:4])) == range(6)
    assert made.add(packed(pieces[4:], CELLS[4:])) == range(6, 9)
    assert made.add(packed([[piece(CELLS[0], 50), piece(CELLS[1], 51)]])) == range(9, 11)
    return made


ALL = [*(each for own in by_cell() for each in own), piece(CELLS[0], 50), piece(CELLS[1], 51)]


def test_pieces_come_back_as_they_were(store: PieceStore) -> None:
    assert [store[number] for number in range(len(store))] == ALL
    assert [store.box(number) for number in range(len(store))] == [each.box for each in ALL]
    assert [store.cell(number) for number in range(9)] == [0, 1, 1, 2, 3, 3, 4, 5, 5]
    assert list(store.ends) == [0, 1, 3, 4, 6, 7, 9]
    for number, each in enumerate(ALL):
        what = store.what(number)
        assert (what.kind, what.answer, what.unsure, what.passing) == (
            each.kind, each.answer, each.unsure, each.passing,
        )  # fmt: skip
        assert what.whole is (number < 9 and each.box in CELLS)


def test_the_sign_of_slip_is_that_of_the_whole_interval() -> None:
    box = CELLS[0]
    for lower, upper, sign in ((1, 2, 1), (-2, -1, -1), (-1, 1, None), (0, 0, 0)):
        numbers = PackedIntervals([None] * 5 + [Dyadic(lower, upper)])
        block = packed([[SweepPiece(*box, Kind.SETTLED, numbers=numbers)]])
        assert block.said == (Said(Kind.SETTLED, slip_sign=sign),)
    assert packed([[SweepPiece(*box, Kind.SETTLED)]]).said[0].slip_sign is None


def test_what_is_unsaid_keeps_its_place_alone(store: PieceStore) -> None:
    """Its numbers are gone; of a piece without a tube nothing was said."""
    assert store[3].kind is Kind.NO_TUBE or store[3].numbers != ALL[0].numbers
    store.unsay(range(9))
    for number, each in enumerate(ALL[:9]):
        if each.kind is Kind.NO_TUBE:
            assert store[number] == each
        else:
            assert store[number] == SweepPiece(*each.box, Kind.OPEN, unsure=(OTHER,), record=each.record)
    assert store[10] == ALL[10]


@pytest.mark.parametrize("order", [range(9), range(2, 7), [0, 9, 10, 3, 5, 6], []])
def test_pieces_in_their_order(store: PieceStore, order: list[int]) -> None:
    pieces, true = SweptPieces(store, order), [ALL[number] for number in order]
    assert len(pieces) == len(true)
    assert list(pieces) == true == [pieces[k] for k in range(len(true))]
    assert pieces == true
    assert pieces != [*true, ALL[0]]
    assert pieces != [ALL[4] for _ in true] or not true
    assert pieces[1:4] == true[1:4]
    assert list(pieces.boxes()) == [(what, each.box) for what, each in zip(pieces.said(), true, strict=True)]
    settled = [box for _, box in pieces.boxes(lambda what: what.kind is Kind.SETTLED)]
    assert settled == [each.box for each in true if each.kind is Kind.SETTLED]
    assert sum(pieces.counts().values()) == len(true)
    assert [each for part in pieces.portions() for each in pickle.loads(pickle.dumps(part))] == true
    assert pickle.loads(pickle.dumps(pieces)) == true == SweptPieces.of(GRID.axes, true)


def test_pieces_go_in_portions_that_hold_all(store: PieceStore, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep_pieces, "_TOGETHER", 2)
    pieces = SweptPieces(store, range(9))
    assert [len(list(part)) for part in pieces.portions()] == [2, 2, 2, 2, 1]
    assert list(pieces) == ALL[:9]


def test_pieces_are_no_number(store: PieceStore) -> None:
    assert (SweptPieces(store, range(2)) == 2) is False


def test_corners_are_those_of_all_cells() -> None:
    line = Grid(GRID.axes[1:])
    for grid in (GRID, line):
        assert list(grid.corners()) == [grid.ends(index) for index in grid.indices()]


def test_cells_that_hold_a_place() -> None:
    for place in product([fmpq(0), fmpq(1), fmpq(3, 2), fmpq(3)], [fmpq(1, 3), fmpq(1, 2), fmpq(3, 5), fmpq(2, 3)]):
        holding = [
            index for index, (lower, upper) in zip(GRID.indices(), CELLS, strict=True)
            if all(low <= value <= high for low, value, high in zip(lower, place, upper, strict=True))
        ]  # fmt: skip
        assert list(GRID.cells_at(place)) == holding
