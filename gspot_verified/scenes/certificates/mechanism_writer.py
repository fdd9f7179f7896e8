"""The certificate of a mechanism's run: the steps of the run, with sines, cosines and divisors beside its states.

The producer's side of ``proofs/run_certificate.md``, section 1a. Nothing here is part of a proof. The bases of the run
are carried along: an error of the run's states moves sines, cosines and divisors with it, and what else can be wrong
with these has directions of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise
from typing import Any

from flint import arb, arb_mat, arb_poly, arb_series, fmpq_mpoly

from gspot_verified.functions.derivative import ZERO
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.integrator.norm_steps.norm_step import Basis, NormPlan
from gspot_verified.numbers.balls import ball, series_length
from gspot_verified.scenes.certificates.bounded_step import NotBounded, grid
from gspot_verified.scenes.certificates.polynomial_mechanism import (
    INVERSE,
    SCALED,
    SLIDE,
    NotPolynomial,
    PolynomialMechanism,
    PolynomialPhase,
    V,
    expression,
)
from gspot_verified.scenes.certificates.run_writer import RunWriter, WrittenPhase
from gspot_verified.scenes.certified.certified_phase import CertifiedPhase
from gspot_verified.scenes.certified.conditions import Conditions
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.effects.stick import STICKS
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.scene.scene import Scene

_BASIS_BITS = 53  # of the entries of a basis
_BELOW_UNIT = 100  # bits: below the unit of the coefficients by that much a basis holds noise
BELT = "belt"
_SERIES = 2  # times the length of the run's polynomials: those of sines and divisors


class MechanismEquations:
    """The phases of a scene with a mechanism, and which states they need: ``kept``.

    :raises NotPolynomial: no certificate covers the mechanism.
    """

    def __init__(self, scene: Scene) -> None:
        assert scene.mechanism is not None
        self.mechanism, self._scene, self.epsilon = PolynomialMechanism(scene.mechanism), scene, scene.epsilon
        self._followed = Conditions.of(scene).followed
        follows, values = BELT not in scene.effects, scene.values()
        self.phases = {
            name: PolynomialPhase(self.mechanism, name, scene.epsilon, values, follows) for name in scene.phases()
        }
        self.kept = self._kept()

    def _kept(self) -> set[str]:
        names = self.mechanism.names_in
        waiting = {V}.union(*(names(phase.functions.values()) for phase in self.phases.values()))
        found: set[str] = set()
        while waiting:
            found |= waiting
            waiting = names(phase.rates[name] for phase in self.phases.values() for name in found) - found
        return found

    def run_names(self, phase: str) -> list[str]:
        """The states of the run in a phase, as a certificate calls them."""
        return [self.token(name) for name in CertifiedPhase(self._scene.system(phase, self._followed)).names]

    def exact_start(self) -> dict[str, str]:
        """What the statement says of the start."""
        values = self._scene.scaled_initial(self._followed)
        return {self.mechanism.place.get(name, name): str(v) for name, v in values.items() if name not in SCALED}

    def start(self) -> dict[str, arb]:
        """All states where the run begins."""
        m = self.mechanism
        given = {self.token(n): arb(value) for n, value in self._scene.scaled_initial(self._followed).items()}
        for q in m.coordinates:
            if m.place[q] in given:
                given |= self.turned(q, given[m.place[q]])
        det = m.put_in(m.minors()[-1], m.normal(self.epsilon))
        return given | ({INVERSE: 1 / self.value(det, given)} if INVERSE in self.kept else {})

    def token(self, name: str) -> str:
        """What a certificate calls a state of the run."""
        return SCALED.get(name, self.mechanism.place.get(name, name))

    def turned(self, q: str, angle: Any) -> dict[str, Any]:
        """Sine and cosine of a coordinate that is counted from its reference; of balls or series."""
        s, c = map(ball, self.mechanism.references[q])
        return {
            f"sin({q})": angle.cos() * s + angle.sin() * c,
            f"cos({q})": angle.cos() * c - angle.sin() * s,
        }

    def value(self, polynomial: fmpq_mpoly, values: Mapping[str, Any]) -> Any:
        """A polynomial at balls, polynomials or series."""
        total: Any = 0
        for powers, coefficient in polynomial.to_dict().items():
            product: Any = ball(coefficient)
            for name, power in zip(self.mechanism.names, powers, strict=True):
                for _ in range(int(power)):
                    product = values[name] * product
            total = product + total
        return total


class MechanismPhase:
    """One phase for the states that are kept: those of the run first, then sines, cosines and divisors."""

    def __init__(self, equations: MechanismEquations, name: str) -> None:
        self._equations, self._phase, self._name = equations, equations.phases[name], name
        m = equations.mechanism
        self._run_names = equations.run_names(name)
        kept = equations.kept - ({SLIDE} if self._phase.divisor.is_zero() else set())
        self._own = [i for i, each in enumerate(self._run_names) if each in kept]
        added = sorted(kept - set(self._run_names))
        turning = {each for q in m.coordinates for each in (f"sin({q})", f"cos({q})")}
        if not set(added) <= {*turning, INVERSE, SLIDE}:
            raise NotPolynomial(f"certificates of runs need the state {added[0]}, which the run does not follow")
        self.names = (*(self._run_names[i] for i in self._own), *added)
        index = {m.names.index(each): i for i, each in enumerate(self.names)}
        rates = [expression(self._phase.rates[each], index) for each in self.names]
        self.field = VectorField(rates)
        self.resting = [each for each, rate in zip(self.names, rates, strict=True) if rate is ZERO]
        self._angles = [q for q in m.coordinates if f"sin({q})" in added or f"cos({q})" in added]

    def enter(self, states: dict[str, arb]) -> None:
        """The divisor of stick."""
        if not self._phase.divisor.is_zero():
            states[SLIDE] = 1 / self._equations.value(self._phase.divisor, states)

    def event(self, name: str) -> Callable[[Sequence[Any]], Any]:
        """The function of an event."""
        function = self._phase.functions.get(name)
        if function is None:
            raise NotBounded(f"certificates of runs do not cover {name} right after {self._name}")
        return lambda states: self._equations.value(function, dict(zip(self.names, states, strict=True)))

    def chosen(self, step: ChosenStep, unit: int) -> ChosenStep:
        """The step with polynomials for all states, and bases for all errors; coefficients are not below 2^-unit."""
        length = _SERIES * max(p.degree() + 1 for p in step.solution)
        curves = self._curves(step, length)
        solution = tuple(_cut(curves[name].coeffs(), unit) for name in self.names)
        bases = tuple(
            self._basis(basis, [p(((a + b) / 2).mid()).mid() for p in solution], unit + _BELOW_UNIT)
            for basis, (a, b) in zip(step.plan.bases, pairwise(step.plan.ends), strict=True)
        )
        degrees = self.field.degrees([max(p.degree(), 0) for p in solution])
        longest = max(degree for degree in degrees if degree is not None)
        plan = NormPlan(step.plan.ends, bases, step.plan.margins, step.plan.disc, longest + 1)
        return replace(step, solution=solution, plan=plan)

    def _curves(self, step: ChosenStep, length: int) -> dict[str, arb_series]:
        with series_length(length):
            found = {
                name: arb_series(p.coeffs(), length) for name, p in zip(self._run_names, step.solution, strict=True)
            }
            for q in self._angles:
                found |= self._equations.turned(q, found[self._equations.mechanism.place[q]])
            for name, divisor in self._divisors.items():
                found[name] = 1 / self._equations.value(divisor, found)
            return found

    @cached_property
    def _divisors(self) -> dict[str, fmpq_mpoly]:
        equations = self._equations
        m = equations.mechanism
        of = {INVERSE: m.put_in(m.minors()[-1], m.normal(equations.epsilon)), SLIDE: self._phase.divisor}
        return {name: divisor for name, divisor in of.items() if name in self.names}

    def _basis(self, basis: Basis, at: Sequence[arb], unit: int) -> Basis:
        """The columns of the run's basis with what they move, and a direction for each other error; multiples of
        2^-unit."""
        m, values = self._equations.mechanism, dict(zip(self.names, at, strict=True))
        moved: dict[str, dict[str, arb]] = {}  # by what a state of the run moves it
        more: list[dict[str, arb]] = []
        for q in self._angles:
            sine, cosine = (values.get(f"{part}({q})", arb(0)) for part in ("sin", "cos"))
            moved |= {f"sin({q})": {m.place[q]: cosine}, f"cos({q})": {m.place[q]: -sine}}
            if m.place[q] in self.names:
                more += [{f"sin({q})": arb(1)}, {f"cos({q})": arb(1)}]
            else:
                more.append({f"sin({q})": sine, f"cos({q})": cosine})
        for name, divisor in self._divisors.items():
            moved[name] = {}
            for part in m.names_in([divisor]):
                slope = -(values[name] ** 2) * self._equations.value(divisor.derivative(m.names.index(part)), values)
                for state, share in moved.get(part, {part: arb(1)}).items():
                    moved[name][state] = moved[name].get(state, arb(0)) + slope * share
            more.append({name: arb(1)})
        rows = dict(zip(self._run_names, basis.S.table(), strict=True))
        table = []
        for name in self.names:
            shares = moved.get(name, {name: arb(1)})
            columns = [
                sum((share * rows[state][j] for state, share in shares.items()), arb(0)) for j in range(len(rows))
            ]
            table.append([_rounded(entry, unit) for entry in (*columns, *(each.get(name, arb(0)) for each in more))])
        return Basis(arb_mat(table), (*basis.blocks, *[1] * len(more)))


def _cut(coefficients: Sequence[arb], unit: int) -> arb_poly:
    """The polynomial with coefficients rounded to units of 2^-unit."""
    half = arb((1, -unit - 1))
    return arb_poly([arb((grid(arb(c.mid() + half).mid(), unit), -unit)) for c in coefficients])


def _rounded(value: arb, unit: int) -> arb:
    mantissa, exponent = map(int, value.mid().man_exp())
    excess = max(0, mantissa.bit_length() - _BASIS_BITS, -unit - exponent)
    return arb((mantissa >> excess, exponent + excess))


class MechanismWriter(RunWriter):
    """Writes the run of a scene with a mechanism."""

    @cached_property
    def equations(self) -> MechanismEquations:
        """Of the scene."""
        return MechanismEquations(self.scene)

    def start(self) -> dict[str, arb]:
        """All states where the run begins."""
        return self.equations.start()

    def phase(self, name: str) -> WrittenPhase:
        """The equations of a phase."""
        return MechanismPhase(self.equations, name)

    def after(self, phase: str, event: str, states: dict[str, arb]) -> str:
        """The phase after an event."""
        known = {LIFT_OFF: FLIGHT, STICKS: STICK, "slip forwards": SLIP, "slip backwards": REVERSE}
        if event in known:
            return known[event]
        if STICK not in self.equations.phases:
            return SLIP
        return SLIP if self.equations.value(self.equations.phases[phase].slip, states) > 0 else REVERSE

    def said_of_scene(self) -> dict[str, Any]:
        """What the statement says beside events and end."""
        m, values = self.equations.mechanism, self.scene.values()
        return super().said_of_scene() | {
            "kind": "run of a mechanism",
            "mechanism": m.given,
            "parameters": {name: str(values[name]) for name in ("damping", "k_1", "k_2")},
            "start": self.equations.exact_start(),
        }
