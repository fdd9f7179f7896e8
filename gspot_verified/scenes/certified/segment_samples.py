"""The trajectory of a run by the integrator: enclosures at some times of each proved step, as midpoints and radii."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.scenes.certified.certified_samples import midpoint_and_radius
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.scene.samples import RADIUS, Samples
from gspot_verified.scenes.scene.scene import Scene

SAMPLES_OF_A_STEP = 4  # and the start of the first: enough for a smooth picture


class Step(Protocol):
    """A proved step: from ``time`` to ``end_time``."""

    @property
    def time(self) -> arb:
        """Its start."""
        ...

    @property
    def end_time(self) -> arb:
        """Its end."""
        ...

    def states(self, tau: arb) -> list[arb]:
        """The states at time + tau (end_time - time)."""
        ...


Observer = Callable[[Step, Mapping[str, arb]], bool]


class SegmentSamples:
    """Collects samples; steps in which an event may fall are left out. The working precision is the run's."""

    def __init__(self, scene: Scene) -> None:
        self._epsilon = scene.epsilon
        self._names: tuple[str, ...] = ()
        self._rows: list[list[float]] = []
        self._phases: list[str] = []

    def beside(self, observer: Observer, system: ScaledSystem, began: arb) -> Observer:
        """The observer, which leaves samples of each step that it sees."""
        size = len(system.states)
        program = BoxProgram([function for _, function in system.read_out], size + 1)
        self._names = tuple(name for name, _ in system.read_out)

        def both(step: Step, states: Mapping[str, arb]) -> bool:
            for k in range(0 if not self._rows else 1, SAMPLES_OF_A_STEP + 1):
                tau = arb(k) / SAMPLES_OF_A_STEP
                clock = began + step.time + tau * (step.end_time - step.time)
                values = program.values([*step.states(tau)[:size], clock])
                pairs = [midpoint_and_radius(value) for value in (clock * self._epsilon, *values)]
                self._rows.append([part for pair in pairs for part in pair])
                self._phases.append(system.phase)
            return observer(step, states)

        return both

    def samples(self) -> Samples:
        """What was collected."""
        import numpy as np

        names = tuple(name + end for name in ("t", *self._names) for end in ("", RADIUS))
        columns = np.array(self._rows).reshape(len(self._rows), len(names)).T
        return Samples(dict(zip(names, columns, strict=True)), tuple(self._phases))
