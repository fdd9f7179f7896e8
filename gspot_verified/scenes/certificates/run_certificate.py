"""A certificate of a certified run: the steps that the integrator chose, written so that each can be proved again.

The producer's side of ``proofs/run_certificate.md``. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from flint import arb, arb_poly, fmpq

from gspot_verified.certificates.text import RUN_VERSION, sealed
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.integrator.norm_steps.norm_step import NormStep
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certificates.bounded_step import BoundedStep, NotBounded, bounded_step, grid
from gspot_verified.scenes.certified.certified_integration import MAX_STEPS, integrated_run, is_narrow, precisions_for
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase
from gspot_verified.scenes.certified.growth_cone import ContactPoint, SlowCone, cones
from gspot_verified.scenes.certified.run_steps import Progress
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.effects.stick import STICKS
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.motions.contact_form import ContactForm
from gspot_verified.scenes.scene.assumption import CHECKED
from gspot_verified.scenes.scene.run import IMPACT, SceneRun
from gspot_verified.scenes.scene.scene import Scene, SceneError

COVERED = ("compliant_contact", "lift_off", "stick", "tangential_motion", "two_way_coupling")
_CHECKER_BITS = 128  # more than the run's
_SPARE_BITS = 64  # more than the checker's, for this file's own balls
_GUARD_BITS = 32  # of the run's bits that coefficients do not use
_DIGITS = 2  # of the width of a bracket, as it is written
_NEWTON_STEPS = 4  # from the bracket of the run to the zero of a curve
_FORMS = {"touch-down": ("Y", "Z"), "lift-off": ("Z", "Y"), "stick": ("u", "")}


class NotCertified(SceneError):
    """Runs of a scene have no certificates; the message says why."""


def check_covered(scene: Scene) -> None:
    """Passes for a scene whose runs have certificates.

    :raises NotCertified: it is none.
    """
    if scene.mechanism is not None:
        raise NotCertified("certificates of runs cover the model system, not a mechanism")
    others = [name for name in scene.effects if name not in COVERED]
    if others:
        raise NotCertified(f"certificates of runs do not cover the effect {others[0]}")
    values, start = scene.values(), scene.initial()
    if not (start["z"] > start["y"] and start.get("u", fmpq(1)) > 0):
        raise NotCertified("certificates of runs begin in contact, y < z, and in slip, u > 0")
    if STICKS in scene.effects and not (values["k_plus"] < 0 < values["k_minus"] and values["a"] == 0):
        raise NotCertified("certificates of runs with stick need k_plus < 0 < k_minus and a = 0")


class CertifiedRun(NamedTuple):
    """``text``: the certificate of ``run``; None: there is none, ``why`` says the reason."""

    run: SceneRun
    text: str | None
    why: str = ""


def certified_with_steps(
    scene: Scene, digits: int = 15, budget: int = MAX_STEPS, progress: Progress = lambda _: None
) -> CertifiedRun:
    """The run by the integrator, and a certificate of it where it is proved; arguments as in ``integrated_run``.

    :raises NotCertified: no run of this scene has a certificate.
    :raises SceneError: digits or budget out of range.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> run, text, _ = certified_with_steps(load_scene("fig-varsim1", epsilon="1/5", until="1/10"))
    >>> run.fate, text.splitlines()[1]
    ('no event', '{"bits":320}')
    """
    check_covered(scene)
    found: CertifiedRun | None = None
    for bits in precisions_for(scene, digits):
        with tempfile.TemporaryDirectory() as folder:
            journal = Path(folder) / "steps"
            run = integrated_run(scene, digits, (bits,), journal=journal, budget=budget, progress=progress)
            phases = _phases(journal)
        if run.verdict.outcome is not Outcome.PROVED:
            found = found or CertifiedRun(run, None, "the run is not proved")
            continue
        if open_ones := [each for each in run.assumptions if each.standing != CHECKED]:
            return CertifiedRun(run, None, f"what leaving an effect out assumes is not certain: {open_ones[0]}")
        try:
            found = CertifiedRun(run, _Writer(scene, run, bits).text(phases))
        except NotBounded as error:
            found = CertifiedRun(run, None, str(error)) if found is None or found.text is None else found
            continue
        if all(is_narrow(event, scene.epsilon, digits) for event in run.events):
            break
    assert found is not None
    return found


def _phases(journal: Path) -> list[list[ChosenStep]]:
    """The steps of each phase, as a run kept them."""
    lines = [json.loads(line)[1] for line in journal.read_text().splitlines()[1:]]
    count = max((line["phase"] for line in lines), default=-1) + 1
    return [[ChosenStep.from_json(line["step"]) for line in lines if line["phase"] == i] for i in range(count)]


@dataclass
class _Place:
    """Where a phase begins: its name, and all states there, with the clock."""

    phase: str
    states: dict[str, arb]


@dataclass
class _Writer:
    """Follows the steps of one run at the precision of its certificate, and writes down what a checker needs."""

    scene: Scene
    run: SceneRun
    bits: int
    lines: list[Any] = field(default_factory=list)
    events: list[list[str]] = field(default_factory=list)

    @property
    def last(self) -> int:
        """The checker's bits."""
        return self.bits + _CHECKER_BITS

    def text(self, phases: Sequence[Sequence[ChosenStep]]) -> str:
        """The certificate."""
        with working_bits(self.last + _SPARE_BITS):
            names = [event.name for event in self.run.events if event.name != IMPACT]
            place = _Place(
                SLIP, {name: arb(value) for name, value in self.scene.scaled_initial().items()} | {CLOCK: arb(0)}
            )
            end = ""
            for i, steps in enumerate(phases):
                event = names[i] if i < len(names) else ""
                end = self._phase(place, steps, event)
        statement = {
            "effects": sorted(self.scene.effects),
            "end": end,
            "epsilon": str(self.scene.epsilon),
            "events": self.events,
            "kind": "run",
            "parameters": {name: str(value) for name, value in self.scene.values().items()},
            "start": {name: str(value) for name, value in self.scene.initial().items() if name != "nu"},
            "until": str(self.scene.until),
        }
        return sealed(RUN_VERSION, statement, [{"bits": self.last}, *self.lines])

    def _phase(self, place: _Place, steps: Sequence[ChosenStep], event: str) -> str:
        """Write one phase, and go on to where the next one begins; the end of the run, where this is the last."""
        head: dict[str, Any] = {"bracket": [], "cone": [], "event": event, "phase": place.phase, "steps": len(steps)}
        self.lines.append(head)
        phase = CertifiedPhase(self.scene.system(place.phase))
        clock, states = place.states[CLOCK], [place.states[name] for name in phase.names]
        before: NormStep | None = None
        for chosen in steps:
            h = self._length(clock) if chosen.h is None else chosen.h
            found: BoundedStep = bounded_step(
                phase.field, phase.names, chosen, h, before, states, (self.bits - _GUARD_BITS, self.last)
            )
            self.lines.append(found.text)
            before, began = found.step, clock
            states, clock = [p(arb(1)) for p in before.solution], clock + h
        assert before is not None
        if event:
            self._event(head, place, phase, before, began)
            return ""
        if steps[-1].h is None:
            return "time"
        head["cone"] = self._cone(phase, before.enclosure(arb(1)), clock)
        return "for ever"

    def _length(self, clock: arb) -> arb:
        """What is left of the time, for the earliest clock, on the checker's grid."""
        left = arb(self.scene.until / self.scene.epsilon) - clock
        return arb((grid(left.upper(), self.last) + 1, -self.last))

    def _event(self, head: dict[str, Any], place: _Place, phase: CertifiedPhase, step: NormStep, began: arb) -> None:
        """The bracket of the event in the last step, and where the next phase begins."""
        name, values = head["event"], self.scene.values()
        plus, minus = _FORMS[name]
        signs = {plus: -1 if name == STICKS and place.phase == REVERSE else 1} | ({minus: -1} if minus else {})
        form = [(sign, phase.names.index(state)) for state, sign in signs.items()]

        def value(tau: arb) -> arb:
            states = step.enclosure(tau)
            return sum((sign * states[i] for sign, i in form), arb(0))

        curve = sum((sign * step.solution[i] for sign, i in form), arb_poly())
        known = [event for event in self.run.events if event.name != IMPACT][len(self.events)]
        tau = ((hull((arb(known.lower), arb(known.upper))) / self.scene.epsilon - began) / step.h).mid()
        for _ in range(_NEWTON_STEPS):
            tau = (tau - curve(tau) / curve.derivative()(tau)).mid()
        middle = arb((grid(tau, self.last), -self.last))
        left, right = self._first(value, middle, -1), self._first(value, middle, 1)
        head["bracket"] = [[grid(end, self.last), -self.last] for end in (left, right)]
        states = zip(phase.names, step.enclosure(hull((left, right))), strict=True)
        rests = place.phase == FLIGHT and values.get("a") == 0  # u has the rate 0
        place.states |= {state: ball for state, ball in states if not (rests and state == "u")}
        place.states[CLOCK] = began + hull((left, right)) * step.h
        self.events.append([name, *self._bracket(place.states[CLOCK])])
        place.phase = self._next(name, place.states)

    def _first(self, value: Callable[[arb], arb], middle: arb, side: int) -> arb:
        """The next point to one side where the function's sign is certain."""
        for power in range(self.last):
            tau = middle + arb((side << power, -self.last))
            if not (tau > 0 and tau <= 1):
                break
            if value(tau) * side < 0:
                return tau
        raise NotBounded("an event is not inside of one step")

    def _next(self, event: str, states: dict[str, arb]) -> str:
        if event == LIFT_OFF:
            return FLIGHT
        if event == STICKS:
            states["u"] = arb(0)
            return STICK
        slip = states.get("u", arb(1))
        if slip.is_zero() and STICKS in self.scene.effects:
            return STICK
        return SLIP if slip > 0 else REVERSE

    def _bracket(self, time: arb) -> list[str]:
        """Decimals around a time in the paper's unit."""
        bounds = Dyadic.from_ball(time * self.scene.epsilon)
        low, high = bounds.lower * fmpq(2) ** bounds.exponent, bounds.upper * fmpq(2) ** bounds.exponent
        places = next(n for n in range(self.last) if fmpq(10) ** (n - _DIGITS) * (high - low) >= 1)
        power = fmpq(10) ** places
        return [str(fmpq((low * power).floor()) / power), str(fmpq((high * power).ceil()) / power)]

    def _cone(self, phase: CertifiedPhase, box: Sequence[arb], clock: arb) -> list[str]:
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
