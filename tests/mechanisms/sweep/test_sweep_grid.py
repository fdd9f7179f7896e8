"""The cells of a sweep: they tile the ranges, know their neighbours, and each has a place to look from or none.

Page: proofs/sweep.md, section 5.
"""

from __future__ import annotations

import pickle

import pytest
from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.sweep import sweep_grid
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid, cells

LINE = Grid((Axis("k", fmpq(-1), fmpq(2), 6),))
MAP = Grid((Axis("k", fmpq(0), fmpq(1), 2), Axis("l", fmpq(5), fmpq(8), 3)))


def test_the_cells_tile_the_ranges() -> None:
    ends = [LINE.ends(index) for index in LINE.indices()]
    assert ends == [((fmpq(k, 2),), (fmpq(k + 1, 2),)) for k in range(-2, 4)]
    assert MAP.indices() == [(i, j) for i in (0, 1) for j in (0, 1, 2)]
    assert MAP.ends((1, 2)) == ((fmpq(1, 2), fmpq(7)), (fmpq(1), fmpq(8)))
    assert str(LINE.axes[0]) == "k=-1..2:6"


def test_the_cell_of_a_place_holds_it() -> None:
    for value in (fmpq(-1), fmpq(-9, 10), fmpq(-1, 2), fmpq(0), fmpq(1, 3), fmpq(19, 10), fmpq(2)):
        lower, upper = LINE.ends(LINE.cell_of([value]))
        assert lower[0] <= value <= upper[0]
    assert LINE.cell_of([fmpq(-7)]) == (0,)
    assert LINE.cell_of([fmpq(7)]) == (5,)
    assert MAP.cell_of([fmpq(3, 4), fmpq(11, 2)]) == (1, 0)


def test_neighbours_share_a_side() -> None:
    assert list(LINE.neighbours((0,))) == [(1,)]
    assert list(LINE.neighbours((3,))) == [(2,), (4,)]
    assert list(LINE.neighbours((5,))) == [(4,)]
    assert set(MAP.neighbours((0, 1))) == {(1, 1), (0, 0), (0, 2)}
    assert set(MAP.neighbours((1, 2))) == {(0, 2), (1, 1)}


def test_every_cell_has_a_place_near_which_to_look_up_to_where_the_spot_ends() -> None:
    """x^2 = k from x = 1 at k = 1: the cells of k > 0, and one beside them that looks from its neighbour."""
    program = BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2)
    found = cells(program, LINE, [fmpq(1)], [arb(1)])
    assert [(cell.lower, cell.upper) for cell in found] == [LINE.ends(index) for index in LINE.indices()]
    assert [cell.origin is not None for cell in found] == [False, True, True, True, True, True]
    for cell in found[2:]:
        assert cell.origin is not None
        ((middle,), (centre,)) = cell.origin.place, cell.origin.centre
        assert cell.lower[0] <= middle <= cell.upper[0]
        assert abs(centre * centre - middle) < fmpq(1, 10**6)
        assert abs(2 * centre * cell.origin.slopes[0][0] - 1) < fmpq(1, 10**6)
    assert found[1].origin == found[2].origin


def test_where_nothing_is_found_at_the_start_no_cell_has_a_place() -> None:
    program = BoxProgram([Variable(0) * Variable(0) + Constant(fmpq(1)) + Variable(1) * Variable(1)], 2)
    assert all(cell.origin is None for cell in cells(program, LINE, [fmpq(1)], [arb(1)]))


def test_of_a_large_grid_few_places_are_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    """x^2 = k from x = 1 at k = 1, three places for 24 cells: where the spot may end each cell looks for its own."""
    monkeypatch.setattr(sweep_grid, "_MOST_PLACES", {1: 3})
    program = BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2)
    fine = Grid((Axis("k", fmpq(-1), fmpq(2), 24),))
    found = cells(program, fine, [fmpq(1)], [arb(1)])
    assert [(cell.lower, cell.upper) for cell in found] == [fine.ends(index) for index in fine.indices()]
    assert {cell.origin.place for cell in found if cell.origin} == {(fmpq(1, 2),), (fmpq(3, 2),)}
    sent = pickle.loads(pickle.dumps(found[4:20]))
    for part in (found[4:20], sent):
        located = list(part.located(program))
        assert [cell.lower for cell in located] == [fine.ends((k,))[0] for k in range(4, 20)]
        assert [cell.origin is not None for cell in located] == [False] * 3 + [True] * 13
        for cell in located[4:12]:  # beside the place without a spot
            assert cell.origin is not None
            ((middle,), (centre,)) = cell.origin.place, cell.origin.centre
            assert cell.lower[0] < middle < cell.upper[0]
            assert abs(centre * centre - middle) < fmpq(1, 10**6)
        assert located[12].origin == located[15].origin == found[20].origin
    assert list(found[20:].located(program)) == list(found[20:])


def test_a_portion_is_sent_with_its_own_places() -> None:
    program = BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2)
    long = Grid((Axis("k", fmpq(1), fmpq(2), 1_000),))
    found = cells(program, long, [fmpq(1)], [arb(1)])
    assert len(pickle.dumps(found[:10])) < 2_000
    assert list(pickle.loads(pickle.dumps(found[5:9]))) == list(found)[5:9]
