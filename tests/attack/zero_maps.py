"""Numbers of zeros of the slow solution over ranges of beta and epsilon, and folds, where two zeros meet, against its
values from the reference's start by DOP853."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

import numpy as np
import scipy.integrate
import scipy.optimize
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fmpq, to_fraction
from attack.reference_contact import slow_start

from gspot_verified import Outcome
from gspot_verified.compliant.zeros.fold_point import FoldPoint, fold_point
from gspot_verified.compliant.zeros.zero_map import ZeroMap, zero_map

_SAMPLES = 1000
_FAR = 8
"""In tau: up to beta = 10 all zeros lie below it."""
_DIGITS = 18
_ROUNDING = 1e-7
_LEAST = Fraction(1, 4)
"""Of epsilon: below it the equation grows too fast on the left for doubles."""


def attack(random: Random) -> Attack:
    """A map more often than a fold."""
    return (_map if random.random() < 0.6 else _fold)(random)


def _scale(epsilon: Fraction) -> Fraction:
    """T of tau = 1."""
    return Fraction(round((2 / float(epsilon)) ** (1 / 3) * 2**20), 2**20)


def _map(random: Random) -> Attack:
    whole = random.choice((4, 5, 5, 6, 7, 8))
    lower = whole + Fraction(random.randint(0, 15), 16)
    upper = lower + random.choice((Fraction(1, 16), Fraction(1, 100), Fraction(1, 10**6)))
    epsilon = max(_LEAST, Fraction(round(10 ** random.uniform(-0.6, 2) * 100), 100))
    if random.random() < 0.3:
        epsilon = random.choice((Fraction(32), Fraction(1376, 100), Fraction(153, 100), Fraction(1755, 100)))
    first = random.choice((epsilon, epsilon, epsilon * Fraction(63, 64)))
    places = [(lower + (upper - lower) * Fraction(random.randint(1, 63), 64),
               max(first + (epsilon - first) * Fraction(random.randint(0, 64), 64), _LEAST))
              for _ in range(3)]  # fmt: skip
    return Attack(f"zero_map('{lower}..{upper}', '{first}..{epsilon}') at {places}",
                  lambda: _judged_map(lower, upper, first, epsilon, places))  # fmt: skip


def _judged_map(
    lower: Fraction, upper: Fraction, first: Fraction, last: Fraction, places: list[tuple[Fraction, Fraction]]
) -> Answer:
    found = zero_map(f"{lower}..{upper}", str(last) if first == last else f"{first}..{last}", budget=12)
    fewer = 0
    for beta, epsilon in places:
        numbers = _numbers(found, beta, epsilon)
        if numbers is None:
            if found.verdict.outcome is Outcome.PROVED and beta.denominator != 1:
                return wrong(f"proved, and nothing is said of beta = {beta}, epsilon = {epsilon}\n{found}")
            continue
        changes = _changes(beta, epsilon)
        if changes > max(numbers):
            return wrong(f"{changes} changes of sign at beta = {beta}, epsilon = {epsilon}\n{found}")
        fewer += changes not in numbers  # above an integer one zero is far out, beyond the samples
    if fewer:
        return undecided("zeros between the samples")
    return AGREED if found.verdict.outcome is Outcome.PROVED else undecided(f"{found.verdict.reason}")


def _numbers(found: ZeroMap, beta: Fraction, epsilon: Fraction) -> tuple[int, ...] | None:
    """What the map says of one place."""
    for row in found.rows:
        if to_fraction(row.lower) <= epsilon <= to_fraction(row.upper):
            for stretch in row.stretch_rows:
                if to_fraction(stretch.beta[0]) < beta < to_fraction(stretch.beta[1]):
                    return stretch.numbers
    return None


def _curve(beta: Fraction, epsilon: Fraction) -> Callable[[np.ndarray], np.ndarray]:
    """F_(beta-1) over tau in [-2, 8], by DOP853 from T = 0 both ways; the ODE is that of ``slow_values``."""
    b, small, scale = float(beta - 1), float(epsilon), float(_scale(epsilon))

    def rates(T: float, F: np.ndarray) -> list[float]:
        return [F[1], F[2], F[3], small * (T * F[2] + (T + 1 - b) * F[1] - b * F[0]) - 2 * F[3]]

    begin = [float(x) for x in slow_start(beta - 1, epsilon, _DIGITS)][:4]
    left, right = (
        scipy.integrate.solve_ivp(rates, (0, end * scale), begin, "DOP853", dense_output=True, rtol=1e-12, atol=1e-12)
        for end in (-2, _FAR)
    )
    return lambda tau: np.where(tau < 0, left.sol(tau * scale)[0], right.sol(tau * scale)[0])


def _changes(beta: Fraction, epsilon: Fraction) -> int:
    values = _curve(beta, epsilon)(np.linspace(-2, _FAR, _SAMPLES))
    return int(np.sum(values[:-1] * values[1:] < 0))


def _fold(random: Random) -> Attack:
    epsilon = Fraction(round(10 ** random.uniform(-0.5, 2.6) * 1000), 1000)
    epsilon = random.choice((epsilon, epsilon, Fraction(32), Fraction(1527, 1000), Fraction(1528, 1000)))
    meeting, digits = random.choice((6, 6, 9)), random.choice((2, 3, 4))
    return Attack(f"fold_point('{epsilon}', {digits}, {meeting})", lambda: _judged_fold(epsilon, digits, meeting))


def _judged_fold(epsilon: Fraction, digits: int, meeting: int) -> Answer:
    found = fold_point(to_fmpq(epsilon), digits, meeting)
    if found is None:
        return undecided("no fold was certified")
    before, after = (_least(found, to_fraction(beta)) for beta in (found.lower, found.upper))
    shown = f"{found}: the least value is {before:.4g} at the lower end and {after:.4g} at the upper one"
    return wrong(shown) if before > _ROUNDING or after < -_ROUNDING else AGREED


def _least(found: FoldPoint, beta: Fraction) -> float:
    """The least value on the interval of tau."""
    curve = _curve(beta, to_fraction(found.epsilon))
    begin, end = (float(to_fraction(place)) for place in found.tau)
    places = np.linspace(begin, end, 400)
    place = places[int(np.argmin(curve(places)))]
    step = (end - begin) / 400
    least = scipy.optimize.minimize_scalar(
        lambda tau: float(curve(np.array(tau))), bounds=(place - step, place + step), method="bounded"
    )
    return float(least.fun)
