"""The contact force after the G-spot, at leading order and on the slow manifold, for one system and for balls of them:
statements for every epsilon below a bound, at one epsilon, and brackets of the lift-off time, against samples."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
from attack.answers import AGREED, Answer, Attack, Tally, undecided, worst, wrong
from attack.balls_as_numbers import to_fmpq, to_fraction
from attack.reference_contact import slow_force
from attack.reference_theta import mp, reference
from flint import arb, fmpq

from gspot_verified import Outcome, iwc
from gspot_verified.compliant.contact.slow_manifold import SlowManifold
from gspot_verified.numbers.balls import working_bits

System = tuple[Fraction, Fraction, Fraction]
Force = Callable[[System, Fraction, Fraction], mpmath.mpf]
"""Of the alphas, epsilon and tau."""
_OFF = 1e-9
"""A force that is known to be negative is less than minus this."""
_SEEN = 1e-9
"""A force that is above this is positive."""
_LEAST = 1e-200
"""Smaller numbers are no floats."""


@dataclass(frozen=True)
class Question:
    """``radii``: of the balls, all 0 for one system."""

    centres: System
    radii: System
    c1: Fraction
    start: Fraction
    epsilon: Fraction | None

    def asked(self) -> dict[str, fmpq | arb | None]:
        """The arguments of :func:`iwc`."""
        with working_bits(256):
            alphas = [
                arb(to_fmpq(x), arb(to_fmpq(r))) if r else to_fmpq(x)
                for x, r in zip(self.centres, self.radii, strict=True)
            ]
        names = ("alpha_1", "alpha_2", "alpha_3", "c1", "tau_start", "epsilon")
        others = (to_fmpq(self.c1), to_fmpq(self.start), None if self.epsilon is None else to_fmpq(self.epsilon))
        return dict(zip(names, (*alphas, *others), strict=True))

    def systems(self) -> list[System]:
        """Four corners of the balls, of which two are across from each other; one where all radii are 0."""
        corners = ((1, 1, 1), (-1, -1, -1), (1, -1, -1), (-1, 1, -1))[: 4 if any(self.radii) else 1]
        (one, two, three), (r, s, t) = self.centres, self.radii
        return [(one + i * r, two + j * s, three + k * t) for i, j, k in corners]


def attack(random: Random) -> Attack:
    """One system, or balls of systems."""
    whole = random.randint(1, 8)
    beta = random.choice((
        Fraction(random.randint(1, 70), 8), whole + random.choice((-1, 1)) * Fraction(1, 10 ** random.randint(2, 5)),
        Fraction(random.randint(1, 9), 10),
    ))  # fmt: skip
    beta = beta + Fraction(1, 3) if beta.denominator == 1 else beta
    first = -Fraction(random.randint(1, 24), 8)
    second = Fraction(random.choice((-1, -1, -1, 1 if beta < 1 else -1)) * random.randint(1, 16), 8)
    size = random.choice((0, 0, Fraction(1, 10**9), Fraction(1, 1000), Fraction(1, 30)))
    question = Question(
        (first, second, beta * first), (size * abs(first), size * abs(second), size * abs(beta * first)),
        random.choice((-1, 1)) * Fraction(random.choice((1, 1, 5, 60)), random.choice((1, 4, 50))),
        random.choice((Fraction(-10), Fraction(-3), Fraction(0), Fraction(5, 2), Fraction(-25))),
        random.choice((None, None, Fraction(1, 1000), Fraction(1, 10**6), Fraction(1, 3), Fraction(2))),
    )  # fmt: skip
    return Attack(f"iwc(**{question}.asked())", lambda: judged(question, random.random()))


def leading_force(question: Question) -> Force:
    """The paper's formula."""

    def value(system: System, epsilon: Fraction, tau: Fraction) -> mpmath.mpf:
        first, second, third = system
        beta = third / first
        with mpmath.workdps(60):
            slope, _ = reference(tau, beta, 1, 40)
            kappa = mpmath.cbrt(mp(-first / 2))
            size = mp(question.c1 / third) * kappa ** mp(1 - beta) * mp(epsilon) ** mp((2 * beta - 2) / 3)
            return mp(second / (third - first)) - size * slope

    return value


def judged(question: Question, part: float) -> Answer:
    """``part``: of the bound, an epsilon below it."""
    result = iwc(**question.asked())  # type: ignore[arg-type]
    leading = leading_force(question)

    def slow(system: System, epsilon: Fraction, tau: Fraction) -> mpmath.mpf:
        return mpmath.mpf(slow_force(system, question.c1, epsilon, tau))

    bound = result.leading.epsilon_0
    checks = [lambda: _statement(question, result.leading, leading, bound, part)]
    if result.slow is not None:
        exact = bound if result.slow.threshold is None else result.slow.threshold.lower
        checks.append(lambda: _statement(question, result.slow, slow, exact, part))
    for found, force in ((result.leading.lift_off, leading), (result.lift_off, slow)):
        if found is not None and found.bracket is not None:
            checks.append(lambda found=found, force=force: _lift_off(question, found, force))  # type: ignore[misc]
    answers = []
    for check in checks:
        answers.append(check())
        if answers[-1].tally is Tally.WRONG:
            return replace(answers[-1], detail=f"{result}\n  {answers[-1].detail}")
    return worst(answers)


def _places(start: Fraction, end: Fraction, count: int = 10) -> list[Fraction]:
    return [start + (end - start) * k / count for k in range(count + 1)]


def _statement(question: Question, found: Any, force: Force, bound: fmpq | None, part: float) -> Answer:
    """On the side where the contact holds: positive everywhere for a proof, negative somewhere against it."""
    verdict, systems = found.verdict, question.systems()
    if verdict.outcome is Outcome.UNDECIDED:
        return undecided(str(verdict.reason))
    if " changes sign" in verdict.statement or "first zero" in verdict.statement:
        return AGREED  # the bracket is judged by itself
    most = Fraction(10) if bound is None else min(to_fraction(bound), Fraction(50))
    below = question.epsilon or most * (1 - Fraction(1, 10 ** int(1 + 8 * part)))
    if getattr(found, "lift_off", None) is not None:
        below = to_fraction(found.lift_off.epsilon)
    places = _places(question.start, question.start + 12)
    if isinstance(found, SlowManifold):  # each sample is a quadrature
        places, systems = places[::3], systems[:1]
    if (minimum := getattr(found, "minimum", None)) is not None:
        places.append(to_fraction(minimum.lower))
    if (exact := getattr(found, "threshold", None)) is not None and exact.place is not None:
        places.append(to_fraction(exact.place))
    if verdict.outcome is Outcome.REFUTED:  # what is said is that the force is negative there, for every system
        places = [Fraction(re.findall(r"τ = ([-+.0-9/e]+)", verdict.witness)[-1])]
    values = [(float(force(system, below, tau)), float(tau)) for system in systems for tau in places]
    least = min(values)
    told = f"at ε = {float(below)} the least sample is {least[0]} at τ = {least[1]}"
    if verdict.outcome is Outcome.PROVED:
        if least[0] < -_OFF:
            return wrong(told)
        earlier = [question.start - step for step in (1, 9) if found.whole_line]
        before = [float(force(system, below, tau)) for system in systems for tau in earlier]
        if min(before, default=0.0) < -_OFF:
            return wrong(f"{told}\n  before the start: {before}")
        return _above(question, found, force, told)
    return wrong(told) if max(values)[0] > _SEEN else AGREED


def _above(question: Question, found: Any, force: Force, told: str) -> Answer:
    """The largest epsilon is no larger than stated: just above the upper end some sample is negative."""
    minimum, largest = getattr(found, "minimum", None), getattr(found, "largest_epsilon", None)
    if question.epsilon is not None or minimum is None or largest is None or not _LEAST < largest < 50:
        return AGREED
    above = Fraction(float(largest.upper())) * Fraction(1001, 1000)
    places = _places(to_fraction(minimum.lower), to_fraction(minimum.upper), 6)
    values = [min(float(force(system, above, tau)) for tau in places) for system in question.systems()]
    return wrong(f"{told}\n  above the largest ε, at ε = {float(above)}: {values}") if max(values) > 0 else AGREED


def _lift_off(question: Question, found: Any, force: Force) -> Answer:
    """Positive before the bracket, negative behind it."""
    lower, upper = (to_fraction(x) for x in found.bracket)
    epsilon = to_fraction(found.epsilon)
    before = [*_places(question.start, lower, 6), *([question.start - 2] if found.whole_line else [])]
    for system in question.systems():
        values = [float(force(system, epsilon, tau)) for tau in before if tau <= lower]
        scale = max(1.0, *map(abs, values)) if values else 1.0
        behind = float(force(system, epsilon, upper + Fraction(1, 1000)))
        if min(values, default=1.0) < -_OFF * scale or behind > _OFF * scale:
            return wrong(f"{found}\n  for {system}: before {values}, behind {behind}")
    return AGREED
