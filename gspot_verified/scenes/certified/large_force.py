"""Where a scene ends its run: p < 0, and λ_N so many times that of rigid slip at the start, -b/p.

Comparisons of balls alone: ``stop_at_force`` of the scene is a definition, and nothing is proved of it.
"""

from __future__ import annotations

from collections.abc import Mapping

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import ball
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.equations.terms import FLIGHT
from gspot_verified.scenes.scene.scene import Scene

_CLOCK = "T"


class LargeForce:
    """The condition in one phase; nowhere in flight, nor where the scene has no ``stop_at_force``."""

    def __init__(self, system: ScaledSystem, scene: Scene) -> None:
        self._program: BoxProgram | None = None
        if scene.stop_at_force is None or system.phase == FLIGHT:
            return
        values = scene.values()
        rigid = -scene.motion.normal_acceleration(values) / scene.motion.painleve_parameter(values)
        self._names = (*system.states, _CLOCK)
        self._limit = ball(scene.stop_at_force) * rigid
        self._program = BoxProgram([system.shown("p"), system.shown("lambda_N")], len(self._names))

    def shown(self, states: Mapping[str, arb]) -> Evidence | None:
        """That it holds in all of these states; None: it does not, or not certainly."""
        if self._program is None:
            return None
        p, force = self._program.values([states.get(name, arb(0)) for name in self._names])
        return every([less(p, 0), less(self._limit, force)])
