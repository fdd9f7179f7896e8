"""The region of growing force: Theorems R1 to R6 against runs, against the model's own sets, and what it must refuse.

Page: proofs/invariant_region.md.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import pytest
from flint import arb, fmpq

from gspot_verified.functions.derivative import lie_derivative
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase, PhaseEnd
from gspot_verified.scenes.certified.invariant_region import ExponentialGrowth, InvariantRegion
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.contact_form import ContactForm, NotOfThisForm
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene


def state(system: ScaledSystem, **values: object) -> dict[str, arb]:
    found = {name: arb(0) for name in (*system.states, CLOCK)}
    return found | {name: value if isinstance(value, arb) else arb(str(value)) for name, value in values.items()}


def deep(scene: Scene) -> dict[str, arb]:
    """p = -0.2, b = -1/10, lambda = 4, and lambda' = 2."""
    system = scene.system("slip")
    more = {"T": arb(fmpq(7, 10) / scene.epsilon)} if "p" not in system.states else {"p": "-0.2"}
    return state(system, b="-0.1", Y="-6", V="-4", Z="-2", **more)


VARSIM1, VARSIM2 = load_scene("fig-varsim1"), load_scene("fig-varsim2")
SCENES = [
    VARSIM1,
    load_scene("fig-varsim1", epsilon="1e-6"),
    VARSIM1.with_settings(alpha_2=1),
    VARSIM2.with_settings(chi=0),
    VARSIM2.with_settings(chi=1),
    VARSIM1.with_settings(beta="7/2"),
]


def certain(found: ExponentialGrowth | None) -> ExponentialGrowth:
    assert found is not None
    return found


@pytest.mark.parametrize("scene", SCENES, ids=range(len(SCENES)))
def test_the_second_derivative_of_the_force(scene: Scene) -> None:
    """(2) of the page, by floats: lambda'' = -2 lambda' + W + G with W = -V, G = -V'."""
    chance = random.Random(1)
    system = scene.system("slip")
    size = len(system.states)
    field = [*system.right_hand_side, Constant(fmpq(1))]
    force = system.shown("lambda_N")
    rate = lie_derivative(force, field)
    second = lie_derivative(rate, field)
    shown = float_function([rate, second, system.right_hand_side[system.states.index("V")]])
    for _ in range(5):
        point = [chance.uniform(-2, 2) for _ in range(size + 1)]
        D, D2, F = shown(point)
        assert pytest.approx(-2 * D - point[system.states.index("V")] - F) == D2


@pytest.mark.parametrize("scene", SCENES, ids=range(len(SCENES)))
def test_the_force_grows_as_stated(scene: Scene) -> None:
    """A validated run from the state: lambda stays above lambda_0 exp(a T) for as long as it is promised."""
    system = scene.system("slip")
    with working_bits(128):
        found = certain(InvariantRegion(system).growth(deep(scene)))
        assert (found.until is None) is (scene.values().get("chi", 0) == 0)
        lasting = InvariantRegion(system).growth(deep(scene), limited=False)
        assert lasting is None if found.until is not None else lasting == found
        phase = CertifiedPhase(system)
        start = deep(scene)
        run = NormRun(phase.field, [start[name] for name in phase.names], arb(40))
        first = start["Z"] - start["Y"]
        for segment in run:
            at = dict(zip(phase.names, segment.states(arb(1)), strict=True))
            force = at["Z"] - at["Y"]
            assert force.is_finite()
            if found.until is not None and not force < found.until * first:
                break
            assert force > first * (found.rate * segment.end_time).exp()
            assert at["V"] < 0
        assert force > 8 * first


def test_growth_may_begin_while_the_body_neither_approaches_nor_leaves() -> None:
    """V = 0 is in the region: Z = -2 closes fast enough for the force to grow."""
    system = SCENES[0].system("slip")
    at_rest = state(system, b="-0.1", Y="-2.5", V="0", Z="-2", T=arb(fmpq(7, 10) / SCENES[0].epsilon))
    with working_bits(128):
        assert certain(InvariantRegion(system).growth(at_rest)).rate > 0


def test_the_whole_box_is_meant() -> None:
    scene = SCENES[0]
    system = scene.system("slip")
    region = InvariantRegion(system)
    with working_bits(128):
        good = deep(scene)
        assert region.growth(good) is not None
        for name, radius in (("Y", "3"), ("V", "4.1"), ("b", "5"), ("Z", "3"), (CLOCK, "300")):
            wide = {**good, name: arb(good[name].mid(), radius)}
            assert region.growth(wide) is None


@pytest.mark.parametrize(
    "changed",
    [
        {"b": "3"},  # G < 0
        {"V": "1"},  # the surface is left
        {"Z": "-7"},  # no contact
        {"V": "-1"},  # the force falls
        {CLOCK: "400"},  # p > 0
        {CLOCK: "500"},  # p = 0
        {"Y": "nan"},
    ],
)
def test_what_is_not_in_the_region(changed: dict[str, str]) -> None:
    scene = SCENES[0]
    region = InvariantRegion(scene.system("slip"))
    with working_bits(128):
        values = {**deep(scene), **{name: arb(value) for name, value in changed.items()}}
        assert region.growth(values) is None


def test_a_coupling_that_turns_p_round_bounds_the_growth() -> None:
    """chi = 1: b' = epsilon (lambda/2 - 1) turns p round; at larger epsilon less growth is promised, then none."""
    promised = []
    for eps in ("1e-6", "1e-4", "1e-3", "1e-2"):
        scene = load_scene("fig-varsim2", chi=1, epsilon=eps)
        with working_bits(128):
            found = InvariantRegion(scene.system("slip")).growth(deep(scene))
        promised.append(0 if found is None else found.until or 0)
    assert promised == sorted(promised, reverse=True)
    assert promised[0] > promised[2] > 0 == promised[3]


def test_stick_is_no_growth() -> None:
    """In stick c < 1 makes the factor of the force positive."""
    scene = load_scene("fig-varsim2")
    system = scene.system("stick")
    with working_bits(128):
        assert InvariantRegion(system).growth(state(system, b="-0.1", p="-0.2", Y="-6", V="-4", Z="-2")) is None


def test_growth_for_ever_needs_an_acceleration_affine_in_the_force() -> None:
    """V' = -1/10 - λ/5 + λ²/1000: q = 1/5 - λ/500 falls as λ grows, V' > 0 for λ > 201, and λ falls again."""
    system = SCENES[0].system("slip")
    Y, Z = Variable(1), Variable(3)
    zero, constant, slope, square = (Constant(fmpq(n, 1000)) for n in (0, -100, -200, 1))
    for curved in (False, True):
        push = slope * (Z - Y) + square * (Z - Y) * (Z - Y) if curved else slope * (Z - Y)
        rates = (zero, system.right_hand_side[1], constant + push, system.right_hand_side[3])
        with working_bits(128):
            found = certain(InvariantRegion(replace(system, right_hand_side=rates)).growth(deep(SCENES[0])))
        assert (found.until is None) is not curved
        assert found.until is None or found.until * 4 < 201


def test_other_equations_are_refused() -> None:
    system = SCENES[0].system("slip")
    b, Y, V, Z = (Variable(i) for i in range(4))
    rates = list(system.right_hand_side)
    others: list[list[Expression]] = [
        [rates[0], V * V, rates[2], rates[3]],
        [rates[0], rates[1], rates[2] + Z, rates[3]],
        [rates[0] + Z, rates[1], rates[2], rates[3]],
        [rates[0], rates[1], rates[2], rates[3] * Z],
        [rates[0], rates[1], rates[2], rates[3] + b],
        [rates[0], rates[1], rates[2], -rates[3]],
    ]
    for changed in others:
        with pytest.raises(NotOfThisForm, match="not"):
            InvariantRegion(replace(system, right_hand_side=tuple(changed)))
    for shown in (Z + Y, Y - Z, (Z - Y) * (Z - Y), Z - Y + Constant(fmpq(1))):
        with pytest.raises(NotOfThisForm, match="not"):
            InvariantRegion(replace(system, read_out=(("lambda_N", shown),)))


@cache
def with_surface(epsilon: str = "1e-4", velocity: int = -1, **settings: object) -> Scene:
    """The oscillator on a surface that moves, so that slip can stop."""
    scene = load_scene("oscillator", epsilon=epsilon, **settings)
    effects = (*scene.effects, "tangential_motion", "stick")
    return replace(scene, effects=effects, parameters={**scene.parameters, "belt_velocity": fmpq(velocity)})


MECHANISMS = [
    (with_surface(), {"phi": "-0.03", "phi_dot": "-1.2", "Y": "-48.4", "V": "-3.2", "Z": "-23.4"}),
    (load_scene("oscillator", epsilon="1e-5"), {"phi": "-0.01", "phi_dot": "-1", "Y": "-52", "V": "-0.3", "Z": "-26"}),
    (
        load_scene("rod", epsilon="1e-4"),
        {"theta": "0.02", "theta_dot": "1", "X_dot": "2", "Y": "-70", "V": "-5", "Z": "-34"},
    ),
    (
        load_scene("extended", epsilon="1e-4"),
        {"p": "-0.02", "b": "-0.1", "u": "0.5", "Y": "-47.9", "V": "-4.6", "Z": "-22.9"},
    ),
    (
        load_scene("extended", epsilon="1e-4", alpha_3=2),
        {"p": "-0.1", "b": "-1", "u": "3", "Y": "-60", "V": "-9", "Z": "-29"},
    ),
]


@pytest.mark.parametrize(("scene", "values"), MECHANISMS, ids=range(len(MECHANISMS)))
def test_a_mechanism_does_what_is_stated(scene: Scene, values: dict[str, str]) -> None:
    """A validated run from the state: λ >= λ_0 exp(aT) until it is so many times as large, or until slip stops, which
    it does in the time that is stated."""
    system = scene.system("slip")
    with working_bits(128):
        start = state(system, **values)
        found = certain(InvariantRegion(system).growth(start))
        assert found.until is not None or found.within is not None
        phase = CertifiedPhase(system)
        first, largest = start["Z"] - start["Y"], arb(1)

        def observer(segment: object, at: Mapping[str, arb]) -> bool:
            nonlocal largest
            largest = (at["Z"] - at["Y"]) / first
            assert largest.is_finite()
            if found.until is not None and not largest < found.until:
                return True
            assert largest > (found.rate * segment.end_time).exp()  # type: ignore[attr-defined]
            return False

        time = arb(5000) if found.within is None else found.within
        end = phase.run(start, time, {}, observer)
        assert isinstance(end, PhaseEnd)
        if found.until is None:
            assert end.event is not None
            assert end.event.name in ("stick", "slip stops")
        else:
            assert largest > found.until / 2


@pytest.mark.parametrize(
    ("scene", "changed"),
    [
        (with_surface(), {"phi": "0.02"}),  # p > 0
        (with_surface(), {"phi": "-0.29"}),  # p > 0 on the other side
        (with_surface(), {"phi": "[-0.02 +/- 0.03]"}),  # p changes its sign
        (with_surface(), {"phi_dot": "-3"}),  # u < 0: not a state of this phase, V' > 0
        (with_surface(), {"Z": "-47"}),  # no contact
        (with_surface(), {"V": "3"}),
        (with_surface(), {"V": "-1"}),  # D < 0
        (with_surface(), {"phi_dot": "-12"}),  # b turns positive
        (with_surface(), {"phi_dot": "nan"}),
        (with_surface(epsilon="1/10"), {}),  # the configuration moves on while the force grows
    ],
)
def test_what_a_mechanism_is_not_told(scene: Scene, changed: dict[str, str]) -> None:
    system = scene.system("slip")
    with working_bits(128):
        good = MECHANISMS[0][1]
        assert InvariantRegion(with_surface().system("slip")).growth(state(system, **good)) is not None
        assert InvariantRegion(system).growth(state(system, **{**good, **changed})) is None


def test_slip_that_the_force_speeds_up_stops_nothing() -> None:
    """Theorem R6 needs a slip velocity that falls with the force: with k^+ > 0 only so many times are promised."""
    scene = load_scene("fig-varsim2", chi=1, epsilon="1e-6")
    values = {"b": "-0.1", "p": "-0.2", "u": "0.01", "Y": "-6", "V": "-4", "Z": "-2"}
    for k_plus, stops in (("-1", True), ("1", False), ("0", False)):
        system = scene.with_settings(k_plus=k_plus).system("slip")
        with working_bits(128):
            found = certain(InvariantRegion(system).growth(state(system, **values)))
        assert (found.within is not None) is stops
        assert (found.until is None) is stops


def test_a_promise_to_stop_is_kept_by_the_slip_velocity() -> None:
    """The larger u, the later; so large that b turns p round before: no such promise."""
    scene = load_scene("fig-varsim2", chi=1, epsilon="1e-4")
    system, times = scene.system("slip"), []
    with working_bits(128):
        region = InvariantRegion(system)
        for u in ("0.01", "0.1", "1", "100"):
            found = region.growth(state(system, b="-0.1", p="-0.2", u=u, Y="-6", V="-4", Z="-2"))
            times.append(None if found is None or found.within is None else float(found.within.mid()))
    assert times[3] is None
    known = [time for time in times[:3] if time is not None]
    assert len(known) == 3
    assert known == sorted(known)


@pytest.mark.parametrize(
    "scene",
    [load_scene("fig-varsim1", k_1=2, k_2="1/3", damping=5), load_scene("rod", epsilon="1e-2")],
    ids=["model", "rod"],
)
def test_the_second_derivative_with_any_stiffness(scene: Scene) -> None:
    """(2) of the page with κ = k_1/c, γ = 1/c, k = k_2: λ'' = -sλ' + k(κW + G), by floats."""
    system, chance = scene.system("slip"), random.Random(3)
    form = ContactForm(system)
    values = scene.values()
    assert (form.k, form.kappa, form.gamma) == (
        values["k_2"], values["k_1"] / values["damping"], 1 / values["damping"],
    )  # fmt: skip
    field = [*system.right_hand_side, Constant(fmpq(1))]
    rate = lie_derivative(system.shown("lambda_N"), field)
    V = system.states.index("V")
    shown = float_function([rate, lie_derivative(rate, field), system.right_hand_side[V]])
    k, kappa, s = (approximate(x) for x in (form.k, form.kappa, form.s))
    for _ in range(5):
        point = [chance.uniform(-1, 1) for _ in range(len(system.states) + 1)]
        D, D2, F = shown(point)
        assert pytest.approx(-s * D + k * (-kappa * point[V] - F), rel=1e-9) == D2
