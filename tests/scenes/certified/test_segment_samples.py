"""Samples of proved steps: their times, their units, and that wide states have wide samples."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb

from gspot_verified.scenes.certified.segment_samples import SAMPLES_OF_A_STEP, SegmentSamples
from gspot_verified.scenes.scene.file import load_scene

SCENE = load_scene("fig-varsim1", epsilon="1/4", p="1/2")


class Line:
    """A step along a straight line: each state is its number plus tau, within a radius; one more state follows."""

    def __init__(self, time: str, end: str, radius: str = "0") -> None:
        self.time, self.end_time, self._radius = arb(time), arb(end), arb(radius)

    def states(self, tau: arb) -> list[arb]:
        return [arb(k) + tau + arb(0, self._radius) for k in range(1, 6)]


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
    assert found.phases == ("slip",) * (2 * SAMPLES_OF_A_STEP + 1)
    taus = [k / 4 for k in range(5)] + [k / 4 for k in range(1, 5)]
    times = [12 + tau * 2 for tau in taus[:5]] + [14 + tau * 4 for tau in taus[5:]]
    expected = {
        "t": [time / 4 for time in times],
        "p": [0.5 - time / 4 for time in times],
        "b": [1 + tau for tau in taus],
        "y": [(2 + tau) / 16 for tau in taus],
        "v": [(3 + tau) / 4 for tau in taus],
        "z": [(4 + tau) / 16 for tau in taus],
        "lambda_N": [2.0 for _ in taus],
    }
    units = {"b": 1.0, "y": 1 / 16, "v": 1 / 4, "z": 1 / 16, "lambda_N": 2.0}
    assert set(found.columns) == {name + end for name in expected for end in ("", "_radius")}
    for name, values in expected.items():
        assert found.columns[name].tolist() == pytest.approx(values, abs=1e-12)
        width = float(radius) * units.get(name, 0.0)
        for half in found.columns[name + "_radius"].tolist():
            assert width <= half <= width * (1 + 1e-6) + 1e-14


def test_a_beginning_in_a_bracket_widens_the_times_alone() -> None:
    samples = SegmentSamples(SCENE)
    samples.beside(lambda *_: False, SCENE.system("slip"), arb("10", "0.5"))(Line("2", "4"), {})
    found = samples.samples()
    for name, width in (("t", 0.125), ("p", 0.125), ("b", 0.0)):
        for half in found.columns[name + "_radius"].tolist():
            assert width <= half <= width + 1e-6


def test_each_phase_has_its_name_and_a_later_one_goes_on() -> None:
    """A later phase begins with its second sample."""
    samples = SegmentSamples(SCENE)
    assert samples.samples().phases == ()
    samples.beside(lambda *_: False, SCENE.system("flight"), arb(0))(Line("0", "1"), {})
    samples.beside(lambda *_: False, SCENE.system("slip"), arb(1))(Line("0", "1"), {})
    found = samples.samples()
    assert found.phases == ("flight",) * 5 + ("slip",) * 4
    assert set(found.columns["lambda_N"][:5]) == {0.0}
    assert found.columns["t"].tolist() == [k / 16 for k in range(9)]
