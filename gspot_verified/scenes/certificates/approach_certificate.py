"""A certificate that rigid slip of a mechanism from a state reaches a G-spot.

The producer's side of ``proofs/approach_certificate.md``. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from flint import arb, fmpq

from gspot_verified.certificates.checker import CheckResult, check
from gspot_verified.certificates.text import APPROACH_VERSION, sealed, write_text
from gspot_verified.functions.rings import RATIONALS
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep, Steps
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.integrator.norm_steps.norm_step import NormStep
from gspot_verified.mechanisms.approach.capture import Capture, capture
from gspot_verified.mechanisms.approach.slip_state import StateError, StateInput, slip_state, state_formula
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.input.mechanism import Mechanism, Place
from gspot_verified.mechanisms.spots.g_spot import place_in
from gspot_verified.numbers.balls import ExactInput, add_remainder, ball, exact, hull, working_bits
from gspot_verified.scenes.certificates.bounded_step import NotBounded, bounded_step, grid, pair
from gspot_verified.scenes.certificates.polynomial_slip import TIME, PolynomialSlip

MAX_STEPS = 400  # a limit against endless work
_PRECISIONS = (128, 192, 320)  # bits of the steps, tried in turn
_CHECKER_BITS = 64  # more than the steps'
_SPARE_BITS = 64  # more than the checker's, for this file's own balls
_GUARD_BITS = 32  # of the steps' bits that coefficients do not use
_NEAR = fmpq(1, 2**20)  # how far a state may still move by Theorem A1, where the way ends
_ROOM = fmpq(1, 2**30)  # relative, by which what is said of the G-spot is wider than needed
_LARGEST_BETA = 2  # up to which Theorem A6 says something
_PLACES = 9  # decimals of what the statement says


def approach_certificate(mechanism: Mechanism, state: StateInput, *, surface_velocity: ExactInput | None = None) -> str:
    """The text of a certificate that ``gspot-verified check`` reads: from ``state`` slip reaches a G-spot, where and
    until when, with a positive contact force until then. The checker was asked before.

    ``state`` and ``surface_velocity`` as in ``approach``; the components are rational numbers, of an angle with a
    reference what is added to that. The sign of C_1 is part of it for beta < 2 alone.

    :raises StateError: no such state, or a component that is not rational.
    :raises NotPolynomial: no certificate covers the mechanism; the message says why.
    :raises NotBounded: no way to a G-spot was found, or the checker does not confirm it.

    >>> from gspot_verified import load
    >>> rod = load("rod")
    >>> print(approach_certificate(rod, {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"})[:36])
    {"format":"gspot_verified certificat
    """
    shifted = shift(mechanism)
    slip = PolynomialSlip(shifted.mechanism)
    with working_bits(_PRECISIONS[0]):
        slip_state(shifted, state)
    start = _exact_start(shifted, state, slip)
    velocity = _velocity(slip, start, surface_velocity)
    written: str | None = None
    reason = NotBounded("no way to a G-spot was found")
    for bits in _PRECISIONS:
        try:
            statement, text = _Writer(slip, start, velocity).text(bits)
        except NotBounded as error:
            reason = error
            continue
        answer = _answer(text)
        if answer.verified:
            written = text
            if statement["C_1"] or not fmpq(statement["beta"][0]) < _LARGEST_BETA:  # more bits would not say more
                break
        else:
            reason = NotBounded(f"the checker does not confirm the certificate: {answer.text}")
    if written is None:
        raise reason
    return written


def _answer(text: str) -> CheckResult:
    """What the checker says."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "approach.cert"
        write_text(file, text)
        return check(file)


def _exact_start(shifted: Shifted, state: StateInput, slip: PolynomialSlip) -> dict[str, fmpq]:
    """The coordinates and velocities that a certificate gives, angles from their references."""
    mechanism, found = shifted.mechanism, dict[str, fmpq]()
    words = {name: word for word, name in slip.mechanism.place.items()}
    for name in slip.own:
        word = words.get(name, name)
        if word not in state:
            raise StateError(f"{mechanism.name}: a certificate needs {word}; leave out {slip.replaced} instead")
        value = state_formula(mechanism, word, state[word])
        placed = replace(mechanism, place=Place(((word, value),)))
        try:
            found[name] = place_in(replace(shifted, mechanism=placed), RATIONALS)[word]
        except ValueError:
            form = f"{word}_ref and a rational number" if name != word else "a rational number"
            raise StateError(f"{mechanism.name}: a certificate needs {form} for {word}") from None
    return found


def _velocity(slip: PolynomialSlip, start: Mapping[str, fmpq], given: ExactInput | None) -> fmpq | None:
    """Of the surface: 0 if u > 0; None: nothing is asked of u."""
    if given is None:
        with working_bits(_PRECISIONS[0]):
            return fmpq(0) if slip.on(slip.start(start)).u > 0 else None
    velocity = exact(given, "surface_velocity")
    if not isinstance(velocity, fmpq):
        raise StateError("a certificate needs a rational number for the surface's velocity")
    return velocity


class _Kept(Steps):
    """Keeps the steps."""

    def __init__(self, budget: int) -> None:
        super().__init__(budget)
        self.steps = list[ChosenStep]()

    def proved(self, step: ChosenStep, time: arb) -> None:
        """One more step."""
        super().proved(step, time)
        self.steps.append(step)


class _Writer:
    """Follows slip to a neighbourhood of a G-spot, and writes down what a checker needs."""

    def __init__(self, slip: PolynomialSlip, start: Mapping[str, fmpq], velocity: fmpq | None) -> None:
        self._slip, self._start, self._velocity = slip, start, velocity

    def text(self, bits: int) -> tuple[dict[str, Any], str]:
        """The statement, and the certificate, by steps of so many bits."""
        with working_bits(bits):
            steps = self._way()
        last = bits + _CHECKER_BITS
        with working_bits(last + _SPARE_BITS):
            lines, states = self._written(steps, bits - _GUARD_BITS, last)
            found = self._captured(states)
            if found is None:
                raise NotBounded("the bounds of a certificate are too wide where slip reaches the G-spot")
            sides = {name: _outward(side, last) for name, side in zip(self._slip.names, found.box, strict=True)}
            statement = self._statement(states, found)
        return statement, sealed(APPROACH_VERSION, statement, [{"bits": last}, *lines, {"neighbourhood": sides}])

    def _captured(self, states: Sequence[arb]) -> Capture | None:
        return capture(self._slip, states, None if self._velocity is None else ball(self._velocity))

    def _way(self) -> list[ChosenStep]:
        """The steps up to where Theorem A1 holds on a small neighbourhood, or on one at all."""
        kept, count, start = _Kept(MAX_STEPS), 0, self._slip.start(self._start)
        if not (self._slip.on(start).p > 0 and self._slides(start)):
            raise NotBounded("p > 0, b < 0 or positive slip is not certain at the start")
        for segment in NormRun(self._slip.field, start, steps=kept):
            states = segment.step.enclosure(arb(1))
            if not self._slides(states):
                break
            found = self._captured(states)
            if found is None and count:
                break
            if found is not None:
                count = len(kept.steps)
                if all(far < ball(_NEAR) for far in found.reach):
                    break
        if not count:
            raise NotBounded("no way to a G-spot was found")
        return kept.steps[:count]

    def _slides(self, states: Sequence[arb]) -> bool:
        """Whether b < 0 and slip is positive, where it is asked for."""
        at = self._slip.on(states)
        return bool(at.b < 0 and (self._velocity is None or at.u > ball(self._velocity)))

    def _written(self, steps: Sequence[ChosenStep], unit: int, last: int) -> tuple[list[Any], list[arb]]:
        """The lines of the steps, and the states at their end."""
        names = (*self._slip.names, TIME)
        states, lines = self._slip.start(self._start), list[Any]()
        step: NormStep | None = None
        for chosen in steps:
            assert chosen.h is not None
            found = bounded_step(self._slip.field, names, chosen, chosen.h, step, states, (unit, last))
            lines.append(found.text)
            step = found.step
            states = [p(arb(1)) for p in step.solution]
        assert step is not None
        return lines, step.enclosure(arb(1))

    def _statement(self, states: Sequence[arb], found: Capture) -> dict[str, Any]:
        slip = self._slip
        reached = [add_remainder(x, far * (1 + ball(_ROOM))) for x, far in zip(states, found.reach, strict=False)]
        place, at = dict(zip(slip.names, reached, strict=True)), slip.on(reached)
        return {
            "C_1": self._side(states, found),
            "alpha": [_range(value) for value in (at.alpha_1, at.alpha_2, at.alpha_3)],
            "beta": _range(at.alpha_3 / at.alpha_1),
            "kind": "approach",
            "mechanism": slip.mechanism.given,
            "place": {name: _range(place[name]) for name in slip.own},
            "start": {name: str(value) for name, value in self._start.items()},
            "surface": [] if self._velocity is None else [str(self._velocity)],
            "time": _range(states[-1] + found.time)[1],
        }

    def _side(self, states: Sequence[arb], found: Capture) -> list[str]:
        """The sign of C_1, where Theorem A5 or A6 gives it."""
        slip, at, inside = self._slip, self._slip.on(states), found.numbers
        rises = inside.alpha_3 - inside.alpha_1
        if rises > 0 and rises.lower() * at.force.lower() > inside.alpha_2.upper().max(arb(0)):
            return ["negative"]
        rate = rises - inside.alpha_1
        if rises < 0 and rate > 0:
            slope = slip.slope_of_limit(found.box, hull((at.force, inside.alpha_2 / rises))).abs_upper()
            excess = at.force - at.alpha_2 / (at.alpha_3 - at.alpha_1)
            if excess.lower() * rate.lower() > slope * at.p.upper():
                return ["negative"]
            if -excess.upper() * rate.lower() > slope * at.p.upper():
                return ["positive"]
        return []


def _outward(side: arb, last: int) -> list[list[int]]:
    """The ends of a side on the checker's grid, a little farther out."""
    low, high = grid(side.lower(), last) - 1, grid(side.upper(), last) + 2
    return [pair(arb((end, -last))) for end in (low, high)]


def _range(value: arb) -> list[str]:
    """Decimals below and above."""
    power = fmpq(10) ** _PLACES
    low, high = (value.lower() * power).floor().unique_fmpz(), (value.upper() * power).ceil().unique_fmpz()
    assert low is not None
    assert high is not None
    return [str(fmpq(end) / power) for end in (low - 1, high + 1)]
