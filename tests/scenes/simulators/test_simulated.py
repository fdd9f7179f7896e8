"""A motion as a table, and what happens in it first."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.simulated import (
    IMPULSE,
    LEAVES,
    NOTHING,
    STOPS,
    Happened,
    Simulated,
    read_motion,
    what_happens,
)

FUNCTIONS = contact_floats(load("rod with a wrist"))


def states(slips: list[float], heights: list[float]) -> list[tuple[float, ...]]:
    """The rod at one angle, at rest but for the slip velocity."""
    return [(0.0, math.sin(0.8) + height, 0.8, slip, 0.0, 0.0) for slip, height in zip(slips, heights, strict=True)]


TIMES = [k / 100 for k in range(101)]


@pytest.mark.parametrize(
    ("slips", "heights", "forces", "expected"),
    [
        ([2.0] * 101, [-1e-6] * 101, None, Happened(NOTHING, None, None, 1.0)),
        ([2.0] * 101, [-1e-6] * 40 + [1e-6] * 61, None, Happened(LEAVES, 0.40, 2.0, 0.39)),
        ([2.0] * 101, [-1e-6] * 40 + [1e-6] + [-1e-6] * 60, None, Happened(NOTHING, None, None, 1.0)),
        ([2.0] * 40 + [0.5] * 61, [-1e-6] * 41 + [1e-6] * 60, None, Happened(IMPULSE, 0.41, 0.5, 0.40)),
        ([2.0] * 40 + [-2.0] * 61, [-1e-6] * 101, None, Happened(STOPS, 0.40, -2.0, 0.39)),  # turned
        ([2.0] * 40 + [0.01] * 61, [-1e-6] * 60 + [1e-6] * 41, None, Happened(STOPS, 0.40, 0.01, 0.39)),
        ([2.0] * 101, [1e-6] * 101, [1.0] * 101, Happened(NOTHING, None, None, 1.0)),
        ([2.0] * 101, [-1e-6] * 100 + [1e-6], None, Happened(NOTHING, None, None, 0.99)),  # its end may cut a flight
        ([2.0] * 101, [-1e-6] * 101, [1.0] * 70 + [0.0] * 31, Happened(LEAVES, 0.70, 2.0, 0.69)),
    ],
)
def test_what_comes_first(
    slips: list[float], heights: list[float], forces: list[float] | None, expected: Happened
) -> None:
    found = what_happens(Simulated(TIMES, states(slips, heights), forces), FUNCTIONS, lasting=0.01)
    assert (found.what, found.time) == (expected.what, expected.time)
    assert found.since == expected.since
    assert found.slip == pytest.approx(expected.slip)


def test_slip_is_that_against_the_surface() -> None:
    motion = Simulated(TIMES, states([2.0] * 50 + [1.0] * 51, [-1e-6] * 101))
    assert what_happens(motion, FUNCTIONS, lasting=0.01).what == NOTHING
    assert what_happens(motion, FUNCTIONS, 1.0, lasting=0.01).what == STOPS


def written(path: Path, rows: list[tuple[float, ...]], head: str = "t,X,Y,theta,X_dot,Y_dot,theta_dot") -> Path:
    path.write_text("\n".join([head, *(",".join(map(str, row)) for row in rows)]) + "\n")
    return path


@pytest.mark.parametrize(
    ("head", "row", "message"),
    [
        ("t,X,Y,theta,X_dot,Y_dot", (0, 0, 0, 0, 0, 0), "no column theta_dot; needed: t, X, Y"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, "nan", 0, 0, 0, 0), "line 2: Y is no finite number: 'nan'"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, "one", 0, 0, 0, 0), "line 2: Y is no finite number: 'one'"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, 0, 0, 0, 0, 0), "the times of column t must grow"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, 0), "theta is no finite number"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot,Y,Y", (0,) * 9, "column Y is there twice"),
    ],
)
def test_a_table_that_is_none_is_refused(tmp_path: Path, head: str, row: tuple[float, ...], message: str) -> None:
    with pytest.raises(SceneError, match=message):
        read_motion(written(tmp_path / "bad.csv", [row, row], head), FUNCTIONS)


def test_a_file_that_is_not_there_or_short(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"none\.csv: cannot be read: No such file"):
        read_motion(tmp_path / "none.csv", FUNCTIONS)
    with pytest.raises(SceneError, match="expected 2 to"):
        read_motion(written(tmp_path / "short.csv", []), FUNCTIONS)


def test_a_table_reads_back(tmp_path: Path) -> None:
    head, rows = (
        "t,X,Y,theta,X_dot,Y_dot,theta_dot",
        [(0, 1, 2, 3, 4, 5, 6), (0.5, 7, 8, 9, 10, 11, "1e-1"), (2, 1, 2, 3, 4, 5, 6)],
    )
    found = read_motion(written(tmp_path / "good.csv", rows, head), FUNCTIONS)  # type: ignore[arg-type]
    assert (found.times, found.forces) == ([0, 0.5, 2], None)
    assert found.states == [(1, 2, 3, 4, 5, 6), (7, 8, 9, 10, 11, 0.1), (1, 2, 3, 4, 5, 6)]
    with_force = [(*row, k) for k, row in enumerate(rows)]
    assert read_motion(written(tmp_path / "force.csv", with_force, f"{head},force"), FUNCTIONS).forces == [0, 1, 2]  # type: ignore[arg-type]


def test_what_lasts_so_long() -> None:
    """Without contact for two steps: lost, from where it began; the start itself does not count."""
    times = [k / 128 for k in range(129)]
    for count, lost in ((2, None), (3, 50 / 128)):
        forces = [1.0] * 50 + [0.0] * count + [1.0] * (79 - count)
        motion = Simulated(times, states([2.0] * 129, [-1e-6] * 129), forces)
        assert what_happens(motion, FUNCTIONS, lasting=2 / 128).time == lost
    motion = Simulated(times, states([2.0] * 129, [-1e-6] * 129), [0.0] * 2 + [1.0] * 127)
    assert what_happens(motion, FUNCTIONS, lasting=1 / 128).what == NOTHING


def test_how_long_a_table_is_does_not_matter() -> None:
    """A flight of .1 is one in a table of 1 and of 100."""
    for end in (1.0, 100.0):
        times = [k / 100 for k in range(101)] + [end + 1]
        forces = [1.0] * 50 + [0.0] * 12 + [1.0] * 40
        motion = Simulated(times, states([2.0] * 102, [-1e-6] * 102), forces)
        assert what_happens(motion, FUNCTIONS, lasting=0.1) == Happened(LEAVES, 0.5, pytest.approx(2.0), 0.49)
