"""A run of the compliant model from an initial state: its events, with brackets, and how it ends.

Proof pages: ``proofs/flight.md``, sections 8 and 9; for the first contact ``proofs/force_range.md`` and
``proofs/first_integrals.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, deviation
from gspot_verified.compliant.motion.compliant_force import contact_motion
from gspot_verified.compliant.motion.contact_series import MAX_WORK
from gspot_verified.compliant.motion.first_zero import contact_lasts, first_zero
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.compliant.motion.later_contact import LaterContact, TouchDown, later_contact
from gspot_verified.compliant.motion.lift_off_state import contact_state, lift_off_state
from gspot_verified.compliant.motion.run_plan import later_times
from gspot_verified.compliant.motion.touch_down import flight_end
from gspot_verified.compliant.motion.zero_by_series import MOST_WORK
from gspot_verified.compliant.side.side_later import side
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.numbers.balls import ball_text, bits_for_digits, digits_for_bits, hull, sign_of, working_bits
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.evidence import equal, every, less, theorem
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written

MAX_DIGITS = 80  # of the brackets; a limit of input: ValueError beyond it
_MORE_DIGITS = (40, 80)  # tried where what follows the lift-off needs more than were asked for
_SPARE_DIGITS = 10  # beyond those asked for, which the flight takes
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right
_TEXT_BITS = 400  # so that a bracket of 80 digits stays what it is in the text
_SHOWN_DIGITS = 30  # at most, in the text

IMPACT = "contact for ever: an impact without collision"
TRIVIAL = "contact for ever on the trivial solution: the force is constant"
AFTER_FLIGHTS = "then contact for ever: an impact without collision"
ONE_FLIGHT = f"exactly one flight, {AFTER_FLIGHTS}"
MOST_FLIGHTS = 8
"""How many flights are followed, unless a caller says otherwise."""


@dataclass(frozen=True, slots=True)
class Event(NoTruthValue, Written):
    """Lift-off, touch-down, or the time from which the contact is known to last for ever.

    It happens in [lower, upper], times measured from the G-spot (p = alpha_1 t). ``velocity``: v there, in the units of
    the paper, not finite where the balls got too wide; ``strength`` says what is proved, by ``evidence``; ``state``: a
    ball of the whole state, in the normal form.
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
    """The events of a run from an initial state, in order.

    The verdict speaks of the whole run, or of it up to a contact that is lost again: then neither when, nor what
    follows, is known.
    """

    written: ClassVar[str] = "model state start=start times events verdict"

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
            velocity = f"v = {ball_text(event.velocity, _SHOWN_DIGITS)}"
            if not event.velocity.is_finite():
                velocity = "v has no enclosure"
            lines.append(f"  {event.name}: {shown} after the start, {velocity}")
            lines.append(f"    {event.strength}")
        return "\n".join(lines)


def events(
    model: CompliantModel,
    state: CompliantState,
    digits: int = 15,
    budget: int = MOST_WORK,
    flights: int = MOST_FLIGHTS,
) -> CompliantRun:
    """What the model does from a state in contact with p > 0, at this epsilon: proved, or undecided from some event on.

    Contact for ever is proved by an invariant set, not by a large force.

    :param digits: 1..80, decimals of the lift-off time in the unit of tau = (2 epsilon^2)^(-1/3) t.
    :param budget: the work of the power series, rate times time, that show the force before lift-off where the bound of
        its fast part does not, and in each contact after a flight.
    :param flights: how many flights are followed.
    :raises ValueError: p <= 0; digits, budget or flights out of range.

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
    if type(flights) is not int or flights < 1:
        raise ValueError(f"flights: expected an int >= 1, got {flights}")
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
    for accuracy in (digits, *(more for more in _MORE_DIGITS if more > digits)):
        zero = first_zero(model, state, accuracy, budget)
        if zero.lower is None or zero.upper is None or zero.verdict.evidence is None:
            if accuracy != digits:
                break  # what fewer digits gave stands
            detail = f"neither the loss of contact nor its lasting for ever was shown: {zero.verdict.detail}"
            reason = zero.verdict.reason or Reason.HYPOTHESIS
            return CompliantRun(model, state, (), Verdict.undecided("how the first contact ends", reason, detail))
        bits = bits_for_digits(accuracy + _SPARE_DIGITS)
        there = contact_motion(model, state).at(zero.lower, int(bits / 3), parts=False)
        followed = _Followed(model, state, bits, budget)
        bracket, before = (zero.lower, zero.upper), contact_state(there, bits + _GUARD_BITS)
        run = followed.after_lift_off(before, bracket, zero.verdict.evidence, flights)
        if not followed.lacks_bits:
            break
    return run


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


@dataclass(slots=True)
class _Followed:
    """A run from its first lift-off on: the events that were found, and what they rest on."""

    model: CompliantModel
    state: CompliantState
    bits: int
    budget: int
    events: list[Event] = field(default_factory=list)
    shown: list[Evidence] = field(default_factory=list)
    lacks_bits: bool = False  # more of them may help

    def after_lift_off(
        self, before: ContactState, bracket: tuple[fmpq, fmpq], lost: Evidence, flights: int
    ) -> CompliantRun:
        """The whole run; ``before``: the state at the lower end of the bracket, ``lost``: what shows the lift-off."""
        for number in range(1, flights + 1):
            start = self._lifted(before, bracket, lost)
            end = flight_end(start, self.bits)
            if end.state is None or end.lower is None or end.upper is None or end.verdict.evidence is None:
                self.lacks_bits = end.verdict.outcome is not Outcome.PROVED
                return self._ended(_of_flight(end.verdict, number))
            lower, upper = bracket
            landed = (lower + self.model.epsilon * end.lower, upper + self.model.epsilon * end.upper)
            self._note("touch-down", landed, end.state, end.verdict.statement, end.verdict.evidence)
            lasting = lasting_contact(end.state, self.bits)
            if lasting.outcome is Outcome.PROVED:
                once = theorem("proofs/flight.md", *self.shown, lasting.evidence)
                return self._run(Verdict.proved(_after_flights(number), once, lasting.detail))
            later = self._later(end.state, landed)
            if isinstance(later, Reason):
                self.lacks_bits = True
                return self._ended(_next_contact(end.state, self.bits, number, self._open(later)))
            bracket = (landed[1] + self.model.epsilon * later.lower, landed[1] + self.model.epsilon * later.upper)
            before, lost = later.state, later.evidence
            if later.lasts is not None:
                self._note("contact for ever from", bracket, before, f"λ_N > 0 before it; {later.lasts}", lost)
                once = theorem("proofs/flight.md", *self.shown)
                return self._run(Verdict.proved(_after_flights(number), once, later.lasts))
        self._lifted(before, bracket, lost)
        detail = f"not followed further: its budget of {counted(flights, 'flight')}"
        return self._run(Verdict.undecided("how the run goes on", Reason.BUDGET, detail))

    def _lifted(self, before: ContactState, bracket: tuple[fmpq, fmpq], lost: Evidence) -> ContactState:
        duration = (bracket[1] - bracket[0]) / self.model.epsilon
        start = lift_off_state(before, duration, self.bits + _GUARD_BITS)
        self._note("lift-off", bracket, start, "λ_N > 0 before it, dλ_N/dt < 0 at it", lost)
        return start

    def _later(self, landed: ContactState, bracket: tuple[fmpq, fmpq]) -> LaterContact | Reason:
        model, (first, last) = self.model, bracket
        touch_down = TouchDown(landed, (last - first) / model.epsilon, model.alpha_1 * last)
        digits = digits_for_bits(self.bits)
        return later_contact(touch_down, model.mean_force * model.sigma**2, digits, self.bits, self.budget)

    def _open(self, reason: Reason) -> tuple[Reason, str]:
        """The reason, and what was not found."""
        none = "it was found in none of the invariant sets, nor a zero of its force"
        if reason is Reason.BUDGET:
            return reason, f"{none}, within its budget of {self.budget} (the work of the power series, rate times time)"
        return reason, f"{none}: the balls of its state are too wide for a sign"

    def _note(
        self, name: str, bracket: tuple[fmpq, fmpq], state: ContactState, strength: str, evidence: Evidence
    ) -> None:
        self.events.append(Event(name, *bracket, _velocity(self.model, state), strength, state, evidence))
        self.shown.append(evidence)

    def _ended(self, verdict: Verdict) -> CompliantRun:
        return self._run(_resting_on(self.shown, verdict))

    def _run(self, verdict: Verdict) -> CompliantRun:
        return CompliantRun(self.model, self.state, tuple(self.events), verdict)


def _after_flights(number: int) -> str:
    return ONE_FLIGHT if number == 1 else f"exactly {number} flights, {AFTER_FLIGHTS}"


def _of_flight(verdict: Verdict, number: int) -> Verdict:
    """The verdict on the end of a flight, as one on the run; the first flight needs no number."""
    if number == 1 or verdict.outcome is not Outcome.PROVED:
        return verdict
    return Verdict.proved(f"{number} flights, and the last one never ends", verdict.evidence, verdict.detail)


def _resting_on(before: Sequence[Evidence], verdict: Verdict) -> Verdict:
    """The verdict; where it is "proved" it rests on what was shown before as well."""
    if verdict.outcome is not Outcome.PROVED:
        return verdict
    return Verdict.proved(verdict.statement, every([*before, verdict.evidence]), verdict.detail)


def _next_contact(state: ContactState, bits: int, number: int, why: tuple[Reason, str]) -> Verdict:
    """What the sign of K says of the contact after a flight where its end was not found."""
    value, so_far = side(state, bits), "one flight" if number == 1 else f"{number} flights"
    if (negative := less(value, 0)) is not None:
        return Verdict.proved(f"{so_far}, then a contact that is lost again", negative, f"K = {ball_text(value)} < 0")
    reason, text = why
    return Verdict.undecided(f"the contact after {so_far}", reason, f"{text}; K = {ball_text(value)}")


def _velocity(model: CompliantModel, state: ContactState) -> arb:
    """v in the units of the paper."""
    with working_bits(_GUARD_BITS * 4):
        return state.V * (model.scaled_epsilon / model.sigma)
