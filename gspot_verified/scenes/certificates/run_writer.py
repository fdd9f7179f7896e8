"""What a certificate says of a run, from the steps that were chosen: curves, brackets, bounds of errors.

The producer's side of ``proofs/run_certificate.md``. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from flint import arb, fmpq

from gspot_verified.certificates.text import RUN_VERSION, sealed
from gspot_verified.functions.derivative import ZERO
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.integrator.norm_steps.norm_step import NormStep
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.scenes.certificates.bounded_step import BoundedStep, NotBounded, bounded_step, grid
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase
from gspot_verified.scenes.certified.growth_cone import ContactPoint, SlowCone, cones
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.effects.stick import STICKS
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.motions.contact_form import ContactForm
from gspot_verified.scenes.scene.run import IMPACT, SceneRun
from gspot_verified.scenes.scene.scene import Scene

_CHECKER_BITS = 128  # more than the run's
_SPARE_BITS = 64  # more than the checker's, for this file's own balls
_GUARD_BITS = 32  # of the run's bits that coefficients do not use
_DIGITS = 2  # of the width of a bracket, as it is written
_PLACES = 12  # decimals of the time at which a run ends that its force ends
_NEWTON_STEPS = 4  # from the bracket of the run to the zero of a curve
_FORMS = {"touch-down": ("Y", "Z"), "lift-off": ("Z", "Y"), "stick": ("u", "")}


class WrittenPhase(Protocol):
    """The equations of one phase as a certificate has them: ``names`` of the states; ``resting``: those that rest."""

    names: tuple[str, ...]
    field: VectorField
    resting: list[str]

    def enter(self, states: dict[str, arb]) -> None:
        """Add what begins with the phase."""
        ...

    def chosen(self, step: ChosenStep, unit: int) -> ChosenStep:
        """A step of the run for these states, with coefficients that are not below 2^-unit."""
        ...

    def event(self, name: str) -> Callable[[Sequence[Any]], Any]:
        """The function of an event, for balls or polynomials in the places of the states."""
        ...


class ModelPhase:
    """A phase of the model system: its states are those of the run."""

    def __init__(self, scene: Scene, name: str) -> None:
        phase = CertifiedPhase(scene.system(name))
        self.system, self.field, self.names = phase.system, phase.field, phase.names
        self.resting = [each for each, rate in zip(self.names, self.field.functions, strict=True) if rate is ZERO]
        self._name = name

    def enter(self, states: dict[str, arb]) -> None:
        """Nothing begins with a phase."""

    def chosen(self, step: ChosenStep, unit: int) -> ChosenStep:  # noqa: ARG002
        """The step as it is."""
        return step

    def event(self, name: str) -> Callable[[Sequence[Any]], Any]:
        """A sum of states with signs."""
        plus, minus = _FORMS[name]
        signs = {plus: -1 if name == STICKS and self._name == REVERSE else 1} | ({minus: -1} if minus else {})
        form = [(sign, self.names.index(state)) for state, sign in signs.items()]
        return lambda states: sum(sign * states[i] for sign, i in form)


@dataclass
class Place:
    """Where a phase begins: its name, and all states there, with the clock."""

    phase: str
    states: dict[str, arb]


@dataclass
class RunWriter:
    """Follows the steps of one run at the precision of its certificate, and writes down what a checker needs."""

    scene: Scene
    run: SceneRun
    bits: int
    lines: list[Any] = field(default_factory=list)
    events: list[list[str]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.until = self.scene.until

    @property
    def last(self) -> int:
        """The checker's bits."""
        return self.bits + _CHECKER_BITS

    def start(self) -> dict[str, arb]:
        """All states where the run begins."""
        return {name: arb(value) for name, value in self.scene.scaled_initial().items()}

    def phase(self, name: str) -> WrittenPhase:
        """The equations of a phase."""
        return ModelPhase(self.scene, name)

    def after(self, phase: str, event: str, states: dict[str, arb]) -> str:  # noqa: ARG002
        """The phase after an event; its states may become exact."""
        if event == LIFT_OFF:
            return FLIGHT
        if event == STICKS:
            states["u"] = arb(0)
            return STICK
        slip = states.get("u", arb(1))
        if slip.is_zero() and STICKS in self.scene.effects:
            return STICK
        return SLIP if slip > 0 else REVERSE

    def said_of_scene(self) -> dict[str, Any]:
        """What the statement says beside events and end."""
        return {
            "effects": sorted(self.scene.effects),
            "epsilon": str(self.scene.epsilon),
            "kind": "run",
            "parameters": {name: str(value) for name, value in self.scene.values().items()},
            "start": {name: str(value) for name, value in self.scene.initial().items() if name != "nu"},
        }

    def text(self, phases: Sequence[Sequence[ChosenStep]]) -> str:
        """The certificate."""
        with working_bits(self.last + _SPARE_BITS):
            names = [event.name for event in self.run.events if event.name != IMPACT]
            place = Place(SLIP, self.start() | {CLOCK: arb(0)})
            end = ""
            for i, steps in enumerate(phases):
                event = names[i] if i < len(names) else ""
                end = self._phase(place, steps, event)
        statement = self.said_of_scene() | {"end": end, "events": self.events, "until": str(self.until)}
        return sealed(RUN_VERSION, statement, [{"bits": self.last}, *self.lines])

    def _phase(self, place: Place, steps: Sequence[ChosenStep], event: str) -> str:
        """Write one phase, and go on to where the next one begins; the end of the run, where this is the last."""
        head: dict[str, Any] = {"bracket": [], "cone": [], "event": event, "phase": place.phase, "steps": len(steps)}
        self.lines.append(head)
        phase = self.phase(place.phase)
        phase.enter(place.states)
        clock, states = place.states[CLOCK], [place.states[name] for name in phase.names]
        before: NormStep | None = None
        for chosen in steps:
            h = self._length(clock) if chosen.h is None else chosen.h
            unit = self.bits - _GUARD_BITS
            step = phase.chosen(chosen, unit)
            found: BoundedStep = bounded_step(phase.field, phase.names, step, h, before, states, (unit, self.last))
            self.lines.append(found.text)
            before, began = found.step, clock
            states, clock = [p(arb(1)) for p in before.solution], clock + h
        assert before is not None
        if event:
            self._event(head, place, phase, before, began)
            return ""
        if steps[-1].h is None:
            return "time"
        if not isinstance(phase, ModelPhase):  # a large force has ended the run
            self.until = _before(clock * self.scene.epsilon)
            return "time"
        head["cone"] = _cone(phase, before.enclosure(arb(1)), clock)
        return "for ever"

    def _length(self, clock: arb) -> arb:
        """What is left of the time, for the earliest clock, on the checker's grid."""
        left = arb(self.scene.until / self.scene.epsilon) - clock
        return arb((grid(left.upper(), self.last) + 1, -self.last))

    def _event(self, head: dict[str, Any], place: Place, phase: WrittenPhase, step: NormStep, began: arb) -> None:
        """The bracket of the event in the last step, and where the next phase begins."""
        name = head["event"]
        function = phase.event(name)

        def value(tau: arb) -> arb:
            found: arb = function(step.enclosure(tau))
            return found

        curve = function(step.solution)
        known = [event for event in self.run.events if event.name != IMPACT][len(self.events)]
        tau = ((hull((arb(known.lower), arb(known.upper))) / self.scene.epsilon - began) / step.h).mid()
        for _ in range(_NEWTON_STEPS):
            tau = (tau - curve(tau) / curve.derivative()(tau)).mid()
        middle = arb((grid(tau, self.last), -self.last))
        left, right = self._first(value, middle, -1), self._first(value, middle, 1)
        head["bracket"] = [[grid(end, self.last), -self.last] for end in (left, right)]
        states = zip(phase.names, step.enclosure(hull((left, right))), strict=True)
        place.states |= {state: ball for state, ball in states if state not in phase.resting}
        place.states[CLOCK] = began + hull((left, right)) * step.h
        self.events.append([name, *self._bracket(place.states[CLOCK])])
        place.phase = self.after(place.phase, name, place.states)

    def _first(self, value: Callable[[arb], arb], middle: arb, side: int) -> arb:
        """The next point to one side where the function's sign is certain."""
        for power in range(self.last):
            tau = middle + arb((side << power, -self.last))
            if not (tau > 0 and tau <= 1):
                break
            if value(tau) * side < 0:
                return tau
        raise NotBounded("an event is not inside of one step")

    def _bracket(self, time: arb) -> list[str]:
        """Decimals around a time in the paper's unit."""
        bounds = Dyadic.from_ball(time * self.scene.epsilon)
        low, high = bounds.lower * fmpq(2) ** bounds.exponent, bounds.upper * fmpq(2) ** bounds.exponent
        places = next(n for n in range(self.last) if fmpq(10) ** (n - _DIGITS) * (high - low) >= 1)
        power = fmpq(10) ** places
        return [str(fmpq((low * power).floor()) / power), str(fmpq((high * power).ceil()) / power)]


def _cone(phase: ModelPhase, box: Sequence[arb], clock: arb) -> list[str]:
    """The numbers of a cone that is kept for ever."""
    form = ContactForm(phase.system)
    named = dict(zip(phase.names, box, strict=True))
    whole = [named[name] for name in form.names] + [clock, form.k * (named["Z"] - named["Y"])]
    bounds = form.bounds(whole)
    for cone in cones(form, ContactPoint.of(form, whole), bounds):
        if cone.is_kept(bounds) and cone.is_kept_for_ever(bounds):
            return [_exact(cone.rate), *([_exact(cone.c)] if isinstance(cone, SlowCone) else [])]
    raise NotBounded("no cone holds the states at the end of the run for ever")


def _exact(value: arb) -> str:
    mantissa, exponent = value.mid().man_exp()
    return str(fmpq(int(mantissa)) * fmpq(2) ** int(exponent))


def _before(time: arb) -> fmpq:
    """A decimal just before a time."""
    bounds = Dyadic.from_ball(time)
    power = fmpq(10) ** _PLACES
    return fmpq((bounds.lower * fmpq(2) ** bounds.exponent * power).floor()) / power
