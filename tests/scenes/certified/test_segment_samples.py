"""Samples and boxes of proved steps: their times, their units, no gap, and that wide states have wide samples."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb

from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.certified.segment_samples import PIECES_OF_A_STEP, SegmentSamples
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.samples import Samples

SCENE = load_scene("fig-varsim1", epsilon="1/4", p="1/2")
NAMES = ("p", "b", "y", "v", "z", "lambda_N")
UNITS = {"b": 1.0, "y": 1 / 16, "v": 1 / 4, "z": 1 / 16, "lambda_N": 2.0}


class Line:
    """A step along a straight line: each state is its number plus tau, within a radius; one more state follows."""

    def __init__(self, time: str, end: str, radius: str = "0") -> None:
        self.time, self.end_time, self._radius = arb(time), arb(end), arb(radius)

    def states(self, tau: arb) -> list[arb]:
        return [arb(k) + tau + arb(0, self._radius) for k in range(1, 6)]


def values(clock: float, tau: float) -> dict[str, float]:
    """Of a Line: p = 1/2 - t, b = 1 + tau, Y = 2 + tau, V = 3 + tau, Z = 4 + tau, lambda_N = 2."""
    return {
        "t": clock / 4,
        "p": 0.5 - clock / 4,
        "b": 1 + tau,
        "y": (2 + tau) / 16,
        "v": (3 + tau) / 4,
        "z": (4 + tau) / 16,
        "lambda_N": 2.0,
    }


def no_gap(samples: Samples) -> None:
    """The boxes follow one another, and both ends of each are samples, which lie in it."""
    boxes, columns = samples.boxes, samples.columns
    assert boxes is not None
    assert np.all(boxes.lower["t"][1:] <= boxes.upper["t"][:-1])
    assert np.all(boxes.lower["t"] < boxes.upper["t"])
    for k, time in enumerate(columns["t"].tolist()):
        inside = (boxes.lower["t"] <= time) & (time <= boxes.upper["t"])
        assert inside.any()
        for name in NAMES:
            middle, radius = columns[name][k], columns[name + "_radius"][k]
            room = 1e-14 * (1 + abs(middle))
            holds = (boxes.lower[name] <= middle - radius + room) & (middle + radius - room <= boxes.upper[name])
            assert (inside & holds).any(), (name, time)


@pytest.mark.parametrize("radius", ["0", "0.25"])
def test_the_ends_of_a_step_and_times_between_in_the_units_of_the_paper(radius: str) -> None:
    """Two steps, T = 10 + [2, 4] and 10 + [4, 8]: the end of the first is not repeated by the second."""
    seen: list[Any] = []
    samples = SegmentSamples(SCENE)
    system = SCENE.system("slip")
    assert system.states == ("b", "Y", "V", "Z")
    observer = samples.beside(lambda *given: seen.append(given) or len(seen) == 2, system, arb(10))  # type: ignore[func-returns-value]
    first, second = Line("2", "4", radius), Line("4", "8", radius)
    assert observer(first, {"b": arb(1)}) is False
    assert observer(second, {}) is True
    assert seen == [(first, {"b": arb(1)}), (second, {})]
    found = samples.samples()
    columns = found.columns
    assert set(columns) == {name + end for name in ("t", *NAMES) for end in ("", "_radius")}
    assert set(found.phases) == {"slip"}
    assert np.all(np.diff(columns["t"]) > 0)
    assert {12 / 4, 14 / 4, 18 / 4} <= set(columns["t"].tolist())
    assert len(found.phases) >= 2 * PIECES_OF_A_STEP + 1
    for k, time in enumerate(columns["t"].tolist()):
        clock = 4 * time
        tau = (clock - 12) / 2 if clock <= 14 else (clock - 14) / 4
        for name, value in values(clock, tau).items():
            assert columns[name][k] == pytest.approx(value, abs=1e-12), (name, time)
            width = float(radius) * UNITS.get(name, 0.0)
            assert width <= columns[name + "_radius"][k] <= width * (1 + 1e-6) + 1e-14
    no_gap(found)


def test_pieces_are_shorter_where_the_trajectory_is_steep() -> None:
    """A box that is taller than a part of what was seen so far is halved; where nothing moves the pieces stay."""

    class Still(Line):
        def states(self, tau: arb) -> list[arb]:
            return [arb(k) + 0 * tau for k in range(1, 6)]

    counts = []
    for step in (Still("0", "1/1024"), Line("0", "1/1024")):
        samples = SegmentSamples(SCENE)
        samples.beside(lambda *_: False, SCENE.system("slip"), arb(1))(step, {})
        counts.append(len(samples.samples().phases))
    assert counts[0] == PIECES_OF_A_STEP + 1
    assert counts[1] > 4 * counts[0]


def test_a_beginning_in_a_bracket_widens_the_times_alone() -> None:
    samples = SegmentSamples(SCENE)
    samples.beside(lambda *_: False, SCENE.system("slip"), arb("10", "0.5"))(Line("2", "4"), {})
    found = samples.samples()
    for name, width in (("t", 0.125), ("p", 0.125), ("b", 0.0)):
        for half in found.columns[name + "_radius"].tolist():
            assert width <= half <= width + 1e-6


def test_each_phase_has_its_name_and_begins_where_the_one_before_ends() -> None:
    samples = SegmentSamples(SCENE)
    assert samples.samples().phases == ()
    samples.beside(lambda *_: False, SCENE.system("flight"), arb(0))(Line("0", "1"), {})
    samples.beside(lambda *_: False, SCENE.system("slip"), arb(1))(Line("0", "1"), {})
    found = samples.samples()
    last = found.phases.index("slip")
    assert set(found.phases[:last]) == {"flight"}
    assert set(found.phases[last:]) == {"slip"}
    assert set(found.columns["lambda_N"][:last]) == {0.0}
    times = found.columns["t"].tolist()
    assert (times[0], times[last - 1], times[last], times[-1]) == (0, 0.25, 0.25, 0.5)
    boxes = found.boxes
    assert boxes is not None
    assert len(boxes.phases) == len(boxes.lower["t"]) == len(boxes.upper["t"])
    assert set(boxes.phases) == {"flight", "slip"}
    for phase, left, right in zip(boxes.phases, boxes.lower["t"], boxes.upper["t"], strict=True):
        assert phase == ("flight" if left + right < 0.5 else "slip")


def test_an_event_inside_a_step_ends_the_phase() -> None:
    """Half of the step T = 10 + [0, 4] is before the bracket 2 +- 1/1024, which is a box of its own, and a sample."""
    samples, system = SegmentSamples(SCENE), SCENE.system("slip")
    samples.beside(lambda *_: False, system, arb(10))
    bracket = {name: arb(k) + arb("0.5", "0.001") for k, name in enumerate(system.states, 1)}
    samples.event((Line("0", "4"), arb("0.5")), arb(2, "0.0009765625"), bracket)
    found = samples.samples()
    times = found.columns["t"].tolist()
    assert times[-2:] == [12 / 4, 12 / 4]
    assert found.columns["b"][-2:].tolist() == pytest.approx([1.5, 1.5])
    assert found.columns["t_radius"][-1] == pytest.approx(2.0**-12)
    assert found.columns["b_radius"].tolist()[-1] == pytest.approx(0.001)
    no_gap(found)
    assert found.boxes is not None
    assert found.boxes.upper["t"][-1] == pytest.approx(3 + 2.0**-12)
    again = SegmentSamples(SCENE)
    again.beside(lambda *_: False, system, arb(10))
    again.event(None, arb(2), bracket)
    assert again.samples().columns["t"].tolist() == [3.0]


def test_before_an_event_where_a_step_begins_nothing_is_added() -> None:
    """The bracket 10 + [0, 1/512] begins with the step: it alone is a box and a sample."""
    samples, system = SegmentSamples(SCENE), SCENE.system("slip")
    samples.beside(lambda *_: False, system, arb(10))
    bracket = {name: arb(k, "0.01") for k, name in enumerate(system.states, 1)}
    samples.event((Line("0", "4"), arb(0)), arb(1, 1) / 1024, bracket)
    found = samples.samples()
    assert found.columns["t"].tolist() == pytest.approx([2.5 + 2.0**-12])
    assert found.boxes is not None
    assert found.boxes.phases == ("slip",)
    assert found.boxes.lower["t"].tolist() == pytest.approx([2.5])
    assert found.boxes.upper["t"].tolist() == pytest.approx([2.5 + 2.0**-11])


def test_of_a_run_each_event_is_sampled_and_there_is_no_gap() -> None:
    """The force goes to 0 at the lift-off, and is 0 at the touch-down; before, steps with an event left a gap there."""
    scene = load_scene("fig-varsim1", epsilon="1/100", until="3/2")
    run = certified_run(scene, route="integrator", points=2)
    found = run.samples
    assert found is not None
    no_gap(found)
    columns = found.columns
    for event, ended in zip(run.events[:2], ("slip", "flight"), strict=True):
        time = approximate((event.lower + event.upper) / 2)
        rows = np.flatnonzero(np.abs(columns["t"] - time) < 1e-14)
        assert [found.phases[row] for row in rows][-2:] == [ended, "flight" if ended == "slip" else "slip"]
        assert np.abs(columns["lambda_N"][rows]).max() < 1e-14
        assert np.abs((columns["y"] - columns["z"])[rows]).max() < 1e-16


def test_a_row_is_of_one_time_in_the_ball_of_its_time_not_of_the_rounded_one() -> None:
    """p = 1/10 - t exactly: at t = 1/10, which is no double, p at the double t lies outside of the row's ball."""
    run = certified_run(load_scene("fig-varsim1", epsilon="1/10", p="1/10", until="1/10"), route="integrator", points=2)
    assert run.samples is not None
    columns = ("t", "t_radius", "p", "p_radius")
    rows = [list(map(Fraction, row)) for row in zip(*(run.samples.columns[name] for name in columns), strict=True)]
    apart = [(abs(Fraction(1, 10) - t - p), t_radius, p_radius) for t, t_radius, p, p_radius in rows]
    assert all(difference <= t_radius + p_radius for difference, t_radius, p_radius in apart)
    assert any(difference > p_radius for difference, _, p_radius in apart)
    assert "need not be the double t" in (Samples.__doc__ or "")
