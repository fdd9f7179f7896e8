"""The trajectory of a run by the integrator: enclosures at times of each proved step, and boxes with no gap in time.

Proof page: ``proofs/norm_step.md`` (Theorem N1: the enclosure of a proved step at all times of a ball). Where the
pieces are cut is a heuristic: any choice is correct.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Protocol

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import float_bounds, hull
from gspot_verified.scenes.certified.certified_samples import midpoint_and_radius
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.scene.samples import RADIUS, Boxes, Samples
from gspot_verified.scenes.scene.scene import Scene

PIECES_OF_A_STEP = 4  # at least; they are halved where the trajectory bends
_HALVINGS = 4  # of such a piece, a limit of effort
_TALL = 1 / 80  # of the largest value of the column so far: a taller box is halved


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
        """The states at time + tau (end_time - time), for a ball tau inside [0, 1] at all of these times."""
        ...


Observer = Callable[[Step, Mapping[str, arb]], bool]


class SegmentSamples:
    """Collects samples and boxes, phase after phase. The working precision is the run's."""

    def __init__(self, scene: Scene) -> None:
        self._epsilon = scene.epsilon
        self._names: tuple[str, ...] = ()
        self._rows: list[list[float]] = []
        self._phases: list[str] = []
        self._boxes: list[list[tuple[float, float]]] = []
        self._box_phases: list[str] = []
        self._largest: list[float] = []
        self._phase: _Phase | None = None

    def beside(self, observer: Observer, system: ScaledSystem, began: arb) -> Observer:
        """The observer, which leaves samples of each step that it sees, of a phase that begins here."""
        phase = self._phase = _Phase(system, began)
        self._names = phase.names
        self._largest = self._largest or [0.0] * len(phase.names)

        def both(step: Step, states: Mapping[str, arb]) -> bool:
            self._along(phase, step, arb(1))
            return observer(step, states)

        return both

    def event(self, before: tuple[Step, arb] | None, time: arb, states: Mapping[str, arb]) -> None:
        """The rest of the phase: from the start of a step to tau, where the bracket of the event begins, and the event.

        ``before``: None where the bracket begins before the step that was seen last has ended. ``time``: from the start
        of the phase, the bracket; ``states``: everywhere in it.
        """
        phase = self._phase
        assert phase is not None
        if before is not None and before[1] > 0:
            self._along(phase, *before)
        clock, values = phase.seen([states[name] for name in phase.system.states], time)
        self._add_row(phase, clock, values)
        self._add_box(phase, clock, values)

    def _along(self, phase: _Phase, step: Step, end: arb) -> None:
        """Samples and boxes of a step from its start to tau = ``end``."""
        if not phase.begun:
            self._add_row(phase, *phase.at(step, arb(0)))
            phase.begun = True
        ends = [end * k / PIECES_OF_A_STEP for k in range(PIECES_OF_A_STEP + 1)]
        for left, right in pairwise(ends):
            self._piece(phase, step, left, right, _HALVINGS)

    def _piece(self, phase: _Phase, step: Step, left: arb, right: arb, halvings: int) -> None:
        clock, values = phase.at(step, hull((left, right)))
        if halvings and any(2 * float(v.rad()) > _TALL * top for v, top in zip(values, self._largest, strict=True)):
            middle = (left + right) / 2
            self._piece(phase, step, left, middle, halvings - 1)
            self._piece(phase, step, middle, right, halvings - 1)
            return
        self._add_box(phase, clock, values)
        self._add_row(phase, *phase.at(step, right))

    def _add_row(self, phase: _Phase, clock: arb, values: Sequence[arb]) -> None:
        pairs = [midpoint_and_radius(value) for value in (clock * self._epsilon, *values)]
        self._rows.append([part for pair in pairs for part in pair])
        self._phases.append(phase.system.phase)
        self._largest = [max(top, abs(pair[0])) for top, pair in zip(self._largest, pairs[1:], strict=True)]

    def _add_box(self, phase: _Phase, clock: arb, values: Sequence[arb]) -> None:
        self._boxes.append([float_bounds(value) for value in (clock * self._epsilon, *values)])
        self._box_phases.append(phase.system.phase)

    def samples(self) -> Samples:
        """What was collected."""
        import numpy as np

        each = ("t", *self._names)
        names = tuple(name + end for name in each for end in ("", RADIUS))
        columns = np.array(self._rows).reshape(len(self._rows), len(names)).T
        bounds = np.array(self._boxes).reshape(len(self._boxes), len(each), 2).T
        lower, upper = (dict(zip(each, side, strict=True)) for side in bounds)
        boxes = Boxes(lower, upper, tuple(self._box_phases))
        return Samples(dict(zip(names, columns, strict=True)), tuple(self._phases), boxes)


class _Phase:
    """The read-out of one phase, with the time at which it began."""

    def __init__(self, system: ScaledSystem, began: arb) -> None:
        self.system, self._began = system, began
        self.names = tuple(name for name, _ in system.read_out)
        self.begun = False
        self._size = len(system.states)
        self._program = BoxProgram([function for _, function in system.read_out], self._size + 1)

    def at(self, step: Step, tau: arb) -> tuple[arb, list[arb]]:
        """The clock and the read-out at all times tau of a step."""
        return self.seen(step.states(tau)[: self._size], step.time + tau * (step.end_time - step.time))

    def seen(self, states: Sequence[arb], time: arb) -> tuple[arb, list[arb]]:
        """The clock and the read-out in a set of states, at times after the start of the phase."""
        clock = self._began + time
        return clock, self._program.mean_values([*states, clock])
