"""What each effect of a scene costs: states, operations and phases more than without it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.scenes.equations.terms import SLIP
from gspot_verified.scenes.scene.scene import Scene, SceneError


@dataclass(frozen=True)
class EffectCost(NoTruthValue, Written):
    """``states`` and ``operations`` of the right-hand side in slip, and ``phases``, that ``effect`` brings; together
    with ``needing``, the effects of the scene that cannot be without it."""

    ask: ClassVar[str] = ".operations says what it costs"
    written: ClassVar[str] = "effect needing states operations phases"

    effect: str
    needing: tuple[str, ...]
    states: int
    operations: int
    phases: tuple[str, ...]

    def __str__(self) -> str:
        together = f" with {', '.join(self.needing)}" if self.needing else ""
        opened = f", the phases {', '.join(self.phases)}" if len(self.phases) > 1 else ""
        opened = f", the phase {self.phases[0]}" if len(self.phases) == 1 else opened
        return (
            f"{self.effect}{together}: {counted(self.states, 'state')}, {counted(self.operations, 'operation')}{opened}"
        )


def effect_costs(scene: Scene) -> tuple[EffectCost, ...]:
    """For each effect that can be dropped what it brings, in the order of the catalogue.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> for cost in effect_costs(load_scene("rod")):
    ...     print(cost)
    lift_off: 0 states, 0 operations, the phase flight
    tangential_motion with stick: one state, one operation, the phases stick, reverse slip
    stick: 0 states, 0 operations, the phases stick, reverse slip
    """
    whole = scene.system(SLIP)
    costs = []
    for effect in scene.used():
        if effect.name == "compliant_contact":
            continue
        needing = _needing(scene, effect.name)
        try:
            less = scene.with_effects(drop=(effect.name, *needing))
        except SceneError:  # the start needs it: a flight, or slip the other way
            continue
        system = less.system(SLIP)
        opened = tuple(phase for phase in scene.phases() if phase not in less.phases())
        states = len(whole.states) - len(system.states)
        costs.append(EffectCost(effect.name, needing, states, whole.operations() - system.operations(), opened))
    return tuple(costs)


def cost_text(scene: Scene) -> str:
    """One line: the scene's states and operations, and what each effect brings.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> cost_text(load_scene("fig-varsim1"))
    '4 states and 11 operations in slip; of it lift_off: 0 states, 0 operations, the phase flight'
    """
    system, parts = scene.system(SLIP), "; ".join(map(str, effect_costs(scene)))
    whole = f"{counted(len(system.states), 'state')} and {counted(system.operations(), 'operation')} in slip"
    return f"{whole}; of it {parts}" if parts else whole


def _needing(scene: Scene, name: str) -> tuple[str, ...]:
    """The effects of the scene that need this one, or one that does."""
    found: list[str] = []
    for effect in scene.used():
        needs = effect.needs if scene.mechanism is not None else (*effect.needs, *effect.needs_in_model)
        if {name, *found} & {*needs}:
            found.append(effect.name)
    return tuple(found)
