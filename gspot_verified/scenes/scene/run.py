"""What a run of a scene gives: events, how it ends, and how sure that is. Float and certified runs give the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.numbers.verdict import NoTruthValue, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.scenes.effects.lift_off import LIFT_OFF, TOUCH_DOWN
from gspot_verified.scenes.scene.assumption import Assumption, provided
from gspot_verified.scenes.scene.samples import Samples

SIMULATED, CERTIFIED = "simulated", "certified"
IMPACT = "impact without collision"
TRIVIAL = "trivial solution"
OPEN = "open"
REFUTED = "an effect that is left out matters"
NO_EVENT = "no event"
FLIGHT_THEN_IMPACT = f"{LIFT_OFF}, {TOUCH_DOWN}, {IMPACT}"
_SHOWN_BITS, _SHOWN_DIGITS = 400, 30  # of a bracket in the text, which its digits round


@dataclass(frozen=True)
class RunEvent:
    """An event between two times after the start; both are one float's value where the run is simulated.

    An impact without collision is no point of time: it is there from some time on, and this is when that was seen.
    """

    name: str
    lower: fmpq
    upper: fmpq

    def shown(self, strength: str) -> str:
        """The time as text: a ball, or the float."""
        if strength == SIMULATED:
            return f"{approximate(self.lower):.12g}"
        if self.lower == self.upper:
            return str(self.lower)
        with working_bits(_SHOWN_BITS):
            return arb(self.lower).union(arb(self.upper)).str(_SHOWN_DIGITS)

    def line(self, strength: str) -> str:
        """The event with its time, in words."""
        when = f"t = {self.shown(strength)} after the start"
        if self.name != IMPACT:
            return f"{self.name}: {when}"
        return f"{self.name}: {'shown' if strength == CERTIFIED else 'seen'} from {when} on"

    def rounded(self, digits: int) -> str:
        """The event with the lower end of its bracket, as a float."""
        return f"{self.name} {'from' if self.name == IMPACT else 'at'} t = {approximate(self.lower):.{digits}g}"


class AtTime(NamedTuple):
    """An event of a simulation."""

    event: str
    time: float


class InBracket(NamedTuple):
    """An event that is certified; of an impact without collision, when its growth is shown: it may begin before."""

    event: str
    lower: fmpq
    upper: fmpq


@dataclass(frozen=True)
class SceneRun(NoTruthValue, Written):
    """The events of one run in order; ``fate``: what they amount to; ``strength``: simulated or certified.

    ``route``: "exact" or "integrator" where it is certified, None where it is simulated.
    ``notes``: what went wrong beside the run, as a journal that could not be written. ``assumptions``: what the effects
    that are left out assume of the motion, and how that stands; what the model system has by definition is not in it.
    """

    written: ClassVar[str] = "strength fate events=event_rows verdict assumptions"

    strength: str
    fate: str
    events: tuple[RunEvent, ...]
    verdict: Verdict
    samples: Samples | None = None
    notes: tuple[str, ...] = ()
    assumptions: tuple[Assumption, ...] = ()
    route: str | None = field(default=None, compare=False)

    @property
    def event_rows(self) -> list[AtTime | InBracket]:
        """The events with their times: floats where the run is simulated."""
        if self.strength == SIMULATED:
            return [AtTime(event.name, approximate(event.lower)) for event in self.events]
        return [InBracket(event.name, event.lower, event.upper) for event in self.events]

    @property
    def heading(self) -> str:
        """How sure it is, and whether under a condition, which the statement names."""
        held = self.strength == CERTIFIED and provided(self.assumptions) and self.fate != OPEN
        return f"{self.strength}{', under the condition below' if held else ''}"

    def __str__(self) -> str:
        lines = [f"{self.heading}: {self.fate}"]
        lines += [f"  {line}" for line in str(self.verdict).splitlines()]
        lines += [f"  {event.line(self.strength)}" for event in self.events]
        return "\n".join(lines + [f"  {assumption}" for assumption in self.assumptions])


def fate_of(names: Sequence[str]) -> str:
    """What the events of a float run amount to, in words.

    >>> fate_of([]), fate_of(["lift-off", "touch-down"])
    ('no event', 'lift-off, touch-down')
    """
    return ", ".join(names) or NO_EVENT


def agreement(simulated: SceneRun, certified: SceneRun) -> bool | None:
    """Whether both end alike; False: a simulated event contradicts what is certified; None: nothing is certified, or
    refuted, or the float run ends before the certified one does."""
    if certified.fate in (OPEN, REFUTED):
        return None
    if simulated.fate == certified.fate:
        return True
    if certified.fate != TRIVIAL and _only_grew(simulated, certified):
        return None
    known = [] if certified.fate == TRIVIAL else [name for name in certified.fate.split(", ") if name != NO_EVENT]
    seen = [event.name for event in simulated.events]
    if IMPACT not in seen:  # the float run need not name an impact from which stick or lift-off follows
        known = [name for name in known[:-1] if name != IMPACT] + known[-1:]
    if seen == known:
        return True
    return None if seen == known[: len(seen)] else False


def _only_grew(simulated: SceneRun, certified: SceneRun) -> bool:
    """Whether the float run ends with a force that has grown, after the events that are certified and before the next:
    that an impact begins is then neither certified nor contradicted."""
    count = len(simulated.events) - 1
    if count < 0 or simulated.events[-1].name != IMPACT or IMPACT in [event.name for event in certified.events]:
        return False
    if certified.fate.endswith(IMPACT):
        return False
    before, after = certified.events[:count], certified.events[count:]
    same = [event.name for event in before] == [event.name for event in simulated.events[:-1]]
    return same and len(before) == count and (not after or simulated.events[-1].lower < after[0].lower)
