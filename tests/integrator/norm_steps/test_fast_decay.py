"""When a slow step is tried: what is read is what was written, and lengths follow what was learned."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from gspot_verified.integrator.norm_steps.fast_decay import DecayState, FastDecay
from gspot_verified.integrator.norm_steps.slow_curve import SlowCurve

FAST_AND_SLOW = [-100.0, -0.001]


def curve(tail: float, start: float) -> SlowCurve:
    return SlowCurve([], tail, start, np.zeros((41, 2, 2)))


def after(steps: int, h: float = 1.0) -> FastDecay:
    """After steps of the same length along constant rates: the fast part has decayed by e^(-100 h) in each."""
    decay = FastDecay()
    for _ in range(steps + 1):
        decay.passed(FAST_AND_SLOW, h)
    return decay


def test_a_state_is_read_as_it_was_written() -> None:
    state = DecayState((-1.5 + 2j, -3 + 0j), (0.1, math.inf), 1 / 3, 0.0, math.inf)
    assert state.to_json() == [[[-1.5, 2.0], [-3.0, 0.0]], [0.1, math.inf], 1 / 3, 0.0, math.inf]
    assert DecayState.from_json(json.loads(json.dumps(state.to_json()))) == state
    decay = after(3)
    other = FastDecay()
    other.state = decay.state
    assert other.state == decay.state
    assert other.slow_length(100, 0.01) == decay.slow_length(100, 0.01) > 0
    assert other.state == decay.state


@pytest.mark.parametrize(
    "data",
    [
        [[[1.0, 2.0]], [0.5], 1.0, 2.0],
        [[[1.0, 2.0]], [0.5], 1.0, 2.0, 3.0, 4.0],
        [[[1.0, 2.0]], [0.5, 0.5], 1.0, 2.0, 3.0],
        [[], [0.5], 1.0, 2.0, 3.0],
        [[[1, 2.0]], [0.5], 1.0, 2.0, 3.0],
        [[[1.0, 2.0]], [True], 1.0, 2.0, 3.0],
        [[[1.0, 2.0]], [0.5], 1.0, 2.0, "3.0"],
    ],
)
def test_states_that_are_refused(data: Any) -> None:
    with pytest.raises(ValueError, match="not the state of a decay"):
        DecayState.from_json(data)


def test_no_slow_step_before_the_fast_part_has_died_out() -> None:
    """At 100 bits it has after 43 units: 0.62 of 69 = 100 ln 2. The slow part is as good as constant."""
    assert FastDecay().slow_length(100, 0.01) == 0.0
    assert after(0).slow_length(100, 0.01) == 0.0
    waiting, ready = (after(steps, 0.01) for steps in (42, 44))
    assert waiting.slow_length(100, 0.001) == 0.0
    assert ready.slow_length(100, 0.001) > 0.3
    assert ready.slow_length(200, 0.001) > 0.3, "the length that was found is kept until the next step"
    fresh = after(44, 0.01)
    assert fresh.slow_length(200, 0.001) == 0.0


def test_a_slow_step_that_gains_little_is_not_tried() -> None:
    length = after(3).slow_length(100, 1e-6)
    assert length == 64.0
    assert after(3).slow_length(100, length / 19) == 0.0
    assert after(3).slow_length(100, length / 20) == 0.0
    assert after(3).slow_length(100, length / 21) == length


def test_rates_that_change_shorten_the_step() -> None:
    """A tenth of the rate in one unit: the length is a share of the 10 units in which all of it changes."""
    decay = FastDecay()
    for rate in (-100.0, -100.0, -90.0):
        decay.passed([rate, -0.001], 1.0)
    assert decay.slow_length(100, 1e-6) == pytest.approx(0.12 * 9)


def test_a_change_of_the_number_of_rates_begins_anew() -> None:
    decay = after(3)
    decay.passed([-100.0], 1.0)
    assert decay.state.decayed == (0.0,)


def test_what_is_learned_of_a_curve() -> None:
    """Refused without one, from a start too far off, with a series too short; else the length follows the tail."""
    for found, state in [
        (None, (0.0, 0.0)),
        (curve(-100.0, -40.0), (40 * math.log(2), -0.001 * -3)),
        (curve(-100.0, 5.0), (0.0, 0.0)),
    ]:
        decay = after(3)
        assert decay.slow_length(100, 1e-6) == 64.0
        assert not decay.accepts(found, 100)
        assert decay.state.decayed == pytest.approx(state)
        assert decay.state.length == 0.0
    decay = after(3)
    assert decay.slow_length(100, 1e-6) == 64.0
    assert not decay.accepts(curve(-79.0, -70.0), 100)
    assert (decay.state.length, decay.state.limit) == (32.0, 32.0)
    assert decay.accepts(curve(-84.0, -70.0), 100)
    assert (decay.state.length, decay.state.limit) == (32.0, 32.0 * 1.3)
    assert decay.accepts(curve(-124.0, -70.0), 100)
    assert decay.state.length == pytest.approx(64.0)
    assert decay.accepts(curve(-1000.0, -70.0), 100)
    assert decay.state.length == pytest.approx(512.0)
