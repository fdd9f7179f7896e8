"""A certificate that rigid slip of a mechanism from a state reaches a G-spot.

The producer's side of ``proofs/approach_certificate.md``. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

from flint import arb, fmpq

from gspot_verified.certificates.text import APPROACH_VERSION, sealed
from gspot_verified.functions.rings import RATIONALS
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep, Steps
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.integrator.norm_steps.norm_step import NormStep
from gspot_verified.mechanisms.approach.capture import Capture, capture
from gspot_verified.mechanisms.approach.slip_state import StateError, StateInput, state_formula
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.input.mechanism import Place
from gspot_verified.mechanisms.spots.g_spot import place_in
from gspot_verified.numbers.balls import add_remainder, ball, working_bits
from gspot_verified.scenes.certificates.bounded_step import NotBounded, bounded_step, grid, pair
from gspot_verified.scenes.certificates.polynomial_slip import PolynomialSlip

_PRECISIONS = (128, 192, 320)  # bits of the steps, tried in turn
_CHECKER_BITS = 64  # more than the steps'
_SPARE_BITS = 64  # more than the checker's, for this file's own balls
_GUARD_BITS = 32  # of the steps' bits that coefficients do not use
MAX_STEPS = 400
_NEAR = fmpq(1, 2**20)  # how far a state may still move by Theorem A1, where the way ends
_ROOM = fmpq(1, 2**30)  # relative, by which the neighbourhood is wider than needed
_PLACES = 9  # decimals of what the statement says


class _Kept(Steps):
    """Keeps the steps."""

    def __init__(self, budget: int) -> None:
        super().__init__(budget)
        self.steps = list[ChosenStep]()

    def proved(self, step: ChosenStep, time: arb) -> None:
        super().proved(step, time)
        self.steps.append(step)


def exact_start(shifted: Shifted, state: StateInput, slip: PolynomialSlip) -> dict[str, fmpq]:
    """The coordinates and velocities that a certificate gives, angles from their references.

    :raises StateError: one is missing, or no rational number.
    """
    mechanism = shifted.mechanism
    found = dict[str, fmpq]()
    words = {name: word for word, name in slip.mechanism.place.items()}
    for name in slip.own:
        word = words.get(name, name)
        if word not in state:
            raise StateError(f"{mechanism.name}: a certificate needs {word}; y = 0 and v = 0 replace another component")
        value = state_formula(mechanism, word, state[word])
        placed = replace(mechanism, place=Place(((word, value),)))
        try:
            found[name] = place_in(replace(shifted, mechanism=placed), RATIONALS)[word]
        except (TypeError, ValueError):
            angle = f", counted from {word}_ref" if name != word else ""
            raise StateError(f"{mechanism.name}: a certificate needs a rational number for {word}{angle}") from None
    return found


class ApproachWriter:
    """Follows slip to a neighbourhood of a G-spot, and writes down what a checker needs."""

    def __init__(self, slip: PolynomialSlip, start: Mapping[str, fmpq], surface: fmpq | None) -> None:
        self.slip, self.start, self.surface = slip, start, surface

    def text(self, max_steps: int = MAX_STEPS) -> str:
        """The certificate.

        :raises NotBounded: no way to a G-spot was found.
        """
        for bits in _PRECISIONS:
            try:
                return self._text(bits, max_steps)
            except NotBounded as error:
                last = error
        raise last

    def _text(self, bits: int, max_steps: int) -> str:
        with working_bits(bits):
            steps = self._way(max_steps)
        last = bits + _CHECKER_BITS
        with working_bits(last + _SPARE_BITS):
            lines, states = self._written(steps, bits - _GUARD_BITS, last)
            found = self._captured(states)
            if found is None:
                raise NotBounded("the bounds of a certificate are too wide where slip reaches the G-spot")
            sides = {name: _outward(side, last) for name, side in zip(self.slip.names, found.box, strict=True)}
            statement = self._statement(states, found)
        return sealed(APPROACH_VERSION, statement, [{"bits": last}, *lines, {"neighbourhood": sides}])

    def _captured(self, states: Sequence[arb]) -> Capture | None:
        surface = None if self.surface is None else ball(self.surface)
        return capture(self.slip, states, surface)

    def _way(self, max_steps: int) -> list[ChosenStep]:
        kept = _Kept(max_steps)
        run = NormRun(self.slip.field, self.slip.start(dict(self.start)), steps=kept)
        for segment in run:
            states = segment.step.enclosure(arb(1))
            found = self._captured(states)
            if found is not None and all(far < ball(_NEAR) for far in found.reach):
                return kept.steps
        raise NotBounded(f"no G-spot was reached: {run.reason}")

    def _written(self, steps: Sequence[ChosenStep], unit: int, last: int) -> tuple[list[Any], list[arb]]:
        names = (*self.slip.names, "t")
        states, lines = self.slip.start(dict(self.start)), list[Any]()
        step: NormStep | None = None
        for chosen in steps:
            assert chosen.h is not None
            found = bounded_step(self.slip.field, names, chosen, chosen.h, step, states, (unit, last))
            lines.append(found.text)
            step = found.step
            states = [p(arb(1)) for p in step.solution]
        assert step is not None
        return lines, step.enclosure(arb(1))

    def _statement(self, states: Sequence[arb], found: Capture) -> dict[str, Any]:
        slip = self.slip
        reached = [add_remainder(side, far * (1 + ball(_ROOM))) for side, far in zip(states, found.reach, strict=False)]
        place, at = dict(zip(slip.names, reached, strict=True)), slip.on(reached)
        alphas = [at.alpha_1, at.alpha_2, at.alpha_3]
        rises = (found.numbers.alpha_3 - found.numbers.alpha_1).lower()
        below = bool(rises > 0 and rises * self._force(states) > found.numbers.alpha_2.upper().max(arb(0)))
        return {
            "C_1": ["negative"] * below,
            "alpha": [_range(value) for value in alphas],
            "beta": _range(at.alpha_3 / at.alpha_1),
            "kind": "approach",
            "mechanism": slip.mechanism.given,
            "place": {name: _range(place[name]) for name in slip.own},
            "start": {name: str(value) for name, value in self.start.items()},
            "surface": [] if self.surface is None else [str(self.surface)],
            "time": _range(states[-1] + found.time)[1],
        }

    def _force(self, states: Sequence[arb]) -> arb:
        """A lower bound of the contact force."""
        return self.slip.on(states).force.lower()


def _outward(side: arb, last: int) -> list[list[int]]:
    ends = side.lower() - arb((1, -last)), side.upper() + arb((1, -last))
    return [pair(arb((grid(end, last), -last))) for end in (ends[0], ends[1] + arb((1, -last)))]


def _range(value: arb) -> list[str]:
    """Decimals below and above."""
    power = fmpq(10) ** _PLACES
    ends = ((value.lower() * power).floor() - 1, (value.upper() * power).ceil() + 1)
    return [str(fmpq(int(end.unique_fmpz())) / power) for end in ends]
