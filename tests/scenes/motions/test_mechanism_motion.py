"""Mechanisms in scenes: states and operations, the equations against second routes, what is refused."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified.functions.derivative import lie_derivative
from gspot_verified.functions.expressions import Constant, Expression, Variable, in_order
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.derive.lie_derivatives import derive
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.certified_phases import CertifiedPhases
from gspot_verified.scenes.equations.scaled_system import operations
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene, parse_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError

CONTACT = ("compliant_contact", "lift_off")
STICK = (*CONTACT, "tangential_motion", "stick")
EPSILON = fmpq(1, 1000)
STARTS = {
    "oscillator": {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"},
    "rod": {"theta": "theta_ref - 1/10", "theta_dot": "1/2", "X_dot": "2", "X": "0"},
    "extended": {"p": "1/2", "b": "-1", "u": "70", "x": "0"},
    "model": {"p": "1/2", "b": "-1", "u": "70", "x": "0"},
}


def scene(mechanism: str | Mechanism, effects: Sequence[str] = CONTACT, **start: str) -> Scene:
    made = shipped_mechanism(mechanism) if isinstance(mechanism, str) else mechanism
    given = start or STARTS[str(mechanism)]
    return Scene("test", tuple(effects), EPSILON, fmpq(1), {}, dict(given), None, made)


@pytest.mark.parametrize(
    ("mechanism", "effects", "phase", "states", "count"),
    [
        ("oscillator", CONTACT, "slip", ("phi", "phi_dot"), 62),
        ("oscillator", CONTACT, "flight", ("phi", "phi_dot"), 42),
        # u is a function of the states that are there already
        ("oscillator", STICK, "slip", ("phi", "phi_dot"), 62),
        # X and X_dot are cyclic
        ("rod", CONTACT, "slip", ("theta", "theta_dot"), 27),
        ("rod", CONTACT, "flight", ("theta", "theta_dot"), 10),
        ("rod", (*CONTACT, "tangential_motion"), "slip", ("theta", "X_dot", "theta_dot"), 28),
        ("rod", (*CONTACT, "tangential_motion", "tangential_place"), "slip", ("X", "theta", "X_dot", "theta_dot"), 29),
        # p has a constant rate: known, as in the model scene
        ("model", CONTACT, "slip", ("b",), 14),
        ("extended", CONTACT, "slip", ("p", "b"), 14),
        ("extended", (*CONTACT, "tangential_motion"), "slip", ("u", "p", "b"), 15),
    ],
)
def test_states_and_operations(
    mechanism: str, effects: Sequence[str], phase: str, states: tuple[str, ...], count: int
) -> None:
    system = scene(mechanism, effects).system(phase)
    assert system.states == (*states, "Y", "V", "Z")
    assert operations(system.right_hand_side) == count


@pytest.mark.parametrize("mechanism", ["oscillator", "rod", "extended"])
@pytest.mark.parametrize("phase", ["slip", "reverse slip", "stick", "flight"])
def test_the_equations_against_sympy(mechanism: str, phase: str) -> None:
    """At a point: dxi/dt = F + G_T lambda_T + G_N lambda_N, dv/dt = b + B lambda_T + C lambda_N, derived by sympy."""
    import sympy

    made = scene(mechanism, (*STICK, "tangential_place"))
    system = made.system(phase)
    point = {name: 0.31 - 0.17 * i for i, name in enumerate(system.states)}
    given = float_function(system.right_hand_side)([*point.values(), 0.0])
    rates = dict(zip(system.states, given, strict=True))
    assert made.mechanism is not None
    f = derive(made.mechanism)
    names = {name: sympy.Symbol(name) for name in made.mechanism.state}
    references = {
        angle.coordinate: sympy.atan2(sympy.Rational(str(angle.sine)), sympy.Rational(str(angle.cosine)))
        for angle in made.mechanism.angles
    }
    extra = {sympy.Symbol(f"{name}_ref"): value for name, value in references.items()}
    values = {names[n]: point[n] + references.get(n, 0) for n in made.motion.states(phase)}
    small = 1e-3
    for function, value in ((f.y, small**2 * point["Y"]), (f.v, small * point["V"])):
        equation = sympy.sympify(function).subs(extra).subs(values) - value
        unknown = {"Y", "Y_dot", "psi", "psi_dot", "y", "v"} & {str(symbol) for symbol in equation.free_symbols}
        (name,) = unknown
        values[names[name]] = sympy.solve(equation, names[name])[0]

    def at(function: object) -> float:
        return float(sympy.sympify(function).subs(extra).subs(values))

    force = 0.0 if phase == "flight" else point["Z"] - point["Y"]
    friction = {
        "slip": -at(f.mu) * force,
        "reverse slip": at(f.mu) * force,
        "stick": -(at(f.a) + at(f.B) * force) / at(f.A),
        "flight": 0.0,
    }[phase]
    assert rates["V"] == pytest.approx(at(f.b) + at(f.B) * friction + at(f.C) * force)
    for i, name in enumerate(made.mechanism.state):
        if name in made.motion.states(phase):
            expected = at(f.F[i]) + at(f.G_T[i]) * friction + at(f.G_N[i]) * force
            assert rates[name] == pytest.approx(small * expected), name
    shown = dict(
        zip(
            (n for n, _ in system.read_out),
            float_function([e for _, e in system.read_out])([*point.values(), 0.0]),
            strict=True,
        )
    )
    for name in "pbux":
        assert shown[name] == pytest.approx(at(getattr(f, name))), name


@pytest.mark.parametrize("mechanism", ["oscillator", "rod", "extended"])
def test_at_the_g_spot_it_is_what_classify_says(mechanism: str) -> None:
    """p = b = 0 there, and along the scaled equations p' = epsilon alpha_1, b' = epsilon (alpha_2 - alpha_3 lambda)."""
    found = classify(shipped_mechanism(mechanism))
    system = scene(mechanism).system("slip")
    spot = {"phi": 0, "phi_dot": -1, "theta": 0, "theta_dot": 1, "p": 0, "b": 0}
    spot |= {"Y": 0, "V": 0, "Z": fmpq(7, 2)}
    p, b = system.shown("p"), system.shown("b")
    rates = [lie_derivative(function, [*system.right_hand_side, Constant(fmpq(1))]) for function in (p, b)]
    values = float_function([p, b, *rates])([*(approximate(fmpq(spot[name])) for name in system.states), 0.0])
    first, second, third = (approximate(alpha) for alpha in (found.alpha_1, found.alpha_2, found.alpha_3))
    assert values == pytest.approx([0, 0, 1e-3 * first, 1e-3 * (second - third * 3.5)], rel=1e-12, abs=1e-15)


def test_the_mechanism_extended_is_the_extended_model_scene() -> None:
    """Two ways to write the same system, in every phase: the fields of Sec. 2, and the model with its effects."""
    effects = (*STICK, "tangential_place")
    coupled = Scene(
        "test",
        (*effects, "two_way_coupling"),
        EPSILON,
        fmpq(1),
        {},
        {n: fmpq(v) if "/" not in v else fmpq(1, 2) for n, v in STARTS["extended"].items()},
    )
    alone = scene("extended", effects)
    for phase in alone.phases():
        one, other = coupled.system(phase), alone.system(phase)
        point = {"p": -0.25, "b": 0.75, "Y": -5.0, "V": 0.5, "Z": -1.5, "u": 0.0 if phase == "stick" else 3.0, "x": 2.0}
        first = dict(
            zip(one.states, float_function(one.right_hand_side)([*(point[n] for n in one.states), 0.0]), strict=True)
        )
        second = dict(
            zip(
                other.states,
                float_function(other.right_hand_side)([*(point[n] for n in other.states), 0.0]),
                strict=True,
            )
        )
        if phase == "stick":
            assert second.pop("u") == pytest.approx(0, abs=1e-15)
        assert second == pytest.approx(first), phase


def test_zero_strength_is_the_smaller_scene() -> None:
    """A belt at rest changes no expression; seeing u changes none of the equations without it."""
    belt, without = scene("rod", (*STICK, "belt")), scene("rod", STICK)
    for phase in without.phases():
        assert belt.system(phase) == without.system(phase)
    small, large = scene("oscillator").system("slip"), scene("oscillator", STICK).system("slip")
    assert small.right_hand_side == large.right_hand_side
    assert set(small.read_out) < set(large.read_out)


def test_a_belt_is_another_frame() -> None:
    """The extended system in a frame that moves with the belt: u less by 3, the belt at rest, the same events."""
    moving = load_scene("fig-varsim2", chi=0, epsilon="1/50")
    moving = Scene("test", (*moving.effects, "belt"), moving.epsilon, moving.until,
                   {**moving.parameters, "belt_velocity": fmpq(3)}, {**moving.start, "u": fmpq(73)})  # fmt: skip
    seen = [(e.name, approximate(e.lower)) for e in float_run(moving).events]
    still = [(e.name, approximate(e.lower)) for e in float_run(load_scene("fig-varsim2", chi=0, epsilon="1/50")).events]
    assert [name for name, _ in seen] == [name for name, _ in still]
    assert [time for _, time in seen] == pytest.approx([time for _, time in still], abs=1e-7)


@pytest.mark.parametrize("name", ["rod", "oscillator"])
def test_before_the_g_spot_runs_follow_the_certified_rigid_slip(name: str) -> None:
    """At small epsilon, once the first oscillations have died out: p and b of ``approach`` at the same time."""
    start = {word: value for word, value in STARTS[name].items() if "X" not in word}
    slip = approach(shipped_mechanism(name), {**start, **({"X": 0, "X_dot": 2} if name == "rod" else {})}).path
    run = float_run(load_scene(name, epsilon="1e-4", until="1/15"), "LSODA", 1e-6)
    assert run.samples is not None
    times, columns = run.samples.columns["t"], run.samples.columns
    import numpy as np

    at = [i for i, time in enumerate(slip.time) if 0.03 < approximate(time) < 0.065]
    assert len(at) >= 2
    for i in at:
        for word, value in (("p", slip.p[i]), ("b", slip.b[i])):
            assert np.interp(approximate(slip.time[i]), times, columns[word]) == pytest.approx(
                approximate(value), abs=2e-4
            )


def test_slip_may_go_on_backwards() -> None:
    """A block that a force pulls backwards stops, and slips the other way where friction is too weak, else sticks."""
    for mu, expected in (("1/4", "slip backwards"), ("3/4", "stick")):
        block = lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], ["-1/2", -1], "X", "Y", mu)
        made = Scene(
            "test",
            STICK,
            fmpq(1, 100),
            fmpq(2),
            {},
            {"X_dot": "1", "y": "-2/10000", "z": "-1/10000", "v": "0"},
            None,
            block,
        )
        run = float_run(made)
        assert [event.name for event in run.events] == [expected]
        assert approximate(run.events[0].lower) == pytest.approx(1 / (0.5 + float(fmpq_of(mu))))
        assert run.samples is not None
        rest = 2 - approximate(run.events[0].lower)
        last = -(0.5 - 0.25) * rest if expected == "slip backwards" else 0.0
        assert run.samples.columns["u"][-1] == pytest.approx(last, abs=1e-8)


def fmpq_of(text: str) -> float:
    numerator, denominator = text.split("/")
    return int(numerator) / int(denominator)


def test_time_is_known_and_not_integrated() -> None:
    block = lagrangian("shaken", ["X", "Y"], [[1, 0], [0, 1]], ["sin(t)", "-1 - cos(2*t)/4"], "X", "Y", "1/3", time="t")
    system = scene(block, X="0").system("slip")
    assert system.states == ("Y", "V", "Z")
    rate = float_function(system.right_hand_side)([-1.0, 0.0, 0.0, 500.0])
    import math

    assert rate[1] == pytest.approx(-1 - math.cos(1.0) / 4 + 1.0)


def test_numbers_that_are_not_rational_are_balls_of_the_precision_in_force() -> None:
    made = load_scene("oscillator")
    bent = lagrangian("bent", ["X", "Y"], [[1, 0], [0, 1]], [0, "-sqrt(2) + pi"], "X", "Y", "1/3")
    other = Scene("test", CONTACT, EPSILON, fmpq(1), {}, {"y": "-1/1000000", "z": "0", "v": "0"}, None, bent)
    for bits in (60, 300):
        with working_bits(bits):
            (found,) = [
                n.value
                for n in in_order(other.system("slip").right_hand_side)
                if isinstance(n, Constant) and not isinstance(n.value, fmpq)
            ][:1]
        assert bits - 20 < found.rel_accuracy_bits() <= bits + 20
    assert all(
        isinstance(n.value, fmpq) for n in in_order(made.system("slip").right_hand_side) if isinstance(n, Constant)
    )


LEVER = {"name": "lever", "coordinates": ["a_1", "a_2"], "mass_matrix": [[2, 0], [0, 2]], "forces": [0, 0]}


@pytest.mark.parametrize(
    ("mechanism", "start", "message"),
    [
        (
            lagrangian(x="cos(a_1) + cos(a_2)", y="sin(a_1) + sin(a_2)", mu=1, **LEVER),  # type: ignore[arg-type]
            {"a_1": "0"},
            "start: y and v determine 2 components of a_1, a_2, a_1_dot, a_2_dot: give all others; left out: a_2, a_1_",
        ),
        (
            lagrangian("pulley", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], "X", "Y", 0, constraints=["X"]),
            {"X": "0"},
            "start: y, v and the constraints determine 4 components of X, Y, X_dot, Y_dot: give all others; left out:",
        ),
        (
            from_fields("clash", ["h", "w", "p"], ["w", "p", 0], [0, 0, 0], [0, 1, 0], 0, "h", 0),
            {"p": "1"},
            "clash: scenes use the name 'p'; give this component another",
        ),
        (shipped_mechanism("oscillator"), {"phi": "phi_ref"}, "start: the state phi_dot is missing"),
        (shipped_mechanism("oscillator"), {"phi": "1", "phi_dot": "0"}, "every component must be a rational number"),
        (
            shipped_mechanism("oscillator"),
            {"phi": "phi_ref", "phi_dot": "0", "psi": "0"},
            "psi follows from y in this scene",
        ),
        (
            shipped_mechanism("oscillator"),
            {"phi": "phi_ref", "phi_dot": "0", "u": "0"},
            "this scene has no state 'u'; give phi",
        ),
        (shipped_mechanism("oscillator"), {"phi": "phi_ref", "phi_dot": "0", "y": "0"}, "the state v is missing"),
        (shipped_mechanism("oscillator"), {"phi": "phi_ref +", "phi_dot": "0"}, "phi"),
        (
            shipped_mechanism("falling rod", m=-1),
            STARTS["rod"],
            "the mass m is -1: it must not be negative",
        ),
        (shipped_mechanism("oscillator", mu=None), STARTS["oscillator"], "parameters without a value: mu"),
    ],
)
def test_what_is_refused(mechanism: Mechanism, start: dict[str, str], message: str) -> None:
    with pytest.raises((SceneError, MechanismError)) as caught:
        Scene("test", CONTACT, EPSILON, fmpq(1), {}, start, None, mechanism)
    assert message in str(caught.value)


def test_effects_that_have_no_place_beside_a_mechanism() -> None:
    with pytest.raises(
        SceneError, match="'two_way_coupling' and a mechanism exclude each other: chi belongs to the model"
    ):
        scene("extended", (*CONTACT, "two_way_coupling"))
    with pytest.raises(SceneError, match="no setting 'nu'"):
        scene("extended").with_settings(nu=1)
    rolling = lagrangian("rolling", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], None, "Y", 0, slip_velocity="X_dot - 1")
    with pytest.raises(SceneError, match="'tangential_place' needs x; it gives a slip velocity"):
        Scene(
            "test",
            (*CONTACT, "tangential_motion", "tangential_place"),
            EPSILON,
            fmpq(1),
            {},
            {"X_dot": "2"},
            None,
            rolling,
        )
    with pytest.raises(SceneError, match=r"u must be >= 0 .* got \[-0.465"):
        scene("oscillator", (*CONTACT, "tangential_motion"))


def test_settings_of_the_mechanism_and_of_effects_meet_in_one_list() -> None:
    made = load_scene("oscillator", kappa="1/2", phi_dot="-1/2", k_1=3)
    assert made.mechanism is not None
    assert dict(made.mechanism.parameters)["kappa"] == Constant(fmpq(1, 2))
    assert made.initial()["phi_dot"] == fmpq(-1, 2)
    assert made.values()["k_1"] == 3
    own = lagrangian("own", ["X", "Y"], [[1, 0], [0, 1]], [0, "-k_1"], "X", "Y", 0, {"k_1": 1})
    with pytest.raises(SceneError, match="'k_1' is one of the mechanism and of an effect"):
        scene(own, X="0").with_settings(k_1=2)


def test_a_setting_of_an_effect_that_is_added_is_no_parameter_of_the_mechanism() -> None:
    """The belt's velocity, which the mechanism's force is called too: it was the force that changed."""
    own = lagrangian("own", ["X", "Y"], [[1, 0], [0, 1]], ["belt_velocity", -1], "X", "Y", 0, {"belt_velocity": 1})
    slipping = scene(own, (*CONTACT, "tangential_motion", "stick"), X_dot="1")
    pushed = slipping.with_settings(belt_velocity=2).mechanism
    assert pushed is not None
    assert dict(pushed.parameters)["belt_velocity"] == Constant(fmpq(2))
    with pytest.raises(SceneError, match="'belt_velocity' is one of the mechanism and of an effect"):
        slipping.with_effects(("belt",), belt_velocity=2)


@pytest.mark.parametrize("name", ["eps", "until", "k_1"])
def test_a_component_with_the_name_of_a_setting_is_not_set_beside_it(name: str) -> None:
    own = lagrangian("own", [name, "Y"], [[1, 0], [0, 1]], [0, -1], name, "Y", 0)
    made = scene(own, **{f"{name}_dot": "1"})
    with pytest.raises(SceneError, match=f"'{name}' is a component of own and a setting of this scene"):
        made.with_settings(**{name: "1/2"})


def test_the_compliance_is_that_of_the_mechanism() -> None:
    stiff = lagrangian(
        "stiff", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], "X", "Y", 0, regularisation={"k_1": 2, "k_2": 3, "c": 5}
    )
    made = scene(stiff, X="0")
    assert [made.values()[name] for name in ("k_1", "k_2", "damping")] == [2, 3, 5]
    assert float_function(made.system("slip").right_hand_side)([-1.0, 0.0, -0.5, 0.0])[2] == pytest.approx(
        (2 * 0.5 - 3 * 0.5) / 5
    )


def test_a_scene_file_with_a_mechanism_file(tmp_path: Path) -> None:
    block = 'format = 1\nname = "block"\n[parameters]\ng = 1\n[lagrangian]\ncoordinates = ["X", "Y"]\n'
    block += 'mass_matrix = [[1, 0], [0, 1]]\nforces = [0, "-g"]\n[contact]\nx = "X"\ny = "Y"\nmu = 0\n'
    (tmp_path / "block.toml").write_text(block, encoding="utf-8")
    text = ('format = 1\nname = "mine"\nmechanism = "block.toml"\neffects = ["compliant_contact"]\nepsilon = 1e-2\n'
            "until = 1\n[parameters]\ng = 2\n")  # fmt: skip
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    made = load_scene(tmp_path / "mine.toml")
    assert float_function(made.system("slip").right_hand_side)([0.0, 0.0, 0.0, 0.0]) == [0.0, -2.0, 0.0]
    with pytest.raises(SceneError, match=r"there is no file 'block\.toml'"):
        parse_scene(text, tmp_path / "elsewhere")


@pytest.mark.parametrize(("names", "clash"), [(("h", "w", "y", "v"), "y"), (("h", "y", "v", "b"), "y"),
                                              (("h", "w", "p", "z"), "z")])  # fmt: skip
def test_names_that_clash_are_told_before_the_start_is_read(names: Sequence[str], clash: str) -> None:
    """The gap is h here; a component y was read as the gap, and "the state z is missing" was said."""
    h, w, p, b = names
    system = from_fields(
        name="h", state=["x", "u", h, w, p, b], F=["u", 0, w, b, -1, -1],
        G_T=[0, f"3/(2*(1 - {p}))", 0, "1/2", 0, f"-3/(4*(1 - {p}))"],
        G_N=[0, "1/2", 0, f"(1 + {p})/2", 0, "3/4"], x="x", y=h, mu=f"1 - {p}",
    )  # fmt: skip
    with pytest.raises(SceneError, match=f"h: scenes use the name '{clash}'; give this component another"):
        scene(system, u="1", x="0", **{p: "1/2", b: "-1"})


def variables_of(function: Expression) -> set[int]:
    return {node.index for node in in_order([function]) if isinstance(node, Variable)}


def test_the_equations_of_a_mechanism_are_autonomous() -> None:
    for name in ("oscillator", "rod", "extended"):
        for phase in (made := scene(name, STICK)).phases():
            system = made.system(phase)
            assert all(max(variables_of(rate), default=0) < len(system.states) for rate in system.right_hand_side)


def test_what_is_no_phase_is_refused() -> None:
    """Checks that stand with optimisation, too, where assert statements are left out."""
    motion = load_scene("rod").motion
    with pytest.raises(ValueError, match="phase: expected one of"):
        motion.states("rest")
    with pytest.raises(ValueError, match="values: expected the constants"):
        motion.start({})
    with pytest.raises(ValueError, match="touch-down ends a flight, not the phase slip"):
        CertifiedPhases(load_scene("rod"))._touching("slip", {})


@pytest.mark.parametrize("name", ["phase", "q_radius", "lambda_N", "t"])
def test_a_component_with_the_name_of_a_column_of_samples_is_refused(name: str) -> None:
    """Beside the columns of samples stand their phases and, of a certified run, their radii."""

    def named(word: str) -> Scene:
        turns = lagrangian("turns", [word, "Y"], [[1, 0], [0, 1]], [0, f"-1 - cos({word})/4"], word, "Y", "1/3")
        return Scene("test", CONTACT, EPSILON, fmpq(1), {}, {word: "0", f"{word}_dot": "1"}, None, turns)

    assert named("radius").system("slip").states[0] == "radius"
    with pytest.raises(SceneError, match=f"^turns: scenes use the name '{name}'; give this component another$"):
        named(name)


def test_components_are_integrated_in_the_order_of_the_state() -> None:
    """Three of ten, the second, seventh and ninth."""
    mass = [[int(i == j) for j in range(5)] for i in range(5)]
    forces = [0, "-r", 0, "-w_dot", "-1 - r/4 - w_dot/4"]
    many = lagrangian("many", ["q", "r", "s", "w", "h"], mass, forces, "q", "h", "1/3")
    start = dict.fromkeys(("q", "r", "s", "w", "r_dot", "s_dot", "w_dot"), "0") | {"q_dot": "1"}
    system = Scene("test", CONTACT, EPSILON, fmpq(1), {}, start, None, many).system("slip")
    assert system.states == ("r", "r_dot", "w_dot", "Y", "V", "Z")
    rates = float_function(system.right_hand_side)([1.0, 2.0, 3.0, -1.0, 0.0, 0.0, 0.0])
    assert rates[:3] == pytest.approx([2e-3, -1e-3, -3e-3])
    assert rates[4] == pytest.approx(-1 - 1 / 4 - 3 / 4 + 1)


@pytest.mark.parametrize("phase", ["slip", "flight"])
def test_forces_that_depend_on_the_height_and_its_rate_have_their_units(phase: str) -> None:
    """epsilon = 1/2: v' = -1 - 5 y - 7 v + lambda with y = Y/4 and v = V/2."""
    soft = lagrangian("soft", ["X", "H"], [[1, 0], [0, 1]], [0, "-1 - 5*H - 7*H_dot"], "X", "H", 0)
    made = Scene("test", CONTACT, fmpq(1, 2), fmpq(1), {}, {"X": "0", "X_dot": "1"}, None, soft)
    system = made.system(phase)
    assert system.states == ("Y", "V", "Z")
    force = 2.0 if phase == "slip" else 0.0
    rates = float_function(system.right_hand_side)([-3.0, 0.5, -1.0, 0.0])
    assert rates == pytest.approx([0.5, -1 + 15 / 4 - 7 / 4 + force, 1.0 - force])
    assert float_function([system.shown("b")])([-3.0, 0.5, -1.0, 0.0]) == pytest.approx([-1 + 15 / 4 - 7 / 4])


@pytest.mark.parametrize(
    ("forces", "x", "depends"),
    [
        ([0, -1], "X", False),
        ([0, -1], "2*X + 1", False),
        ([0, "-1 - X"], "X", True),  # a force that the place changes
        ([0, -1], "X + X^2", True),  # no constant slope
        ([0, -1], "sin(H)", True),
        ([0, -1], None, True),  # nothing is said of the place
    ],
)
def test_whether_the_place_along_the_surface_matters(forces: list[str | int], x: str | None, depends: bool) -> None:
    start = {"X": "0", "X_dot": "1"}
    slips = {} if x is not None else {"slip_velocity": "X_dot"}
    made = lagrangian("block", ["X", "H"], [[1, 0], [0, 1]], forces, x, "H", 0, **slips)  # type: ignore[arg-type]
    assert Scene("test", CONTACT, EPSILON, fmpq(1), {}, start, None, made).motion.depends_on_place is depends
