"""Which pieces hold the continued spot: neighbours with the same zero where they meet. Page: proofs/sweep.md.

x^2 = λ has two roots; the pieces hold tubes of one or of the other.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.sweep import sweep_links
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_links import Groups, Links, common_place, groups_in_a_row, same_zero
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece, TubeRecord
from gspot_verified.mechanisms.sweep.sweep_pieces import PieceStore, packed
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, Tube
from gspot_verified.numbers.balls import working_bits

ROOT = Equations(BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2), 1)
Corners = tuple[tuple[int | fmpq, ...], tuple[int | fmpq, ...]]


def box(corners: Corners) -> SweepPiece:
    lower, upper = (tuple(map(fmpq, ends)) for ends in corners)
    return SweepPiece(lower, upper, Kind.NO_TUBE)


@pytest.mark.parametrize(
    ("first", "second", "place"),
    [
        (((0,), (1,)), ((1,), (3,)), (1,)),
        (((1,), (3,)), ((0,), (1,)), (1,)),
        (((0,), (1,)), ((2,), (3,)), None),
        (((2,), (3,)), ((0,), (1,)), None),
        (((0,), (4,)), ((1,), (3,)), (2,)),
        (((0,), (2,)), ((1,), (5,)), (fmpq(3, 2),)),
        (((0, 0), (1, 4)), ((1, 2), (2, 8)), (1, 3)),
        (((1, 2), (2, 8)), ((0, 0), (1, 4)), (1, 3)),
        (((0, 0), (4, 1)), ((1, 1), (3, 2)), (2, 1)),
        (((0, 0), (1, 1)), ((1, 1), (2, 2)), None),  # a corner
        (((0, 0), (1, 1)), ((1, 2), (2, 3)), None),
        (((0, 0), (1, 1)), ((2, 0), (3, 1)), None),
        (((0, 0), (2, 2)), ((1, 1), (3, 3)), (fmpq(3, 2), fmpq(3, 2))),
    ],
)
def test_where_two_pieces_meet(first: Corners, second: Corners, place: tuple[int | fmpq, ...] | None) -> None:
    found = common_place(box(first).box, box(second).box)
    assert found == (None if place is None else tuple(map(fmpq, place)))


def root(lower: int, upper: int, sign: int = 1) -> SweepPiece:
    """The piece over [lower, upper] that holds one of the two roots."""
    low, high = (fmpq(lower),), (fmpq(upper),)
    middle = (fmpq(lower + upper) / 2,)
    with working_bits(80):
        guess = fmpq(*(sign * ((lower + upper) / 2) ** 0.5).as_integer_ratio())
        on = proved_tube(ROOT, low, high, Origin(middle, (guess,), ((1 / (2 * guess),),)))
        assert on is not None
        return SweepPiece(low, high, Kind.SETTLED, record=TubeRecord.of(on.tube))


def test_groups_are_those_that_hold_the_same_root() -> None:
    """Cell after cell; beyond the next cell, and where there is no tube, nothing is said."""
    line = [root(1, 2), root(2, 3), root(3, 5, -1), root(5, 6, -1), box(((6,), (7,))), root(7, 8, -1)]
    with working_bits(80):
        groups = groups_in_a_row(ROOT, [[line[0], line[1]], [line[2]], [], [line[3]], [line[4], line[5]]])
        assert list(groups) == [0, 0, 1, 2, 3, 4]
        assert list(groups_in_a_row(ROOT, [[each] for each in line])) == [0, 0, 1, 1, 2, 3]
        assert list(groups_in_a_row(ROOT, [[root(3, 5), root(6, 7)], []])) == [0, 1]


def test_what_is_joined_stays_joined() -> None:
    groups = Groups(2)
    assert groups.add(3) == 2
    groups.join(4, 2)
    assert groups.with_first() == [True, False, False, False, False]
    groups.join(1, 4)
    groups.join(2, 0)
    assert groups.with_first() == [True, True, True, False, True]
    assert [groups.of(number) for number in range(5)] == [0, 0, 0, 3, 0]


def test_pieces_are_one_where_all_groups_between_are_joined(monkeypatch: pytest.MonkeyPatch) -> None:
    line = Grid((Axis("k", fmpq(1), fmpq(8), 7),))
    links = Links(PieceStore(line), ROOT, [fmpq(1)], [arb(1)])
    cells = [[root(k, k + 1, sign)] for k, sign in zip(range(1, 7), (1, 1, -1, -1, 1, 1), strict=True)]
    with working_bits(80):
        links.add(packed(cells), groups_in_a_row(ROOT, cells))
        one = [(a, b) for a in range(7) for b in range(a, 7) if links.are_one(a, b)]
        assert one == [(0, 1), (0, 2), (1, 2), (2, 3), (2, 4), (3, 4), (4, 5), (4, 6), (5, 6)]
        for piece in (1, 3):  # the two roots are not the same
            links.link([piece], [piece + 1])
        assert not links.are_one(0, 6)
        links.add(packed([[root(7, 8)]]), [0])
        assert not links.are_one(5, 7)
        links.link([6], [4, 5])
        assert links.are_one(4, 7)
        assert not links.are_one(3, 7)
    monkeypatch.setattr(sweep_links, "same_zero", None)
    links.link([4, 5, 6], [4, 5, 6])  # is not asked again


def level(radius: str, found: str) -> Tube:
    """Around 2 over [3, 5]; its zero is said to lie within ``found`` of 2."""
    return Tube((fmpq(3),), (fmpq(5),), (arb(2),), ((arb(0),),), (arb(0, radius),), (arb(0, found),))


def test_a_zero_in_between_decides_where_what_is_found_is_too_wide(monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither tube holds all that the other may have found; the zero itself, sought anew, lies in both or not."""
    place = (fmpq(4),)
    first, second = level("0.5", "0.4"), level("0.3", "0.29")
    with working_bits(80):
        assert same_zero(ROOT, first, level("0.45", "0.1"), place)
        assert same_zero(ROOT, level("0.45", "0.1"), first, place)
        wide = (
            level("0.25", "0.24"),
            Tube(first.lower, first.upper, (arb("2.3"),), first.slopes, (arb(0, "0.4"),), (arb(0, "0.39"),)),
        )
        assert same_zero(ROOT, *wide, place)
        assert same_zero(ROOT, *reversed(wide), place)
        apart = Tube(first.lower, first.upper, (arb("2.3"),), first.slopes, (arb(0, "0.25"),), (arb(0, "0.24"),))
        assert not same_zero(ROOT, second, apart, place)
        assert not same_zero(ROOT, apart, second, place)
        monkeypatch.setattr(sweep_links, "proved_tube", lambda *_: None)
        assert not same_zero(ROOT, *wide, place)
        one_way = level("0.5", "0.49"), level("0.45", "0.1")  # the first holds what the second found
        assert same_zero(ROOT, *one_way, place)
        assert same_zero(ROOT, *reversed(one_way), place)
