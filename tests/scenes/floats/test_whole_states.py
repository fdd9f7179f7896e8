"""The components that no run integrates, by another run that does, by the contact, and by a momentum that is kept."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from flint import fmpq

from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.floats.whole_states import whole_states
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError

ANGLE = math.asin(3 / 5)  # the reference of the rod


def along(scene: Scene, points: int | None = None) -> tuple[dict[str, Any], dict[str, Any], tuple[str, ...]]:
    """The samples, the whole states by the names of the components, and the phases."""
    samples = float_run(scene, points=points).samples
    assert samples is not None
    assert scene.mechanism is not None
    states = np.array(whole_states(scene, samples)).T
    return samples.columns, dict(zip(scene.mechanism.state, states, strict=True)), samples.phases


def test_the_place_along_the_surface_is_that_of_a_run_that_integrates_it() -> None:
    """x, through slip, stick and flight; the rod starts at X = 3 there."""
    scene = load_scene("rod", epsilon="1/100")
    farther = replace(scene, start={**scene.start, "X": fmpq(3)}, effects=(*scene.effects, "tangential_place"))
    (columns, _, phases), (_, states, _) = along(farther, 201), along(replace(farther, effects=scene.effects), 201)
    assert {SLIP, STICK, FLIGHT} <= set(phases)
    x = states["X"] + np.cos(ANGLE + states["theta"])
    assert columns["x"][0] == pytest.approx(3 + math.cos(ANGLE - 1 / 10))
    assert np.abs(x - columns["x"]).max() < 1e-4
    assert np.ptp(columns["x"]) > 0.25


def test_a_velocity_that_is_not_integrated() -> None:
    """Slip without tangential motion against slip with it, before the slip velocity matters."""
    scene = load_scene("rod", epsilon="1/100", until="1/20")
    slips = replace(scene, effects=("compliant_contact", "lift_off"))
    (columns, _, _), (_, states, phases) = along(scene, 2), along(slips)
    assert set(phases) == {SLIP}
    assert "X_dot" not in float_run(slips).samples.columns  # type: ignore[union-attr]
    assert states["X_dot"][-1] == pytest.approx(columns["X_dot"][-1], abs=1e-5)
    assert states["X_dot"][-1] < 1.98


def test_the_two_components_that_y_and_v_stand_for() -> None:
    columns, states, phases = along(load_scene("oscillator", epsilon="1/1000"))
    phi, rate = math.asin(4 / 5) + states["phi"], states["phi_dot"]
    assert FLIGHT in phases
    assert states["psi"] + 1 - np.cos(phi) == pytest.approx(columns["y"], abs=1e-14)
    assert states["psi_dot"] + np.sin(phi) * rate == pytest.approx(columns["v"], abs=1e-13)


@pytest.mark.parametrize(
    ("push", "slip", "expected"),
    [(-3, 1, (SLIP, REVERSE)), (0, 1, (SLIP, STICK)), (3, -1, (REVERSE, SLIP))],
)
def test_a_momentum_that_is_kept_in_every_phase(push: int, slip: int, expected: tuple[str, ...]) -> None:
    """A weight on the block, free along it: its momentum X'/2 + W' stays, whatever the friction is."""
    weight = lagrangian(
        "a block with a weight", ["X", "Y", "W"], [[1, 0, "1/2"], [0, 1, 0], ["1/2", 0, 1]], [push, -1, 0],
        "X", "Y", "1/2",
    )  # fmt: skip
    effects = ("compliant_contact", "lift_off", "tangential_motion", "stick")
    start = {"X_dot": fmpq(slip), "W_dot": fmpq(1, 4)}
    scene = Scene("weight", effects, fmpq(1, 10), fmpq(3), {}, start, mechanism=weight)
    columns, states, phases = along(scene, 2001)
    assert tuple(dict.fromkeys(phases)) == expected
    assert "W_dot" not in columns
    assert states["X_dot"] / 2 + states["W_dot"] == pytest.approx(slip / 2 + 1 / 4, abs=2e-4)
    assert np.ptp(states["W_dot"]) > 0.4


def test_the_model_has_no_bodies() -> None:
    scene = load_scene("fig-varsim1", beta="1/2")
    samples = float_run(scene, points=3).samples
    assert samples is not None
    with pytest.raises(SceneError, match="the scene has no mechanism, the model system has no bodies"):
        whole_states(scene, samples)
