"""What simulators say, beside what is certified: judged by motions that are known."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.approach.approach_result import IMPACT, LIFT_OFF
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators import comparison
from gspot_verified.scenes.simulators.comparison import simulators
from gspot_verified.scenes.simulators.contact_floats import Contact, contact_floats
from gspot_verified.scenes.simulators.moreau_jean import moreau_jean, solutions
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

ROD = load("rod with a wrist")
FUNCTIONS = contact_floats(ROD)
START = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}


def states(slips: list[float], heights: list[float]) -> list[tuple[float, ...]]:
    """The rod at one angle, at rest but for the slip velocity."""
    return [(0.0, math.sin(0.8) + height, 0.8, slip, 0.0, 0.0) for slip, height in zip(slips, heights, strict=True)]


TIMES = [k / 100 for k in range(101)]


@pytest.mark.parametrize(
    ("slips", "heights", "forces", "expected"),
    [
        ([2.0] * 101, [-1e-6] * 101, None, Happened(NOTHING, None, None)),
        ([2.0] * 101, [-1e-6] * 40 + [1e-6] * 61, None, Happened(LEAVES, 0.40, 2.0)),
        ([2.0] * 101, [-1e-6] * 40 + [1e-6] + [-1e-6] * 60, None, Happened(NOTHING, None, None)),
        ([2.0] * 40 + [0.5] * 61, [-1e-6] * 41 + [1e-6] * 60, None, Happened(IMPULSE, 0.41, 0.5)),
        ([2.0] * 40 + [0.01] * 61, [-1e-6] * 60 + [1e-6] * 41, None, Happened(STOPS, 0.40, 0.01)),
        ([2.0] * 101, [1e-6] * 101, [1.0] * 101, Happened(NOTHING, None, None)),
        ([2.0] * 101, [-1e-6] * 101, [1.0] * 70 + [0.0] * 31, Happened(LEAVES, 0.70, 2.0)),
    ],
)
def test_what_comes_first(
    slips: list[float], heights: list[float], forces: list[float] | None, expected: Happened
) -> None:
    found = what_happens(Simulated(TIMES, states(slips, heights), forces), FUNCTIONS)
    assert (found.what, found.time) == (expected.what, expected.time)
    assert found.slip == pytest.approx(expected.slip)


def test_slip_is_that_against_the_surface() -> None:
    motion = Simulated(TIMES, states([2.0] * 50 + [1.0] * 51, [-1e-6] * 101))
    assert what_happens(motion, FUNCTIONS).what == NOTHING
    assert what_happens(motion, FUNCTIONS, surface_velocity=1.0).what == STOPS


NUMBERS = st.floats(-3, 3, allow_nan=False)


@given(NUMBERS, NUMBERS, st.floats(0.1, 3), st.floats(0.1, 3), st.floats(-0.9, 0.9), st.floats(0, 2))
def test_every_solution_obeys_the_laws_of_contact(
    u: float, v: float, A: float, C: float, share: float, mu: float
) -> None:
    """Signorini: impulse >= 0, velocity >= 0, one of them 0; Coulomb: the cone, and against the slip."""
    B = share * math.sqrt(A * C)
    for normal, tangential in solutions(Contact(y=0, u=u, v=v, A=A, B=B, C=C, p=0, b=0, mu=mu)):
        after_n, after_t = v + C * normal + B * tangential, u + B * normal + A * tangential
        tolerance = 1e-9 * (1 + normal + abs(tangential))
        assert normal >= 0
        assert after_n >= -tolerance
        assert normal == 0 or abs(after_n) <= tolerance
        assert abs(tangential) <= mu * normal + tolerance
        if normal > 0 and abs(after_t) > tolerance:
            assert tangential == pytest.approx(-math.copysign(mu * normal, after_t))


def test_the_paradox_in_one_step() -> None:
    """p < 0: where v < 0 only an impulse that stops the slip serves; where v > 0 there are three solutions."""
    rod = Contact(y=0, u=1.0, v=-0.01, A=4.0, B=1.5, C=1.0, p=0, b=0, mu=1.0)
    ((normal, tangential),) = solutions(rod)
    assert abs(tangential) < normal
    assert len(solutions(replace(rod, v=0.01))) == 3


def test_a_rod_in_flight_falls_as_it_must() -> None:
    """Far above the surface no impulse is given, and the height is the parabola of gravity and of the push."""
    flight = moreau_jean(FUNCTIONS, [0.0, 9.0, 0.9, 1.0, 0.0, 0.0], step=1e-3, until=0.5)
    assert flight.forces is not None
    assert not any(flight.forces[1:])
    time, state = flight.times[-1], flight.states[-1]
    assert state[1] == pytest.approx(9 - (9.81 + 5) * time**2 / 2, abs=1e-3)
    assert state[0] == pytest.approx(time)


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


@pytest.mark.parametrize(
    ("head", "row", "message"),
    [
        ("t,X,Y,theta,X_dot,Y_dot", (0, 0, 0, 0, 0, 0), "no column theta_dot; needed: t, X, Y"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, "nan", 0, 0, 0, 0), "line 2: Y is no finite number: 'nan'"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, "one", 0, 0, 0, 0), "line 2: Y is no finite number: 'one'"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, 0, 0, 0, 0, 0), "the times of column t must grow"),
        ("t,X,Y,theta,X_dot,Y_dot,theta_dot", (0, 0, 0), "theta is no finite number"),
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


def test_what_cannot_be_compared_is_said() -> None:
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
