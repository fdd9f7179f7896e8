"""What effects cost: against the counts of the equations themselves; effects added and dropped."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.effect_cost import EffectCost, cost_text, effect_costs
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import SceneError


def test_the_costs_of_the_extended_example() -> None:
    """p = p_0 + alpha_1 t takes two operations, p' = epsilon (alpha_1 + chi b) two more: one state and none."""
    costs = {cost.effect: cost for cost in effect_costs(load_scene("fig-varsim2"))}
    assert costs["two_way_coupling"] == EffectCost("two_way_coupling", (), 1, 0, ())
    assert costs["tangential_motion"] == EffectCost("tangential_motion", ("stick",), 1, 1, ("stick", "reverse slip"))
    assert costs["stick"].phases == ("stick", "reverse slip")
    assert costs["lift_off"] == EffectCost("lift_off", (), 0, 0, ("flight",))
    assert list(costs) == [name for name in EFFECTS if name in costs]


@pytest.mark.parametrize("name", ["rod", "extended", "fig-varsim2"])
def test_what_is_left_without_an_effect_and_what_it_costs_is_the_whole(name: str) -> None:
    whole = load_scene(name)
    for cost in effect_costs(whole):
        less = whole.with_effects(drop=(cost.effect, *cost.needing))
        system = whole.system("slip")
        assert len(less.system("slip").states) + cost.states == len(system.states)
        assert less.system("slip").operations() + cost.operations == system.operations()
        assert {*less.phases(), *cost.phases} == {*whole.phases()}


def test_what_the_start_needs_is_not_counted() -> None:
    flying = load_scene("fig-varsim1", y="1/10", v=0, z=0)
    assert effect_costs(flying) == ()
    assert cost_text(flying) == "4 states and 11 operations in slip"


def test_dropped_and_added_again_is_the_same_scene() -> None:
    whole = load_scene("fig-varsim2", chi=3, k_minus=5)
    less = whole.with_effects(drop=("stick", "tangential_motion", "two_way_coupling"))
    assert less.effects == ("compliant_contact", "lift_off")
    assert "u" not in less.start
    assert not {"chi", "k_minus"} & {*less.parameters}
    again = less.with_effects(
        add=("tangential_motion", "stick", "two_way_coupling"), u=whole.start["u"], chi=3, k_minus=5
    )
    assert again.start == whole.start
    assert {*again.effects} == {*whole.effects}
    assert again.system("slip") == whole.system("slip")


def test_a_mechanism_keeps_the_components_of_its_start() -> None:
    less = load_scene("rod").with_effects(drop=("stick", "tangential_motion"))
    assert less.start == load_scene("rod").start
    assert less.system("slip").states == ("theta", "theta_dot", "Y", "V", "Z")


def test_settings_alone_change_no_effect() -> None:
    scene = load_scene("rod")
    turned = replace(scene, effects=scene.effects[::-1])
    assert turned.with_settings(epsilon="1/10").effects == turned.effects


def test_an_effect_that_is_added_is_in_the_run() -> None:
    """Without stick the rod slips on; with it it sticks after the G-spot."""
    whole = load_scene("rod", until="37/200")
    less = whole.with_effects(drop=["stick"])
    assert "stick" not in [event.name for event in float_run(less, "LSODA", 1e-8).events]
    assert float_run(less.with_effects(add=["stick"]), "LSODA", 1e-8).events[0].name == "stick"


@pytest.mark.parametrize(
    ("add", "drop", "message"),
    [
        (("stick",), (), "effect 'stick' is in the scene already"),
        ((), ("belt",), "effect 'belt' is not in the scene; it has: compliant_contact, lift_off,"),
        ((), ("gravity",), "effect 'gravity' is not in the scene"),
        (("gravity",), (), "unknown effect 'gravity'"),
        ((), ("tangential_motion",), "effect 'stick' needs 'tangential_motion'"),
        ((), ("compliant_contact",), "effect 'lift_off' needs 'compliant_contact'"),
        (("belt", "belt"), (), "effect 'belt' is named twice"),
        (("two_way_coupling",), (), "exclude each other"),
    ],
)
def test_what_cannot_be(add: tuple[str, ...], drop: tuple[str, ...], message: str) -> None:
    with pytest.raises(SceneError) as caught:
        load_scene("rod").with_effects(add, drop)
    assert message in str(caught.value)


def test_an_effect_needs_what_it_sees_of_the_start() -> None:
    model = load_scene("fig-varsim1")
    with pytest.raises(SceneError, match="start: the state u is missing"):
        model.with_effects(add=["tangential_motion"])
    assert model.with_effects(add=["tangential_motion"], u="7/2").initial()["u"] == fmpq(7, 2)
