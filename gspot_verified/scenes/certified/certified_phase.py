"""One phase of a certified run: which event ends it, in a bracket, and that no other event came before.

Proof pages: ``proofs/norm_step.md``, ``proofs/validated_step.md`` (Theorems V5 and V6).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import ZERO, lie_derivative
from gspot_verified.functions.expressions import Constant, in_order
from gspot_verified.integrator.field.event import Crossing, Moment, Unclear, Watch, first_crossing, rivals
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.chosen_step import Steps
from gspot_verified.integrator.norm_steps.norm_run import NormRun, NormSegment
from gspot_verified.numbers.balls import hull
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence
from gspot_verified.scenes.equations.scaled_system import PhaseEvent, ScaledSystem

CLOCK = "T"
_WIDE = 2.0**-20  # relative radius from which on an open end speaks of wide sets; no verdict rests on it
_HALVINGS = 6  # of a segment on which a sign stays open; then the run is open
_RATES = 2  # derivatives at most that tell how a function leaves 0
_AT_THE_END = "an event may fall on the end of the time"


@dataclass(frozen=True)
class PhaseEnd:
    """``event``: what ended the phase (None: the time ended, or the observer stopped the run).

    ``time``: from the start of the phase, a bracket; ``states``: by name, everywhere in the bracket. ``evidence``: the
    signs at the event and those that exclude every other one; without an event, that steps were made up to there.
    ``before``: the step that the observer has not seen, and the tau at which the bracket begins in it; None: in none.
    """

    event: PhaseEvent | None
    time: arb
    states: dict[str, arb]
    evidence: Evidence
    before: tuple[NormSegment, arb] | None = None


@dataclass(frozen=True)
class Open:
    """Why the phase could not be followed further, and from when on. ``budget``: because a number of steps or events
    was reached, so that more of them may decide it; other reasons may need a higher precision.
    """

    reason: str
    time: arb
    budget: bool = False


Observer = Callable[[NormSegment, Mapping[str, arb]], bool]
"""Sees each segment and the states at its end; True ends the phase there."""


def _has_sense(name: str, value: arb) -> bool:
    """Whether it is certain that mu >= 0, or that another function is positive."""
    return bool(value >= 0) if name == "mu" else bool(value > 0)


class CertifiedPhase:
    """The equations of one phase as a vector field; the clock is a state where it occurs."""

    def __init__(self, system: ScaledSystem) -> None:
        self.system = system
        rates = list(system.right_hand_side)
        supposed = [function for _, function in system.supposed]
        functions = [*rates, *(event.function for event in system.events), *supposed]
        self.names = system.states
        if system.clock in in_order(functions):
            rates.append(Constant(fmpq(1)))
            self.names = (*system.states, CLOCK)
        self.field = VectorField(rates)
        self._supposed = BoxProgram(supposed, self.field.dimension) if supposed else None
        self._resting = [name for name, rate in zip(self.names, rates, strict=True) if rate is ZERO]

    def run(
        self,
        start: Mapping[str, arb],
        time: arb,
        at_zero: Mapping[str, int | None],
        observer: Observer,
        steps: Steps | None = None,
    ) -> PhaseEnd | Open:
        """The phase from the states at its start, for a time.

        ``time``: how long the phase lasts at most; where it is a ball, what is said holds for each time in it.
        ``at_zero``: the events whose functions vanish at the start, and the first of their derivatives that does not,
        where it is known. ``steps``: what an interrupted run has chosen, to be proved again.
        """
        if not time > 0:
            return Open(_AT_THE_END, arb(0))
        box = [start[name] for name in self.names]
        watches = []
        for event in self.system.events:
            order: int | None = 0
            if event.name in at_zero:
                order = at_zero[event.name] or self._order(event, box)
            if order is None:
                return Open(f"the phase begins where {event.name} cannot be told from the start", arb(0))
            watches.append(Watch(event.name, -event.function, self.field, order))
        run = NormRun(self.field, box, time, steps)
        for segment in run:
            doubt = self._doubt(segment, arb(0), arb(1))
            if doubt is not None:
                return Open(f"{doubt} may be negative, where the equations have no sense", segment.time)
            hits = [watch.along(segment) for watch in watches]
            if any(hit is not None for hit in hits):
                return self._ended(watches, hits, segment, start)
            quiet = [watch.excluded(Moment(segment, arb(1))) for watch in watches]
            at_end = self._named(segment.states(arb(1)), start)
            passed = every([less(0, segment.step.h), *quiet])
            if passed is not None and observer(segment, at_end):
                return PhaseEnd(None, segment.end_time, at_end, passed)
        if run.reason is not None:
            return Open(f"{run.reason}{self._width(run)}", run.time, run.budget_ended)
        ended = every([run.at_end, passed])
        return Open(_AT_THE_END, run.time) if ended is None else PhaseEnd(None, run.time, at_end, ended)

    def _doubt(self, segment: NormSegment, left: arb, right: arb, halvings: int = _HALVINGS) -> str | None:
        """The name of a function that is supposed to be positive (mu: not negative) and is not certainly so from
        ``left`` to ``right``, parts of the segment; None where all are."""
        if self._supposed is None:
            return None
        values = self._supposed.mean_values(segment.states(hull((left, right))))
        signs = zip(self.system.supposed, values, strict=True)
        doubts = [name for (name, _), value in signs if not _has_sense(name, value)]
        if not doubts or halvings == 0:
            return next(iter(doubts), None)
        middle = (left + right) / 2
        first = self._doubt(segment, left, middle, halvings - 1)
        return first or self._doubt(segment, middle, right, halvings - 1)

    def _named(self, states: Sequence[arb], start: Mapping[str, arb]) -> dict[str, arb]:
        """The states by name; one whose rate is 0 has its first value, without rounding errors."""
        named = dict(zip(self.names, states, strict=True))
        return named | {name: start[name] for name in self._resting}

    def _order(self, event: PhaseEvent, box: list[arb]) -> int | None:
        """Which derivative of the event's function takes it away from 0 at the start; None: it is not certain."""
        rates = self._rates(event, box)
        return len(rates) if rates[-1] > 0 else None

    def falls(self, event: PhaseEvent, start: Mapping[str, arb]) -> Evidence | None:
        """That a function that is 0 at the start is negative from then on, for some time; None: it is not certain."""
        return less(self._rates(event, [start[name] for name in self.names])[-1], 0)

    def _rates(self, event: PhaseEvent, box: list[arb]) -> list[arb]:
        """Derivatives of the event's function in the box, up to the first that is not exactly 0, or to the second."""
        derivative, rates = event.function, list[arb]()
        while len(rates) < _RATES and all(rate.is_zero() for rate in rates):
            derivative = lie_derivative(derivative, self.field.functions)
            rates.append(Watch(event.name, derivative, self.field).value(box))
        return rates

    def _ended(
        self,
        watches: list[Watch],
        hits: list[Crossing | Unclear | None],
        segment: NormSegment,
        start: Mapping[str, arb],
    ) -> PhaseEnd | Open:
        """The event that certainly comes first in this segment."""
        first = first_crossing(watches, hits)
        if first is not None:
            crossing, evidence = first
            event = next(event for event, hit in zip(self.system.events, hits, strict=True) if hit is crossing)
            before = (segment, crossing.begin.tau) if crossing.begin.segment is segment else None
            return PhaseEnd(event, crossing.time, self._named(crossing.states, start), evidence, before)
        for hit in hits:
            if isinstance(hit, Crossing):
                others = " and ".join(rivals(hit, watches, hits))
                return Open(f"simultaneous {hit.name} and {others}: their order is not certain", hit.time)
        unclear = next(hit for hit in hits if isinstance(hit, Unclear))
        return Open(f"{unclear.name}: {self._why(segment)}", unclear.time)

    def _why(self, segment: NormSegment) -> str:
        if self._is_wide(segment):
            return "the set of states has become too wide to follow it; a start on a canard is never decided"
        return "the event is grazing, or nearly: its function touches 0 without a certain sign of its derivative"

    def _is_wide(self, segment: NormSegment) -> bool:
        states = segment.states(arb(1))
        return any(
            not radius < _WIDE * (1 + abs(state)) for radius, state in zip(segment.step.tube, states, strict=True)
        )

    def _width(self, run: NormRun) -> str:
        wide = any(not state.rad() < _WIDE * (1 + abs(state)) for state in run.set.enclosure())
        return "; the set of states has become wide" if wide else ""
