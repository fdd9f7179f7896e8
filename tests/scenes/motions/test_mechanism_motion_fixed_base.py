"""Contacts without a free translation: arms, constraints, a biped; against a penalty simulation and other charts."""

from __future__ import annotations

import math

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.simulate import simulate

EFFECTS = ("compliant_contact", "lift_off", "tangential_motion")
EPSILON, HEIGHT, MU = fmpq(1, 50), 1.5, 0.5

ARM = lagrangian(
    "two-link arm", ["a", "c"], [["4/3", "cos(a - c)/2"], ["cos(a - c)/2", "1/3"]],
    ["-sin(a - c)*c_dot^2/2 - 3*sin(a)/2", "sin(a - c)*a_dot^2/2 - sin(c)/2"],
    "sin(a) + sin(c)", "3/2 - cos(a) - cos(c)", "1/2", place={"a": "4/5", "c": "-3/5", "a_dot": 1, "c_dot": 1},
)  # fmt: skip
"""Two slender links of length 1 and mass 1 hang from a hinge at the height 3/2; absolute angles from the vertical."""
BODIES = ("X_1", "Y_1", "a", "X_2", "Y_2", "c")
IN_BODIES = lagrangian(
    "two bodies", BODIES, [[0] * i + [1 if word[0] in "XY" else "1/12"] + [0] * (5 - i) for i, word in
                           enumerate(BODIES)],
    [0, -1, 0, 0, -1, 0], "X_2 + sin(c)/2", "3/2 + Y_2 - cos(c)/2", "1/2",
    constraints=["X_1 - sin(a)/2", "Y_1 + cos(a)/2", "X_2 - sin(a) - sin(c)/2", "Y_2 + cos(a) + cos(c)/2"],
    place={"X_1": "1/3", "Y_1": "-1/3", "X_2": "1/3", "Y_2": -1, "a": "4/5", "c": "-3/5"} | dict.fromkeys(
        (f"{word}_dot" for word in BODIES), 1),
)  # fmt: skip
"""The same arm as two free bodies with hinges as constraints."""
BIPED = lagrangian(
    "compass biped", ["q", "s"], [["13/4", "-cos(q - s)/2"], ["-cos(q - s)/2", "1/4"]],
    ["sin(q - s)*s_dot^2/2 + 7*sin(q)/2", "-sin(q - s)*q_dot^2/2 - sin(s)/2"],
    "sin(q) - sin(s)", "cos(q) - cos(s)", "3/4", place={"q": "2/5", "s": "-2/5", "q_dot": 1, "s_dot": -1},
)  # fmt: skip
"""Two legs of length 1 with a mass 1 half-way down, a hip of mass 2; the stance foot is a hinge, the other slips."""


def scene(mechanism: Mechanism, start: dict[str, str], epsilon: fmpq = EPSILON, until: str = "1/5") -> Scene:
    numerator, denominator = until.split("/")
    return Scene("test", EFFECTS, epsilon, fmpq(int(numerator), int(denominator)), {}, dict(start), None, mechanism)


def penalty(start: list[float], epsilon: float, until: float):  # type: ignore[no-untyped-def]
    """The arm in slip with its own springs and damper, in unscaled variables: nothing of the package is in it."""
    from scipy.integrate import solve_ivp

    def rates(_: float, state: np.ndarray) -> list[float]:  # type: ignore[type-arg]
        a, c, a_rate, c_rate, z = state
        mass = np.array([[4 / 3, math.cos(a - c) / 2], [math.cos(a - c) / 2, 1 / 3]])
        swing = math.sin(a - c) / 2
        forces = np.array([-swing * c_rate**2 - 1.5 * math.sin(a), swing * a_rate**2 - 0.5 * math.sin(c)])
        push = (z - (HEIGHT - math.cos(a) - math.cos(c))) / epsilon**2
        along_y, along_x = np.array([math.sin(a), math.sin(c)]), np.array([math.cos(a), math.cos(c)])
        turning = np.linalg.solve(mass, forces + push * along_y - MU * push * along_x)
        return [a_rate, c_rate, *turning, epsilon * (-z / epsilon**2 - push)]

    return solve_ivp(rates, (0, until), [*start, 0.0], "Radau", rtol=1e-9, atol=1e-13, dense_output=True).sol


def test_an_arm_moves_as_its_penalty_simulation() -> None:
    made = scene(ARM, {"a": "4/5", "a_dot": "1"}, until="3/20")
    solved = made.enclosed_initial()
    assert list(solved) == ["c", "c_dot"]
    c, c_rate = (approximate(value) for value in solved.values())
    assert math.cos(0.8) + math.cos(c) == pytest.approx(HEIGHT, abs=1e-15)
    assert math.sin(0.8) + math.sin(c) * c_rate == pytest.approx(0, abs=1e-15)
    samples = float_run(made, "Radau", 1e-9, 4).samples
    assert samples is not None
    columns = samples.columns
    other = penalty([0.8, c, 1.0, c_rate], 1 / 50, 0.15)
    for i, time in enumerate(columns["t"]):
        a, c, a_rate, c_rate, z = other(time)
        y = HEIGHT - math.cos(a) - math.cos(c)
        expected = {"a": a, "c": c, "a_dot": a_rate, "c_dot": c_rate, "lambda_N": (z - y) * 2500}
        for name, value in expected.items():
            assert columns[name][i] == pytest.approx(value, abs=1e-7), name
        own = HEIGHT - math.cos(columns["a"][i]) - math.cos(columns["c"][i])
        assert columns["y"][i] == pytest.approx(own, abs=1e-13)  # y(xi) = epsilon^2 Y is kept
    assert columns["lambda_N"].max() > 0.5


def test_the_same_arm_with_constraints() -> None:
    """Lift-off of the arm by its angles and by two bodies with hinges: other equations, the same event."""
    start = {"a": "4/5", "a_dot": "1"}
    bodies = scene(IN_BODIES, start)
    (one,), (other,) = (float_run(made, "LSODA", 1e-9).events for made in (scene(ARM, start), bodies))
    assert one.name == other.name == "lift-off"
    assert approximate(one.lower) == pytest.approx(approximate(other.lower), abs=1e-8)
    assert set(bodies.enclosed_initial()) <= {*BODIES, *(f"{word}_dot" for word in BODIES)} - set(start)


def test_the_lift_off_of_an_arm_is_proved() -> None:
    run = simulate(scene(ARM, {"a": "4/5", "a_dot": "1"}), digits=15)
    assert run.verdict.outcome.value == "proved"
    (event,) = run.events
    (simulated,) = float_run(scene(ARM, {"a": "4/5", "a_dot": "1"}), "LSODA", 1e-10).events
    assert event.upper - event.lower < fmpq(1, 10**15)
    assert approximate(event.lower) == pytest.approx(approximate(simulated.lower), abs=1e-8)


@pytest.mark.slow
def test_with_constraints_the_same_lift_off_is_proved() -> None:
    start = {"a": "4/5", "a_dot": "1"}
    (one,), (other,) = (simulate(scene(made, start)).events for made in (ARM, IN_BODIES))
    assert one.lower <= other.upper
    assert other.lower <= one.upper


def bent_rod() -> Mechanism:
    """The falling rod with w + w^3 in the place of its height: no component in which y is linear is left."""
    rod = {"place": {"X": 0, "w": "1/2", "theta": "theta_ref", "X_dot": 2, "w_dot": "1/2", "theta_dot": 1}}
    return lagrangian(
        "bent rod", ["X", "w", "theta"], [[1, 0, 0], [0, "(1 + 3*w^2)^2", 0], [0, 0, "1/3"]],
        [0, "-3/5*(1 + 3*w^2) - 6*w*(1 + 3*w^2)*w_dot^2", 0], "X + cos(theta)", "w + w^3 - sin(theta)", "73/36",
        angles={"theta": ("3/5", "4/5")}, **rod,  # type: ignore[arg-type]
    )  # fmt: skip


def test_both_charts_give_the_same_motion_and_the_same_slow_manifold() -> None:
    start = {"theta": "theta_ref - 1/10", "theta_dot": "1/2", "X_dot": "2"}
    straight = scene(shipped_mechanism("rod"), start | {"X": "0"}, fmpq(1, 1000), "1/10")
    bent = scene(bent_rod(), start | {"X": "0"}, fmpq(1, 1000), "1/10")
    assert straight.system("slip").states == ("theta", "X_dot", "theta_dot", "Y", "V", "Z")
    assert {*bent.system("slip").states} >= {"theta", "X_dot", "theta_dot", "Y", "V", "Z"}
    assert list(bent.enclosed_initial()) == [name for name in ("w", "w_dot") if name in bent.system("slip").states]
    one, other = (float_run(each, "LSODA", 1e-10, 3).samples for each in (straight, bent))
    assert one is not None
    assert other is not None
    for name in ("p", "b", "lambda_N", "theta - theta_ref", "X_dot"):
        assert other.columns[name] == pytest.approx(one.columns[name], abs=1e-7), name
    first, second = (each.with_settings(start="slip").slow_start for each in (straight, bent))
    assert first is not None
    assert second is not None
    for name in "YVZ":
        assert approximate(getattr(second, name)) == pytest.approx(approximate(getattr(first, name)), rel=1e-12)


def test_a_start_on_the_slow_manifold_moves_the_components_that_follow() -> None:
    """y is not 0 there, and c is where y(a, c) is what the point says."""
    made = scene(ARM, {"a": "4/5", "a_dot": "1"}, fmpq(1, 5000)).with_settings(start="slip")
    y = made.initial()["y"]
    assert y < 0
    c = made.enclosed_initial()["c"]
    assert (arb(fmpq(3, 2)) - arb(fmpq(4, 5)).cos() - c.cos() - y).contains(0)
    assert not (arb(fmpq(3, 2)) - arb(fmpq(4, 5)).cos() - c.cos()).contains(0)


def test_a_compass_biped_is_simulated() -> None:
    made = scene(BIPED, {"q": "2/5", "q_dot": "1"}, fmpq(1, 200), "1/20")
    assert approximate(made.enclosed_initial()["s"]) == pytest.approx(-0.4, abs=1e-14)
    run = float_run(made, "LSODA", 1e-9, 3)
    assert run.samples is not None
    at = {name: float(column[-1]) for name, column in run.samples.columns.items()}
    assert math.cos(at["q"]) - math.cos(at["s"]) == pytest.approx(at["y"], abs=1e-12)


def test_names_that_are_no_texts_are_refused_in_words() -> None:
    """They ended in "'int' object is not subscriptable"."""
    with pytest.raises(StateError, match="compass biped: the state must give values by the names q, s, q_dot, s_dot"):
        approach(BIPED, [1, 2, 3, 4])  # type: ignore[arg-type]
    with pytest.raises(StateError, match="compass biped: the state must give values by the names"):
        approach(BIPED, {0: 1, 1: 2})  # type: ignore[dict-item]
    for parts, message in (
        ((EFFECTS, {}, {0: 1}), "start: expected values by their names"),
        ((EFFECTS, {}, [1, 2]), "start: expected values by their names"),
        ((EFFECTS, {1: 2}, {"q": "2/5"}), "parameters: expected values by their names"),
        (((1,), {}, {"q": "2/5"}), "effects: expected names of effects"),
    ):
        effects, parameters, start = parts
        with pytest.raises(SceneError, match=message):
            Scene("test", effects, EPSILON, fmpq(1), parameters, start, None, BIPED)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("start", "message"),
    [
        ({"a": "4/5", "a_dot": "1", "c": "0"}, "y and v determine 2 components of a, c, a_dot, c_dot: give all others"),
        ({"a": "4/5"}, "left out: c, a_dot, c_dot"),
        ({"a": "4/5", "c": "-3/5"}, "y and v do not certainly determine a_dot, c_dot near the mechanism's place"),
        ({"a": "3", "a_dot": "1"}, "y and v do not certainly determine c, c_dot"),  # out of reach
        ({"a": "4/5", "hand": "1"}, "this scene has no state 'hand'"),
    ],
)
def test_starts_that_do_not_determine_the_others(start: dict[str, str], message: str) -> None:
    with pytest.raises(SceneError) as caught:
        scene(ARM, start)
    assert message in str(caught.value)
