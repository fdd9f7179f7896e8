"""A run of the compliant model from an initial state: its events, with brackets, and how it ends.

Proof pages: ``proofs/flight.md``, section 8; for the first contact ``proofs/force_range.md`` and
``proofs/first_integrals.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, deviation
from gspot_verified.compliant.motion.compliant_force import contact_motion
from gspot_verified.compliant.motion.contact_series import MAX_WORK
from gspot_verified.compliant.motion.first_zero import contact_lasts, first_zero
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.compliant.motion.lift_off_state import contact_state, lift_off_state
from gspot_verified.compliant.motion.run_plan import later_times
from gspot_verified.compliant.motion.touch_down import flight_end
from gspot_verified.compliant.motion.zero_by_series import MOST_WORK
from gspot_verified.compliant.side.side_later import side
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.numbers.balls import ball_text, bits_for_digits, hull, sign_of, working_bits
from gspot_verified.numbers.evidence import equal, every, less, theorem
from gspot_verified.numbers.verdict import ASK_VERDICT, Evidence, NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written

MAX_DIGITS = 80  # of the brackets; a limit of input: ValueError beyond it
_SPARE_DIGITS = 10  # beyond those asked for, which the flight takes
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right
_TEXT_BITS = 400  # so that a bracket of 80 digits stays what it is in the text
_SHOWN_DIGITS = 30  # at most, in the text

IMPACT = "contact for ever: an impact without collision"
TRIVIAL = "contact for ever on the trivial solution: the force is constant"
ONE_FLIGHT = "exactly one flight, then contact for ever: an impact without collision"


@dataclass(frozen=True, slots=True)
class Event(NoTruthValue, Written):
    """Lift-off, touch-down, or the time from which the contact is known to last for ever.

    It happens in [lower, upper], times measured from the G-spot (p = alpha_1 t). ``velocity``: v there, in the units of
    the paper; ``strength`` says what is proved, by ``evidence``; ``state``: a ball of the whole state, in the normal
    form.
    """

    ask: ClassVar[str] = ".strength says what is proved"
    written: ClassVar[str] = "event=name lower upper v=velocity strength"

    name: str
    lower: fmpq
    upper: fmpq
    velocity: arb
    strength: str
    state: ContactState
    evidence: Evidence


@dataclass(frozen=True, slots=True)
class CompliantRun(NoTruthValue, Written):
    """The events of a run from an initial state, in order; the verdict speaks of the whole run."""

    ask: ClassVar[str] = ASK_VERDICT
    written: ClassVar[str] = "model start=start times events verdict"

    model: CompliantModel
    state: CompliantState
    events: tuple[Event, ...]
    verdict: Verdict

    @property
    def start(self) -> fmpq:
        """The time of the initial state, measured from the G-spot."""
        return self.state.p / self.model.alpha_1

    @property
    def times(self) -> str:
        """From when the times of events count, in plain data; the text counts them from the start."""
        return "measured from the G-spot; the run begins at start"

    def __str__(self) -> str:
        lines = [str(self.verdict)]
        for event in self.events:
            with working_bits(_TEXT_BITS):
                since = hull([arb(event.lower - self.start), arb(event.upper - self.start)])
                shown = since.str(_SHOWN_DIGITS)
            lines.append(f"  {event.name}: {shown} after the start, v = {ball_text(event.velocity, _SHOWN_DIGITS)}")
            lines.append(f"    {event.strength}")
        return "\n".join(lines)


def events(model: CompliantModel, state: CompliantState, digits: int = 15, budget: int = MOST_WORK) -> CompliantRun:
    """What the model does from a state in contact with p > 0, at this epsilon: proved, or undecided from some event on.

    Contact for ever is proved by an invariant set, not by a large force.

    :param digits: 1..80, decimals of the lift-off time in the unit of tau = (2 epsilon^2)^(-1/3) t.
    :param budget: the work of the power series, rate times time, that show the force before lift-off where the bound of
        its fast part does not.
    :raises ValueError: p <= 0; digits or budget out of range.

    >>> from gspot_verified import compliant_model, compliant_state
    >>> model = compliant_model("3/2", "1e-6")
    >>> run = events(model, compliant_state("1/2", -2, "-8e-12", 0, "-4e-12"))
    >>> run.verdict.statement
    'exactly one flight, then contact for ever: an impact without collision'
    """
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}, got {digits}")
    if type(budget) is not int or not 1 <= budget <= MAX_WORK:
        raise ValueError(f"budget must be an int and lie in 1..{MAX_WORK}, got {budget}")
    if (trivial := _trivial(model, state)) is not None:
        return CompliantRun(
            model, state, (), Verdict.proved(TRIVIAL, trivial, f"λ_N = {model.mean_force}; K = 0, the canard")
        )
    if not state.p > 0:
        raise ValueError(f"p: expected a state before the G-spot, p > 0, got {state.p}")
    rule = side_rule(model, state)
    bits = bits_for_digits(digits + _SPARE_DIGITS)
    if sign_of(rule.side) == 1:
        lasting = _lasting_from(model, state, digits + _SPARE_DIGITS, bits, budget)
        if lasting is not None:
            return CompliantRun(model, state, (lasting,), Verdict.proved(IMPACT, lasting.evidence))
    zero = first_zero(model, state, digits, budget)
    if zero.lower is None or zero.upper is None or zero.verdict.evidence is None:
        detail = f"neither the loss of contact nor its lasting for ever was shown: {zero.verdict.detail}"
        reason = zero.verdict.reason or Reason.HYPOTHESIS
        return CompliantRun(model, state, (), Verdict.undecided("how the first contact ends", reason, detail))
    return _after_lift_off(model, state, (zero.lower, zero.upper), zero.verdict.evidence, bits)


def _trivial(model: CompliantModel, state: CompliantState) -> Evidence | None:
    """That the state lies on the trivial solution exactly, and its force is positive."""
    hats = deviation(model, state)
    return every([*(equal(hat, 0) for hat in (hats.b, hats.V, hats.Y, hats.Z)), less(0, model.mean_force)])


def _lasting_from(model: CompliantModel, state: CompliantState, digits: int, bits: int, budget: int) -> Event | None:
    """The first of some times from which on the contact lasts for ever, after lambda > 0 up to it."""
    motion = contact_motion(model, state)
    for time in later_times(model):
        there = contact_state(motion.at(time, digits, parts=False), bits)
        verdict = lasting_contact(there, bits)
        if verdict.outcome is not Outcome.PROVED:
            continue
        before = contact_lasts(model, state, time, budget)
        shown = every([before.evidence, verdict.evidence])
        if before.outcome is not Outcome.PROVED or shown is None:
            return None
        strength = f"λ_N > 0 before it; from then on {verdict.detail}"
        return Event("contact for ever from", time, time, _velocity(model, there), strength, there, shown)
    return None


def _after_lift_off(
    model: CompliantModel, state: CompliantState, bracket: tuple[fmpq, fmpq], lost: Evidence, bits: int
) -> CompliantRun:
    """The events from a bracket of lift-off on; ``lost`` is what shows the lift-off."""
    digits, (lower, upper) = int(bits / 3), bracket
    there = contact_motion(model, state).at(lower, digits, parts=False)
    before = contact_state(there, bits + _GUARD_BITS)
    start = lift_off_state(before, (upper - lower) / model.epsilon, bits + _GUARD_BITS)
    lift = Event("lift-off", lower, upper, _velocity(model, start), "λ_N > 0 before it, dλ_N/dt < 0 at it", start, lost)
    end = flight_end(start, bits)
    ended = end.verdict.evidence
    if end.state is None or end.lower is None or end.upper is None or ended is None:
        return CompliantRun(model, state, (lift,), _resting_on([lost], end.verdict))
    first, last = lower + model.epsilon * end.lower, upper + model.epsilon * end.upper
    velocity, strength = _velocity(model, end.state), end.verdict.statement
    land = Event("touch-down", first, last, velocity, strength, end.state, ended)
    lasting = lasting_contact(end.state, bits)
    if lasting.outcome is Outcome.PROVED:
        once = theorem("proofs/flight.md", lost, ended, lasting.evidence)
        return CompliantRun(model, state, (lift, land), Verdict.proved(ONE_FLIGHT, once, lasting.detail))
    return CompliantRun(model, state, (lift, land), _resting_on([lost, ended], _second_contact(end.state, bits)))


def _resting_on(before: Sequence[Evidence], verdict: Verdict) -> Verdict:
    """The verdict; where it is "proved" it rests on what was shown before as well."""
    if verdict.outcome is not Outcome.PROVED:
        return verdict
    return Verdict.proved(verdict.statement, every([*before, verdict.evidence]), verdict.detail)


def _second_contact(state: ContactState, bits: int) -> Verdict:
    """What the sign of K says where the invariant sets do not apply."""
    value = side(state, bits)
    if (negative := less(value, 0)) is not None:
        return Verdict.proved("one flight, then a contact that is lost again", negative, f"K = {ball_text(value)} < 0")
    text = "the contact after the first flight"
    return Verdict.undecided(text, Reason.HYPOTHESIS, f"in none of the invariant sets; K = {ball_text(value)}")


def _velocity(model: CompliantModel, state: ContactState) -> arb:
    """v in the units of the paper."""
    with working_bits(_GUARD_BITS * 4):
        return state.V * (model.scaled_epsilon / model.sigma)
