"""Certified runs of any scene by the validated integrator: phase after phase, with brackets of the events.

Proof pages: ``proofs/norm_step.md``, ``proofs/validated_step.md``, ``proofs/invariant_region.md``,
``proofs/left_out_effects.md``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import approximate, ball, working_bits
from gspot_verified.numbers.evidence import at_most, every, less
from gspot_verified.numbers.verdict import Evidence
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase, Open
from gspot_verified.scenes.certified.certified_phases import CertifiedPhases, Next
from gspot_verified.scenes.certified.certified_result import Record, event_of, growth_words, result_of
from gspot_verified.scenes.certified.conditions import Conditions
from gspot_verified.scenes.certified.invariant_region import ExponentialGrowth, InvariantRegion
from gspot_verified.scenes.certified.run_steps import Progress, RunSteps
from gspot_verified.scenes.certified.segment_samples import Observer, SegmentSamples, Step
from gspot_verified.scenes.certified.step_journal import FORMAT, StepJournal
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.equations.terms import FLIGHT, STICK
from gspot_verified.scenes.motions.contact_form import NotOfThisForm
from gspot_verified.scenes.scene.run import IMPACT, RunEvent, SceneRun
from gspot_verified.scenes.scene.run_journal import question
from gspot_verified.scenes.scene.scene import Scene, SceneError

MAX_EVENTS = 200  # of one run, against endless work; then the run is open
MAX_STEPS = 20_000  # where no budget is given, against endless work
BITS = (192, 320, 576)
SMALL = fmpq(1, 10**6)
"""From here on down 192 bits are too few for a mechanism: its runs begin at 320. The model system has enough."""
MAX_DIGITS = 80  # of the brackets; a limit of input: ValueError beyond it
_DIGIT_BITS = 3.33  # bits of a decimal digit
_SPARE_DIGITS = 5  # by which a bracket must be narrower than what is asked for, or more bits are tried


def integrated_run(
    scene: Scene,
    digits: int = 15,
    bits: tuple[int, ...] | None = None,
    sampled: bool = False,
    journal: str | Path | None = None,
    budget: int = MAX_STEPS,
    progress: Progress = lambda _: None,
) -> SceneRun:
    """The events until ``scene.until``, or until an impact without collision is shown to last for ever; or undecided,
    with the events that are certain and the reason. Where more bits show less, what fewer bits have shown is kept.

    What the effects that are left out assume of the motion is followed with it. Where that fails for certain, the
    verdict is refuted, as a statement on the motion with them; where it is not certain, it stands in the statement.

    :param digits: 1..80, decimals of the times of the events in the unit epsilon.
    :param bits: working precisions to try, one after the other.
    :param sampled: keep enclosures of the trajectory: at some times of each step, at the events, and boxes between.
    :param journal: a file that keeps what was chosen for each step; a run that was interrupted goes on from there, to
        the same result. All of it is proved again, so that a journal that was changed cannot make the result wrong.
        Where it cannot be written (a full disk) the run goes on without it, and ``notes`` says so.
    :param budget: how many steps may be made at each precision; where it ends the run is undecided, and says where.
    :raises SceneError: digits or budget out of range.
    :raises ValueError: the journal is that of another run, or a line of it is damaged.
    :raises OSError: the journal cannot be opened.
    """
    if not 1 <= digits <= MAX_DIGITS:
        raise SceneError(f"digits must lie in 1..{MAX_DIGITS}, got {digits}")
    if budget < 1:
        raise SceneError(f"budget must be >= 1, got {budget}")
    precisions = bits or precisions_for(scene, digits)
    every = Conditions.of(scene)
    asked = _asked(scene, every, digits, precisions)
    kept = None if journal is None else StepJournal(journal, question(scene, asked))
    left = precisions if kept is None else _not_left_behind(precisions, kept)
    best = _best(
        scene=scene,
        every=every,
        digits=digits,
        precisions=left,
        sampled=sampled,
        kept=kept,
        budget=budget,
        progress=progress,
    )
    if best.record.open is not None and len(left) < len(precisions):  # one that was left behind may have shown more
        best = _best(
            scene=scene,
            every=every,
            digits=digits,
            precisions=precisions,
            sampled=sampled,
            kept=kept,
            budget=budget,
            progress=progress,
        )
    samples = None if best.samples is None else best.samples.samples()
    result = replace(result_of(scene, best.conditions, best.record), samples=samples)
    return result if kept is None else replace(result, notes=tuple(kept.notes))


def precisions_for(scene: Scene, digits: int) -> tuple[int, ...]:
    """The working precisions to try, one after the other, in bits."""
    extra = round(max(0, digits - 15) * _DIGIT_BITS)
    first = 1 if scene.mechanism is not None and scene.epsilon <= SMALL else 0
    return tuple(value + extra for value in BITS[first:])


def is_narrow(event: RunEvent, epsilon: fmpq, digits: int) -> bool:
    """Whether a bracket leaves no doubt about that many decimals in the unit epsilon; else more bits are tried."""
    return bool(event.upper - event.lower <= epsilon * fmpq(1, 10 ** (digits + _SPARE_DIGITS)))


@dataclass(frozen=True)
class _Attempt:
    """What was shown with these conditions watched, and the samples."""

    record: Record
    conditions: Conditions
    samples: SegmentSamples | None

    def reach(self) -> tuple[bool, bool, int, float]:
        """How much is shown, for a choice between attempts: all of the run, with no condition lost, so many events, and
        how far."""
        record = self.record
        time = math.inf if record.open is None else approximate(record.open.time)
        return record.open is None, not self.conditions.lost, len(record.events), time


def _best(
    scene: Scene, every: Conditions, digits: int, precisions: Sequence[int], sampled: bool, kept: StepJournal | None,
    budget: int, progress: Progress,
) -> _Attempt:  # fmt: skip
    """The attempt that shows most, of those at the precisions that are tried one after the other."""
    best: _Attempt | None = None
    for precision in precisions:
        attempt = _attempt(scene, every, precision, sampled, kept, budget, progress)
        if best is None or attempt.reach() >= best.reach():
            best = attempt
        record = attempt.record
        narrow = all(is_narrow(event, scene.epsilon, digits) for event in record.events)
        if (narrow and not attempt.conditions.lost) if record.open is None else record.open.budget:
            break
    assert best is not None
    return best


def _attempt(
    scene: Scene, every: Conditions, precision: int, sampled: bool, kept: StepJournal | None, budget: int,
    progress: Progress,
) -> _Attempt:  # fmt: skip
    """The run at one precision: with all conditions watched, and where that is undecided with fewer."""
    certain_until: arb | None = None
    for watched in every.fewer():
        conditions = every.watching(watched, arb(0) if certain_until is None else certain_until)
        steps = RunSteps(budget, precision, approximate(scene.epsilon), approximate(scene.until), kept, progress)
        with working_bits(precision):
            samples = SegmentSamples(scene) if sampled else None
            record = _run(scene, conditions, samples, steps)
        if record.open is None or record.open.budget:
            break
        certain_until = record.seen if certain_until is None else certain_until
    return _Attempt(record, conditions, samples)


def _asked(scene: Scene, every: Conditions, digits: int, precisions: Sequence[int]) -> dict[str, object]:
    """What a journal's first line says beside the scene. Another version may choose other steps, and is refused."""
    from gspot_verified import __version__

    start = {name: str(value) for name, value in scene.scaled_initial(every.followed).items()}
    return {
        "certified": FORMAT,
        "digits": digits,
        "bits": list(precisions),
        "version": __version__,
        "start": start,
    }


def _not_left_behind(precisions: Sequence[int], kept: StepJournal) -> Sequence[int]:
    """From the last precision on that a journal holds steps of: those before it were not enough. It need not be true:
    which precisions are tried is a choice."""
    reached = [precisions.index(line["bits"]) for line in kept.lines if line.get("bits") in precisions]
    return precisions[max(reached, default=0) :]


def _run(scene: Scene, conditions: Conditions, samples: SegmentSamples | None, steps: RunSteps) -> Record:
    """The whole run at the precision in force."""
    record, phases = Record(), CertifiedPhases(scene, conditions.followed, conditions.watched)
    initial = scene.scaled_initial(conditions.followed)
    start = {name: arb(value) for name, value in initial.items()} | {CLOCK: arb(0)}
    end = arb(scene.until / scene.epsilon)
    now = phases.first(start)
    for _ in range(MAX_EVENTS):
        if isinstance(now, Open):
            record.open = now
            return record
        at_zero = _checked_start(conditions, phases, now, start, record)
        if at_zero is None:
            return record
        began, phase = start[CLOCK], phases[now.phase]
        record.seen, record.phase = began, now.phase
        observer: Observer = _ImpactObserver(phase, began, end, scene, record)
        observer = _ConditionObserver(observer, conditions, phases, now.phase, began, end, record)
        if samples is not None:
            observer = samples.beside(observer, phase.system, began)
        steps.begins(now.phase, began)
        phase_end = phase.run(start, end - began, at_zero, observer, steps)
        if isinstance(phase_end, Open):
            record.open = replace(phase_end, time=began + phase_end.time)
            return record
        start = {**start, **phase_end.states, CLOCK: began + phase_end.time}
        if record.stopped is not None:
            record.ended = every([phase_end.evidence, record.ended])
            return record
        # The phase was followed for each time of the ball end - began: an event after ``end`` is none of this run.
        after = less(end, start[CLOCK])
        if phase_end.event is None:
            # These are the states for each time of that ball, those at ``end`` among them. No step certainly ends by
            # then: no observer has asked there.
            if record.violated is None:
                record.violated = _failed(conditions, phases, now.phase, start, phase_end.evidence)
            record.ended = phase_end.evidence
            return record
        if after is not None:
            record.ended = every([phase_end.evidence, after])
            return record
        shown = every([phase_end.evidence, at_most(start[CLOCK], end)])
        if shown is None:
            record.open = Open(f"whether {phase_end.event.name} comes before the end of the time", start[CLOCK])
            return record
        if samples is not None:
            samples.event(phase_end.before, phase_end.time, start)
        record.violated = _failed(conditions, phases, now.phase, start, shown)
        if record.violated is not None:
            return record
        if phase_end.event.left_out:
            record.violated = phase_end.event.left_out, start[CLOCK], shown
            return record
        following = phases.after(now.phase, phase_end.event, start)
        record.events.append(event_of(following.event, start[CLOCK], scene.epsilon))
        record.shown.append(shown)
        now = following.phase
    record.open = Open(f"the budget of {MAX_EVENTS} events ended", start[CLOCK], budget=True)
    return record


def _checked_start(
    conditions: Conditions, phases: CertifiedPhases, now: Next, start: Mapping[str, arb], record: Record
) -> dict[str, int | None] | None:
    """The events that are at zero where a phase begins, those of conditions with them; None: the run ends there,
    because a condition fails, or is not certain."""
    at_zero = dict(now.at_zero)
    for event, value in phases.conditions(now.phase, start):
        if (negative := less(value, 0)) is not None:
            record.violated = event.left_out, conditions.since(event, start[CLOCK]), negative
            return None
        if value.is_zero() and (falls := phases[now.phase].falls(event, start)) is not None:
            record.violated = event.left_out, conditions.since(event, start[CLOCK]), falls
            return None
        if value > 0 or event.name in at_zero or not conditions.watches(event):
            continue
        if not value.is_zero():
            record.open = Open(f"whether {event.name} where {now.phase} begins is not certain", start[CLOCK])
            return None
        at_zero[event.name] = None
    return at_zero


def _failed(
    conditions: Conditions, phases: CertifiedPhases, phase: str, states: Mapping[str, arb], shown: Evidence | None
) -> tuple[str, arb, Evidence] | None:
    """The effect whose condition has certainly failed by the time of these states, when it did first, and what shows
    it; ``shown``: that they are reached. An event can end a phase in its first step, which no observer sees."""
    for event, value in phases.conditions(phase, states):
        if (failed := every([less(value, 0), shown])) is not None:
            return event.left_out, conditions.since(event, states[CLOCK]), failed
    return None


class _ConditionObserver:
    """Looks at the end of each segment whether a condition that could not be followed has certainly failed by then, and
    before the end of the time; up to there those that are followed hold."""

    def __init__(
        self,
        inner: Observer,
        conditions: Conditions,
        phases: CertifiedPhases,
        phase: str,
        began: arb,
        end: arb,
        record: Record,
    ) -> None:
        self._inner, self._conditions, self._phases, self._phase = inner, conditions, phases, phase
        self._began, self._end, self._record = began, end, record

    def __call__(self, segment: Step, states: Mapping[str, arb]) -> bool:
        time = self._record.seen = self._began + segment.end_time
        in_time = at_most(time, self._end)
        self._record.violated = _failed(self._conditions, self._phases, self._phase, {**states, CLOCK: time}, in_time)
        if self._record.violated is not None:
            return True
        return self._inner(segment, states)


class _ImpactObserver:
    """Looks at the end of each segment for a state from which the force grows for as long as the scene slips; until
    then, for one from which it grows by some factor."""

    def __init__(self, phase: CertifiedPhase, began: arb, end: arb, scene: Scene, record: Record) -> None:
        self._began, self._end, self._epsilon, self._record = began, end, scene.epsilon, record
        self._large = LargeForce(phase.system, scene)
        lift_off_alone = all(event.next_phase == FLIGHT for event in phase.system.events)
        self._may_slip_for_ever = lift_off_alone and not phase.system.supposed  # that is seen step by step alone
        self._sticks = phase.system.phase == STICK
        self._known: ExponentialGrowth | None = None
        self._region: InvariantRegion | None = None
        if phase.system.phase != FLIGHT:
            try:
                self._region = InvariantRegion(phase.system)
            except NotOfThisForm:
                self._region = None

    def __call__(self, segment: Step, states: Mapping[str, arb]) -> bool:
        limited = self._known is not None and self._known.until is not None
        if self._known is not None and self._stops(segment, states):
            return True
        if self._region is None or (self._known is not None and not limited):
            return False
        growth = self._region.growth(states, limited=not limited)
        time = self._began + segment.end_time
        if growth is None:
            return False
        shown = every([less(0, growth.rate), at_most(time, self._end)])
        if shown is None:
            return False
        self._known = growth
        if not limited:
            self._record.events.append(event_of(IMPACT, time, self._epsilon))
            self._record.multiples.append(None)
            self._record.limits.append("")
            self._record.shown.append(shown)
        self._record.multiples[-1] = growth.until
        self._record.limits[-1] = growth_words(growth, self._sticks, time * self._epsilon if limited else None)
        self._record.remarks.append(self._record.limits[-1])
        self._record.for_ever = growth.until is None and growth.within is None and self._may_slip_for_ever
        return self._record.for_ever

    def _stops(self, segment: Step, states: Mapping[str, arb]) -> bool:
        """Whether the scene's run ends here, before the end of the time: an impact has made the force as large as it
        says."""
        time = self._began + segment.end_time
        ended = every([self._large.shown(states), at_most(time, self._end)])
        if ended is None:
            return False
        self._record.stopped, self._record.ended = time, ended
        return True


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
