"""Undecided pieces are divided again: the parts take a piece's place, cover it, and say what points say.

Page: proofs/sweep.md, sections 2 and 5.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_division import Patchwork
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_links import common_place
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece, TubeRecord
from gspot_verified.mechanisms.sweep.sweep_pieces import packed
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.mechanisms.zeros.tube import Equations, Tube
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.work.executors import executor

ROD = shipped_mechanism("falling rod of Génot and Brogliato")
OVER = {"mu": "1.5..1.6:2", "g": "1/2..1:2"}
MAP = Grid((Axis("k", fmpq(0), fmpq(2), 2), Axis("l", fmpq(0), fmpq(1), 1)))
LINE = Grid((Axis("k", fmpq(0), fmpq(2), 2),))
SQUARE = Equations(BoxProgram([Variable(0) - Variable(1)], 3), 1)


def piece(left: int, right: int, low: int = 0, high: int = 4, kind: Kind = Kind.NO_TUBE) -> SweepPiece:
    """A rectangle in quarters."""
    return SweepPiece((fmpq(left, 4), fmpq(low, 4)), (fmpq(right, 4), fmpq(high, 4)), kind)


PLACE, SPOT = (fmpq(0), fmpq(0)), [arb(0)]


def patched(
    grid: Grid, pieces_by_cell: list[list[SweepPiece]], place: tuple[fmpq, ...] = PLACE, groups: Sequence[int] = ()
) -> Patchwork:
    """ξ = k; cell by cell, or all together with the groups that are given."""
    patchwork = Patchwork(grid, SQUARE, place, SPOT)
    cells = [grid.ends(index) for index in grid.indices()]
    with working_bits(80):
        if groups:
            patchwork.add_cells(packed(pieces_by_cell, cells), groups)
        for cell, pieces in zip(cells, () if groups else pieces_by_cell, strict=False):
            patchwork.add_cells(packed([pieces], [cell]), range(len(pieces)))
    return patchwork


def replaced(patchwork: Patchwork, number: int, parts: list[SweepPiece]) -> None:
    with working_bits(80):
        patchwork.replace([number], packed([parts]), range(len(parts)))


def touching(patchwork: Patchwork) -> set[tuple[int, int]]:
    there = patchwork.order()
    near = {number: patchwork.touching(number) for number in there}
    assert all(number in near[other] for number in there for other in near[number])
    assert all(len({*near[number]}) == len(near[number]) for number in there)
    return {(one, other) for one, other in combinations(sorted(there), 2) if other in near[one]}


def test_a_piece_touches_those_with_a_side_in_common() -> None:
    patchwork = patched(MAP, [[piece(0, 4)], [piece(4, 8, 0, 2), piece(4, 8, 2, 4)]])
    assert list(patchwork.order()) == [0, 1, 2]
    assert touching(patchwork) == {(0, 1), (0, 2), (1, 2)}
    diagonal = patched(MAP, [[piece(0, 4, 0, 2), piece(0, 4, 2, 4)], [piece(4, 8, 0, 2), piece(4, 8, 2, 4)]])
    assert touching(diagonal) == {(0, 1), (0, 2), (1, 3), (2, 3)}


def test_parts_take_the_place_of_a_piece() -> None:
    """Two times, the second time a part that lies inside: neighbours and order are those of what is there."""
    patchwork = patched(MAP, [[piece(0, 4)], [piece(4, 8)]])
    replaced(patchwork, 0, [piece(0, 2), piece(2, 4)])
    assert list(patchwork.order()) == [2, 3, 1]
    assert touching(patchwork) == {(2, 3), (1, 3)}
    replaced(patchwork, 3, [piece(2, 4, 0, 1), piece(2, 4, 1, 4)])
    store, order = patchwork.store, patchwork.order()
    assert [store[number].lower for number in order] == [
        (fmpq(0), fmpq(0)), (fmpq(1, 2), fmpq(0)), (fmpq(1, 2), fmpq(1, 4)), (fmpq(1), fmpq(0)),
    ]  # fmt: skip
    expected = {
        (one, other)
        for one, other in combinations(sorted(order), 2)
        if common_place(store.box(one), store.box(other)) is not None
    }
    assert touching(patchwork) == expected


def root(left: int, right: int, low: int = 0, high: int = 4, spot: int = 0) -> SweepPiece:
    """The same rectangle with a tube around ξ = k + spot."""
    own = piece(left, right, low, high, Kind.SETTLED)
    middle = (own.lower[0] + own.upper[0]) / 2
    sides = tuple(arb(0, fmpq(1, 64)) for _ in range(2))
    tube = Tube(*own.box, (arb(middle + spot),), ((arb(1), arb(0)),), sides[:1], (arb(0),))
    return replace(own, record=TubeRecord.of(tube))


def test_a_row_with_a_gap_is_linked_beyond_it_by_the_next_rows() -> None:
    """Also where these come together, as one group."""
    grid = Grid((Axis("k", fmpq(0), fmpq(3), 3), Axis("l", fmpq(0), fmpq(3), 3)))
    boxes = [grid.ends(index) for index in grid.indices()]
    corners = [(4 * i, 4 * i + 4, 4 * j, 4 * j + 4) for i, j in grid.indices()]
    cells = [[piece(*ends) if number == 1 else root(*ends)] for number, ends in enumerate(corners)]
    patchwork = Patchwork(grid, SQUARE, PLACE, SPOT)
    with working_bits(80):
        patchwork.add_cells(packed(cells[:3], boxes[:3]), range(3))
        patchwork.add_cells(packed(cells[3:], boxes[3:]), [0] * 6)
    assert patchwork.own() == [number != 1 for number in range(9)]


def own(patchwork: Patchwork) -> list[int]:
    held = patchwork.own()
    return [number for number in patchwork.order() if held[number]]


def test_the_spot_is_followed_through_pieces_that_hold_it() -> None:
    """Within a cell, to the cell above and to the next; not to another spot, nor behind it, nor where none is known."""
    assert own(patched(MAP, [[root(0, 4)], [root(4, 8)]])) == [0, 1]
    assert own(patched(MAP, [[root(0, 4, spot=1)], [root(4, 8)]])) == []
    assert own(patched(MAP, [[root(0, 4)], [root(4, 8, spot=1)]])) == [0]
    assert own(patched(MAP, [[root(0, 4, 0, 2), piece(0, 4, 2, 4)], [root(4, 8)]])) == [0, 2]
    assert own(
        patched(
            MAP,
            [
                [
                    root(0, 4),
                ],
                [root(4, 6, spot=1), root(6, 8)],
            ],
        )
    ) == [0]
    assert own(patched(MAP, [[root(0, 4)], [root(4, 8)]], (fmpq(3, 2), fmpq(0)))) == []


def test_the_spot_begins_in_every_cell_that_holds_the_place() -> None:
    """k = 1 belongs to both, and so does ξ = 0 there to the second alone."""
    assert own(patched(MAP, [[root(0, 4)], [root(4, 8, spot=-1)]], (fmpq(1), fmpq(0)))) == [1]
    assert own(patched(MAP, [[root(0, 4, spot=-1)], [root(4, 8)]], (fmpq(1), fmpq(0)))) == [0]
    assert own(patched(MAP, [[root(0, 4, spot=-1)], [root(4, 8)]], (fmpq(3, 4), fmpq(0)))) == []


def test_a_group_is_taken_whole() -> None:
    """Pieces with one number hold one spot: those of another batch count from where it begins."""
    both = [[root(0, 4)], [root(4, 8, spot=1)]]
    assert own(patched(MAP, both, groups=[3, 3])) == [0, 1]
    assert own(patched(MAP, both, groups=[0, 1])) == [0]
    assert own(patched(MAP, both)) == [0]


def test_parts_are_linked_with_those_around() -> None:
    """A piece without a tube keeps the spot from the next; a part of it leads there."""
    patchwork = patched(MAP, [[root(0, 4, 0, 4)], [piece(4, 6), root(6, 8)]])
    assert own(patchwork) == [0]
    replaced(patchwork, 1, [piece(4, 6, 0, 3), root(4, 6, 3, 4)])
    assert own(patchwork) == [0, 4, 2]
    patchwork = patched(MAP, [[piece(0, 4)], [root(4, 8)]])
    replaced(patchwork, 0, [root(0, 4)])
    assert own(patchwork) == [2, 1]


def asked(patchwork: Patchwork) -> list[int]:
    with working_bits(80):
        return [number for number, _ in patchwork.divisible()]


def test_what_may_be_divided() -> None:
    """ξ = k on a map: at first the piece at the start; not again what did not fall into parts, nor what is tiny."""
    patchwork = patched(MAP, [[piece(0, 4)], [piece(4, 8)]])
    assert asked(patchwork) == [0]
    replaced(patchwork, 0, [piece(0, 4)])
    assert asked(patchwork) == []
    assert asked(patched(MAP, [[piece(0, 4)], [piece(4, 8)]], (fmpq(1), fmpq(1)))) == [0, 1]
    tiny = SweepPiece((fmpq(0), fmpq(0)), (fmpq(1, 2**14), fmpq(1, 2)), Kind.NO_TUBE)
    assert asked(patched(MAP, [[tiny], [piece(4, 8)]])) == []
    without = SweepPiece((fmpq(0),), (fmpq(1),), Kind.NO_TUBE)
    assert asked(patched(LINE, [[without], []], (fmpq(0),))) == []


def test_beside_the_spot_there_is_hope() -> None:
    """One cell further there is none."""
    grid = Grid((Axis("k", fmpq(0), fmpq(3), 3), Axis("l", fmpq(0), fmpq(1), 1)))
    patchwork = patched(grid, [[root(0, 4)], [piece(4, 8)], [piece(8, 12)]])
    assert asked(patchwork) == [1]
    open_piece = replace(root(0, 4), kind=Kind.OPEN)
    assert asked(patched(grid, [[open_piece], [piece(4, 8)], [piece(8, 12)]])) == [0, 1]


def area(result: Sweep) -> fmpq:
    total = fmpq(0)
    for each in result.pieces:
        (left, low), (right, high) = each.lower, each.upper
        total += (right - left) * (high - low)
    return total


@pytest.fixture(scope="module")
def divided() -> Sweep:
    return sweep(ROD, OVER)


def test_a_coarse_map_is_refined_until_it_is_settled(divided: Sweep) -> None:
    coarse = sweep(ROD, OVER, budget=0)
    assert coarse.verdict.outcome is Outcome.UNDECIDED
    assert coarse.verdict.reason is Reason.BUDGET
    assert coarse.verdict.detail == (
        f"{sum(each.kind is Kind.OPEN for each in coarse.pieces)} of {len(coarse.pieces)} pieces are left; "
        "the budget of 0 divided pieces ended: a larger one may settle them"
    )
    assert divided.verdict.outcome is Outcome.PROVED
    assert divided.budget is None
    assert len(divided.pieces) > len(coarse.pieces)
    assert area(coarse) == area(divided) == fmpq(1, 10) * fmpq(1, 2)


def test_a_part_says_what_a_point_in_it_says(divided: Sweep) -> None:
    dice = random.Random(3)
    new = set(divided.pieces) - set(sweep(ROD, OVER, budget=0).pieces)
    for each in dice.sample(sorted(new, key=lambda one: one.lower), 8):
        mu, g = (
            low + (high - low) * fmpq(dice.randrange(101), 100)
            for low, high in zip(each.lower, each.upper, strict=True)
        )
        found = classify(ROD.with_parameters(mu=Fraction(int(mu.p), int(mu.q)), g=Fraction(int(g.p), int(g.q))))
        assert each.kind is Kind.CROSSING or each.answer == (found.case, found.lift_off_sign, found.impact_sign)


def test_behind_a_fold_of_a_map_nothing_is_settled() -> None:
    """There is no spot for μ < 4/3, and dividing ends by itself or with the budget."""
    result = sweep(ROD, {"mu": "1.3..1.5:2", "g": "9/10..1:1"}, start={"mu": "3/2"}, budget=20)
    assert result.verdict.outcome is Outcome.UNDECIDED
    assert "the budget of 20 divided pieces ended" in result.verdict.detail
    settled = [each for each in result.pieces if each.kind is Kind.SETTLED]
    assert settled
    assert all(3 * each.lower[0] > 4 for each in settled)


def test_a_line_is_refined_too() -> None:
    """Next to the fold β grows without bound, and passes more integers than one cell may look at."""
    oscillator, over = shipped_mechanism("oscillator"), {"mu": "2.0005..3:2"}
    coarse, fine = (sweep(oscillator, over, start={"mu": "25/12"}, budget=budget) for budget in (0, 60))
    left = [
        sum((p.upper[0] - p.lower[0] for p in each.pieces if p.kind is Kind.OPEN), fmpq(0)) for each in (coarse, fine)
    ]
    assert 10 * left[1] < left[0]
    assert {crossing.quantity for crossing in coarse.crossings} < {crossing.quantity for crossing in fine.crossings}


def test_what_vanishes_all_along_is_not_divided_for_ever() -> None:
    """kappa does not change β = 2: each piece is asked once more, and the sweep says that this was in vain."""
    result = sweep(shipped_mechanism("oscillator", beta=2), {"kappa": "-1/2..1/2:2"})
    assert result.budget is None
    assert result.verdict.outcome is Outcome.UNDECIDED
    assert "dividing them again has not settled them; more cells may: kappa=-1/2..1/2:4" in result.verdict.detail


def test_the_same_for_every_executor_and_after_a_kill(divided: Sweep, tmp_path: Path) -> None:
    """A journal goes on, also with a larger budget."""
    path = tmp_path / "journal"
    counts: list[tuple[int, int]] = []
    half = sweep(ROD, OVER, budget=7, journal=path)
    assert half == sweep(ROD, OVER, budget=7)
    assert half.verdict.outcome is Outcome.UNDECIDED
    assert sweep(ROD, OVER, journal=path, progress=lambda done, of: counts.append((done, of))) == divided
    assert all(done <= of for done, of in counts)
    assert counts[-1][0] == counts[-1][1] > 4
    whole = path.read_text(encoding="utf-8")
    path.write_text(whole[: len(whole) // 2], encoding="utf-8")
    assert sweep(ROD, OVER, journal=path) == divided
    with executor(2) as pool:
        assert sweep(ROD, OVER, executor=pool) == divided


@pytest.mark.parametrize("budget", [-1, 2.5, "7", True])
def test_a_wrong_budget(budget: int) -> None:
    with pytest.raises(ValueError, match="budget must be an int >= 0"):
        sweep(ROD, OVER, budget=budget)
