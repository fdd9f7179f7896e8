"""From an initial state of slip to what happens: a G-spot and its side, lift-off, or the end of slip.

Proof pages: ``proofs/approach.md``, ``proofs/norm_step.md``, ``proofs/validated_step.md``. Paper, Secs. 1.2, 4.5, 5.4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from flint import arb, fmpq

from gspot_verified.expansion.series.regularisation import NO_DAMPER
from gspot_verified.functions.expressions import Constant
from gspot_verified.functions.krawczyk import krawczyk
from gspot_verified.functions.rings import BALLS
from gspot_verified.integrator.field.event import Crossing, Moment, Unclear, Watch, first_crossing
from gspot_verified.integrator.norm_steps.chosen_step import Steps
from gspot_verified.integrator.norm_steps.norm_run import NormRun, NormSegment
from gspot_verified.integrator.norm_steps.norm_step import UNIT_INTERVAL
from gspot_verified.mechanisms.approach.approach_plan import (
    Trials,
    bits_of_trial,
    disc_and_terms,
    exponent_for,
    last_exponent_for,
    lost_bits,
    too_few_bits,
)
from gspot_verified.mechanisms.approach.approach_result import EVENTS, IMPACT, LIFT_OFF, SLIP_STOPS, Approach, SlipPath
from gspot_verified.mechanisms.approach.capture import Capture, capture
from gspot_verified.mechanisms.approach.deviation_coefficient import coefficient_above_one, coefficient_below_one
from gspot_verified.mechanisms.approach.distinguished import shared_taylor_in_p, taylor_in_p
from gspot_verified.mechanisms.approach.fast_decay import surviving_exponent
from gspot_verified.mechanisms.approach.slip_programs import slip_programs
from gspot_verified.mechanisms.approach.slip_state import SlipState, StateError, StateInput, slip_state
from gspot_verified.mechanisms.derive.mass_matrix import check_mass_matrix
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.classify import case_of, sides_of
from gspot_verified.numbers.balls import (
    ExactInput,
    approximate,
    ball,
    ball_text,
    exact,
    relative_bits,
    sign_of,
    working_bits,
)
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.inner_text import text_of_each
from gspot_verified.numbers.verdict import Evidence, Reason, Verdict

MAX_STEPS = 600  # validated steps: a limit against endless work
PRECISIONS = (160, 400)  # bits, tried in turn: any is correct, more keep the last balls narrow
SPARE_BITS = 48  # more, which the polynomials of long steps leave to rounding errors
_SPARE_OF_FEW_BITS = 32  # the same with fewer bits than those
_LEAST_ORDER = 24  # of the polynomials of steps: with few bits what a step costs beside its terms counts more
_FEWEST_LOST = 6.0  # bits that p has lost before its neighbourhood is looked at without the surface's velocity
_SAMPLES = 4  # parts of a step that are checked, and points of it that are kept for pictures
_PARTS = tuple(arb((2 * k + 1, -3), (1, -3)) for k in range(_SAMPLES))  # [k/4, (k + 1)/4]
_FEWEST_BITS = 36  # of p: with fewer a run towards a G-spot ends, and what was seen before counts
_FEWEST_OF_FEW = 8  # the same with few bits, where signs are enough
_TOO_CLOSE = "lift-off and the end of slip happen too close together to tell which comes first"


class Goal(NamedTuple):
    """What ends a run: an answer that is ``enough``, with so many ``bits`` of C_1; with 0 of them its sign does."""

    enough: Callable[[Approach], bool]
    bits: int = 0


def approach(
    mechanism: Mechanism,
    state: StateInput,
    *,
    surface_velocity: ExactInput | None = None,
    max_steps: int = MAX_STEPS,
    spot: int | None = None,
) -> Approach:
    """Follow rigid slip (positive, on the contact) from ``state`` with every error bounded, and say where it ends.

    ``state`` gives all components, or all but two, which y = 0 and v = 0 then determine. With ``spot``, the number of
    a G-spot as ``classify_all`` lists them, all others that are left out are those of that G-spot.
    ``surface_velocity`` is the constant tangential velocity of the surface: slip stops at u = surface_velocity (so
    it counts against the x of the file where negative slip is mirrored). Without it the surface is at rest if u > 0 at
    the start; if u < 0 there, nothing is asked of u and the result says which surfaces it holds for.

    Proved: the trajectory reaches a G-spot (in finite time, with λ_N > 0 and positive slip until then), or lifts off,
    or slip stops, first; stick may follow then, or slip the other way. At a G-spot C_1 is enclosed and its sign gives
    the side by the paper's rule.

    :raises StateError: the state is not on the contact, p <= 0, b >= 0, or slip is not positive there.
    :raises MechanismError: the mechanism is not complete.
    :raises ValueError: there is no G-spot of that number.

    >>> from gspot_verified import load
    >>> model = load("model system")
    >>> result = approach(model, {"x": 0, "u": 3, "p": "1/2", "b": "-2"})
    >>> result.end, result.side, result.coefficient < 0
    ('G-spot', 'lift-off', True)
    """
    return followed(
        shift(at_spot(mechanism, spot)),
        state,
        surface_velocity=surface_velocity,
        max_steps=max_steps,
        beside_place=spot is not None,
    )


def followed(
    shifted: Shifted,
    state: StateInput,
    *,
    surface_velocity: ExactInput | None = None,
    max_steps: int = MAX_STEPS,
    beside_place: bool = False,
    precisions: Sequence[int] | None = None,
    goal: Goal | None = None,
) -> Approach:
    """The same for a mechanism whose functions are derived; ``beside_place``: what is left out is as at its place.

    ``precisions``: in bits (default: those of :func:`approach`), tried in turn until the end is proved and the sign of
    C_1 is certain. ``goal``: a run towards a G-spot ends as soon as it is met, and its answer holds no path; where no
    precision meets it, the answer has as many bits of C_1 as were found.
    """
    velocity = None if surface_velocity is None else exact(surface_velocity, "surface_velocity")
    best: Approach | None = None
    tried = precisions or PRECISIONS
    for bits in tried:
        more = bits != tried[-1]
        with working_bits(bits + (SPARE_BITS if bits >= SPARE_BITS else _SPARE_OF_FEW_BITS)):
            outcome = _Attempt(
                shifted, state, velocity, bits, max_steps, beside_place=beside_place, goal=goal, more=more
            ).result()
        known = outcome.coefficient is not None and sign_of(outcome.coefficient) in (1, -1)
        if goal is not None and goal.bits and outcome.end == "G-spot":
            if goal.enough(outcome):
                return outcome
            if best is None or _certain_bits(outcome) >= _certain_bits(best):
                best = outcome
        elif outcome.exit_code == 0 or known:  # more bits would not say more
            return outcome
    return outcome if best is None else best


def _certain_bits(found: Approach) -> int:
    """How many bits of C_1 are certain: 0 or less where its sign is not."""
    return 0 if found.coefficient is None else relative_bits(found.coefficient)


@dataclass(frozen=True, slots=True)
class _Caught:
    """States (the last component is the time) from which the G-spot is certainly reached.

    ``exponent``: how many bits p has lost, about.
    """

    states: list[arb]
    capture: Capture
    exponent: float


class _Attempt:
    """One run at one precision."""

    def __init__(
        self,
        shifted: Shifted,
        state: StateInput,
        velocity: fmpq | arb | None,
        bits: int,
        max_steps: int,
        beside_place: bool = False,
        goal: Goal | None = None,
        more: bool = False,
    ) -> None:
        self.mechanism, self.bits, self.max_steps = shifted.mechanism, bits, max_steps
        self.goal, self.more = goal, more
        self.wanted = 0 if goal is None else goal.bits
        self.programs = slip_programs(shifted)
        self.flow, self.numbers = self.programs.flow, self.programs.numbers
        self.hypotheses = self.programs.hypotheses
        self.start: SlipState = slip_state(shifted, state, beside_place)
        at = self.numbers.on(self.start.box)
        self._check(at.p, at.b)
        if isinstance(self.hypotheses.checked(self.start.box), str):  # then it says what is wrong
            place = dict(zip(self.mechanism.state, self.start.box, strict=True))
            check_mass_matrix(shifted, place, BALLS, "at the start")
        if velocity is None and at.u < 0:
            self.surface: arb | None = None
            self.surface_text: str | None = None
        else:
            self.velocity = fmpq(0) if velocity is None else velocity
            self.surface = ball(self.velocity)
            self.surface_text = "0" if velocity is None else text_of_each(velocity)
            if not at.u > self.surface:
                raise StateError(
                    f"{self.mechanism.name}: no positive slip: u = {ball_text(at.u)} is not certainly above the "
                    f"velocity {self.surface_text} of the surface"
                )
        self.rows: list[tuple[arb, tuple[arb, ...]]] = []
        self.least_slip: arb | None = None
        self.shown: list[Evidence | None] = []  # the way: steps, hypotheses, no event up to the first capture

    def _check(self, p: arb, b: arb) -> None:
        name = self.mechanism.name
        if not p > 0:
            raise StateError(
                f"{name}: p = {ball_text(p)} is not certainly positive: for p <= 0 the rigid slip force -b/p is no "
                "stable contact force (Painlevé paradox); start with p > 0"
            )
        if not b < 0:
            raise StateError(
                f"{name}: b = {ball_text(b)} is not certainly negative: for b >= 0 there is no positive contact force "
                "-b/p, the contact opens; start with b < 0"
            )

    def result(self) -> Approach:
        """The run, until something is proved or the budget ends."""
        field = self.programs.desingularised
        run = NormRun(
            field, [*self.start.box, arb(0)], steps=Steps(self.max_steps), slow=False, least_order=_LEAST_ORDER
        )
        watches = [Watch(LIFT_OFF, self.flow.b, field)]
        if self.surface is not None:
            watches.append(Watch(SLIP_STOPS, Constant(self.velocity) - self.flow.u, field))
        caught: _Caught | None = None
        marked: _Caught | None = None
        known: list[_Caught] = []
        trials = Trials(self.wanted, self.flow.dimension)
        for segment in run:
            doubt = self._doubt(segment)
            if doubt is not None:
                return self._open(doubt)
            if caught is None:
                events = [watch.along(segment) for watch in watches]
                if any(event is not None for event in events):
                    return self._event(watches, events, segment)
                quiet = every(watch.excluded(Moment(segment, arb(1))) for watch in watches)
            self._remember(segment)
            states = run.set.enclosure()
            if caught is not None and not self._tells(states):
                marked = marked or caught
                break
            neighbourhood = capture(self.numbers, states, self.surface)
            if neighbourhood is None:
                near = caught is None and self._near(states, _FEWEST_LOST)
                loose = capture(self.numbers, states, None) if near else None
                if loose is not None and self._near(states, exponent_for(loose, self.bits, self.wanted)):
                    slip = ball_text(loose.numbers.u, 6)
                    return self._open(f"u may fall to the surface's velocity just where p vanishes: u = {slip} there")
                continue
            supposed = self.hypotheses.checked(neighbourhood.box)
            if isinstance(supposed, str):
                continue
            if caught is None:
                if quiet is None:
                    continue
                self.shown += [quiet, neighbourhood.evidence, supposed]
            caught = _Caught(states, neighbourhood, lost_bits(self.numbers.on(states).p))
            if self.goal is not None:
                known.append(caught)
                found = self._early(known, trials, self.goal)
                if found is not None:
                    return found
            exponent = exponent_for(neighbourhood, self.bits, self.wanted)
            if marked is None and self._near(states, exponent):
                marked = caught
            if marked is not None and self._near(
                states, last_exponent_for(neighbourhood, exponent, self.bits, self.flow.dimension)
            ):
                break
        if caught is not None and self.goal is not None:
            marked = marked or caught
        if caught is not None and marked is not None:
            lost = marked.exponent if self.goal else exponent_for(marked.capture, self.bits, self.wanted)
            return self._at_spot(marked, caught, lost)
        return self._open(run.reason or "no end")

    def _early(self, known: list[_Caught], trials: Trials, goal: Goal) -> Approach | None:
        """The answer from these states, where it is enough, or more bits are needed; else the run goes on."""
        last = known[-1]
        hopeless = self.more and too_few_bits(last.capture, self.bits, self.wanted)
        chosen = len(known) - 1 if hopeless else trials.marked(known)
        if chosen is None:
            return None
        exponent = known[chosen].exponent
        needed = bits_of_trial(last.capture, exponent, self.bits, self.wanted)
        found = self._at_spot(known[chosen], last, exponent, needed)
        if hopeless or goal.enough(found):
            return found
        trials.tried(last, _certain_bits(found))
        return None

    def _doubt(self, segment: NormSegment) -> str | None:
        """A hypothesis on the mechanism that is not certain on some part of the segment."""
        self.shown.append(less(0, segment.step.h))
        for parts in ((UNIT_INTERVAL,), _PARTS):
            found = [self.hypotheses.checked(segment.states(part)) for part in parts]
            shown = [each for each in found if isinstance(each, Evidence)]
            if len(shown) == len(found):
                self.shown += shown
                return None
        return next(each for each in found if isinstance(each, str))

    def _remember(self, segment: NormSegment) -> None:
        if self.goal is not None:  # no path is asked for, and u only where it says which surfaces the answer is for
            if self.surface is None:
                self._note_slip(segment, arb(1))
            return
        first = [arb(0)] if not self.rows else []
        for tau in [*first, *(arb(k) / _SAMPLES for k in range(1, _SAMPLES + 1))]:
            states = segment.states(tau)
            self.rows.append((states[-1], tuple(states[:-1])))
        self._note_slip(segment, arb(1))

    def _note_slip(self, segment: NormSegment, end: arb) -> None:
        for part in _PARTS:
            slip = self.numbers.on(segment.states(part * end)).u.lower()
            self.least_slip = slip if self.least_slip is None else self.least_slip.min(slip)

    def _near(self, states: list[arb], exponent: float) -> bool:
        return bool(self.numbers.on(states).p < arb(2) ** -round(exponent))

    def _tells(self, states: list[arb]) -> bool:
        """Whether p is far enough from 0 for its errors to be small."""
        return self.numbers.on(states).p.rel_accuracy_bits() >= (
            _FEWEST_BITS if self.bits >= SPARE_BITS else _FEWEST_OF_FEW
        )

    def _at_spot(self, marked: _Caught, last: _Caught, exponent: float, bits: int = 0) -> Approach:
        """What is proved at the G-spot; ``exponent``: how many bits p has lost in the marked state, at least; ``bits``
        of the distinguished trajectory are needed there, 0: as many as there are."""
        place = self._spot(last.capture)
        star = self.numbers.on(place)
        alphas = (star.alpha_1, star.alpha_2, star.alpha_3)
        beta = star.alpha_3 / star.alpha_1
        case, reason = case_of(*alphas)
        coefficient = None
        if beta < 1:
            coefficient = coefficient_below_one(self.numbers, last.states, last.capture, place)
        elif beta > 1:
            disc, terms = disc_and_terms(approximate(beta), exponent, bits or self.bits)
            taylor = taylor_in_p if self.goal is None else shared_taylor_in_p
            states, around, field = marked.states, marked.capture, self.programs.by_p
            coefficient = coefficient_above_one(
                self.numbers, field, states, around, place, order=terms, disc=arb(2) ** -disc, taylor=taylor
            )
        side, why = self._side(case, reason, beta, coefficient)
        slip = last.capture.numbers.u.lower()
        self.least_slip = slip if self.least_slip is None else self.least_slip.min(slip)
        text = "slip reaches a G-spot in finite time, with a positive contact force until then"
        shown = every([*self.shown, last.capture.evidence])
        if shown is None:
            return self._open("it is not certain that neither lift-off nor the end of slip comes first")
        return self._made(
            verdict=Verdict.proved(text, shown),
            end="G-spot",
            time=last.states[-1] + last.capture.time * arb((1, -1), (1, -1)),
            place=place,
            case=case,
            alphas=alphas,
            beta=beta,
            coefficient=coefficient,
            side=side,
            why=why,
        )

    def _spot(self, neighbourhood: Capture) -> list[arb]:
        """The G-spot that is reached; the only one near, where it is isolated, is enclosed more tightly."""
        box = list(neighbourhood.box)
        if len(box) != 4:
            return box
        tight = krawczyk(self.numbers.conditions, self.numbers.condition_rows, box)
        if tight is None:
            return box
        for _ in range(4):
            again = krawczyk(self.numbers.conditions, self.numbers.condition_rows, tight)
            if again is None:
                break
            tight = again
        return tight

    def _side(self, case: str | None, reason: str, beta: arb, coefficient: arb | None) -> tuple[str | None, str]:
        if case not in ("I", "II", "III"):
            return None, reason
        if not self.mechanism.regularisation.c:
            return None, NO_DAMPER
        lift_off, impact = sides_of(case, beta)
        if impact is None:
            return None, "beta is, or may be, an integer: no side at leading order"
        if coefficient is None:
            return None, "C1 could not be enclosed: a hypothesis of its bound is not certain"
        sign = sign_of(coefficient)
        if sign in (None, 0):
            return None, "the state is too close to the distinguished trajectory: the sign of C1 is open"
        word = "C1 < 0" if sign < 0 else "C1 > 0"
        if sign == lift_off:
            return LIFT_OFF, f"Case {case}, {word}"
        return (IMPACT, f"Case {case}, {word}") if sign == impact else (None, f"Case {case}, {word}")

    def _event(self, watches: list[Watch], events: list[Crossing | Unclear | None], segment: NormSegment) -> Approach:
        first = first_crossing(watches, events)
        if first is None:
            unclear = next((each for each in events if isinstance(each, Unclear)), None)
            if unclear is None:
                return self._open(_TOO_CLOSE)
            return self._open(f"{unclear.name}: this may be grazing, it is not certain whether it happens")
        event, evidence = first
        self._note_slip(segment, event.end.tau)
        if self.surface is not None:  # until the event u is above it, whatever follows on the segment
            self.least_slip = None if self.least_slip is None else self.least_slip.max(self.surface.lower())
        states = list(event.states)
        return self._made(
            verdict=Verdict.proved(EVENTS[event.name], every([*self.shown, evidence])),
            end=event.name,
            time=states[-1],
            place=states[:-1],
            case=None,
            alphas=None,
            beta=None,
            coefficient=None,
            side=None,
            why="no G-spot is reached",
        )

    def _open(self, why: str) -> Approach:
        verdict = Verdict.undecided("where slip from this state ends", Reason.BUDGET, why)
        return self._made(
            verdict=verdict,
            end=None,
            time=None,
            place=[],
            case=None,
            alphas=None,
            beta=None,
            coefficient=None,
            side=None,
            why=why,
        )

    def _made(
        self, verdict: Verdict, end: str | None, time: arb | None, place: list[arb], case: str | None,
        alphas: tuple[arb, arb, arb] | None, beta: arb | None, coefficient: arb | None, side: str | None, why: str,
    ) -> Approach:  # fmt: skip
        path = self._path()
        fast = end == "G-spot" and self.goal is None and self.mechanism.regularisation.c > 0
        return Approach(
            name=self.mechanism.name,
            start=self._texts(list(self.start.box)),
            solved=self.start.solved,
            verdict=verdict,
            end=end,
            time=time,
            place=self._texts(place),
            case=case,
            alphas=alphas,
            beta=beta,
            coefficient=coefficient,
            side=side,
            side_reason=why,
            least_slip=self.least_slip,
            surface_velocity=self.surface_text,
            surface=self.surface,
            notes=self.mechanism.notes,
            path=path,
            bits=self.bits,
            supposed=self.start.supposed,
            fast_exponent=self._fast_exponent(path) if fast else None,
            spot=tuple(place) if end == "G-spot" else (),
            other_names=self.programs.other_names,
        )

    def _texts(self, values: list[arb]) -> tuple[tuple[str, str], ...]:
        """Components as text; an angle as ``reference + deviation``."""
        references = {angle.coordinate: angle.name for angle in self.mechanism.angles}
        components = []
        for word, value in zip(self.mechanism.state, values, strict=False):
            text = ball_text(value)
            components.append((word, f"{references[word]} + {text}" if word in references else text))
        return tuple(components)

    def _fast_exponent(self, path: SlipPath) -> float:
        p, times = ([approximate(value) for value in values] for values in (path.p, path.time))
        return surviving_exponent(times, p, self.mechanism.regularisation)

    def _path(self) -> SlipPath:
        numbers = [self.numbers.on(states) for _, states in self.rows]
        return SlipPath(
            tuple(time for time, _ in self.rows), tuple(states for _, states in self.rows),
            tuple(n.p for n in numbers), tuple(n.b for n in numbers), tuple(n.u for n in numbers),
            tuple(n.force for n in numbers),
        )  # fmt: skip
