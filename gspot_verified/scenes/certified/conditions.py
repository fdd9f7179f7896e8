"""Which conditions of effects that are left out a run follows, and how strictly.

Proof page: ``proofs/left_out_effects.md``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations

from flint import arb

from gspot_verified.numbers.balls import hull
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.equations.scaled_system import PhaseEvent
from gspot_verified.scenes.scene.scene import Scene


@dataclass(frozen=True)
class Conditions:
    """``followed``: effects whose conditions can be evaluated along the run. ``watched``: those of them that must be
    certain all along; of the others it is only seen where they have failed. ``unknown``: the effects whose conditions
    cannot be evaluated, and why. ``certain_until``: the time, in the unit epsilon, up to which all that are followed
    were certain when all of them were watched.
    """

    followed: tuple[Effect, ...]
    watched: tuple[Effect, ...]
    unknown: Mapping[str, str]
    certain_until: arb

    @classmethod
    def of(cls, scene: Scene) -> Conditions:
        """All that can be followed are watched."""
        reasons = {effect.name: scene.not_followed(effect) for effect in scene.conditional()}
        unknown = {name: reason for name, reason in reasons.items() if reason is not None}
        followed = tuple(effect for effect in scene.conditional() if effect.name not in unknown)
        return cls(followed, followed, unknown, arb(0))

    def fewer(self) -> Iterator[tuple[Effect, ...]]:
        """What to watch, one after the other: all, then fewer, at last none."""
        for count in range(len(self.followed), -1, -1):
            yield from combinations(self.followed, count)

    def watching(self, watched: tuple[Effect, ...], certain_until: arb) -> Conditions:
        """The same with others watched."""
        return replace(self, watched=watched, certain_until=certain_until)

    @property
    def lost(self) -> set[str]:
        """The effects whose conditions are followed and not watched."""
        return {effect.name for effect in self.followed} - {effect.name for effect in self.watched}

    def watches(self, event: PhaseEvent) -> bool:
        """Whether the event ends a condition that must be certain."""
        return any(effect.name == event.left_out for effect in self.watched)

    def since(self, event: PhaseEvent, time: arb) -> arb:
        """When a condition failed first that has failed at this time; one that is watched had not before."""
        return time if self.watches(event) else hull([self.certain_until, time])
