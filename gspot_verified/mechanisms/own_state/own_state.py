"""An explicit epsilon_0 for the starts around the user's own state: from there to the starts near the G-spot.

Proof page: ``proofs/from_own_state.md``, Theorem P.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce

from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_side import AffineSide
from gspot_verified.expansion.from_state.slow_series import Contact, contact_text
from gspot_verified.functions.krawczyk import krawczyk_operator
from gspot_verified.mechanisms.approach.approach import MAX_STEPS, SPARE_BITS
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide, OwnSide
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.approach.slip_state import StateInput, slip_state
from gspot_verified.mechanisms.derive.slip_hypotheses import SlipHypotheses
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.own_state.compliant_tube import (
    CompliantEquations,
    CompliantTube,
    OwnStarts,
    compliant_tube,
)
from gspot_verified.mechanisms.own_state.fast_norm import FastNorm
from gspot_verified.mechanisms.own_state.rigid_way import WayPart, rigid_way
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.numbers.balls import ball, ball_text, float_bounds, rounded_text, working_bits
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.inner_text import in_inner_interval
from gspot_verified.numbers.verdict import Evidence, Reason, Verdict

_STARTS = OwnStarts(beside=fmpq(1), share=fmpq(1, 2))  # any numbers are right
_WEIGHTS = (fmpq(1), fmpq(1, 2), fmpq(1, 4), fmpq(1, 8))  # of the norm: any are right
_TRIES, _NEXT = 32, fmpq(3, 4)  # of epsilon, each time this part of it


def with_own_state(
    found: MechanismSide, mechanism: Mechanism, start: StateInput, spot: int | None = None, max_steps: int = MAX_STEPS
) -> MechanismSide:
    """The same with ``own``: what ``found.explicit`` says of starts near the G-spot, for those around ``start``.

    The arguments are those that :func:`mechanism_side` had.
    """
    side = found.explicit
    if side is None or side.side is None or side.way is None or found.side is None or found.reached is None:
        return found
    shifted = shift(at_spot(mechanism, spot))
    with working_bits(found.approach.bits + SPARE_BITS):
        question = _Question(
            found, side, shifted, SlipFlow.of(shifted), slip_state(shifted, start, spot is not None).box
        )
        way = rigid_way(question.flow, question.start, ball(side.start.p), max_steps)
        if way is None:
            return replace(found, own=question.open(side.epsilon, "rigid slip does not certainly come to these starts"))
        epsilon = side.epsilon
        for _ in range(_TRIES):
            own = question.answer(way, epsilon)
            if own.side is not None:
                break
            epsilon = epsilon * _NEXT
        return replace(found, own=own)


@dataclass(frozen=True, eq=False)
class _Question:
    """What is known of one mechanism and one state."""

    found: MechanismSide
    side: AffineSide
    shifted: Shifted
    flow: SlipFlow
    start: Sequence[arb]

    def answer(self, way: Sequence[WayPart], epsilon: fmpq) -> OwnSide:
        """For all epsilon up to this one; the first norm that serves."""
        equations, contact = CompliantEquations(self.flow), Contact.of(self.shifted.mechanism.regularisation)
        why = "no norm was tried"
        for weight in _WEIGHTS:
            tube = compliant_tube(equations, FastNorm(contact, weight), self.start, way, _STARTS, epsilon)
            if isinstance(tube, CompliantTube):
                shown = self._shown(tube)
                if isinstance(shown, Evidence):
                    verdict = self._proved(epsilon, way[-1].until, self._with_slip(tube, shown))
                    return OwnSide(_STARTS.beside, _STARTS.share, epsilon, self.side.side, verdict)
                return self.open(epsilon, shown)
            why = tube
        return self.open(epsilon, why)

    def open(self, epsilon: fmpq, why: str) -> OwnSide:
        """Undecided."""
        verdict = Verdict.undecided(f"{self._starts(epsilon)}: lift-off or impact", Reason.HYPOTHESIS, why)
        return OwnSide(_STARTS.beside, _STARTS.share, epsilon, None, verdict)

    def _shown(self, tube: CompliantTube) -> Evidence | str:
        """That the motion ends at one of the starts, and what the mechanism is supposed to be on the way."""
        start, way, mechanism = self.side.start, self.side.way, self.shifted.mechanism
        if way is None or self.side.verdict.evidence is None:
            return "nothing is known of the starts near the G-spot"
        active = [mechanism.state.index(word) for word in self.found.active]
        p, force, own, b = ball(start.p), ball(start.force), *tube.place[:2]
        largest = ball(start.within) * own * abs(ball(start.excess))
        states = _narrowed(SlipNumbers(self.flow), tube, active)
        conditions = {
            f"p = {_text(own)} lies in {_text(p)}": in_inner_interval(own, p),
            f"-b/p = {_text(tube.force)} lies in {_text(force)}": in_inner_interval(tube.force, force),
            f"b = {_text(b)} lies in {_text(ball(start.b))}": in_inner_interval(b, ball(start.b)),
            f"the fast part {_text(tube.fast)} is less than {_text(largest)}": less(tube.fast, largest),
            "the state is one of the chart": every(map(in_inner_interval, states, way.starts.around)),
        }
        failed = [name for name, shown in conditions.items() if shown is None]
        on_way = self._on_way(tube)
        if isinstance(on_way, str):
            return on_way
        evidence = every([self.side.verdict.evidence, tube.evidence, on_way, *conditions.values()])
        return f"not certain: {'; '.join(failed)}" if evidence is None else evidence

    def _on_way(self, tube: CompliantTube) -> Evidence | str:
        hypotheses, numbers, shown = SlipHypotheses(self.shifted), SlipNumbers(self.flow), list[Evidence | None]()
        for box in tube.boxes:
            checked = hypotheses.checked(box)
            if isinstance(checked, str):
                return checked
            shown.append(checked)
            if (surface := self.found.approach.surface) is not None:
                shown.append(less(surface, numbers.on(box).u))
        return every(shown) or "slip is not certainly positive on the way"

    def _with_slip(self, tube: CompliantTube, shown: Evidence) -> _Proved:
        """Whether slip lasts from the starts near the G-spot on."""
        if self.side.way is None or self.side.way.lost is None:
            return _Proved(shown)
        numbers = SlipNumbers(self.flow)
        left = numbers.on(tube.states).u - ball(self.side.way.lost)
        if self.found.approach.surface is not None:
            kept = every([shown, less(self.found.approach.surface, left)])
            return _Proved(shown) if kept is None else _Proved(kept, slip_lasts=True)
        slowest = reduce(arb.min, (numbers.on(box).u.lower() for box in tube.boxes), left.lower())
        return (
            _Proved(shown, slip_lasts=True, below=float_bounds(slowest)[0]) if slowest.is_finite() else _Proved(shown)
        )

    def _starts(self, epsilon: fmpq) -> str:
        contact = self.shifted.mechanism.regularisation
        state = self.found.approach.components(self.found.approach.start)
        surface = f" {self.found.approach.on_surface}".rstrip()
        return (
            f"{self.shifted.mechanism.name} with {contact_text(contact)}{surface}: every start in contact with each "
            f"component within {_STARTS.beside} epsilon of {state}, on the contact, and kappa p (v/epsilon)^2 + "
            f"(b + p lambda_N)^2 + (g^2/l) p fast^2 <= {_STARTS.share**2} b^2, {Contact.of(contact).fast_text}, "
            f"for every 0 < epsilon <= {epsilon}"
        )

    def _proved(self, epsilon: fmpq, time: arb, proved: _Proved) -> Verdict:
        both, alone = "contact and positive slip last", "contact lasts"
        condition = "as long as slip is positive, " if self.found.approach.surface is None else ""
        if proved.below is not None:
            condition = f"on any surface with a constant velocity below {rounded_text(proved.below, -1)} "
        before = alone if self.found.approach.surface is None and not proved.slip_lasts else both
        ends = {
            "lift-off": f"{both} until p < 0, and contact is lost later, in positive slip"
            if proved.slip_lasts
            else f"{alone} until p < 0 and is lost later",
            "impact": f"{both if proved.slip_lasts else alone} until p < 0, and after that until lambda_N exceeds the "
            "force stated there",
        }
        return Verdict.proved(
            f"{self._starts(epsilon)}: {condition}{before} up to t = {ball_text(time, 6)}, and the state is then one "
            f"of the starts above, so with what is said there {ends[str(self.side.side)]}",
            proved.evidence,
        )


@dataclass(frozen=True)
class _Proved:
    """What was compared; whether slip lasts as long as what is said, if the surface's velocity is ``below`` a number
    where it is not given."""

    evidence: Evidence
    slip_lasts: bool = False
    below: float | None = None


def _narrowed(numbers: SlipNumbers, tube: CompliantTube, active: Sequence[int]) -> list[arb]:
    """The active components of all states of the tube's end that have its p, b, y, v."""
    box, middle = list(tube.states), list(tube.states)
    for i in active:
        middle[i] = box[i].mid()
    left = [value - wanted for value, wanted in zip(numbers.conditions(middle), tube.place, strict=True)]
    over, near = ([[row[i] for i in active] for row in numbers.condition_rows(states)] for states in (box, middle))
    return krawczyk_operator(left, over, near, [box[i] for i in active]) or [box[i] for i in active]


def _text(value: arb) -> str:
    return ball_text(value, 5)
