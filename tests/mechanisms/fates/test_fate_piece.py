"""Boxes of cells, halved and asked what they hold."""

from __future__ import annotations

from itertools import pairwise

from flint import fmpq

from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fate_piece import OPEN, FatePiece, StartBox, blocks
from gspot_verified.mechanisms.sweep.sweep_grid import Grid, axes_of


def test_a_box_is_cut_between_cells_across_its_longest_side() -> None:
    """Counted in cells, not in numbers; a cell in the middle."""
    box = StartBox((fmpq(0), fmpq(0)), (fmpq(5), fmpq(300)), (5, 3))
    low, high = box.halves((fmpq(1), fmpq(100)))
    assert low == StartBox((fmpq(0), fmpq(0)), (fmpq(2), fmpq(300)), (2, 3))
    assert high == StartBox((fmpq(2), fmpq(0)), (fmpq(5), fmpq(300)), (3, 3))
    far = StartBox((fmpq(0), fmpq(90)), (fmpq(2), fmpq(91)), (2, 1))
    assert far.halves((fmpq(1), fmpq(1)))[0].upper == (fmpq(1), fmpq(91))
    cell = StartBox((fmpq(0), fmpq(1)), (fmpq(1), fmpq(4)), (1, 1))
    assert cell.small
    assert not low.small
    assert not StartBox(cell.lower, cell.upper, (1, 2)).small
    first, second = cell.halves((fmpq(1), fmpq(2)))
    assert (first.upper, second.lower) == ((fmpq(1), fmpq(5, 2)), (fmpq(0), fmpq(5, 2)))
    assert first.cells == second.cells == (1, 1)


def test_a_piece_holds_its_edges_and_nothing_beside() -> None:
    piece = FatePiece((fmpq(0), fmpq(1)), (fmpq(1), fmpq(3)), Fate.BELOW)
    for first, second, held in (
        (0, 1, True), (1, 3, True), (0, 3, True), (-1, 2, False), (2, 2, False), (0, 0, False), (1, 4, False),
    ):  # fmt: skip
        assert piece.holds((fmpq(first), fmpq(second))) is held


def test_what_is_open() -> None:
    assert set(OPEN) == {Fate.UNDECIDED, Fate.SPOT}


def test_blocks_are_whole_cells_in_order() -> None:
    grid = Grid(axes_of({"p": "0..1:40", "b": "-1..1:3"}))
    found = blocks(grid)
    assert [box.cells[1] for box in found] == [3] * len(found)
    assert sum(box.cells[0] for box in found) == 40
    assert found[0].lower == (0, -1)
    assert found[-1].upper == (1, 1)
    assert all(one.upper[0] == two.lower[0] for one, two in pairwise(found))
