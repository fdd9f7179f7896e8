"""Theorems 2 and 4 of the page: C_1 read off early, where the bound is wide, contains C_1 read off late.

Page: proofs/approach.md.
"""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb

from gspot_verified.balls import working_bits
from gspot_verified.integrator.integrate import Run
from gspot_verified.mechanisms.approach import approach
from gspot_verified.mechanisms.capture import Capture, capture
from gspot_verified.mechanisms.deviation_coefficient import coefficient_above_one, coefficient_below_one
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.slip_state import slip_state
from gspot_verified.mechanisms.to_system import shift

STARTS: list[tuple[str, dict[str, Any]]] = [
    ("extended", {"x": 0, "u": 3, "p": "1/4", "b": "-1/2"}),
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}),
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-1/2"}),
    ("rod", {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"}),
]


@pytest.mark.parametrize(("name", "state"), STARTS)
def test_early_bounds_contain_the_late_value(name: str, state: dict[str, Any]) -> None:
    mechanism = shipped_mechanism(name)
    accurate = approach(mechanism, state).coefficient
    assert accurate is not None
    assert accurate.is_finite()
    found: list[arb] = []
    with working_bits(160):
        flow = SlipFlow.of(shift(mechanism))
        numbers, by_p = SlipNumbers(flow), flow.by_p()
        run = Run(flow.desingularised(), [*slip_state(shift(mechanism), state).box, arb(0)], max_steps=26)
        caught: list[tuple[list[arb], Capture]] = []
        for segment in run:
            states = segment.after.enclosure()
            held = capture(numbers, states, None)
            if held is not None:
                caught.append((states, held))
        place = caught[-1][1].box
        for states, held in caught:
            if held.numbers.alpha_3 > held.numbers.alpha_1:
                value = coefficient_below_one(numbers, states, held, place)
            else:
                p = numbers.on(states).p
                value = coefficient_above_one(numbers, by_p, states, held, place, 8, (4 * p.upper()).max(arb(2) ** -9))
            if value is not None:
                found.append(value)
        assert len(found) >= 5
        for value in found:
            assert value.is_finite()
            assert value.overlaps(accurate)
        narrow = [value for value in found if value.rad() < abs(accurate) * arb("1e-2")]
        assert len(narrow) >= 2
        assert any(value.rad() > 10 * narrow[-1].rad() for value in found)


def test_hypotheses_that_fail() -> None:
    """Theorem 2 asks for α_3 < α_1 on the neighbourhood, and for a disc that is larger than p."""
    mechanism = shipped_mechanism("rod")
    with working_bits(120):
        flow = SlipFlow.of(shift(mechanism))
        numbers = SlipNumbers(flow)
        run = Run(flow.desingularised(), [*slip_state(shift(mechanism), STARTS[3][1]).box, arb(0)], max_steps=12)
        states = [segment.after.enclosure() for segment in run][-1]
        held = capture(numbers, states, None)
        assert held is not None
        assert coefficient_above_one(numbers, flow.by_p(), states, held, held.box, 5, arb(1) / 64) is None
        model = SlipFlow.of(shift(shipped_mechanism("model")))
        own = SlipNumbers(model)
        at = [arb(0), arb(5), arb(0), arb(0), arb(1) / 64, arb(-1) / 16]
        inside = capture(own, at, None)
        assert inside is not None
        assert coefficient_above_one(own, model.by_p(), at, inside, inside.box, 5, arb(1) / 128) is None
        assert coefficient_below_one(own, at, inside, inside.box) is None
