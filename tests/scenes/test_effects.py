"""Each effect by itself: its equations at points against the formulas of the paper, its events, and its condition."""

from __future__ import annotations

import random

import pytest
import sympy
from flint import fmpq

from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.effects import (
    belt,
    compliant_contact,
    lift_off,
    model,
    stick,
    tangential_motion,
    tangential_place,
    two_way_coupling,
)
from gspot_verified.scenes.effects.catalogue import EFFECTS, EXCLUSIONS, OUTSIDE
from gspot_verified.scenes.effects.effect import Condition
from gspot_verified.scenes.equations.mechanism_terms import MechanismTerms
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.scaled_system import CONTACT, ScaledSystem
from gspot_verified.scenes.equations.terms import FLIGHT, PHASES, REVERSE, SLIP, STICK
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.scene.scene import Scene, SceneError

EVERYTHING = (
    "compliant_contact",
    "lift_off",
    "tangential_motion",
    "tangential_place",
    "stick",
    "belt",
    "two_way_coupling",
)
PARAMETERS = {
    name: fmpq(*value)
    for name, value in {
        "k_1": (2, 1), "k_2": (3, 1), "damping": (5, 1), "alpha_1": (-7, 2), "alpha_2": (11, 3), "beta": (5, 4),
        "chi": (13, 5), "a": (1, 7), "k_plus": (-3, 2), "k_minus": (5, 3), "p_minus": (7, 4), "belt_velocity": (1, 3),
    }.items()
}  # fmt: skip
EPSILON = fmpq(1, 8)
START = {"p": fmpq(1, 2), "b": fmpq(-1), "u": fmpq(2), "x": fmpq(0), "y": fmpq(-1, 100), "v": fmpq(0), "z": fmpq(0)}
WHOLE = Scene("whole", EVERYTHING, EPSILON, fmpq(1), PARAMETERS, START)


def paper(phase: str, at: dict[str, float]) -> dict[str, float]:
    """Eqs. newex1 to newex5, udot, xdot and cdot in T = t/ε, with any stiffness; λ_N as given."""
    w = {name: approximate(value) for name, value in PARAMETERS.items()}
    eps = approximate(EPSILON)
    force = 0.0 if phase == FLIGHT else w["k_2"] * (at["Z"] - at["Y"])
    c = {SLIP: 1.0, REVERSE: 0.0, FLIGHT: 0.0}.get(phase)
    if c is None:
        c = (w["k_minus"] + w["a"] / force) / (w["k_minus"] - w["k_plus"])
    forward, backward = c * force, (1 - c) * force
    u = w["belt_velocity"] if phase == STICK else at["u"]
    alpha_3 = w["beta"] * w["alpha_1"]
    return {
        "b": eps * (w["alpha_2"] - alpha_3 * forward),
        "Y": at["V"],
        "V": at["b"] + at["p"] * forward + w["p_minus"] * backward,
        "Z": (-w["k_1"] * at["Z"] - force) / w["damping"],
        "u": eps * (w["a"] + w["k_plus"] * forward + w["k_minus"] * backward),
        "x": eps * u,
        "p": eps * (w["alpha_1"] + w["chi"] * at["b"]),
    }


def points(system: ScaledSystem, count: int = 5) -> list[dict[str, float]]:
    chance = random.Random(3)
    found = [{name: chance.uniform(-2, 2) for name in system.states} for _ in range(count)]
    return [{**at, "Z": at["Y"] + abs(at["Z"]) + 1} for at in found]


@pytest.mark.parametrize("phase", PHASES)
def test_the_equations_are_those_of_the_paper(phase: str) -> None:
    system = WHOLE.system(phase)
    rates = float_function(system.right_hand_side)
    for at in points(system):
        expected = paper(phase, at)
        for name, rate in zip(system.states, rates([at[name] for name in system.states]), strict=True):
            assert rate == pytest.approx(expected[name], rel=1e-12, abs=1e-12), name


@pytest.mark.parametrize(
    ("phase", "names"),
    [
        (SLIP, [("lift-off", FLIGHT), ("slip stops", CONTACT)]),
        (REVERSE, [("lift-off", FLIGHT), ("slip stops", CONTACT)]),
        (STICK, [("lift-off", FLIGHT), ("slip forwards", SLIP)]),
        (FLIGHT, [("touch-down", CONTACT)]),
    ],
)
def test_the_events_are_where_the_phases_end(phase: str, names: list[tuple[str, str]]) -> None:
    """λ_N in contact, Y - Z in flight; |u - u_belt| in slip; in stick (a > 0) λ⁺ >= 0 may end: -k⁺ λ_N - a."""
    system = WHOLE.system(phase)
    assert [(event.name, event.next_phase) for event in system.events] == names
    shown = float_function([event.function for event in system.events])
    w = {name: approximate(value) for name, value in PARAMETERS.items()}
    for at in points(system):
        force = w["k_2"] * (at["Z"] - at["Y"])
        values = dict(zip([name for name, _ in names], shown([at[name] for name in system.states]), strict=True))
        if phase == FLIGHT:
            assert values == {"touch-down": pytest.approx(-force)}
            continue
        assert values["lift-off"] == pytest.approx(force)
        if phase == STICK:
            assert values["slip forwards"] == pytest.approx(-w["k_plus"] * force - w["a"])
        else:
            assert values["slip stops"] == pytest.approx((at["u"] - w["belt_velocity"]) * (1 if phase == SLIP else -1))


def test_the_conditions_are_events_of_the_full_scene() -> None:
    """The function of each condition is that of the event which the effect adds."""
    for name, phases in (("stick", (SLIP,)), ("lift_off", (SLIP, STICK, REVERSE))):
        effects = [each for each in EVERYTHING if each not in ({name} | ({"belt"} if name == "stick" else set()))]
        own = {
            key: value
            for key, value in PARAMETERS.items()
            if name != "stick" or key not in ("k_minus", "p_minus", "belt_velocity")
        }
        part = Scene("part", tuple(effects), EPSILON, fmpq(1), own, START)
        still = Scene("full", EVERYTHING, EPSILON, fmpq(1), {**PARAMETERS, "belt_velocity": fmpq(0)}, START)
        for phase in part.phases():
            found = [event for event in part.system(phase, [EFFECTS[name]]).events if event.left_out]
            assert bool(found) is (phase in phases)
            for event in found:
                assert event.left_out == name
                (same,) = (each for each in still.system(phase).events if each.name == event.name)
                values = [
                    float_function([each.function])([0.5, -3.0, 1.5, -1.0, 2.5, 0.25, 0.125]) for each in (event, same)
                ]
                assert values[0] == values[1]
                assert event.next_phase == same.next_phase


def test_which_effect_stands_where() -> None:
    modules = (compliant_contact, lift_off, tangential_motion, tangential_place, stick, belt, two_way_coupling)
    assert list(EFFECTS) == [module.EFFECT.name for module in modules] == list(EVERYTHING)
    assert {name: (effect.needs, effect.needs_in_model) for name, effect in EFFECTS.items()} == {
        "compliant_contact": ((), ()),
        "lift_off": (("compliant_contact",), ()),
        "tangential_motion": ((), ()),
        "tangential_place": (("tangential_motion",), ()),
        "stick": (("tangential_motion",), ()),
        "belt": ((), ("stick",)),
        "two_way_coupling": ((), ()),
    }
    assert {name for name, effect in EFFECTS.items() if effect.opens} == {"lift_off", "stick"}
    assert [name for name, effect in EFFECTS.items() if effect.not_with_mechanism] == ["two_way_coupling"]
    assert {second for first, second in EXCLUSIONS if first == "mechanism"} == {
        *("two_way_coupling", "nu"),
    }


@pytest.mark.parametrize("name", OUTSIDE)
def test_what_is_outside_is_refused_with_its_reason(name: str) -> None:
    assert name not in EFFECTS
    with pytest.raises(SceneError, match=rf"effect '{name}' is outside of what scenes know: {OUTSIDE[name][:20]}"):
        Scene("outside", ("compliant_contact", name), fmpq(1, 10), fmpq(1), {}, {"p": fmpq(1), "b": fmpq(-1)})


def test_the_direction_of_slip_in_space_turns_with_the_force() -> None:
    """p = C - mu B.e for slip along e = w/|w|, and L_G w = B - mu A e: L_G p is not 0, but where nothing turns e."""
    mu, A, C, w1, w2, B1, B2 = sympy.symbols("mu A C w_1 w_2 B_1 B_2", positive=True)
    w, B = sympy.Matrix([w1, w2]), sympy.Matrix([B1, B2])
    e = w / sympy.sqrt(w.dot(w))
    p = C - mu * B.dot(e)
    along = sum(sympy.diff(p, part) * push for part, push in zip(w, B - mu * A * e, strict=True))
    across = (B1 * w2 - B2 * w1) ** 2
    assert sympy.simplify(along + mu * across / w.dot(w) ** sympy.Rational(3, 2)) == 0


def test_the_defaults_are_those_of_the_paper() -> None:
    """Eq. newex6, k_1 = k_2 = c = 1, α_1 = α_2 = -1, β = 3/2, χ = 1, a surface at rest."""
    defaults = dict(model.PARAMETERS)
    for effect in EFFECTS.values():
        defaults |= {**effect.parameters, **effect.model_parameters}
    assert defaults == {
        "alpha_1": -1, "alpha_2": -1, "beta": fmpq(3, 2), "k_1": 1, "k_2": 1, "damping": 1, "a": 0, "k_plus": -1,
        "k_minus": 2, "p_minus": 1, "belt_velocity": 0, "chi": 1,
    }  # fmt: skip


BLOCK = lagrangian("block", ["X", "H"], [[1, "1/2"], ["1/2", 1]], [3, -4], "X", "H", "1/4")


@pytest.mark.parametrize(("phase", "share"), [(SLIP, -0.25), (REVERSE, 0.25), (STICK, None)])
def test_the_friction_of_a_mechanism(phase: str, share: float | None) -> None:
    """M⁻¹ = (4, -2; -2, 4)/3: A = C = 4/3, B = -2/3, a = 20/3, b = -22/3. Slip has -μ λ_N, reverse slip μ λ_N; in stick
    du/dt = a + A λ_T + B λ_N = 0."""
    effects = ("compliant_contact", "tangential_motion", "stick")
    made = Scene("block", effects, EPSILON, fmpq(1), {}, {"X_dot": "1"}, None, BLOCK)
    system = made.system(phase)
    terms = made.motion.terms(phase, system.states, made.values())
    assert isinstance(terms, MechanismTerms)
    at = [{"Y": -3.0, "Z": -1.0}.get(name, 0.5) for name in system.states]
    friction, acceleration, u_rate = float_function(
        [terms.friction, terms.acceleration, system.right_hand_side[system.states.index("X_dot")]]
    )([*at, 0.0])
    assert friction == pytest.approx(2 * share if share is not None else -(20 / 3 - 4 / 3) / (4 / 3))
    assert acceleration == pytest.approx(-22 / 3 + 4 / 3 * 2 - 2 / 3 * friction)
    assert u_rate == pytest.approx(approximate(EPSILON) * (20 / 3 - 2 / 3 * 2 + 4 / 3 * friction), abs=1e-12)


@pytest.mark.parametrize(
    ("k_plus", "k_minus", "a", "phases"),
    [
        (fmpq(-1), fmpq(2), fmpq(0), []),
        (fmpq(-1), fmpq(1, 2), fmpq(0), []),
        (fmpq(-1), fmpq(2), fmpq(1, 2), [SLIP]),
        (fmpq(-1), fmpq(2), fmpq(-1, 2), [REVERSE]),
        (fmpq(0), fmpq(2), fmpq(0), [SLIP]),
        (fmpq(1, 2), fmpq(2), fmpq(0), [SLIP]),
        (fmpq(-2), fmpq(0), fmpq(0), [REVERSE]),
        (fmpq(-2), fmpq(-1), fmpq(0), [REVERSE]),
        (fmpq(-2), fmpq(-1), fmpq(1, 2), [SLIP, REVERSE]),
    ],
)
def test_stick_ends_only_where_a_force_of_friction_can_vanish(
    k_plus: fmpq, k_minus: fmpq, a: fmpq, phases: list[str]
) -> None:
    """(k^- - k^+) lambda^+ = k^- lambda_N + a and (k^- - k^+) lambda^- = -k^+ lambda_N - a, both > 0 for every
    lambda_N > 0: that end of stick is left out, and no other. Where none is left slip ends in stick, for certain."""
    parameters = {**PARAMETERS, "k_plus": k_plus, "k_minus": k_minus, "a": a}
    terms = ModelTerms(STICK, ("b", "Y", "V", "Z"), EPSILON, parameters, fmpq(1))
    assert [phase for phase, _ in terms.stick_ends] == phases
    expected = {SLIP: -k_plus * 6 - a, REVERSE: k_minus * 6 + a}
    for phase, function in terms.stick_ends:
        assert float_function([function])([0.0, -3.0, 1.0, -1.0, 0.0]) == [pytest.approx(approximate(expected[phase]))]
    slipping = ModelTerms(SLIP, ("b", "Y", "V", "Z", "u"), EPSILON, parameters, fmpq(1))
    (end,) = stick.events(slipping)
    assert (end.name, end.next_phase) == (("slip stops", CONTACT) if phases else ("stick", STICK))


@pytest.mark.parametrize(("phase", "shares"), [(SLIP, [6.0, 0.0]), (REVERSE, [0.0, 6.0]), (FLIGHT, [0.0, 0.0])])
def test_the_two_parts_of_the_force(phase: str, shares: list[float]) -> None:
    """lambda^+ = c lambda_N and lambda^- = (1 - c) lambda_N, c = 1 in slip and 0 in reverse slip (eq. lambda+)."""
    terms = ModelTerms(phase, ("b", "Y", "V", "Z", "u"), EPSILON, PARAMETERS, fmpq(1))
    assert float_function([terms.forward, terms.backward])([0.0, -3.0, 1.0, -1.0, 2.0, 0.0]) == shares


def test_what_is_known_of_the_model_without_coupling() -> None:
    """p = p_0 + alpha_1 epsilon T; without a belt the surface is at rest."""
    known = {name: value for name, value in PARAMETERS.items() if name != "belt_velocity"}
    terms = ModelTerms(STICK, ("b", "Y", "V", "Z"), EPSILON, known, fmpq(1, 2))
    assert float_function([terms.p, terms.u])([0.0, 0.0, 0.0, 0.0, 2.0]) == [0.5 - 3.5 / 8 * 2, 0.0]


@pytest.mark.parametrize("phase", PHASES)
def test_what_friction_supposes_of_a_mechanism(phase: str) -> None:
    """mu >= 0 and A > 0 in contact, also where no effect sees the slip velocity, and definite masses, or fields that
    have some, in flight too; nothing of a constant."""
    effects = ("compliant_contact", "lift_off", "tangential_motion", "stick")
    rough = lagrangian("rough", ["X", "H"], [[1, "1/2"], ["1/2", 1]], [3, -4], "X", "H", "1/4 + X^2")
    start = {"X": "1", "X_dot": "1"}
    for mechanism, given, names in ((rough, start, ["mu"]), (BLOCK, {"X_dot": "1"}, [])):
        system = Scene("block", effects, EPSILON, fmpq(1), {}, given, None, mechanism).system(phase)
        assert [name for name, _ in system.supposed] == ([] if phase == FLIGHT else names)
    unseen = Scene("unseen", effects[:2], EPSILON, fmpq(1), {}, start, None, rough)
    assert [name for name, _ in unseen.system(SLIP).supposed] == ["mu"]
    rates, along = ["U", "V_H", 0, -1], [0, 0, "2+X", 0]
    apart = from_fields("apart", ["X", "H", "U", "V_H"], rates, along, [0, 0, 0, 1], "X", "H", "2+X")
    unseen = Scene("unseen", effects[:2], EPSILON, fmpq(1), {}, {"X": "1", "U": "1"}, None, apart)
    fields = ["A", "A C - B^2"]
    if phase in unseen.phases():
        assert [name for name, _ in unseen.system(phase).supposed] == fields + ["mu"] * (phase != FLIGHT)


def test_what_the_absence_of_tangential_effects_means() -> None:
    """Of the paper's model u > 0 is part of what it is; of a mechanism it is a condition. x is cyclic where it is."""
    contact = ("compliant_contact", "lift_off")
    model_start = {name: START[name] for name in ("p", "b", "y", "v", "z")}
    of_model = Scene("model", contact, EPSILON, fmpq(1), {}, model_start)
    of_block = Scene("block", contact, EPSILON, fmpq(1), {}, {}, None, BLOCK)
    assert "by definition of the model system" in of_model.assumes()["tangential_motion"]
    assert of_block.assumes()["tangential_motion"] == tangential_motion.EFFECT.left_out
    assert of_model.conditional() == ()
    assert of_block.conditional() == (tangential_motion.EFFECT,)
    rough = lagrangian("rough", ["X", "H"], [[1, 0], [0, 1]], [3, -4], "X", "H", "1/4 + X^2")
    on_place = Scene("rough", contact, EPSILON, fmpq(1), {}, {"X": "1", "X_dot": "1"}, None, rough)
    meanings = [each.assumes()["tangential_place"] for each in (of_model, of_block, on_place)]
    assert [text.endswith("x is cyclic") for text in meanings] == [True, True, False]
    assert "integrated" in meanings[2]


def test_a_condition_is_asked_of_the_model_too() -> None:
    """Unless it is said that the model has it by definition."""
    assert Condition("u > 0", lambda _: ()).of_model
