"""The parts of rigid slip (proofs/from_own_state.md, section 3) beside the exact slip of the model system."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.mechanisms.approach.slip_flow import SlipFlow
from gspot_verified.mechanisms.approach.slip_state import slip_state
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.own_state.rigid_way import WayPart, rigid_way
from gspot_verified.numbers.balls import ball, hull, working_bits


def way(goal: arb, most: int = 100) -> list[WayPart] | None:
    shifted = shift(load("model system"))
    start = slip_state(shifted, {"x": 0, "u": 3, "p": "1/2", "b": "-2"}).box
    return rigid_way(SlipFlow.of(shifted), start, goal, most)


def exact_b(p: arb) -> arb:
    """b = -2p + C p^(3/2) with alpha = (-1, -1, -3/2): b' = -1 - (3/2) b/p... along p' = -1."""
    return -2 * p - 1 / arb(fmpq(1, 2)) ** arb("1.5") * p ** arb("1.5")


def test_the_parts_follow_each_other_and_hold_the_slip() -> None:
    with working_bits(160):
        parts = way(arb("0.2", "0.01"))
        assert parts is not None
        time = arb(0)
        before = arb(fmpq(1, 2))
        for part in parts:
            time += part.duration
            assert time.overlaps(part.until)
            p = ball(fmpq(1, 2)) - part.until
            assert part.last[4].overlaps(p)
            assert part.last[5].overlaps(exact_b(p))
            for inner in (before, (before + p) / 2, p):
                assert part.states[4].overlaps(inner)
                assert part.states[5].overlaps(exact_b(inner))
            assert part.states[4].rad() < hull([before, p]).rad() * 2
            before = p
        assert arb("0.2", "0.01").contains(parts[-1].last[4])
        assert not any(arb("0.2", "0.01").contains(part.last[4]) for part in parts[:-1])


@pytest.mark.parametrize("goal", [arb("0.2"), arb("0.6", "0.01"), arb("nan"), arb(-1)])
def test_a_place_that_no_part_ends_in(goal: arb) -> None:
    with working_bits(160):
        assert way(goal, 3) is None
