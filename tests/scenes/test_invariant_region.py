"""The region of growing force: Theorems R1 to R3 against runs, against the model's own sets, and what it must refuse.

Page: proofs/invariant_region.md.
"""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.balls import working_bits
from gspot_verified.expansion.derivative import lie_derivative
from gspot_verified.expansion.expressions import Constant, Expression, Variable
from gspot_verified.integrator.norm_run import NormRun
from gspot_verified.scenes.certified_phase import CLOCK, CertifiedPhase
from gspot_verified.scenes.file import load_scene
from gspot_verified.scenes.float_function import float_function
from gspot_verified.scenes.invariant_region import Growth, InvariantRegion
from gspot_verified.scenes.scaled_system import ScaledSystem
from gspot_verified.scenes.scene import Scene


def state(system: ScaledSystem, **values: object) -> dict[str, arb]:
    found = {name: arb(0) for name in (*system.states, CLOCK)}
    return found | {name: value if isinstance(value, arb) else arb(str(value)) for name, value in values.items()}


def deep(scene: Scene) -> dict[str, arb]:
    """p = -0.2, b = -1/10, lambda = 4, and lambda' = 2."""
    system = scene.system("slip")
    more = {"T": arb(fmpq(7, 10) / scene.epsilon)} if "p" not in system.states else {"p": "-0.2"}
    return state(system, b="-0.1", Y="-6", V="-4", Z="-2", **more)


SCENES = [
    load_scene("fig-varsim1"),
    load_scene("fig-varsim1", eps="1e-6"),
    load_scene("fig-varsim1", alpha_2=1),
    load_scene("fig-varsim2", chi=0),
    load_scene("fig-varsim2", chi=1),
    load_scene("fig-varsim1", beta="7/2"),
]


def certain(found: Growth | None) -> Growth:
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
        scene = load_scene("fig-varsim2", chi=1, eps=eps)
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
        with pytest.raises(ValueError, match="not"):
            InvariantRegion(replace(system, right_hand_side=tuple(changed)))
    for shown in (Z + Y, Y - Z, (Z - Y) * (Z - Y), Z - Y + Constant(fmpq(1))):
        with pytest.raises(ValueError, match="not"):
            InvariantRegion(replace(system, read_out=(("lambda_N", shown),)))
