"""Constraints that depend on time: surfaces and joints that are moved, against closed forms and a moving frame."""

from __future__ import annotations

import math

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.given import from_energies, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.motions.mechanism_motion import MechanismMotion
from gspot_verified.scenes.scene.scene import Scene

EFFECTS = ("compliant_contact", "lift_off", "tangential_motion", "stick")


def block(x: str = "X", y: str = "H") -> Mechanism:
    """Mass and weight 1, mu = 1/2."""
    return lagrangian("block", ["X", "H"], [[1, 0], [0, 1]], [0, -1], x, y, "1/2", time="t")


def scene(mechanism: Mechanism, velocity: str, until: str, epsilon: fmpq, force: str = "1") -> Scene:
    """From the springs in equilibrium under ``force``."""
    size = fmpq(*map(int, force.split("/"))) * epsilon**2
    start: dict[str, fmpq | str] = {"X_dot": velocity, "y": -2 * size, "v": fmpq(0), "z": -size}
    return Scene("moved", EFFECTS, epsilon, fmpq(*map(int, until.split("/"))), {}, start, mechanism=mechanism)


def first_events(made: Scene) -> list[tuple[str, float]]:
    """Of a certified run, after a run with floats that must say the same."""
    certified, floats = integrated_run(made), float_run(made)
    assert certified.verdict.outcome.value == "proved"
    found = [(event.name, approximate(arb(event.lower))) for event in certified.events]
    assert [name for name, _ in found] == [event.name for event in floats.events]
    for (_, time), event in zip(found, floats.events, strict=True):
        assert time == pytest.approx(approximate(arb(event.lower)), rel=1e-6)
    return found


def test_slip_ends_when_the_block_is_as_fast_as_the_surface() -> None:
    """The surface moves by sin t: u = 2 - t/2 - cos t. There its acceleration is too large for friction."""
    (event, time), *_ = first_events(scene(block(x="X - sin(t)"), "2", "5", fmpq(1, 10)))
    assert event == "slip backwards"
    assert time == pytest.approx(float(mpmath.findroot(lambda t: 2 - t / 2 - mpmath.cos(t), 4.5)), rel=1e-9)


def test_stick_ends_where_the_surface_accelerates_too_fast() -> None:
    """Its acceleration is sin t, and friction gives 1/2."""
    (event, time), *_ = first_events(scene(block(x="X - t + sin(t)"), "0", "1", fmpq(1, 10)))
    assert event == "slip backwards"
    assert time == pytest.approx(math.pi / 6, rel=1e-9)


def test_a_shaken_table_loses_the_block() -> None:
    """Its acceleration is 2 cos 2 t: b = -1 - 2 cos 2 t is 0 at pi/3, but for terms of the order of epsilon."""
    made = scene(block(y="H - (1 - cos(2*t))/2"), "1", "11/10", fmpq(1, 100), force="3")
    (event, time), *_ = first_events(made)
    assert event == "lift-off"
    assert time == pytest.approx(math.pi / 3, abs=1e-3)


def test_a_joint_that_is_moved_is_a_constraint_or_a_coordinate_less() -> None:
    """The upper end of a rod is driven along X by sin(3 t)/10: with a multiplier, and with X put in."""
    angle, contact = {"theta": ("3/5", "4/5")}, ("1/4",)
    joint = lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, -1, 0], "X + cos(theta)",
        "Y - sin(theta)", *contact, angles=angle, time="t", constraints=["X - cos(theta) - sin(3*t)/10"],
    )  # fmt: skip
    frame = from_energies(
        "rod", ["Y", "theta"], "((3*cos(3*t)/10 - sin(theta)*theta_dot)^2 + Y_dot^2)/2 + theta_dot^2/6", "Y",
        "2*cos(theta) + sin(3*t)/10", "Y - sin(theta)", *contact, angles=angle, time="t",
    )  # fmt: skip
    Y, theta, Y_dot, theta_dot, t = (fmpq(n, 16) for n in (9, -2, 5, -7, 6))
    with working_bits(120):
        turn = arb(theta) + arb.atan2(arb(3), arb(4))
        place = turn.cos() + (3 * arb(t)).sin() / 10
        rate = -turn.sin() * theta_dot + 3 * (3 * arb(t)).cos() / 10
        states = {joint: [place, Y, theta, rate, Y_dot, theta_dot, t], frame: [Y, theta, Y_dot, theta_dot, t]}
        found = []
        for mechanism, state in states.items():
            shifted = shift(mechanism)
            names = ("u", "v", "a", "b", "A", "B", "C", "p", "alpha_1", "alpha_2", "alpha_3")
            functions = shifted.expressions([getattr(shifted.functions, name) for name in names], BALLS)
            found.append(BoxProgram(functions, len(state)).values([arb(value) for value in state]))
        for one, other in zip(*found, strict=True):
            assert one.rad() < 1e-20
            assert other.rad() < 1e-20
            assert one.overlaps(other)


def test_what_a_moved_joint_leaves_open_is_solved_at_the_time_0() -> None:
    """Without a time at the start the clock is 0: X = cos theta + cos(0)/10, and X' = -sin theta theta'."""
    joint = lagrangian(
        "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, -1, 0], "X + cos(theta)",
        "Y - sin(theta)", "1/4", angles={"theta": ("3/5", "4/5")}, time="t",
        constraints=["X - cos(theta) - cos(3*t)/10"], search=True,
        place={"X": "9/10", "Y": "3/5", "theta": "theta_ref", "X_dot": 0, "Y_dot": 0, "theta_dot": 0, "t": 0},
    )  # fmt: skip
    start = {"theta": "theta_ref", "theta_dot": fmpq(-1, 2)}
    made = Scene("moved", EFFECTS, fmpq(1, 10), fmpq(1), {}, start, mechanism=joint)
    motion = made.motion
    assert isinstance(motion, MechanismMotion)
    found = dict(zip(joint.state, motion.whole_state(made.values()), strict=True))
    assert abs(found["X"] - arb("0.9")) < 1e-12
    assert abs(found["X_dot"] - arb("0.3")) < 1e-12
