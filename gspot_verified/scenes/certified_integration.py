"""Certified runs of any scene by the validated integrator: phase after phase, with brackets of the events.

Proof pages: ``proofs/norm_step.md``, ``proofs/validated_step.md``, ``proofs/invariant_region.md``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from flint import arb, fmpq

from gspot_verified.balls import approximate, float_bounds, rounded_text, working_bits
from gspot_verified.dyadic import Dyadic
from gspot_verified.scenes.certified_phase import CLOCK, CertifiedPhase, Open
from gspot_verified.scenes.certified_phases import CertifiedPhases
from gspot_verified.scenes.contact_form import NotOfThisForm
from gspot_verified.scenes.effects.terms import FLIGHT, STICK
from gspot_verified.scenes.invariant_region import Growth, InvariantRegion
from gspot_verified.scenes.run import CERTIFIED, IMPACT, NO_EVENT, OPEN, RunEvent, SceneRun, fate_of
from gspot_verified.scenes.run_journal import question
from gspot_verified.scenes.run_steps import Progress, RunSteps
from gspot_verified.scenes.scene import Scene, SceneError
from gspot_verified.scenes.segment_samples import Observer, SegmentSamples, Step
from gspot_verified.scenes.step_journal import FORMAT, StepJournal
from gspot_verified.verdict import Reason, Verdict

MAX_EVENTS = 200
MAX_STEPS = 20_000
BITS = (192, 320, 576)
SMALL = fmpq(1, 10**6)
"""From here on down 192 bits are too few for a mechanism: its runs begin at 320. The model system has enough."""
MAX_DIGITS = 80
_DIGIT_BITS = 3.33
_SPARE_DIGITS = 5


@dataclass
class _Record:
    """What a run at one precision has shown; ``multiples``: how far each impact is shown to grow, None: no limit."""

    events: list[RunEvent] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    multiples: list[int | None] = field(default_factory=list)
    open: Open | None = None
    for_ever: bool = False

    def reach(self) -> tuple[bool, int, float]:
        """How much is shown, for a choice between records: all of the run, or so many events and this time."""
        return self.open is None, len(self.events), math.inf if self.open is None else approximate(self.open.time)


def integrated_run(
    scene: Scene,
    digits: int = 15,
    bits: tuple[int, ...] | None = None,
    sampled: bool = False,
    journal: Path | None = None,
    budget: int = MAX_STEPS,
    progress: Progress = lambda _: None,
) -> SceneRun:
    """The events until ``scene.until``, or until an impact without collision is shown to last for ever; or undecided,
    with the events that are certain and the reason. Where more bits show less, what fewer bits have shown is kept.

    :param digits: 1..80, decimals of the times of the events in the unit epsilon.
    :param bits: working precisions to try, one after the other.
    :param sampled: keep enclosures of the trajectory at some times of each step.
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
    extra = round(max(0, digits - 15) * _DIGIT_BITS)
    first = 1 if scene.mechanism is not None and scene.epsilon <= SMALL else 0
    precisions = bits or tuple(value + extra for value in BITS[first:])
    kept = None if journal is None else StepJournal(journal, question(scene, _asked(digits, precisions)))
    left = precisions if kept is None else _not_left_behind(precisions, kept)
    record, samples = _best(scene, digits, left, sampled, kept, budget, progress)
    if record.open is not None and len(left) < len(precisions):  # one that was left behind may have shown more
        record, samples = _best(scene, digits, precisions, sampled, kept, budget, progress)
    found = replace(_result(scene, record), samples=None if samples is None else samples.samples())
    return found if kept is None or not kept.failure else replace(found, notes=(kept.failure,))


def _best(
    scene: Scene, digits: int, precisions: Sequence[int], sampled: bool, kept: StepJournal | None, budget: int,
    progress: Progress,
) -> tuple[_Record, SegmentSamples | None]:  # fmt: skip
    """The record that shows most, of those at the precisions that are tried one after the other."""
    best: tuple[_Record, SegmentSamples | None] = _Record(), None
    for count, precision in enumerate(precisions):
        steps = RunSteps(budget, precision, approximate(scene.epsilon), kept, progress)
        with working_bits(precision):
            samples = SegmentSamples(scene) if sampled else None
            record = _run(scene, samples, steps)
        if count == 0 or record.reach() >= best[0].reach():
            best = record, samples
        narrow = all(_narrow(event, scene.epsilon, digits) for event in record.events)
        if narrow if record.open is None else record.open.budget:
            break
    return best


def _asked(digits: int, precisions: Sequence[int]) -> dict[str, object]:
    """What a journal's first line says beside the scene. Another version may choose other steps, and is refused."""
    from gspot_verified import __version__

    return {"certified": FORMAT, "digits": digits, "bits": list(precisions), "version": __version__}


def _not_left_behind(precisions: Sequence[int], kept: StepJournal) -> Sequence[int]:
    """From the last precision on that a journal holds steps of: those before it were not enough. It need not be true:
    which precisions are tried is a choice."""
    reached = [precisions.index(line["bits"]) for line in kept.lines if line.get("bits") in precisions]
    return precisions[max(reached, default=0) :]


def _narrow(event: RunEvent, epsilon: fmpq, digits: int) -> bool:
    return bool(event.upper - event.lower <= epsilon * fmpq(1, 10 ** (digits + _SPARE_DIGITS)))


def _run(scene: Scene, samples: SegmentSamples | None, steps: RunSteps) -> _Record:
    """The whole run at the precision in force."""
    record, phases = _Record(), CertifiedPhases(scene)
    start = {name: arb(value) for name, value in scene.scaled_initial().items()} | {CLOCK: arb(0)}
    end = arb(scene.until / scene.epsilon)
    now = phases.first(start)
    for _ in range(MAX_EVENTS):
        if isinstance(now, Open):
            record.open = now
            return record
        began, phase = start[CLOCK], phases[now.phase]
        observer: Observer = _ImpactObserver(phase, began, scene.epsilon, record)
        if samples is not None:
            observer = samples.beside(observer, phase.system, began)
        steps.begins(now.phase, began)
        found = phase.run(start, end - began, now.at_zero, observer, steps)
        if isinstance(found, Open):
            record.open = replace(found, time=began + found.time)
            return record
        start = {**start, **found.states, CLOCK: began + found.time}
        if found.event is None:
            return record
        following = phases.after(now.phase, found.event, start)
        record.events.append(_event(following.event, start[CLOCK], scene.epsilon))
        now = following.phase
    record.open = Open(f"the budget of {MAX_EVENTS} events ended", start[CLOCK], budget=True)
    return record


class _ImpactObserver:
    """Looks at the end of each segment for a state from which the force grows for as long as the scene slips; until
    then, for one from which it grows by some factor."""

    def __init__(self, phase: CertifiedPhase, began: arb, epsilon: fmpq, record: _Record) -> None:
        self._began, self._epsilon, self._record = began, epsilon, record
        self._may_slip_for_ever = all(event.next_phase == FLIGHT for event in phase.system.events)
        self._sticks = phase.system.phase == STICK
        self._known: Growth | None = None
        self._region: InvariantRegion | None = None
        if phase.system.phase != FLIGHT:
            try:
                self._region = InvariantRegion(phase.system)
            except NotOfThisForm:
                self._region = None

    def __call__(self, segment: Step, states: Mapping[str, arb]) -> bool:
        limited = self._known is not None and self._known.until is not None
        if self._region is None or (self._known is not None and not limited):
            return False
        found = self._region.growth(states)
        if found is None or (limited and found.until is not None):
            return False
        self._known = found
        time = self._began + segment.end_time
        if not limited:
            self._record.events.append(_event(IMPACT, time, self._epsilon))
            self._record.multiples.append(None)
        self._record.multiples[-1] = found.until
        self._record.remarks.append(_words(found, self._sticks, time * self._epsilon if limited else None))
        self._record.for_ever = found.until is None and found.within is None and self._may_slip_for_ever
        return self._record.for_ever


def _words(growth: Growth, sticks: bool, since: arb | None) -> str:
    rate, motion = rounded_text(float_bounds(growth.rate)[0], -1), "stick" if sticks else "slip"
    begin = "" if since is None else f"from t = {rounded_text(float_bounds(since)[1], 1, 6)} after the start on "
    grows = f"{begin}λ_N grows at least like exp({rate} t/ε)"
    if growth.until is not None:
        return f"{grows} until it is {growth.until} times as large, or {motion} ends"
    lasting = f"{grows} for as long as the contact {motion}s"
    if growth.within is None:
        return lasting
    return f"{lasting}, which ends within {rounded_text(float_bounds(growth.within)[1], 1)} ε"


def _statement(fate: str, span: str, multiples: Sequence[int | None] = ()) -> str:
    """What is proved. An impact without collision that no cone shows is not excluded, so "no event" would be too much;
    and where a cone shows the growth of λ_N up to a multiple only, the multiple is part of the statement.

    >>> _statement("lift-off", " until t = 1 after the start")
    'lift-off until t = 1 after the start, and no other change of phase'
    >>> _statement("impact without collision", "", (8, None))
    'impact without collision (λ_N grows 8-fold, or slip or stick ends), and no other change of phase'
    """
    if fate == NO_EVENT:
        return f"no change of phase{span}"
    known = [multiple for multiple in multiples if multiple is not None]
    limit = f" (λ_N grows {min(known)}-fold, or slip or stick ends)" if known else ""
    return f"{fate}{limit}{span}, and no other change of phase"


def _event(name: str, time: arb, epsilon: fmpq) -> RunEvent:
    bounds = Dyadic.from_ball(time * epsilon)
    unit = fmpq(2) ** bounds.exponent
    return RunEvent(name, bounds.lower * unit, bounds.upper * unit)


def _result(scene: Scene, record: _Record) -> SceneRun:
    events = tuple(record.events)
    names = [event.name for event in events]
    remarks = "; ".join(record.remarks)
    if record.open is None:
        fate = fate_of(names)
        span = "" if record.for_ever else f" until t = {scene.until} after the start"
        return SceneRun(CERTIFIED, fate, events, Verdict.proved(_statement(fate, span, record.multiples), remarks))
    known = f"certain before it: {fate_of(names)}"
    at = (record.open.time * scene.epsilon).str(10)
    detail = "; ".join(filter(None, (f"{record.open.reason} (t = {at} after the start)", known, remarks)))
    reason = Reason.BUDGET if record.open.budget else Reason.HYPOTHESIS
    return SceneRun(CERTIFIED, OPEN, events, Verdict.undecided("the events of the run", reason, detail))
