"""What is drawn of a run, as numbers: no line crosses an event, events are on the curve, boxes hold the curve."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.balls import approximate
from gspot_verified.report.pictures.scene_curves import boxes_over, falls, outline, phase_rows, places, sampled_at
from gspot_verified.scenes.certified_run import certified_run, with_boxes
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.scenes.scene.samples import RADIUS, Boxes, Samples

SCENE = load_scene("fig-varsim1", epsilon="1/100", until="3/2")


@cache
def exact() -> SceneRun:
    return certified_run(SCENE, points=5)


@cache
def boxed() -> SceneRun:
    return with_boxes(SCENE, exact())


@cache
def floats() -> SceneRun:
    return float_run(SCENE, tolerance=1e-8, points=5)


def times(run: SceneRun) -> list[float]:
    return [approximate((event.lower + event.upper) / 2) for event in run.events]


@pytest.mark.parametrize("made", [exact, boxed, floats], ids=["exact", "boxes", "floats"])
@pytest.mark.parametrize("over", ["t", "p"])
def test_events_are_drawn_at_their_times_on_the_curve(made: Callable[[], SceneRun], over: str) -> None:
    """The touch-down, which lies beyond the last of the equal steps that is known, at its own p = 1/2 - t."""
    run = made()
    found = places(run, over)
    assert [place.name for place in found][:2] == ["lift-off", "touch-down"]
    samples = run.samples
    assert samples is not None
    for place, time in zip(found, times(run), strict=True):
        assert place.at == pytest.approx(time if over == "t" else 0.5 - time, abs=1e-14)
        assert place.value(samples.columns["t"]) == pytest.approx(time, abs=1e-14)
    for place in found[:2]:  # y = z where the contact opens and closes
        gap = place.value(samples.columns["y"] - samples.columns["z"])
        assert gap is not None
        assert abs(gap) < 1e-6 * abs(samples.columns["y"][0])


@pytest.mark.parametrize("made", [exact, boxed, floats], ids=["exact", "boxes", "floats"])
def test_no_line_crosses_an_event(made: Callable[[], SceneRun]) -> None:
    """The force is not 0 before lift-off, is 0 at it and after it, and no line joins the two."""
    run = made()
    samples = run.samples
    assert samples is not None
    at, force = samples.columns["t"], samples.columns["lambda_N"]
    changes = [
        time for event, time in zip(run.events, times(run), strict=True) if event.name in ("lift-off", "touch-down")
    ]
    assert len(changes) == 2
    crossed = 0
    for first, last in phase_rows(samples):
        for time in changes:
            assert not at[first] + 1e-12 < time < at[last] - 1e-12
            crossed += at[last] <= time + 1e-12
    assert crossed > 0
    before = next(last for first, last in phase_rows(samples) if samples.phases[first] == "slip")
    assert at[before] == pytest.approx(changes[0], abs=1e-14)
    assert abs(force[before]) < 1e-6 * force[0]


def test_what_is_not_sampled_has_no_place_over_p() -> None:
    """The run is known to the lift-off; its touch-down is not where the samples end."""
    assert exact().samples is not None
    kept = [k for k, phase in enumerate(exact().samples.phases) if phase == "slip"]
    columns = {name: column[kept] for name, column in exact().samples.columns.items()}
    run = replace(exact(), samples=Samples(columns, tuple("slip" for _ in kept)))
    assert [place.name for place in places(run, "p")] == ["lift-off"]
    assert [(place.name, place.between is None) for place in places(run, "t")] == [
        ("lift-off", False),
        ("touch-down", True),
    ]
    assert [place.between for place in places(replace(exact(), samples=None), "t")] == [None, None]
    assert places(replace(exact(), samples=None), "p") == []


def test_a_sample_is_at_an_event_where_their_times_meet() -> None:
    event = exact().events[0]
    time = approximate(event.lower)
    for shift, found in ((0.0, (1, 0)), (2e-16, (1, 0)), (1e-9, None), (-1e-9, None)):
        samples = Samples({"t": np.array([0.0, time + shift])}, ("slip", "slip"))
        assert sampled_at(event, samples) == found
    wide = Samples({"t": np.array([0.0, time + 1e-9]), f"t{RADIUS}": np.array([0.0, 2e-9])}, ("slip", "slip"))
    assert sampled_at(event, wide) == (1, 0)


def test_an_event_inside_a_box_lies_on_the_line_that_the_box_holds() -> None:
    """From when on contact lasts for ever is no change of phase: the integrator takes no sample there."""
    scene = load_scene("fig-varsim1", beta="5/2", nu=4, epsilon="1/100", until=1)
    known = certified_run(scene, points=3)
    boxed = with_boxes(scene, known)
    (event,) = known.events
    time = approximate(event.lower)
    assert boxed.samples is not None
    for run in (known, boxed):
        (place,) = places(run, "p")
        assert (place.name, place.at) == ("contact for ever from", pytest.approx(0.5 - time, abs=1e-12))
    (place,) = places(boxed, "t")
    assert place.between is not None
    row, share = place.between
    assert 0 < share < 1
    assert boxed.samples.columns["t"][row] < time < boxed.samples.columns["t"][row + 1]
    value = place.value(boxed.samples.columns["lambda_N"])
    assert boxed.samples.boxes is not None
    assert value is not None
    (stretch,) = boxes_over(boxed.samples.boxes, "t", "lambda_N", 1.0, 0.0, 0.0)
    assert holds(stretch, time, value, 0.0)
    cut = replace(
        boxed.samples, phases=tuple("slip" if k <= row else "flight" for k in range(len(boxed.samples.phases)))
    )
    assert sampled_at(event, cut) is None
    assert sampled_at(event, replace(boxed.samples, boxes=None)) is None


@pytest.mark.parametrize("over", ["t", "p"])
@pytest.mark.parametrize("name", ["lambda_N", "y", "b"])
def test_the_boxes_hold_samples_and_floats(over: str, name: str) -> None:
    """Every sample with its radius; the float run, which knows nothing of them, within its error. Also when boxes are
    put together, and scaled."""
    certified, seen = boxed().samples, floats().samples
    assert certified is not None
    assert certified.boxes is not None
    assert seen is not None
    scale = 1e-4 if name == "y" else 1.0
    size = float(np.abs(certified.columns[name]).max()) / scale
    counts = []
    for tall, wide in ((0.0, 0.0), (0.01 * size, 0.02)):
        stretches = boxes_over(certified.boxes, over, name, scale, tall, wide)
        assert len(stretches) == 1
        counts.append(len(stretches[0]))
        columns = certified.columns
        for k, at in enumerate(columns[over].tolist()):
            middle, radius = columns[name][k] / scale, columns[name + RADIUS][k] / scale
            assert holds(stretches[0], at, middle - radius, 1e-15 * size)
            assert holds(stretches[0], at, middle + radius, 1e-15 * size)
        until = certified.boxes.upper["t"][-1]
        for k, time in enumerate(seen.columns["t"].tolist()):
            if time < until:
                at, value = seen.columns[over][k], seen.columns[name][k] / scale
                assert holds(stretches[0], at, value, 1e-4 * size)
    assert counts[1] < counts[0]


def holds(stretch: list[tuple[float, float, float, float]], at: float, value: float, room: float) -> bool:
    """Whether a box has the point in it, within ``room``, and within rounding errors along the axis."""
    for begin, end, low, high in stretch:
        if min(begin, end) - 1e-15 <= at <= max(begin, end) + 1e-15 and low - room <= value <= high + room:
            return True
    return False


BOUNDS = st.tuples(st.floats(-1e3, 1e3), st.floats(0, 10)).map(lambda pair: (pair[0], pair[0] + pair[1]))


@given(st.lists(BOUNDS, min_size=1, max_size=12), st.booleans(), st.floats(0, 100), st.floats(0, 5))
def test_boxes_that_are_put_together_hold_each_of_them(
    bounds: list[tuple[float, float]], falling: bool, tall: float, wide: float
) -> None:
    count = len(bounds)
    first, last = np.arange(count, dtype=float), np.arange(1, count + 1, dtype=float)
    ends = (-last, -first) if falling else (first, last)
    low, high = (np.array(side) for side in zip(*bounds, strict=True))
    over = "p" if falling else "t"
    boxes = Boxes({over: ends[0], "b": low}, {over: ends[1], "b": high}, ("slip",) * count)
    (stretch,) = boxes_over(boxes, over, "b", 1.0, tall, wide)
    sign = -1 if falling else 1
    assert [sign * stretch[0][0], sign * stretch[-1][1]] == [0, count]
    assert all(one[1] == other[0] for one, other in pairwise(stretch))
    for k, (least, most) in enumerate(bounds):
        (box,) = [each for each in stretch if sign * each[0] <= k and k + 1 <= sign * each[1]]
        assert box[2] <= least
        assert most <= box[3]
    for begin, end, least, most in stretch:
        assert abs(end - begin) <= max(wide, 1)
        assert most - least <= max(tall, max(high - low))
    assert len(outline(stretch)) == 4 * len(stretch)


def test_where_a_bound_is_infinite_there_is_a_gap() -> None:
    ends = np.array([0.0, 1.0, 2.0]), np.array([1.0, 2.0, 3.0])
    boxes = Boxes(
        {"t": ends[0], "b": np.array([0, -math.inf, 0])}, {"t": ends[1], "b": np.array([1, 1, 1])}, ("slip",) * 3
    )
    assert boxes_over(boxes, "t", "b", 1.0, 9, 9) == [[(0, 1, 0, 1)], [(2, 3, 0, 1)]]


def test_p_stands_for_time_only_where_it_falls() -> None:
    def made(*values: float) -> Samples:
        return Samples({"p": np.array(values)}, ("slip",) * len(values))

    assert falls(made(1, 0.5, 0.5, -1))
    assert falls(made(1, 0.5, 0.5 + 1e-12, -1))
    assert not falls(made(1, 0.5, 0.6))


def test_rows_of_a_phase_that_comes_twice() -> None:
    assert phase_rows(Samples({}, ("slip", "flight", "flight", "slip"))) == [(0, 0), (1, 2), (3, 3)]
    assert phase_rows(Samples({}, ())) == []
