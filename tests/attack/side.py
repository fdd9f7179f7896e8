"""K, the exact side of a state at finite epsilon, against the growing solution of the linear contact; the number of
zeros of the slow solution against its changes of sign."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import exactly, to_fmpq
from attack.reference_contact import force_later, slow_values

from gspot_verified import Outcome
from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.compliant.zeros.zero_count import slow_zeros

_SEEN = Fraction(1, 10**12)


def attack(random: Random) -> Attack:
    """The side of two states more often than a number of zeros, which is dear."""
    return (_side if random.random() < 0.8 else _zeros)(random)


def _beta(random: Random) -> Fraction:
    whole = Fraction(random.randint(2, 6))
    found = random.choice((
        Fraction(random.randint(3, 60), 8), whole,
        whole + random.choice((-1, 1)) * Fraction(1, 10 ** random.randint(2, 12)),
        Fraction(random.randint(10**8, 6 * 10**8), 10**8 + 7),
    ))  # fmt: skip
    return found + Fraction(1, 3) if found == 1 else found


def _side(random: Random) -> Attack:
    beta, epsilon = _beta(random), random.choice((Fraction(1, 5), Fraction(1, 20), Fraction(1, 100), Fraction(3, 1)))
    p = Fraction(random.randint(-4, 8), 8) + random.choice((Fraction(0), Fraction(1, 10**6)))
    mean = -1 / (1 - beta)
    trivial = (p * -mean, -2 * mean, Fraction(0), -mean)
    states = [tuple(x + Fraction(random.randint(-64, 64), 64) / 4 for x in trivial) for _ in range(2)]
    states = [(b, Y, V, Z if Z > Y else Y + Fraction(1, 16)) for b, Y, V, Z in states]
    question = f"side_rule(compliant_model('{beta}', '{epsilon}'), ...) at p = {p}, (b, Y, V, Z) = {states}"
    return Attack(question, lambda: _judged_side(beta, epsilon, p, states))


def _judged_side(beta: Fraction, epsilon: Fraction, p: Fraction, states: list[tuple[Fraction, ...]]) -> Answer:
    """The sign of K is that of the force at last, and the two K are to each other as the two forces are."""
    model = compliant_model(to_fmpq(beta), to_fmpq(epsilon))
    found, forces = [], []
    # From p = 0 on the growing solution grows like exp(2/3 |p|^1.5/epsilon): here by about e^100.
    end = min(p, Fraction(0)) - Fraction(round((150 * float(epsilon)) ** (2 / 3) * 16), 16)
    for b, Y, V, Z in states:
        given = (p, b, Y * epsilon**2, V * epsilon, Z * epsilon**2)
        found.append(side_rule(model, compliant_state(*map(to_fmpq, given))))
        forces.append(force_later(beta, epsilon, (p, b, Y, V, Z), end, -1 / (1 - beta)))
    shown = f"K = {[str(rule.side) for rule in found]}, the forces at p = {end}: {[float(f) for f in forces]}"
    for rule, force in zip(found, forces, strict=True):
        if rule.verdict.outcome is Outcome.PROVED and abs(force) > 10**12 and (rule.side > 0) != (force > 0):
            return wrong(f"the sign of K: {shown}\n  {rule.verdict}")
        if rule.verdict.outcome is not Outcome.PROVED:
            return undecided("the sign of K")
    with mpmath.workdps(60):
        one, two = (exactly(rule.side.mid()) for rule in found)
        spread = sum(exactly(rule.side.rad()) / abs(exactly(rule.side.mid())) for rule in found)
        first, second = (mpmath.mpf(f.numerator) / f.denominator for f in forces)
        others = 1000 * (2 + abs(mpmath.mpf(float((p - end) / epsilon)))) ** (
            float(beta) + 1
        )  # the slow ones grow like T^beta
        if min(abs(first), abs(second)) < 10**4 * others:
            return undecided("the growing solution has not outgrown the others")
        off = abs(one * second / (two * first) - 1)
        allowed = spread * 2 + others / min(abs(first), abs(second))
    if off > allowed:
        return wrong(f"the ratio of K is off by {mpmath.nstr(off, 5)}, allowed {mpmath.nstr(allowed, 5)}: {shown}")
    return AGREED


def _zeros(random: Random) -> Attack:
    beta = Fraction(random.randint(9, 55), 8) + random.choice((Fraction(0), Fraction(1, 10**5)))
    epsilon = random.choice(
        (Fraction(1, 4), Fraction(1), Fraction(5), Fraction(20), Fraction(31), Fraction(33), Fraction(200))
    )
    return Attack(f"slow_zeros('{beta}', '{epsilon}')", lambda: _judged_zeros(beta, epsilon))


def _judged_zeros(beta: Fraction, epsilon: Fraction) -> Answer:
    found = slow_zeros(to_fmpq(beta), to_fmpq(epsilon))
    if found.number is None:
        return undecided(str(found.verdict.reason))
    scale = Fraction(round((2 / float(epsilon)) ** (1 / 3) * 2**20), 2**20)
    samples = slow_values(beta - 1, epsilon, 7 * scale, 84)
    times, values = zip(*samples, strict=True)
    changes = [k for k in range(len(times) - 1) if values[k] * values[k + 1] < 0]
    shown = f"{found}\n  changes of sign after T = {[float(times[k]) for k in changes]}"
    if len(changes) > found.number:
        return wrong(f"{len(changes)} changes of sign\n{shown}")
    for k in changes:
        inside = [t for t in found.places if times[k] - _SEEN <= Fraction(float(t.mid())) <= times[k + 1] + _SEEN]
        if not inside and len(found.places) == found.number:
            return wrong(f"no place in ({float(times[k])}, {float(times[k + 1])})\n{shown}")
    return AGREED if len(changes) == found.number else undecided("zeros between the samples, double ones, or far out")
