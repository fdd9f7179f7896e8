"""What of a tube goes through a record: never more than was proved. Page: proofs/sweep.md, section 2."""

from __future__ import annotations

from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.balls import working_bits
from gspot_verified.mechanisms.sweep_piece import TubeRecord
from gspot_verified.mechanisms.tube import Tube

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
        assert TubeRecord.of(once.tube(PLACE, PLACE)).within == once.within
