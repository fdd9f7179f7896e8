"""Starts on the slow manifold: against the exact fast coefficients, and against motions whose oscillation died out."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.compliant.model.normal_form import deviation
from gspot_verified.compliant.side.side_rule import coefficients
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.certified_run import exact_start
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.motions.slow_point import SlowPoint
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.side import LASTS, LOST, certified_side


def fast_size(scene: Scene) -> float:
    """|c_+|/|C| of the start, by the integrals of proofs/first_integrals.md."""
    slow, fast, _ = coefficients(deviation(*exact_start(scene)), 120)
    return abs(approximate(abs(fast)) / approximate(slow))


@pytest.mark.parametrize(("beta", "epsilon"), [("5/2", "1/200"), ("1/2", "1/500"), ("13/2", "1/1000")])
def test_the_exact_fast_part_vanishes_with_the_orders(beta: str, epsilon: str) -> None:
    """From rest it is of the order epsilon^2; from the expansion what its last order says."""
    rest = load_scene("fig-varsim1", beta=beta, nu=2, epsilon=epsilon)
    slow = rest.with_settings(start="slip")
    assert slow.slow_start is not None
    assert fast_size(slow) < 100 * slow.slow_start.last * fast_size(rest) / approximate(rest.epsilon) ** 2
    assert fast_size(slow) < 1e-8 * fast_size(rest)


@pytest.mark.slow
def test_the_side_at_beta_13_2_turns_with_the_start() -> None:
    """epsilon = 1/1000, where the paper's rule fails from rest (proofs/first_integrals.md)."""
    rest = load_scene("fig-varsim1", beta="13/2", nu=2)
    assert certified_side(rest).side == LOST
    assert certified_side(rest.with_settings(start="slip")).side == LASTS


def test_a_motion_whose_oscillation_died_out_is_met() -> None:
    """The rod from far away; where it is then, y, v and z are those of the slow manifold over its slow components."""
    far = load_scene("rod", theta="theta_ref - 3/10", theta_dot=1, X_dot=9, epsilon="1/1000", until="1/6")
    samples = float_run(far, "LSODA", 1e-11, 3).samples
    assert samples is not None
    at = {name.split()[0]: float(column[-1]) for name, column in samples.columns.items()}
    given = {n: str(fmpq(*at[n].as_integer_ratio())) for n in ("theta", "theta_dot", "X_dot")}
    given["theta"] = f"theta_ref + {given['theta']}"
    start = far.with_settings(start="slip", **given).initial()
    for name, accuracy in (("y", 1e-6), ("z", 1e-6), ("v", 1e-3)):
        assert approximate(start[name]) == pytest.approx(at[name], rel=accuracy)
    assert abs(at["v"]) > 1e-4 * 1e-3  # v = 0, of a start at rest, would be wrong by this


def test_the_springs_and_the_damper_are_in_it() -> None:
    """Where nothing moves slowly, b and p constant: Z = -lambda/k_1, Y = Z - lambda/k_2, V = 0."""
    scene = load_scene("fig-varsim1", alpha_1="-1/1000000", alpha_2=0, beta=0, b=-3, k_1=2, k_2=5, damping=7)
    point = scene.with_settings(start="slip").slow_start
    assert point is not None
    force = 6.0
    assert approximate(point.Z) == pytest.approx(-force / 2, rel=1e-5)
    assert approximate(point.Y) == pytest.approx(-force / 2 - force / 5, rel=1e-5)
    assert abs(approximate(point.V)) < 1e-4


def test_the_start_is_exact_and_says_what_it_is() -> None:
    scene = load_scene("rod", start="slip")
    assert isinstance(scene.slow_start, SlowPoint)
    start = scene.initial()
    assert start["y"] == scene.epsilon**2 * scene.slow_start.Y
    assert start["y"] < start["z"] < 0
    assert len(str(start["y"].q)) < 40  # a decimal
    assert "an exact point next to its slow manifold, from the expansion to epsilon^" in str(scene.slow_start)
    assert "its distance from the manifold is not bounded" in str(scene.slow_start)
    assert load_scene("rod").slow_start is None


def test_another_epsilon_has_another_point() -> None:
    scene = load_scene("rod", start="slip")
    smaller = scene.with_settings(epsilon="1/10000")
    assert smaller.initial()["v"] == load_scene("rod", start="slip", epsilon="1/10000").initial()["v"]
    ratio = approximate(smaller.initial()["v"] / scene.initial()["v"])
    assert ratio == pytest.approx(1e-2, rel=1e-2)  # v is of the order epsilon^2


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"p": "-1/2", "b": -1}, "it needs p > 0, where it attracts"),
        ({"b": 1}, "start: not in contact"),
        ({"epsilon": 1}, "epsilon = 1 is too large for the slow manifold's expansion there"),
    ],
)
def test_where_there_is_none(settings: dict[str, object], message: str) -> None:
    scene = load_scene("fig-varsim1")
    scene = Scene("test", ("compliant_contact",), scene.epsilon, scene.until, scene.parameters, scene.start)
    with pytest.raises(SceneError) as caught:
        scene.with_settings(start="slip", **settings)  # type: ignore[arg-type]
    assert message in str(caught.value)


def test_backward_slip_and_flight_have_none() -> None:
    with pytest.raises(SceneError, match="no positive slip in contact there"):
        load_scene("fig-varsim1", start="slip", b=1)
    with pytest.raises(SceneError, match="no positive slip in contact there"):
        load_scene("rod", start="slip", X_dot=-5)


def test_one_of_the_two_is_given() -> None:
    scene = load_scene("oscillator-canard")
    assert scene.with_settings(start="slip").slow_start is not None  # takes the place of y, v, z
    with pytest.raises(SceneError, match="y is given, and the slow manifold of slip is asked for"):
        scene.with_settings(start="slip").with_settings(y=-1)
    for order in (("start", "y"), ("y", "start")):
        settings = {"start": "slip", "y": "-1/100"}
        with pytest.raises(SceneError, match="y is given, and the slow manifold of slip is asked for"):
            load_scene("fig-varsim1", **{name: settings[name] for name in order})
    with pytest.raises(SceneError, match='start: expected "slip", or a table'):
        scene.with_settings(start="stick")
