"""A run: validated steps one after the other, until a time, a condition or the end of the budget.

Proof page: ``proofs/validated_step.md``. Each step and each set is proved in ``step.py`` and ``error_set.py``; this
file only asks for them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import arb

from gspot_verified.integrator.box_steps.approximation import taylor
from gspot_verified.integrator.box_steps.choice import (
    flow_step_length,
    limited_by_growth,
    order_for,
    plan_for,
    scaled_curve,
    step_length,
    weights_for,
)
from gspot_verified.integrator.box_steps.error_set import ErrorSet
from gspot_verified.integrator.box_steps.step import Step, certified_step
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.field.no_series import NoSeriesError
from gspot_verified.numbers.balls import current_bits
from gspot_verified.numbers.evidence import every, inside
from gspot_verified.numbers.inner_text import text_of_each
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict

MAX_STEPS = 20_000  # against endless work; then the run is open
_HALVINGS = 40  # of a step that is not proved; then the run is open
_GUARD_BITS = 10  # of the working ones that the last terms of the series need not reach


@dataclass(frozen=True, slots=True)
class Segment:
    """One proved step of a run: from ``time`` on, with the set of states at its beginning and at its end."""

    time: arb
    step: Step
    before: ErrorSet
    after: ErrorSet

    @property
    def end_time(self) -> arb:
        """The time at its end."""
        return self.time + self.step.h

    def states(self, tau: arb) -> list[arb]:
        """The states at the times ``time`` + τ h, τ in a ball inside [0, 1]."""
        return self.step.enclosure(tau)


class Run:
    """Segments from an initial box; iterate over it. ``reason`` says why the iteration ended early, if it did."""

    def __init__(self, field: VectorField, box: Sequence[arb], time: arb | None = None, max_steps: int = MAX_STEPS):
        if len(box) != field.dimension:
            raise ValueError(f"box: expected {field.dimension} components, got {len(box)}")
        if not all(side.is_finite() for side in box):
            raise ValueError("box: every component must be finite")
        self.field, self.end, self.max_steps = field, time, max_steps
        self.set = ErrorSet.of_box(box)
        self.time = arb(0)
        self.reason: str | None = None

    def __iter__(self) -> Iterator[Segment]:
        for _ in range(self.max_steps):
            left = None if self.end is None else self.end - self.time
            segment = self._segment(left)
            if segment is None:
                self.reason = "no step could be proved: the solution, or the right-hand side, may cease to exist here"
                return
            self.set, self.time = segment.after, segment.end_time
            yield segment
            if segment.step.h is left:
                return
        self.reason = f"the budget of {self.max_steps} steps ended"

    def _segment(self, left: arb | None) -> Segment | None:
        """The next step: as long as the series allows, halved until it can be proved."""
        bits = current_bits()
        order = order_for(bits)
        middle, deviations = self.set.middle, self.set.deviations()
        try:
            solution, flow = taylor(self.field, middle, order)
            speed, rows = self.field.on_box(middle)
        except NoSeriesError:
            return None
        if not all(c.is_finite() for row in solution for c in row):
            return None
        weights, norm = weights_for(rows)
        length = min(step_length(solution, bits - _GUARD_BITS), flow_step_length(flow))
        length = limited_by_growth(length, norm, deviations)
        for halving in range(_HALVINGS):
            size = length / 2**halving
            h = arb(size)
            if left is not None and not 2 * h < left:  # what is left must stay certainly positive
                half = (left / 2).mid()
                h = half if h < left and half < left else left  # a wide ball of times is not passed
            curve = scaled_curve(solution, flow, middle, h)
            plan = plan_for(weights, middle, deviations, speed, h, norm, order)
            try:
                step = certified_step(self.field, curve, deviations, h, plan)
            except NoSeriesError:
                step = None
            after = None if step is None else self.set.after(step)
            if step is not None and after is not None:
                return Segment(self.time, step, self.set, after)
        return None


@dataclass(frozen=True, slots=True)
class Integration(NoTruthValue):
    """The result of :func:`integrate`. ``end`` encloses the states at the end; None when it was not reached."""

    verdict: Verdict
    end: tuple[arb, ...] | None
    time: arb
    segments: tuple[Segment, ...]


def integrate(field: VectorField, box: Sequence[arb], time: arb, max_steps: int = MAX_STEPS) -> Integration:
    """All solutions of dξ/dt = f(ξ) that start in the box, after the time ``time`` > 0, at the precision in force.

    Proved: each of them exists until then and ends in ``end``. Undecided: nothing is said about the end.

    :raises ValueError: a box of another dimension, a component or a time that is not finite, a time <= 0.

    >>> from gspot_verified.numbers.balls import working_bits
    >>> from gspot_verified.functions.expressions import Variable
    >>> oscillator = VectorField([Variable(1), -Variable(0)])
    >>> with working_bits(100):
    ...     orbit = integrate(oscillator, [arb(1), arb(0)], arb(2) * arb.pi())
    ...     orbit.end[0].overlaps(arb(1)), orbit.end[0].rel_accuracy_bits() > 80
    (True, True)
    """
    if not (time.is_finite() and time > 0):
        raise ValueError(f"time: expected a finite positive number, got {time}")
    run = Run(field, box, time, max_steps)
    segments = tuple(run)
    statement = f"every solution from the box exists up to the time {text_of_each(time)}"
    if run.reason is not None or not segments:
        verdict = Verdict.undecided(statement, Reason.BUDGET, f"{run.reason}, at the time {run.time.str(10)}")
        return Integration(verdict, None, run.time, segments)
    reached = _reached(segments, time)
    if reached is None:
        detail = "the last step does not hold all of the time that is left"
        return Integration(Verdict.undecided(statement, Reason.HYPOTHESIS, detail), None, run.time, segments)
    return Integration(Verdict.proved(statement, reached), tuple(run.set.enclosure()), run.time, segments)


def _reached(segments: Sequence[Segment], time: arb) -> Evidence | None:
    """Each step is proved and begins when the one before it ends; the last one holds all of the time that is left."""
    if not segments:
        return None
    ends = [arb(0), *(segment.end_time for segment in segments)]
    joined = (inside(end, segment.time) for end, segment in zip(ends, segments, strict=False))
    left = inside(time - segments[-1].time, segments[-1].step.h)
    return every([*joined, *(segment.step.evidence for segment in segments), left])
