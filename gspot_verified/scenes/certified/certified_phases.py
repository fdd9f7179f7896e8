"""Which phase follows which in a certified run: lift-off, touch-down, slip, stick, by certain signs only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase, Open
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.effects.stick import SLIPS, STICKS
from gspot_verified.scenes.effects.tangential_motion import SLIP_STOPS
from gspot_verified.scenes.equations.scaled_system import CONTACT, PhaseEvent, ScaledSystem
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.scene.scene import Scene


@dataclass(frozen=True)
class Next:
    """A phase that begins; ``at_zero``: the events whose functions vanish at its beginning, and which derivative of
    each is the first that does not, where that is known beforehand."""

    phase: str
    at_zero: dict[str, int | None]


@dataclass(frozen=True)
class Following:
    """The name of the event that ended a phase, and what follows it."""

    event: str
    phase: Next | Open


class CertifiedPhases:
    """The phases of one scene at the precision in force, compiled when they are first asked for.

    ``followed``: effects that are left out, what their conditions need is integrated; ``watched``: those of them whose
    conditions end a phase where they end to hold.
    """

    def __init__(self, scene: Scene, followed: Sequence[Effect] = (), watched: Sequence[Effect] = ()) -> None:
        self._scene, self._followed = scene, tuple(followed)
        self._watched = {effect.name for effect in watched}
        self._whole: dict[str, ScaledSystem] = {}
        self._compiled: dict[str, CertifiedPhase] = {}

    def __getitem__(self, phase: str) -> CertifiedPhase:
        if phase not in self._compiled:
            self._compiled[phase] = CertifiedPhase(self._system(phase))
        return self._compiled[phase]

    def _all_events(self, phase: str) -> ScaledSystem:
        if phase not in self._whole:
            self._whole[phase] = self._scene.system(phase, self._followed)
        return self._whole[phase]

    def _system(self, phase: str) -> ScaledSystem:
        whole = self._all_events(phase)
        kept = (event for event in whole.events if not event.left_out or event.left_out in self._watched)
        return replace(whole, events=tuple(kept))

    def conditions(self, phase: str, states: Mapping[str, arb]) -> list[tuple[PhaseEvent, arb]]:
        """The conditions that are followed in a phase, with enclosures of their functions in one set of states."""
        events = [event for event in self._all_events(phase).events if event.left_out]
        return [(event, self._value(phase, event.function, states)) for event in events]

    def first(self, start: Mapping[str, arb]) -> Next | Open:
        """The phase at the start of the scene."""
        phase = self._scene.first_phase()
        exact = self._scene.scaled_initial()  # the balls of ``start`` need not be points
        touching = exact["Z"] == exact["Y"]
        return self._resting(start, touching) if phase == STICK else self._begins(phase, touching, at_rest=False)

    def after(self, phase: str, event: PhaseEvent, states: dict[str, arb]) -> Following:
        """What follows an event; where the contact sticks, ``states`` then holds the slip velocity exactly."""
        if event.next_phase == FLIGHT:
            return Following(event.name, self._begins(FLIGHT, touching=True, at_rest=False))
        if event.next_phase == STICK:
            self._hold(states)
            return Following(event.name, self._begins(STICK, touching=False, at_rest=True))
        if event.next_phase != CONTACT:  # friction at its bound: slip begins without acceleration
            return Following(event.name, self._begins(event.next_phase, touching=False, at_rest=True, order=2))
        if event.name != SLIP_STOPS:
            return Following(event.name, self._touching(phase, states))
        resting = self._resting(states, touching=False)
        if isinstance(resting, Open):
            return Following(event.name, resting)
        return Following(STICKS if resting.phase == STICK else SLIPS[resting.phase], resting)

    def _touching(self, phase: str, states: dict[str, arb]) -> Next | Open:
        """Contact that has just closed."""
        if phase != FLIGHT:
            raise ValueError(f"touch-down ends a flight, not the phase {phase}")
        if STICK not in self._scene.phases():  # the effect stick opens REVERSE too
            return self._begins(SLIP, touching=True, at_rest=False)
        slip = self._value(SLIP, self[SLIP].system.shown("u"), states) - self._belt
        if slip > 0:
            return self._begins(SLIP, touching=True, at_rest=False)
        if slip < 0:
            return self._begins(REVERSE, touching=True, at_rest=False)
        if slip.is_zero():
            return self._resting(states, touching=True)
        return Open("the direction of slip at touch-down is not certain", states[CLOCK])

    def _resting(self, states: Mapping[str, arb], touching: bool) -> Next | Open:
        """Contact without slip velocity: it sticks where friction certainly holds it."""
        guards = {
            event.next_phase: self._value(STICK, event.function, states)
            for event in self[STICK].system.events
            if event.next_phase not in (FLIGHT, CONTACT)
        }
        if all(guard > 0 for guard in guards.values()):
            if isinstance(states, dict):
                self._hold(states)
            return self._begins(STICK, touching, at_rest=True)
        for phase, guard in guards.items():
            if guard < 0:
                return self._begins(phase, touching, at_rest=True)
        return Open("whether friction holds the contact is not certain", states[CLOCK])

    def _begins(self, phase: str, touching: bool, at_rest: bool, order: int | None = None) -> Next:
        """The phase, with lift-off or touch-down at zero where y = z, and the end of slip where the contact rests."""
        orders: dict[str, int | None] = {}
        for event in self[phase].system.events:
            opens = phase == FLIGHT or event.next_phase == FLIGHT
            stops = phase in (SLIP, REVERSE) and event.next_phase in (STICK, CONTACT)
            if opens and touching:
                orders[event.name] = None
            if stops and at_rest:
                orders[event.name] = order
        return Next(phase, orders)

    def _hold(self, states: dict[str, arb]) -> None:
        if "u" in states:
            states["u"] = arb(self._belt)

    @property
    def _belt(self) -> fmpq:
        return self._scene.values().get("belt_velocity", fmpq(0))

    def _value(self, phase: str, function: Expression, states: Mapping[str, arb]) -> arb:
        names = self[phase].system.states
        box = [states[name] for name in names] + [states[CLOCK]]
        return BoxProgram([function], len(box)).values(box)[0]
