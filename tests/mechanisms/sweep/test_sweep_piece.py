"""What of a tube goes through a record: never more than was proved. Page: proofs/sweep.md, section 2."""

from __future__ import annotations

import json

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.sweep.sweep_piece import NUMBERS, Kind, Passing, SweepPiece, TubeRecord, interval
from gspot_verified.mechanisms.zeros.tube import Tube
from gspot_verified.numbers.balls import nonfinite, working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.packed import PackedIntervals

PLACE = (fmpq(0),)


@given(st.floats(1e-30, 1e3), st.floats(0, 1e-31))
def test_a_tube_does_not_become_wider_by_its_record(width: float, offset: float) -> None:
    """The zero is the only one in ``within``, not in a wider ball; what is found may only become wider."""
    with working_bits(80):
        within = arb(offset, arb(width).upper())
        tube = Tube(PLACE, PLACE, (arb(1),), ((arb(2),),), (within,), (within / 3,))
        again = TubeRecord.of(tube).tube(PLACE, PLACE)
        assert within.contains(again.within[0])
        assert again.within[0].is_finite()
        assert again.within[0].rad() * (1 + fmpq(1, 2**20)) > within.rad()
        assert again.found[0].contains(tube.found[0])
        assert again.centre[0].is_exact()
        assert again.centre[0] == 1
        assert again.slopes[0][0] == 2


def test_a_record_of_a_record_is_the_same() -> None:
    with working_bits(80):
        tube = Tube(PLACE, PLACE, (arb(1),), ((arb(2),),), (arb(0, arb("0.7").upper()),), (arb(0, "0.1"),))
        once = TubeRecord.of(tube)
        assert TubeRecord.of(once.tube(PLACE, PLACE)).parts()[2] == once.parts()[2]


def test_what_a_piece_holds_and_its_middle() -> None:
    piece = SweepPiece((fmpq(1), fmpq(3)), (fmpq(2), fmpq(7)), Kind.NO_TUBE)
    assert piece.middle == (fmpq(3, 2), fmpq(5))
    for place in ((1, 3), (2, 7), (1, 7), (fmpq(3, 2), 4)):
        assert piece.holds(list(map(fmpq, place)))
    for place in ((fmpq(99, 100), 3), (fmpq(201, 100), 3), (1, fmpq(299, 100)), (1, fmpq(701, 100))):
        assert not piece.holds(list(map(fmpq, place)))
    with pytest.raises(ValueError, match="zip"):
        piece.holds([fmpq(1)])
    assert piece.tube() is None
    assert piece.answer == (None, None, None)


PLAIN = SweepPiece((fmpq(1),), (fmpq(2),), Kind.NO_TUBE)


def full() -> SweepPiece:
    tube = Tube((fmpq(1),), (fmpq(2),), (arb(1),), ((arb(2),),), (arb(0, "0.7"),), (arb(0, "0.1"),))
    numbers = PackedIntervals(None if k == 1 else Dyadic.from_ball(arb(k, "0.25")) for k in range(len(NUMBERS)))
    passing = Passing("beta - 2", 0, -1, 1, None)
    unsure = ("beta - 2",)
    return SweepPiece(
        (fmpq(1),), (fmpq(2),), Kind.CROSSING, "III", -1, 1, unsure, passing, numbers, TubeRecord.of(tube)
    )


@pytest.mark.parametrize("piece", [PLAIN, full()], ids=["plain", "full"])
def test_the_plain_data_of_a_piece(piece: SweepPiece) -> None:
    data = json.loads(json.dumps(piece.to_json()))
    assert [Dyadic.parse(number) if number else None for number in data["numbers"]] == list(piece.numbers)
    assert [data["kind"], data["case"], data["lift_off_sign_of_C1"], data["impact_sign_of_C1"]] == [
        piece.kind.value, piece.case, piece.lift_off_sign, piece.impact_sign,
    ]  # fmt: skip
    assert (data["tube"] is None) == (piece.record is None)
    assert (data["passing"] is None) == (piece.passing is None)


def test_numbers_by_name() -> None:
    assert full().number("alpha_2") is None
    number = full().number("alpha_3")
    assert number is not None
    assert number.contains(2)
    assert PLAIN.number("beta") is None
    assert full().answer == ("III", -1, 1)
    assert interval(None) is None
    assert interval(nonfinite()) is None
    assert interval(arb(1, 2)) == Dyadic.from_ball(arb(1, 2))


def test_a_tube_over_two_parameters_comes_back_row_by_row() -> None:
    box = (fmpq(0), fmpq(1)), (fmpq(1), fmpq(3))
    rows = ((arb(1), arb(2)), (arb(3), arb(4)))
    with working_bits(80):
        tube = Tube(*box, (arb(5), arb(6)), rows, (arb(0, 1), arb(0, 2)), (arb(0, "0.5"), arb(0, "0.25")))
        assert TubeRecord.of(tube).tube(*box).slopes == rows
