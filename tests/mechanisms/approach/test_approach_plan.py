"""Which state of a path is a start for an explicit epsilon_0."""

from __future__ import annotations

import pytest
from flint import arb

from gspot_verified.mechanisms.approach.approach_plan import state_to_start_from


@pytest.mark.parametrize(("radius", "number"), [(32.0, 0), (8.3, 0), (7.7, 2), (3.2, 3), (1e-9, 4)])
def test_the_first_state_near_the_goal_is_taken(radius: float, number: int) -> None:
    """A 32nd of the radius; from twice that on it is the first one."""
    sizes = [arb("0.5"), arb("0.3"), arb("0.2"), arb("0.05"), arb("0.01")]
    assert state_to_start_from(sizes, radius) == number
