"""A motion in a program of others: its own contact, its own steps, and the mechanism's own free motion.

In each step the program is given the forces with which its bodies, where nothing touches, would have the accelerations
of the mechanism: weights, motors, springs and dampers, whatever they are. What is left to the program is
M^-1 (dx/dq λ_T + dy/dq λ_N): its M and its contact point are compared with the mechanism's before it begins.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.planar_model import PlanarModel, moved_states
from gspot_verified.scenes.simulators.simulated import Simulated

STIFF = 10  # the time constant of a soft contact in steps; MuJoCo asks for 2 or more
_CLOSE = 1e-6  # relative: other programs compute in doubles, with mass matrices that may be badly scaled


class Engine(Protocol):
    """A program that has been told the bodies, without weight; joints in the order of the model's."""

    def directions(self, places: Sequence[float]) -> tuple[Sequence[float], Sequence[float]]:
        """M^-1 dx/dq and M^-1 dy/dq of the point that touches, by the program's own M."""

    def begin(self, places: Sequence[float], rates: Sequence[float]) -> None:
        """From here the motion goes on."""

    def step(self, accelerations: Sequence[float]) -> tuple[Sequence[float], Sequence[float], float]:
        """Places, rates and the normal force after one step, in which the joints have these accelerations if free."""


def follow(model: PlanarModel, engine: Engine, *, step: float, until: float) -> Simulated:
    """The motion from the start of the model.

    :raises SceneError: the program has other bodies than the mechanism, or its numbers are no longer finite.
    """
    for state in moved_states(model.start):
        told = engine.directions(model.places(state))
        for ours, theirs in zip(model.directions(state), told, strict=True):
            if not _same(ours, theirs):
                raise SceneError("its mass matrix and contact point are not those of the mechanism")
    engine.begin(model.places(model.start), model.rates(model.start))
    states, forces = [list(model.start)], [1.0]
    steps = math.ceil(until / step)
    for _ in range(steps):
        places, rates, force = engine.step(model.accelerations(states[-1]))
        if not all(map(math.isfinite, (*places, *rates))):
            raise SceneError(f"its numbers are not finite in step {len(states)}")
        states.append(model.state(places, rates))
        forces.append(force)
    return Simulated([k * step for k in range(steps + 1)], states, forces)


def _same(ours: Sequence[float], theirs: Sequence[float]) -> bool:
    """Up to the direction in which x counts: a mechanism that slips backwards is mirrored."""
    return any(math.dist(ours, [sign * each for each in theirs]) <= _CLOSE * math.hypot(*ours) for sign in (1, -1))
