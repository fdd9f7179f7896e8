"""The model system in a scene: its states and parameters, its start at rest and with nu, what is refused."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.model_motion import ModelMotion

LINEAR = ("compliant_contact", "lift_off")
ALL = (*LINEAR, "tangential_motion", "stick", "tangential_place", "two_way_coupling")
EPSILON = fmpq(1, 10)
HALF = fmpq(1, 2)


def motion(effects: tuple[str, ...] = LINEAR, **start: Any) -> ModelMotion:
    given_start = {"p": HALF, "b": fmpq(-3)} | {name: fmpq(value) for name, value in start.items()}
    return ModelMotion([EFFECTS[name] for name in effects], EPSILON, without_none(given_start, start))


def without_none(given_start: Mapping[str, fmpq], start: Mapping[str, Any]) -> dict[str, fmpq]:
    """nu takes the place of b."""
    return {name: value for name, value in given_start.items() if not (name == "b" and "nu" in start)}


def values(made: ModelMotion, **others: fmpq) -> dict[str, fmpq]:
    one = fmpq(1)
    return {
        **made.parameters,
        "k_1": one,
        "k_2": one,
        "damping": one,
        "alpha_1": fmpq(-2),
        "alpha_2": fmpq(-3),
        "beta": fmpq(3, 2),
        **others,
    }


def test_the_states_are_b_and_those_of_the_effects_of_a_phase() -> None:
    assert motion().states("slip") == motion().states("flight") == ("b",)
    coupled = motion(ALL, u=1, x=2)
    assert set(coupled.states("slip")) == {"b", "u", "x", "p"}
    assert coupled.states("slip")[0] == "b"
    assert "u" not in coupled.states("stick")
    assert (ModelMotion.is_model, ModelMotion.depends_on_place) == (True, False)


def test_the_parameters_are_those_of_the_model_and_of_the_effects() -> None:
    assert set(motion().parameters) >= {"alpha_1", "alpha_2", "beta"}
    assert "k_plus" not in motion().parameters
    assert {"k_plus", "k_minus", "a"} <= set(motion(ALL, u=1, x=2).parameters)


@pytest.mark.parametrize("phase", ["slip", "flight", "stick", "reverse slip"])
def test_each_state_has_its_rate_and_what_is_seen_is_the_state(phase: str) -> None:
    made = motion(ALL, u=1, x=2)
    names = made.states(phase)
    states = (*names, "Y", "V", "Z")
    terms = made.terms(phase, states, values(made, chi=fmpq(0)))
    assert set(made.rates(terms)) == set(names)
    shown = made.shown(terms)
    assert set(shown) == {"p", "b", "u", "x"}
    point = {name: float(3 + i) for i, name in enumerate(states)}
    found = float_function([shown["b"], shown["x"]])([*point.values(), 0.0])
    assert found == [point["b"], point["x"]]
    if phase != "stick":
        assert float_function([shown["u"]])([*point.values(), 0.0]) == [point["u"]]
    alone = motion()
    shown = alone.shown(alone.terms("slip", ("b", "Y", "V", "Z"), values(alone)))
    assert set(shown) == {"p", "b"}


@given(st.fractions(1, 20, max_denominator=9), st.fractions(1, 20, max_denominator=9), st.fractions(-9, 9))
def test_at_rest_nothing_moves(k_1: Any, k_2: Any, b: Any) -> None:
    """dv/dt = b + p lambda = 0 and dz/dt = 0, which is where k_1 z + lambda = 0; lambda = k_2 (z - y)/epsilon^2."""
    made = ModelMotion([EFFECTS[name] for name in LINEAR], EPSILON, {"p": fmpq(2, 3), "b": exact(b)})
    stiffness = {"k_1": exact(k_1), "k_2": exact(k_2)}
    start = made.start(values(made, **stiffness))
    force = stiffness["k_2"] * (start["z"] - start["y"]) / EPSILON**2
    assert start["b"] + start["p"] * force == 0
    assert stiffness["k_1"] * start["z"] / EPSILON**2 + force == 0
    assert start["v"] == 0


def exact(value: Any) -> fmpq:
    return fmpq(value.numerator, value.denominator)


def test_a_start_that_is_given_is_kept() -> None:
    made = motion(y=-3, v=4, z=-2, p=-1)
    assert made.start(values(made)) == {"p": -1, "b": -3, "y": -3, "v": 4, "z": -2}
    for name, value in (("normal_acceleration", -3), ("painleve_parameter", -1)):
        assert getattr(made, name)(values(made)) == value
    assert motion(ALL, u=5, x=2).slip_velocity(values(motion(ALL, u=5, x=2))) == 5
    made.check(values(made))


@pytest.mark.parametrize("beta", ["3/2", "1/2", "5/2"])
def test_nu_is_the_multiple_of_b_on_the_trivial_solution(beta: str) -> None:
    """There b = -p lambda with lambda = alpha_2/(alpha_3 - alpha_1), taken positive: nu = 1."""
    factor, third = fmpq(*map(int, beta.split("/"))), fmpq(7, 3)
    made = motion(nu=third, p=2)
    known = values(made, beta=factor)
    force = known["alpha_2"] / (factor * known["alpha_1"] - known["alpha_1"])
    assert made.start(known)["b"] == -third * 2 * abs(force)
    assert made.start(known)["b"] < 0
    assert "nu" not in made.start(known)
    with pytest.raises(SceneError, match="at beta = 1 there is none: give b"):
        made.start(values(made, beta=fmpq(1)))
    with pytest.raises(SceneError, match="at beta = 1 there is none: give b"):
        made.start(values(made, alpha_1=fmpq(0)))


@pytest.mark.parametrize(
    ("effects", "start", "message"),
    [
        (LINEAR, {"b": 1}, "the state p is missing"),
        (("compliant_contact", "tangential_motion"), {"p": 1, "b": 1}, "the state u is missing"),
        (LINEAR, {"p": 1}, "give b or nu, one of them"),
        (LINEAR, {"p": 1, "b": 1, "nu": 1}, "give b or nu, one of them"),
        (LINEAR, {"p": 1, "b": 1, "u": 1}, "this scene has no state 'u'"),
        (LINEAR, {"p": 1, "b": 1, "w": 1}, "this scene has no state 'w'"),
        (LINEAR, {"p": 1, "b": 1, "y": 1}, "the state v is missing; give y, v and z, or none"),
        (LINEAR, {"p": 1, "b": 1, "v": 1, "z": 1}, "the state y is missing; give y, v and z, or none"),
        (LINEAR, {"p": 1, "b": 1, "v": 1, "y": 1}, "the state z is missing; give y, v and z, or none"),
        (LINEAR, {"p": 0, "b": -1}, "at rest on the surface p must be > 0, got 0; give y, v and z"),
        (LINEAR, {"p": -1, "b": -1}, "at rest on the surface p must be > 0, got -1; give y, v and z"),
    ],
)
def test_a_start_that_says_too_little_or_too_much(
    effects: tuple[str, ...], start: dict[str, int], message: str
) -> None:
    made = ModelMotion([EFFECTS[n] for n in effects], EPSILON, {name: fmpq(value) for name, value in start.items()})
    with pytest.raises(SceneError, match=f"^start: .*{message}"):
        made.start(values(made))
