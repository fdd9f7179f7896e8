"""What simulators say, beside what is certified: judged by motions that are known."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from gspot_verified.mechanisms.approach.approach_result import IMPACT, LIFT_OFF
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators import comparison
from gspot_verified.scenes.simulators.comparison import simulators
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.simulated import (
    LEAVES,
    STOPS,
)

ROD = load("rod with a wrist")
FUNCTIONS = contact_floats(ROD)
START = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}


def test_rigid_slip_of_the_steps_is_that_of_the_certified_path() -> None:
    """Up to the G-spot all three follow one path: the slip velocity after 9/10 of the way agrees."""
    found = simulators(ROD, START, epsilons=[], steps=[])
    path = found.certified.path
    judge = comparison._Judge(ROD, FUNCTIONS, found.certified, None)
    index = max(i for i, time in enumerate(path.time) if float(time.mid()) < 0.9 * judge.time)
    for _, _, motion in judge.simulations(["1e-4"], [1e-3]):
        run = motion()
        near = min(range(len(run.times)), key=lambda i: abs(run.times[i] - float(path.time[index].mid())))
        assert FUNCTIONS.contact(run.states[near]).u == pytest.approx(float(path.u[index].mid()), rel=2e-2)


@pytest.mark.parametrize(("rate", "side", "first"), [("33/10", LIFT_OFF, LEAVES), ("17/5", IMPACT, STOPS)])
def test_the_compliant_run_takes_the_certified_side(rate: str, side: str, first: str) -> None:
    found = simulators(ROD, START | {"theta_dot": rate}, epsilons=["1e-4"], steps=[])
    (run,) = found.runs
    assert (found.certified.side, run.happened, run.agrees) == (side, first, comparison.RIGHT)
    assert run.time is not None
    assert run.time > float(found.certified.time.mid())  # type: ignore[union-attr]


def written(path: Path, rows: list[tuple[float, ...]], head: str = "t,X,Y,theta,X_dot,Y_dot,theta_dot") -> Path:
    path.write_text("\n".join([head, *(",".join(map(str, row)) for row in rows)]) + "\n")
    return path


def leaving_early(begin: float = 0.0, spin: float = 3.3) -> list[tuple[float, ...]]:
    """A table from the start with 6 ms of contact, or from another time or angular velocity."""
    start = (0.0, math.sin(0.8), 0.8, 5.0, 3.3 * math.cos(0.8), spin)
    up = (start[0], start[1] + 1e-3, *start[2:])
    return [(begin + k / 1000, *(start if k < 6 else up)) for k in range(60)]


@pytest.mark.parametrize(
    ("begin", "spin", "message"),
    [
        (0.0, 3.4, r"mine\.csv: the table begins with theta_dot = 3\.4, and the certified state has 3\.3"),
        (5.0, 3.3, r"mine\.csv: the table begins at t = 5, and the certified state is that at t = 0"),
    ],
)
def test_a_table_of_another_start_is_refused(tmp_path: Path, begin: float, spin: float, message: str) -> None:
    table = written(tmp_path / "mine.csv", leaving_early(begin, spin))
    with pytest.raises(SceneError, match=message):
        simulators(ROD, START, files=[table], epsilons=[], steps=[])


def test_a_table_that_leaves_early_is_told(tmp_path: Path) -> None:
    found = simulators(ROD, START, files=[written(tmp_path / "mine.csv", leaving_early())], epsilons=[], steps=[])
    (run,) = found.runs
    assert (run.simulator, run.happened, run.agrees) == (str(tmp_path / "mine.csv"), LEAVES, comparison.EARLY)
    assert run.time == 0.006
    assert "too early" in str(found)


def test_what_cannot_be_compared_is_said() -> None:
    for step in (0, -1e-3, 2, "1/10000000", float("nan"), float("inf")):
        with pytest.raises(ValueError, match=r"step of a simulator.*1e-6\.\.1"):
            simulators(ROD, START, epsilons=[], steps=[step])
    for epsilon in (0, -1, 2, "1/10000000"):
        with pytest.raises(ValueError, match="expected a number in"):
            simulators(ROD, START, epsilons=[epsilon], steps=[])
    with pytest.raises(MechanismError, match="simulators need coordinates and velocities"):
        simulators(load("model"), {"x": 0, "u": 3, "p": "1/2", "b": -2})
    with pytest.raises(SceneError, match="a simulator needs the surface's velocity"):
        simulators(load("oscillator"), {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})


def test_angles_are_counted_as_the_user_does() -> None:
    """The shipped rod counts theta from a reference: the sine of its angle is 3/5."""
    functions = contact_floats(load("rod"))
    assert functions.contact([0, 0.6, math.asin(0.6), 2, 0.8, 1]).y == pytest.approx(0)
    assert functions.contact([0, 0.6, math.asin(0.6), 2, 0.8, 1]).p == pytest.approx(0)
