"""What a certified run has shown, as a verdict: growth, events, and what the effects that are left out assume.

Proof page: ``proofs/left_out_effects.md``, section 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flint import arb, fmpq

from gspot_verified.numbers.balls import float_bounds, rounded_text
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.evidence import equal, every
from gspot_verified.numbers.verdict import Evidence, Reason, Verdict
from gspot_verified.scenes.certified.certified_phase import Open
from gspot_verified.scenes.certified.conditions import Conditions
from gspot_verified.scenes.certified.invariant_region import ExponentialGrowth
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.equations.terms import SLIP
from gspot_verified.scenes.scene.assumption import ASSUMED, CHECKED, VIOLATED, Assumption, provided
from gspot_verified.scenes.scene.run import CERTIFIED, NO_EVENT, OPEN, REFUTED, RunEvent, SceneRun, fate_of
from gspot_verified.scenes.scene.scene import Scene

_NOT_FURTHER = "the run is not followed further"


@dataclass
class Record:
    """What a run at one precision has shown; ``multiples``: how far each impact is shown to grow, None: no limit.
    ``limits``: the same of each in words.

    ``violated``: the effect whose absence is wrong, when, and what was compared. ``seen``: up to when those that are
    watched hold. ``shown``: the evidence of each event; ``ended``: that of the end of the run, None where it was not
    reached. ``stopped``: when λ_N had certainly passed the scene's ``stop_at_force``, if that ended the run.
    ``phase``: the last one.
    """

    events: list[RunEvent] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    multiples: list[int | None] = field(default_factory=list)
    limits: list[str] = field(default_factory=list)
    open: Open | None = None
    for_ever: bool = False
    violated: tuple[str, arb, Evidence] | None = None
    seen: arb = field(default_factory=lambda: arb(0))
    shown: list[Evidence] = field(default_factory=list)
    ended: Evidence | None = None
    stopped: arb | None = None
    phase: str = SLIP

    @property
    def evidence(self) -> Evidence | None:
        """What shows the whole run; None where an event, or the end, has none."""
        return every([equal(len(self.shown), len(self.events)), *self.shown, self.ended])


def growth_words(growth: ExponentialGrowth, sticks: bool, since: arb | None) -> str:
    """How λ_N grows; ``since``: from which time on, where that is not that of the event."""
    rate, motion = rounded_text(float_bounds(growth.rate)[0], -1), "stick" if sticks else "slip"
    begin = "" if since is None else f"from t = {rounded_text(float_bounds(since)[1], 1, 6)} after the start on "
    grows = f"{begin}λ_N grows at least like exp({rate} t/ε)"
    if growth.until is not None:
        return f"{grows} until it is {growth.until} times as large, or {motion} ends"
    lasting = f"{grows} for as long as the contact {motion}s"
    if growth.within is None:
        return lasting
    return f"{lasting}, which ends within {rounded_text(float_bounds(growth.within)[1], 1)} ε"


def statement(
    fate: str, span: str, multiples: Sequence[int | None] = (), limits: Sequence[str] = (), phase: str = SLIP
) -> str:
    """What is proved. An impact without collision that no cone shows is not excluded, so "no event" would be too much;
    and where a cone shows the growth of λ_N up to a multiple only, the multiple is part of the statement, which then is
    true of every impact of the run; else ``limits`` says of each how λ_N grows, and how long. ``phase`` is the last
    one: where it is the only one and not slip, it is named.

    >>> statement("lift-off", " until t = 1 after the start")
    'lift-off until t = 1 after the start, and no other change of phase'
    >>> statement("impact without collision", "", (8, None))
    'impact without collision (λ_N grows 8-fold, or slip or stick ends), and no other change of phase'
    >>> statement("impact without collision", "", (None,), ("λ_N grows for as long as the contact slips",))
    'impact without collision (λ_N grows for as long as the contact slips), and no other change of phase'
    """
    if fate == NO_EVENT:
        return f"no change of phase{span}" if phase == SLIP else f"{phase} from the start on, no change of phase{span}"
    known = [multiple for multiple in multiples if multiple is not None]
    said = f"λ_N grows {min(known)}-fold, or slip or stick ends" if known else "; then ".join(limits)
    return f"{fate}{f' ({said})' if said else ''}{span}, and no other change of phase"


def bracket(time: arb, epsilon: fmpq) -> tuple[fmpq, fmpq]:
    """A time in the paper's unit, between two exact numbers."""
    bounds = Dyadic.from_ball(time)
    unit = epsilon * fmpq(2) ** bounds.exponent
    return bounds.lower * unit, bounds.upper * unit


def event_of(name: str, time: arb, epsilon: fmpq) -> RunEvent:
    """An event between two exact times."""
    return RunEvent(name, *bracket(time, epsilon))


def _assumptions(scene: Scene, conditions: Conditions, record: Record) -> tuple[Assumption, ...]:
    """How each condition of the scene stands after this run."""
    assumptions = []
    for effect in scene.conditional():
        assert effect.condition is not None
        text, start = effect.condition.text, (fmpq(0), fmpq(0))
        if record.violated is not None and record.violated[0] == effect.name:
            assumptions.append(Assumption(effect.name, text, VIOLATED, *bracket(record.violated[1], scene.epsilon)))
        elif effect.name in conditions.unknown:
            assumptions.append(Assumption(effect.name, text, ASSUMED, *start, conditions.unknown[effect.name]))
        elif effect.name in conditions.lost:
            since = bracket(conditions.certain_until, scene.epsilon)
            assumptions.append(Assumption(effect.name, text, ASSUMED, *since, "neither it nor its contrary is certain"))
        elif record.open is not None or record.violated is not None:
            since = bracket(record.seen, scene.epsilon)
            assumptions.append(Assumption(effect.name, text, ASSUMED, *since, _NOT_FURTHER))
        else:
            assumptions.append(Assumption(effect.name, text, CHECKED))
    return tuple(assumptions)


def _to_add(scene: Scene, failed: Assumption) -> str:
    """The effect whose absence is wrong, and those that need it and whose absence then assumes the same."""
    wanted = (failed.effect, *(e.name for e in scene.left_out() if _goes_on(e, failed)))
    return f"the effect{'s' if len(wanted) > 1 else ''} {' and '.join(map(repr, wanted))}"


def _goes_on(effect: Effect, failed: Assumption) -> bool:
    return failed.effect in effect.needs and effect.condition is not None and effect.condition.text == failed.assumes


def _span(scene: Scene, record: Record) -> str:
    """Up to when the run is followed, in words."""
    if record.stopped is None:
        return f" until t = {scene.until} after the start"
    lower, upper = float_bounds(record.stopped * scene.epsilon)
    until, by = rounded_text(lower, -1, 12), rounded_text(upper, 1, 12)
    large = f"λ_N is more than {scene.stop_at_force} times that of rigid slip at the start"
    return f" until t = {until} after the start; by t = {by} {large}"


def result_of(scene: Scene, conditions: Conditions, record: Record) -> SceneRun:
    """The run: proved to its end, refuted where an absence is wrong, or undecided from some time on."""
    events = tuple(record.events)
    names = [event.name for event in events]
    remarks = "; ".join(record.remarks)
    assumptions = _assumptions(scene, conditions, record)
    known = f"certain before it: {fate_of(names)}"
    span = "" if record.for_ever else _span(scene, record)
    failed = next((each for each in assumptions if each.standing == VIOLATED), None)
    on = provided([each for each in assumptions if each.why != _NOT_FURTHER])
    if failed is not None and record.violated is not None:
        verdict = Verdict.refuted(
            f"{failed.assumes}{span}, as leaving {failed.effect} out assumes{on}",
            f"that {failed.assumes} fails at {failed.when} after the start: add {_to_add(scene, failed)}",
            record.violated[2],
            "; ".join(filter(None, (known, remarks))),
        )
        return SceneRun(CERTIFIED, REFUTED, events, verdict, assumptions=assumptions)
    if record.open is None:
        fate = fate_of(names)
        limits = () if record.for_ever and len(record.limits) == 1 else record.limits
        said = statement(fate, span, record.multiples, limits, record.phase) + on
        remarks = "; ".join(remark for remark in record.remarks if remark not in said)
        return SceneRun(
            CERTIFIED, fate, events, Verdict.proved(said, record.evidence, remarks), assumptions=assumptions
        )
    at = (record.open.time * scene.epsilon).str(10)
    detail = "; ".join(filter(None, (f"{record.open.reason} (t = {at} after the start)", known, remarks)))
    reason = Reason.BUDGET if record.open.budget else Reason.HYPOTHESIS
    verdict = Verdict.undecided(f"the events of the run{on}", reason, detail)
    return SceneRun(CERTIFIED, OPEN, events, verdict, assumptions=assumptions)
