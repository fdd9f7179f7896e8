"""A phase in floats: what ends it, from which side, and what the solver is told; nothing of it is proved."""

from __future__ import annotations

import math
import warnings
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import scipy.integrate
from flint import fmpq

from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.scenes.floats import float_run
from gspot_verified.scenes.floats.float_run import FloatPhase
from gspot_verified.scenes.floats.float_run import float_run as run_floats
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError

MODEL = load_scene("fig-varsim1", epsilon="1/4", p="1/2")
STATE = {"b": -1.0, "Y": -3.0, "V": 0.5, "Z": -1.0}
POINT = [STATE[name] for name in FloatPhase(MODEL, "slip", None).states]
STICK = ("compliant_contact", "lift_off", "tangential_motion", "stick")


def block() -> Scene:
    made = lagrangian("block", ["X", "H"], [[1, "1/4"], ["1/4", 1]], ["-1/2", -1], "X", "H", "1/4")
    return Scene("test", STICK, fmpq(1, 10), fmpq(1), {}, {"X_dot": "1"}, None, made)


def test_only_friction_guards_a_stick() -> None:
    """Lift-off ends a stick too, and is no direction of slip that could follow at its start."""
    phase = FloatPhase(block(), "stick", None)
    assert {name for name, _ in phase.ends} == {"lift-off", "slip forwards", "slip backwards"}
    assert [name for name, _ in phase.guards] == ["slip", "reverse slip"]
    assert FloatPhase(block(), "slip", None).guards == []


@pytest.mark.parametrize(
    ("time", "value"),
    [(0.0, 10.0), (2.0, 10.0), (2.0625, 8.0), (4.0, 8.0)],  # p = 1/2 - T/4, 0 at T = 2
)
def test_a_large_force_ends_a_contact_where_p_is_negative(time: float, value: float) -> None:
    phase = FloatPhase(MODEL, "slip", 10.0)
    assert phase.shown(POINT, time)["p"] == 0.5 - time / 4
    assert phase.ends[-1] == ("impact without collision", None)
    event = phase._events[-1]
    assert event(time, np.array(POINT)) == value  # lambda_N = 2
    assert (event.terminal, event.direction) == (True, -1.0)
    assert len(phase.ends) == len(phase._events) == 2
    for without in (FloatPhase(MODEL, "slip", None), FloatPhase(MODEL, "flight", 10.0)):
        assert [name for name, _ in without.ends] in (["lift-off"], ["touch-down"])
        assert len(without._events) == 1


def test_rows_are_in_the_units_of_the_paper() -> None:
    """t = epsilon T, y = epsilon^2 Y, v = epsilon V; at T = 1/2, p = 3/8 and the force is Z - Y."""
    phase = FloatPhase(MODEL, "slip", None)
    (row,) = phase.rows([0.5], np.array([POINT]).T)
    expected = {"p": 0.375, "b": -1.0, "y": -3 / 16, "v": 1 / 8, "z": -1 / 16, "lambda_N": 2.0}
    assert row[0] == 0.125
    assert dict(zip(phase.names, row[1:], strict=True)) == expected
    assert phase.shown(POINT, 0.5) == expected
    with pytest.raises(ValueError, match="zip"):
        phase.rows([1.0, 2.0], np.array([POINT]).T)


def test_what_the_solver_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """The absolute tolerance is a thousandth of the relative one; the Jacobian matrix is that of the rates, by
    differences; a solver that stops or breaks is an error of the scene."""
    told: dict[str, Any] = {}

    def solve(function: Any, span: Any, state: Any, **options: Any) -> Any:
        told.update(options, function=function, span=span, state=state)
        return SimpleNamespace(success=True, y=np.array([POINT]).T)

    monkeypatch.setattr(scipy.integrate, "solve_ivp", solve)
    phase = FloatPhase(MODEL, "slip", None)
    phase.integrate(POINT, (0.0, 3.0), "BDF", 1e-6)
    assert (told["method"], told["span"], told["rtol"], told["dense_output"]) == ("BDF", (0.0, 3.0), 1e-6, True)
    assert told["atol"] == pytest.approx(1e-9)
    assert told["state"].tolist() == POINT
    assert told["events"] == phase._events
    slopes, size = told["jac"](1.0, np.array(POINT)), len(POINT)
    assert slopes.shape == (size, size)
    for j in range(size):
        step = 1e-3 * np.eye(size)[j]
        up, down = (np.array(told["function"](1.0, np.array(POINT) + sign * step)) for sign in (1, -1))
        assert slopes[:, j] == pytest.approx((up - down) / 2e-3, abs=1e-9)
    for said in (lambda *_, **__: SimpleNamespace(success=False, message="too stiff"), lambda *_, **__: 1 / 0):
        monkeypatch.setattr(scipy.integrate, "solve_ivp", said)
        with pytest.raises(SceneError, match=r"^the float run failed in slip: (too stiff|division by zero)$"):
            phase.integrate(POINT, (0.0, 3.0), "BDF", 1e-6)


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan])
def test_values_beyond_floats_are_a_failure(monkeypatch: pytest.MonkeyPatch, value: float) -> None:
    """Whatever the solver says of them, and without numpy's or the solver's own warnings."""

    def solve(*_: Any, **__: Any) -> Any:
        warnings.warn("lsoda: something", UserWarning, stacklevel=1)
        y = np.array([POINT, [np.float64(1e300) * np.float64(1e300), *POINT[1:]]]).T
        y[0, 1] = value
        return SimpleNamespace(success=True, y=y)

    monkeypatch.setattr(scipy.integrate, "solve_ivp", solve)
    with pytest.raises(SceneError, match=r"^the float run failed in slip: a value is too large for a float$"):
        FloatPhase(MODEL, "slip", None).integrate(POINT, (0.0, 3.0), "BDF", 1e-6)


def test_an_overflow_in_the_solver_is_an_error_and_no_warning() -> None:
    """Warnings are errors in these tests."""
    state = [-1e150, *POINT[1:]]
    with pytest.raises(SceneError, match="the float run failed in slip"):
        FloatPhase(MODEL, "slip", None).integrate(state, (0.0, 1e-3), "Radau", 1e-10)


@pytest.mark.parametrize("method", ["LSODA", pytest.param("Radau", marks=pytest.mark.slow)])
def test_a_mechanism_that_is_pulled_ever_faster_ends_with_its_reason(
    method: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The rod with its contact alone: friction of forward slip goes on where slip has stopped, the surface pulls,
    and it turns ever faster: with Radau there was no answer in 90 s."""
    monkeypatch.setattr(float_run, "MAX_PULLING", 500)
    less = load_scene("rod").with_effects(drop=("stick", "tangential_motion", "lift_off"))
    with pytest.raises(SceneError) as caught:
        run_floats(less, method, 1e-8)
    assert "the surface has pulled in 500 evaluations of the equations; without lift_off λ_N is supp" in str(
        caught.value
    )
    reached = float(str(caught.value).partition("t = ")[2].partition(":")[0])
    assert 0.2 < reached < 0.25
    assert run_floats(less.with_settings(until="1/5"), method, 1e-8).fate == "no event"
    assert run_floats(less.with_effects(add=["lift_off"]), method, 1e-8).fate == "lift-off"


def test_a_surface_that_pulls_for_a_while_is_no_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """In flight nothing pulls, and with lift_off the surface does not."""
    monkeypatch.setattr(float_run, "MAX_PULLING", 0)
    assert run_floats(load_scene("fig-varsim1", nu=2), "LSODA", 1e-8).events[0].name == "lift-off"
    with pytest.raises(SceneError, match="the float run ended in slip at t = "):
        run_floats(load_scene("fig-varsim1", nu=2).with_effects(drop=["lift_off"], until=1), "LSODA", 1e-8)
