"""Scenes that start just before a G-spot: on slip, near it, with the effects that its slip velocity asks for."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified import load, scene_before_spot, simulate
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import ball
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.scene.before_spot import ON_A_BELT, ON_A_SURFACE_AT_REST
from gspot_verified.scenes.scene.scene import SceneError


@pytest.mark.parametrize(
    ("name", "number", "effects"),
    [
        ("rod", 1, ON_A_SURFACE_AT_REST),
        ("extended", 1, ON_A_SURFACE_AT_REST),
        ("genot_brogliato_rod", 1, ON_A_SURFACE_AT_REST),
        ("oscillator", 2, ON_A_BELT),
    ],
)
def test_a_start_on_slip_near_the_g_spot(name: str, number: int, effects: tuple[str, ...]) -> None:
    """By the scene's own equations: p is about a 32nd part of C or less, and -b/p about 5/4 of the mean force."""
    mechanism = load(name)
    scene = scene_before_spot(mechanism, number)
    spot = classify_all(mechanism).spots[number - 1]
    assert (scene.effects, scene.first_phase(), scene.mechanism) == (effects, "slip", mechanism)
    assert [scene.initial()[word] for word in "yvz"] == [0, 0, 0]
    p, b, u = (
        of(scene.values())
        for of in (scene.motion.painleve_parameter, scene.motion.normal_acceleration, scene.motion.slip_velocity)
    )
    assert 0 < p < ball(spot.C) / 30
    assert abs(-b / p / ball(spot.mean_force) - fmpq(5, 4)) < fmpq(1, 1000)
    assert (u > 0) is (effects is ON_A_SURFACE_AT_REST)
    assert abs(scene.until * abs(ball(spot.alpha_1)) / p - 10) < fmpq(1, 1000)


def test_slip_from_there_comes_to_that_g_spot() -> None:
    """By rigid slip, another route, from the components that y = 0 and v = 0 leave free."""
    rod = load("rod")
    scene = scene_before_spot(rod, 1)
    result = approach(rod, dict(scene.start))
    assert (result.end, result.verdict.outcome) == ("G-spot", Outcome.PROVED)
    assert result.time is not None
    assert result.time < ball(scene.until) / 5


@settings(max_examples=5, deadline=None)
@given(st.fractions(Fraction(3, 2), 3, max_denominator=20))
def test_at_every_friction_the_start_is_on_slip(mu: object) -> None:
    """The rod with another μ: its first G-spot is in Case II, or in none, which is refused with that reason."""
    rod = load("genot_brogliato_rod", mu=str(mu))
    if classify_all(rod).spots[0].case == "II":
        assert scene_before_spot(rod, 1).first_phase() == "slip"
    else:
        with pytest.raises(SceneError, match="no start before it: no Case"):
            scene_before_spot(rod, 1)


def test_a_certified_run_from_there() -> None:
    run = simulate(scene_before_spot(load("rod"), 1).with_settings(until="1/20"), digits=5)
    assert run.verdict.outcome is Outcome.PROVED
    assert [event.name for event in run.events] == ["impact without collision"]


def test_what_is_impossible_is_refused_with_its_reason() -> None:
    rod = load("genot_brogliato_rod")
    with pytest.raises(SceneError, match="G-spot 2: no start before it: no Case: alpha_1 is not negative"):
        scene_before_spot(rod, 2)
    with pytest.raises(ValueError, match="9"):
        scene_before_spot(rod, 9)


@pytest.mark.parametrize("number", [1, 2, 3])
def test_an_arm_starts_next_to_the_g_spot_that_is_asked(number: int) -> None:
    """No coordinate of it is free: y = v = 0 has other solutions far from this G-spot, and the file names another."""
    arm = load("two-link arm")
    spot = find_g_spot(at_spot(arm, number))
    scene = scene_before_spot(arm, number)
    state = scene.motion.whole_state(scene.values())  # type: ignore[union-attr]
    assert all(abs(a - b) < 0.1 for a, b in zip(state[:2], map(ball, spot.system.point), strict=False))
    assert scene.motion.painleve_parameter(scene.values()) > 0


def test_another_parameter_is_said_in_the_name() -> None:
    """The G-spot of the scene is not one of the mechanism with another mu."""
    scene = scene_before_spot(load("rod"), 1)
    assert scene.with_settings(epsilon="1/100", mu=None).name == scene.name
    other = scene.with_settings(mu="3/2")
    assert other.name == f"{scene.name}, mu = 3/2"
    assert other.with_settings(mu="7/4").name == f"{scene.name}, mu = 7/4"
    assert other.with_settings(g=9, mu="3/2").name == f"{scene.name}, mu = 3/2, g = 9"


def test_another_start_is_said_in_the_name() -> None:
    """It is no longer just before the G-spot."""
    scene = scene_before_spot(load("rod"), 1)
    assert scene.with_settings(X_dot=1, theta=None).name == f"{scene.name}, X_dot = 1"
    assert scene.with_settings(X_dot=1).with_settings(X_dot="1/2").name == f"{scene.name}, X_dot = 1/2"
    assert scene.with_settings(theta=scene.start["theta"]).name == scene.name


def test_a_mechanism_with_constraints_is_refused_with_this_reason() -> None:
    """Its gap is a coordinate, so that y and v alone could be solved for them."""
    rod = lagrangian(
        "rod", ["X", "Y", "theta", "H"], [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, 1]], [0, -1, 0, 0],
        "X + cos(theta)", "H - sin(theta)", "73/36", constraints=["H - Y"], search=True, fixed=["X", "X_dot"],
        place={"X": 0, "Y": "4/5", "H": "4/5", "theta": "3/5", "X_dot": 2, "Y_dot": "1/2", "H_dot": "1/2",
               "theta_dot": 1},
    )  # fmt: skip
    with pytest.raises(SceneError, match="the mechanism has constraints; write a scene with a start"):
        scene_before_spot(rod, 1)
