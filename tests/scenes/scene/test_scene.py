"""Scenes: which states and how many operations each effect costs, exact values of the equations, error messages."""

from __future__ import annotations

import pickle
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.functions.derivative import substitute
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.equations.scaled_system import ScaledSystem, operations
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.scene.file import SHIPPED, load_scene, parse_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.scene.start import check_rigid_force, check_start, first_phase, in_contact

MODEL = load_scene("fig-varsim1")
ALL = load_scene("fig-varsim2")
POINT = {"b": 0.75, "p": -0.25, "Y": -5.0, "V": 0.5, "Z": -1.5, "u": 3.0}
TIME = 750.0


def smaller(*effects: str) -> Scene:
    start = {"p": fmpq(1, 2), "nu": fmpq(1)}
    if "tangential_motion" in effects:
        start["u"] = fmpq(70)
    return Scene("test", effects, ALL.epsilon, ALL.until, {}, start)


def rates(system: ScaledSystem) -> dict[str, float]:
    values = float_function(system.right_hand_side)([*(POINT[name] for name in system.states), TIME])
    return dict(zip(system.states, values, strict=True))


@pytest.mark.parametrize(
    ("scene", "phase", "states"),
    [
        (MODEL, "slip", ("b", "Y", "V", "Z")),
        (MODEL, "flight", ("b", "Y", "V", "Z")),
        (ALL, "slip", ("b", "Y", "V", "Z", "u", "p")),
        (ALL, "stick", ("b", "Y", "V", "Z", "p")),
        (ALL, "flight", ("b", "Y", "V", "Z", "u", "p")),
    ],
)
def test_only_the_states_of_its_effects_are_integrated(scene: Scene, phase: str, states: tuple[str, ...]) -> None:
    system = scene.system(phase)
    assert system.states == states
    assert len(system.right_hand_side) == len(states)


@pytest.mark.parametrize(
    ("effects", "phase", "count"),
    [
        # lambda 2, b' 2, p 2, V' 2, Z' 3
        (("compliant_contact",), "slip", 11),
        (("compliant_contact", "lift_off"), "slip", 11),
        # Z' alone: b' is a constant, Y' and V' are states
        (("compliant_contact", "lift_off"), "flight", 1),
        # u' is a multiple of lambda
        (("compliant_contact", "tangential_motion"), "slip", 12),
        # p' takes 2, p is then a state and takes none
        (("compliant_contact", "two_way_coupling"), "slip", 11),
        (tuple(ALL.effects), "slip", 12),
    ],
)
def test_what_an_effect_costs(effects: tuple[str, ...], phase: str, count: int) -> None:
    """Operations of the right-hand side: an effect that is left out costs none."""
    assert operations(smaller(*effects).system(phase).right_hand_side) == count


def test_the_equations_of_the_paper_in_slip() -> None:
    """modelsys2 to modelsys5 and newex1, udot at a point, by hand: lambda = 3.5, epsilon = 1/1000, alpha_3 = -1/2."""
    found = rates(ALL.system("slip"))
    assert found == pytest.approx(
        {"b": 0.75e-3, "Y": 0.5, "V": 0.75 - 0.25 * 3.5, "Z": 1.5 - 3.5, "u": -3.5e-3, "p": (-1 + 0.75) * 1e-3}
    )


def test_the_equations_of_the_paper_in_stick() -> None:
    """newex2 and newex4 with c = 2/3 and p^- = 1."""
    found = rates(ALL.system("stick"))
    assert found["b"] == pytest.approx((-1 + 2 / 3 * 0.5 * 3.5) * 1e-3)
    assert found["V"] == pytest.approx(0.75 + (-0.25 * 2 / 3 + 1 / 3) * 3.5)
    slip = rates(ALL.system("slip"))
    assert (found["Y"], found["Z"], found["p"]) == (slip["Y"], slip["Z"], slip["p"])


def test_general_stiffness() -> None:
    """c z' = -k_1 z - lambda, lambda = k_2 (z - y), and the start at rest on it: all rates but b's are 0."""
    scene = MODEL.with_settings(k_1=3, k_2="1/2", damping=5)
    assert rates(scene.system("slip"))["Z"] == pytest.approx((3 * 1.5 - 0.5 * 3.5) / 5)
    start, small = scene.initial(), scene.epsilon
    state = [start["b"], start["y"] / small**2, start["v"] / small, start["z"] / small**2]
    values = float_function(scene.system("slip").right_hand_side)([*(int(x.p) / int(x.q) for x in state), 0.0])
    assert values[1:] == pytest.approx([0, 0, 0], abs=1e-12)
    assert values[0] != 0


def test_no_coupling_is_the_smaller_scene() -> None:
    """chi = 0: with p_0 + alpha_1 epsilon T in the place of p, the very same equations for the other states."""
    alone = smaller("compliant_contact").system("slip")
    coupled = smaller("compliant_contact", "two_way_coupling").with_settings(chi=0).system("slip")
    inserted: list[Expression] = [*map(Variable, range(len(alone.states))), alone.shown("p"), alone.clock]
    found = [substitute(rate, inserted) for rate in coupled.right_hand_side[:4]]
    for state in ([0.25, -2.0, 0.5, -1.0, 300.0], [-1.0, 3.0, 2.0, 0.0, 700.0]):
        assert float_function(found)(state) == float_function(alone.right_hand_side)(state)
    assert coupled.right_hand_side[4] == Constant(fmpq(-1, 1000))


def test_tangential_motion_acts_on_nothing_else() -> None:
    with_u = smaller("compliant_contact", "tangential_motion").system("slip")
    without = rates(smaller("compliant_contact").system("slip"))
    assert {name: rate for name, rate in rates(with_u).items() if name != "u"} == without


def test_the_start_is_the_paper_s() -> None:
    for beta in ("1/2", "3/2", "5/2"):
        state = paper_state(compliant_model(beta, "1e-3"), 4)
        found = load_scene("fig-varsim1", beta=beta, nu=4, epsilon="1e-3").initial()
        assert found == {name: getattr(state, name) for name in "pbyvz"}


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_scenes_have_their_names(name: str) -> None:
    assert load_scene(name).name == name


def test_a_file_of_the_user(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(TEXT, encoding="utf-8")
    assert load_scene(path).initial()["z"] == fmpq(-1, 10**6)
    assert load_scene(str(path), epsilon="1/10").epsilon == fmpq(1, 10)


TEXT = """
format = 1
name = "mine"
effects = ["compliant_contact", "lift_off"]
epsilon = 1e-3
until = 1
[start]
p = 0.5
b = -0.5
"""


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("lift_off", "lift_of", "unknown effect 'lift_of'; did you mean 'lift_off'"),
        ("lift_off", "stick", "effect 'stick' needs 'tangential_motion'"),
        ('"lift_off"', '"lift_off", "lift_off"', "effect 'lift_off' is named twice"),
        ('"compliant_contact", "lift_off"', "", "effect 'compliant_contact' is missing"),
        ("lift_off", "tangential_motion", "the state u is missing"),
        ("epsilon = 1e-3", "epsilon = 0", "epsilon must be > 0, got 0"),
        ("epsilon = 1e-3", "epsilon = -1", "epsilon must be > 0, got -1"),
        ("epsilon = 1e-3", "", '"epsilon" is missing'),
        ("epsilon = 1e-3", "epsilon = nan", "epsilon"),
        ("epsilon = 1e-3", "epsilon = 1e-999999", "epsilon"),
        ("until = 1", "until = 0", "until must be > 0"),
        ("until = 1", "untill = 1", 'unknown key "untill"; did you mean'),
        ("format = 1", "format = 2", '"format" must be 1'),
        ("b = -0.5", "", "give b or nu"),
        ("b = -0.5", "b = -0.5\nnu = 1", "give b or nu"),
        ("b = -0.5", "b = -0.5\ny = -1", "the state v is missing"),
        ("b = -0.5", "b = -0.5\nu = 1", "no state 'u'"),
        ("b = -0.5", "b = -0.5\ny = 1\nv = 0\nz = 1", "z must be <= 0"),
        ("p = 0.5", "p = -0.5", "at rest on the surface p must be > 0"),
        ("p = 0.5", "", "the state p is missing"),
        ("[start]", "[parameters]\nchi = 1\n[start]", "unknown parameter 'chi'"),
        ("[start]", "[parameters]\nk_1 = 0\n[start]", "k_1 must be > 0"),
        ("[start]", "[parameters]\nbeta = 1\n[start]\nnu = 1\n#", "start"),
        ("b = -0.5", "b = -0.5\ny = 1\nv = 0\nz = 0\n[parameters]\nk_3 = 1", "unknown parameter 'k_3'"),
        (
            "until = 1\n[start]\np = 0.5\nb = -0.5",
            "until = 1\nstop_at_force = 9\n[start]\np = -0.5\nb = -0.5\ny = 0\nv = 0\nz = 0",
            "no force of rigid slip at the start, -b/p",
        ),
        ("b = -0.5", "b = -0.5\ny = -1\nv = 0\nz = 0", "interpenetrating: y lies 1 below the surface at z = 0"),
        ("b = -0.5", "b = 0\ny = 0\nv = 0\nz = 0", "whether contact begins is open"),
        ("epsilon = 1e-3", 'epsilon = "1e-3 s"', "epsilon: '1e-3 s' has a unit (s); numbers stand without units"),
        ("p = 0.5", 'p = "500 mm"', "start: p: '500 mm' has a unit (mm)"),
        ("lift_off", "belt", "effect 'belt' needs 'stick'"),
        ("lift_off", "tangential_place", "effect 'tangential_place' needs 'tangential_motion'"),
        ("until = 1", "until = 1\nstop_at_force = 1", "stop_at_force must be > 1"),
        ("name", "[name", "no TOML"),
    ],
)
def test_errors_name_the_part(old: str, new: str, message: str) -> None:
    assert old in TEXT
    with pytest.raises((SceneError, MechanismError, ValueError)) as caught:
        parse_scene(TEXT.replace(old, new, 1))
    assert message in str(caught.value)


def test_without_lift_off_the_start_must_be_in_contact() -> None:
    text = TEXT.replace(', "lift_off"', "").replace("b = -0.5", "b = -0.5\ny = 1\nv = 0\nz = 0")
    with pytest.raises(SceneError, match="not in contact: y = 1 >= z = 0"):
        parse_scene(text)


def test_phases_and_settings_that_are_not_there() -> None:
    with pytest.raises(SceneError, match="no phase 'stick' in this scene; there are: slip, flight"):
        MODEL.system("stick")
    with pytest.raises(SceneError, match="no setting 'chi'"):
        MODEL.with_settings(chi=1)
    with pytest.raises(SceneError, match=r"no scene file 'fig-varsim'.*did you mean 'fig-varsim"):
        load_scene("fig-varsim")
    with pytest.raises(TypeError):
        MODEL.with_settings(nu=0.5)  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="at beta = 1 there is none"):
        MODEL.with_settings(beta=1)
    with pytest.raises(SceneError, match="k_minus must be > k_plus"):
        ALL.with_settings(k_minus=-1)
    with pytest.raises(SceneError, match="u must be >= 0 \\(positive slip\\) where stick is left out, got -1"):
        smaller("compliant_contact", "tangential_motion").with_settings(u=-1)


def test_epsilon_has_a_short_form() -> None:
    assert load_scene("fig-varsim1", eps="1e-5").epsilon == load_scene("fig-varsim1", epsilon="1e-5").epsilon


def names(effects: tuple[Effect, ...]) -> list[str]:
    return [effect.name for effect in effects]


@pytest.mark.parametrize(
    ("scene", "left_out", "conditional"),
    [
        (MODEL, ["tangential_motion", "stick", "tangential_place", "belt", "two_way_coupling"], []),
        (smaller("compliant_contact"), ["lift_off", "tangential_motion", "stick", "tangential_place", "belt",
         "two_way_coupling"], ["lift_off"]),
        (smaller("compliant_contact", "lift_off", "tangential_motion"), ["stick", "tangential_place", "belt",
         "two_way_coupling"], ["stick"]),
        # beside a mechanism: its u is no constant, and chi belongs to the model
        (load_scene("oscillator"), ["tangential_motion", "stick", "tangential_place"], ["tangential_motion"]),
        (load_scene("rod"), ["tangential_place", "belt"], []),
    ],
    ids=["model", "contact", "u", "oscillator", "rod"],
)  # fmt: skip
def test_what_is_left_out_and_what_that_assumes(scene: Scene, left_out: list[str], conditional: list[str]) -> None:
    assert sorted(names(scene.left_out())) == sorted(left_out)
    assert names(scene.conditional()) == conditional
    assert set(scene.assumes()) == set(left_out)
    assert all(scene.assumes().values())


def test_what_a_condition_needs_is_integrated_beside_the_rest() -> None:
    """The rod in contact: theta and its velocity; u needs X_dot too. Of a lift-off nothing more is needed."""
    made = load_scene("rod")
    start = {**made.start, "X_dot": fmpq(2)}
    rod = Scene("test", ("compliant_contact",), made.epsilon, made.until, {}, start, None, made.mechanism)
    slip, lift = EFFECTS["tangential_motion"], EFFECTS["lift_off"]
    alone = rod.system("slip")
    assert alone.states == rod.system("slip", (lift,)).states == ("theta", "theta_dot", "Y", "V", "Z")
    watched = rod.system("slip", (slip,))
    assert watched.states == ("theta", "X_dot", "theta_dot", "Y", "V", "Z")
    assert [event.left_out for event in watched.events] == ["tangential_motion"]
    assert {event.left_out for event in rod.system("slip", (lift, slip)).events} == {"lift_off", "tangential_motion"}
    assert "X_dot" in rod.scaled_initial((slip,))
    assert "X_dot" not in rod.scaled_initial((lift,))
    assert rod.system("slip") == alone  # as if nothing had been watched


def test_the_scaled_start_is_exact() -> None:
    found = MODEL.with_settings(epsilon="1/7", y="-2/9", v="3/5", z="-1/9", b=-2, p="1/3")
    assert found.scaled_initial() == {
        "p": fmpq(1, 3), "b": -2, "y": fmpq(-2, 9), "v": fmpq(3, 5), "z": fmpq(-1, 9),
        "Y": fmpq(-98, 9), "V": fmpq(21, 5), "Z": fmpq(-49, 9),
    }  # fmt: skip


def test_a_mechanism_that_cannot_be_is_none_of_a_scene() -> None:
    for settings, message in (({"m": -1}, "the mass m is -1"), ({"mu": "-1/2"}, "friction coefficient mu is -0.5: ")):
        with pytest.raises(MechanismError, match=message):
            load_scene("rod", **settings)


def test_each_setting_comes_to_its_place() -> None:
    """A number of the mechanism, one of an effect, a formula of the start; what is None stays; b and nu take turns."""
    made = load_scene("rod", mu="7/3", k_1=5, theta="theta_ref - 1/20", epsilon="1/9", until=3, theta_dot=None)
    assert made.mechanism is not None
    assert dict(made.mechanism.parameters)["mu"] == Constant(fmpq(7, 3))
    assert made.parameters["k_1"] == 5
    assert (made.start["theta"], made.epsilon, made.until) == ("theta_ref - 1/20", fmpq(1, 9), 3)
    assert made.start["theta_dot"] == load_scene("rod").start["theta_dot"]
    assert type(load_scene("rod", theta_dot=1).start["theta_dot"]) is fmpq  # a number is one, a text may be a formula
    with pytest.raises(SceneError, match="theta_dot: a number of 2001 bits"):
        load_scene("rod", theta_dot=2**2000)
    assert "nu" not in MODEL.with_settings(b=-1).start
    assert "b" not in MODEL.with_settings(b=-1).with_settings(nu=3).start
    with pytest.raises(SceneError, match="no setting 'nus'; did you mean 'nu'"):
        MODEL.with_settings(nus=3)


def test_a_start_without_rigid_slip_needs_no_force_of_it() -> None:
    """p < 0 at the start is no error where the run does not stop at a multiple of -b/p."""
    text = TEXT.replace("p = 0.5", "p = -0.5\ny = 0\nv = 0\nz = 0")
    assert parse_scene(text).initial()["p"] == fmpq(-1, 2)
    with pytest.raises(SceneError, match="no force of rigid slip"):
        parse_scene(text.replace("until = 1", "until = 1\nstop_at_force = 2"))


def test_the_velocity_of_the_surface_is_known_where_it_is_given() -> None:
    """The oscillator: a surface that moves, at a velocity which the paper does not say."""
    made = load_scene("oscillator")
    assert made.has_unknown_surface_velocity
    assert "belt_velocity" not in made.values()
    assert made.not_followed(EFFECTS["tangential_motion"]) == "the velocity of the surface is not given"
    told = made.with_settings(belt_velocity=-3)
    assert not told.has_unknown_surface_velocity
    assert told.values()["belt_velocity"] == -3
    assert told.not_followed(EFFECTS["tangential_motion"]) is None
    assert not ALL.has_unknown_surface_velocity


def test_a_scene_crosses_a_process_without_its_equations() -> None:
    """They hold functions without a name; here they were made before."""
    scene = load_scene("fig-varsim1", beta="1/2")
    assert scene.motion.states("slip") == pickle.loads(pickle.dumps(scene)).motion.states("slip")
    assert pickle.loads(pickle.dumps(scene)) == scene


# What may be a start and which phase it begins, from numbers alone: every comparison at its border and beside it.


VALUES = {"k_1": fmpq(2), "k_2": fmpq(1), "damping": fmpq(3)}
ZERO, ONE, EPSILON = fmpq(0), fmpq(1), fmpq(1, 10)
CONTACT = ("compliant_contact",)
ALL_PHASES = (SLIP, STICK, REVERSE, FLIGHT)


@dataclass
class Motion:
    """Only numbers."""

    y: fmpq = ZERO
    v: fmpq = ZERO
    z: fmpq = ZERO
    b: fmpq | arb = -ONE
    p: fmpq | arb = ONE
    u: fmpq | arb = ONE
    checked: bool = False

    def check(self, values: object) -> None:
        assert values is VALUES
        self.checked = True

    def start(self, values: object) -> dict[str, fmpq]:
        assert values
        return {"y": self.y, "v": self.v, "z": self.z}

    def normal_acceleration(self, values: object) -> fmpq | arb:
        assert values
        return self.b

    def painleve_parameter(self, values: object) -> fmpq | arb:
        assert values
        return self.p

    def slip_velocity(self, values: object) -> fmpq | arb:
        assert values
        return self.u


def contact(**numbers: object) -> bool:
    return in_contact(Motion(**numbers), VALUES, EPSILON)  # type: ignore[arg-type]


TINY = fmpq(1, 10**30)


@pytest.mark.parametrize(
    ("numbers", "expected"),
    [
        ({"y": -TINY}, True),
        ({"y": TINY}, False),
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3) - TINY}, True),
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3) + TINY}, False),
        ({"v": -TINY}, True),
        ({"v": TINY}, False),
        ({"b": -TINY}, True),
        ({"b": TINY}, False),
        ({"b": arb("[-1 +/- 0.5]")}, True),
        ({"b": arb("[1 +/- 0.5]")}, False),
        # z = -1, v = 20/3: (k_1/c)² z/ε² = -400/9
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3), "b": fmpq(-400, 9) - TINY}, True),
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3), "b": fmpq(-400, 9) + TINY}, False),
    ],
)
def test_the_first_derivative_that_is_not_zero_decides(numbers: dict[str, object], expected: bool) -> None:
    """Of Z - Y: z - y, then -(k_1/c) z/ε² - v/ε, then (k_1/c)² z/ε² - b; here k_1/c = 2/3 and ε = 1/10."""
    assert contact(**numbers) is expected


@pytest.mark.parametrize("b", [fmpq(0), arb("[0 +/- 1]"), arb("nan")])
def test_two_derivatives_that_vanish_leave_it_open(b: object) -> None:
    with pytest.raises(SceneError, match="whether contact begins is open"):
        contact(b=b)


def first(motion: Motion, phases: tuple[str, ...] = ALL_PHASES, **more: fmpq) -> str:
    return first_phase(motion, {**VALUES, **more}, EPSILON, phases)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("u", "belt", "expected"),
    [
        (TINY, 0, SLIP),
        (-TINY, 0, REVERSE),
        (fmpq(0), 0, STICK),
        (fmpq(3), 3, STICK),
        (fmpq(3), 4, REVERSE),
        (fmpq(3), -4, SLIP),
        (arb("[1 +/- 0.5]"), 0, SLIP),
        (arb(0), 0, STICK),
    ],
)
def test_the_phase_by_the_slip_velocity(u: fmpq | arb, belt: int, expected: str) -> None:
    assert first(Motion(u=u), belt_velocity=fmpq(belt)) == expected
    assert first(Motion(u=u, y=fmpq(1)), belt_velocity=fmpq(belt)) == FLIGHT
    assert first(Motion(u=u), (SLIP, FLIGHT), belt_velocity=fmpq(belt)) == SLIP
    assert first(Motion(u=u, y=fmpq(1)), (SLIP, STICK, REVERSE), belt_velocity=fmpq(belt)) == expected


def test_a_slip_velocity_around_zero_is_refused() -> None:
    with pytest.raises(SceneError, match="the sign of the slip velocity is not certain"):
        first(Motion(u=arb("[0 +/- 1]")))


def check(motion: Motion, effects: tuple[str, ...], given: tuple[str, ...] = ("y", "v", "z")) -> None:
    check_start(motion, VALUES, EPSILON, effects, dict.fromkeys(given))  # type: ignore[arg-type]
    assert motion.checked


@pytest.mark.parametrize(
    ("motion", "effects", "message"),
    [
        (Motion(z=TINY), CONTACT, "z must be <= 0"),
        (Motion(y=-EPSILON - TINY), CONTACT, "interpenetrating"),
        (Motion(y=TINY), CONTACT, "not in contact: .* lift_off is left out"),
        (Motion(u=-TINY), (*CONTACT, "tangential_motion"), "u must be >= 0 .* got -1/1"),
        (Motion(u=arb("[-2 +/- 0.5]")), (*CONTACT, "tangential_motion"), "u must be >= 0"),
    ],
)
def test_what_is_no_start(motion: Motion, effects: tuple[str, ...], message: str) -> None:
    with pytest.raises(SceneError, match=message):
        check(motion, effects)


@pytest.mark.parametrize(
    ("motion", "effects", "given"),
    [
        (Motion(), CONTACT, ("y",)),
        (Motion(y=-EPSILON), CONTACT, ("y",)),
        (Motion(y=-EPSILON - TINY), CONTACT, ()),
        (Motion(y=TINY), (*CONTACT, "lift_off"), ("y",)),
        (Motion(u=fmpq(0)), (*CONTACT, "tangential_motion"), ("y",)),
        (Motion(u=fmpq(-1)), CONTACT, ("y",)),
        (Motion(u=fmpq(-1)), (*CONTACT, "tangential_motion", "stick"), ("y",)),
    ],
)
def test_what_is_a_start(motion: Motion, effects: tuple[str, ...], given: tuple[str, ...]) -> None:
    check(motion, effects, given)


@pytest.mark.parametrize(
    ("p", "b", "good"),
    [
        (TINY, -TINY, True),
        (fmpq(0), fmpq(-1), False),
        (fmpq(1), fmpq(0), False),
        (fmpq(-1), fmpq(1), False),
        (arb("[1 +/- 2]"), fmpq(-1), False),
        (fmpq(1), arb("[-1 +/- 2]"), False),
        (arb("[1 +/- 0.5]"), arb("[-1 +/- 0.5]"), True),
    ],
)
def test_the_force_of_rigid_slip(p: fmpq | arb, b: fmpq | arb, good: bool) -> None:
    motion = Motion(p=p, b=b)
    if good:
        check_rigid_force(motion, VALUES)  # type: ignore[arg-type]
        return
    with pytest.raises(SceneError, match=r"it needs p > 0 and b < 0, got p = .*, b = "):
        check_rigid_force(motion, VALUES)  # type: ignore[arg-type]


class Liar(fmpq):
    """Below 0, and above it."""

    def __gt__(self, other: object) -> bool:
        return True

    def __le__(self, other: object) -> bool:
        return False


@pytest.mark.parametrize("name", ["epsilon", "until", "stop_at_force", "beta"])
def test_a_scene_made_by_hand_has_plain_exact_numbers(name: str) -> None:
    """Balls and floats went in unasked, and a run with a stiffness of -1 was proved."""
    good = load_scene("fig-varsim1")

    def with_number(value: Any) -> Scene:
        return replace(good, **({"parameters": {name: value}} if name == "beta" else {name: value}))

    for wrong, error, message in (
        (arb("2.5", "0.1"), ValueError, "expected one exact number, got a ball"),
        (2.5, TypeError, "a float is not taken as exact"),
    ):
        with pytest.raises(error, match=f"{name}: {message}"):
            with_number(wrong)
    made = with_number(2)
    assert type(made.parameters["beta"] if name == "beta" else getattr(made, name)) is fmpq
    if name != "beta":
        with pytest.raises(SceneError, match=f"{name} must be > "):
            with_number(Liar(-1))
    with pytest.raises(SceneError, match="k_1 must be > 0, got -1"):
        replace(good, parameters={"k_1": Liar(-1)})
