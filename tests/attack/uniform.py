"""True solutions of the extended example beside its expansion: how far they are, lift-off and impact, at deltas up to
the one that is asked for, against runs of the scaled equations by DOP853."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

import numpy as np
import scipy.integrate
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fmpq, to_fraction

from gspot_verified import Outcome, Trajectory, UniformSide, expand, uniform_bound, uniform_side
from gspot_verified.testing import extended_example

_KAPPA = 0.5
_ROUNDING = 1e-9
_LEAST_UNIT = 1e-8
_STIFF = 1e-3

Numbers = tuple[Fraction, Fraction, Fraction, Fraction]
"""chi, alpha_1, alpha_2, alpha_3."""


def attack(random: Random) -> Attack:
    """One of the two."""
    return random.choice((_bound, _side))(random)


def _numbers(random: Random) -> Numbers:
    first = -Fraction(random.randint(4, 16), 8)
    beta = random.choice((Fraction(random.randint(5, 15), 4), Fraction(random.randint(4, 10), 3)))
    beta += Fraction(1, 7) * (beta.denominator == 1)
    chi = random.choice((Fraction(0), Fraction(1), Fraction(random.randint(-8, 8), 4)))
    return chi, first, -Fraction(random.randint(2, 16), 8), beta * first


def _trajectory(numbers: Numbers, order: int) -> Trajectory:
    chi, *alphas = map(to_fmpq, numbers)
    return expand(extended_example(chi, tuple(alphas)), order)


def _run(
    numbers: Numbers, delta: float, span: tuple[float, float], start: list[float], event: Callable[..., float] | None
) -> scipy.integrate.OdeSolution:
    """States p, b, y, v, z, and the component of xi on which p' depends; k_1 = k_2 = c = 1."""
    chi, first, second, third = map(float, numbers)

    def rates(_: float, state: np.ndarray) -> list[float]:
        p, b, y, v, z, own = state
        force = z - y
        rate = second - third * force
        return [first + chi * delta**2 * own, rate, v, b + p * force, (-z - force) / delta, rate]

    if event is not None:
        event.terminal = True  # type: ignore[attr-defined]
    method = "Radau" if delta < _STIFF else "DOP853"
    return scipy.integrate.solve_ivp(
        rates, span, start, method, dense_output=True, events=event, rtol=1e-13, atol=1e-14
    )


def _begin(
    trajectory: Trajectory, s: Fraction, delta: Fraction, moves: list[float], fast: float
) -> tuple[dict[str, float], list[float]]:
    """The expansion there, and the state that is ``moves`` (p, b, y, v, xi_6; lambda + kappa y) away from it."""
    at = {name: float(value.mid()) for name, value in trajectory.evaluate(to_fmpq(s), to_fmpq(delta), 25).items()}
    p, b, y, v, own = (at[name] + move for name, move in zip(("p", "b", "y", "v", "xi_6"), moves, strict=True))
    force = at["lambda_n"] + fast - _KAPPA * moves[2]
    return at, [p, b, y, v, y + force, own]


def _bound(random: Random) -> Attack:
    numbers, order = _numbers(random), random.choice((4, 5, 6))
    delta = Fraction(1, random.choice((6, 10, 20, 40)))
    start, length = Fraction(random.randint(-12, 0), 4), Fraction(random.randint(2, 16), 4)
    within = random.choice((Fraction(0), Fraction(1), Fraction(20)))
    small = delta * random.choice((Fraction(1), Fraction(9, 10), Fraction(1, 2)))
    shares = [random.choice((-1.0, 1.0, random.uniform(-1, 1))) for _ in range(6)]
    question = (
        f"uniform_bound(expand(extended_example(*{numbers}), {order}), {start}, {start + length}, {delta}, {within})"
    )
    return Attack(
        f"{question} at {small}",
        lambda: _judged_bound(numbers, order, (start, length), (delta, small), within, shares),
    )


def _judged_bound(
    numbers: Numbers, order: int, span: tuple[Fraction, Fraction], deltas: tuple[Fraction, Fraction], within: Fraction,
    shares: list[float],
) -> Answer:  # fmt: skip
    start, length = span
    delta, small = deltas
    trajectory = _trajectory(numbers, order)
    found = uniform_bound(trajectory, to_fmpq(start), to_fmpq(start + length), to_fmpq(delta), to_fmpq(within))
    if found.verdict.outcome is not Outcome.PROVED:
        return undecided(f"{found.verdict.reason}")
    unit = float(small) ** order
    moves = [share * float(within) * unit for share in shares]
    _, state = _begin(trajectory, start, small, moves[:5], moves[5])
    end = float(start + length)
    solution = _run(numbers, float(small), (float(start), end), state, None)
    if not solution.success:
        return undecided("the reference: the integration fails")
    for k in range(9):
        s = start + length * Fraction(k, 8)
        at = trajectory.evaluate(to_fmpq(s), to_fmpq(small), 25)
        p, b, y, v, z, own = solution.sol(float(s))
        values = {"p": p, "b": b, "y": y, "v": v, "z": z, "xi_6": own, "lambda_n": z - y}
        for name, value in values.items():
            off = abs(value - float(at[name].mid()))
            most = max(float(one.constants[name].upper()) for one in found.stretches
                       if to_fraction(one.start) <= s <= to_fraction(one.end))  # fmt: skip
            if off > most * unit + _ROUNDING * (1 + abs(value)) * 1e-2:
                return wrong(f"{name} at s = {s} is {off:.5g} away, K delta^M = {most * unit:.5g}\n{found}")
        if found.contact.outcome is Outcome.PROVED and z - y < -_ROUNDING:
            return wrong(f"the force is {z - y:.3g} at s = {s}\n{found}")
    return AGREED


def _side(random: Random) -> Attack:
    numbers = _numbers(random)
    c_1 = random.choice((-1, 1)) * random.choice((Fraction(1), Fraction(1, 10), Fraction(5)))
    delta, start = (
        Fraction(1, random.choice((20, 50, 500, 5000))),
        random.choice((Fraction(-1), Fraction(-2), Fraction(0))),
    )
    small = delta * random.choice((Fraction(1), Fraction(1, 2), Fraction(1, 30)))
    within, shares = random.choice((Fraction(1, 1000), Fraction(1, 50))), [random.uniform(-1, 1) for _ in range(6)]
    question = f"uniform_side(expand(extended_example(*{numbers}), 8), {c_1}, {delta}, {start}, {within}) at {small}"
    return Attack(question, lambda: _judged_side(numbers, c_1, (delta, small), start, within, shares))


def _judged_side(
    numbers: Numbers, c_1: Fraction, deltas: tuple[Fraction, Fraction], start: Fraction, within: Fraction,
    shares: list[float],
) -> Answer:  # fmt: skip
    delta, small = deltas
    trajectory = _trajectory(numbers, 8)
    found = uniform_side(trajectory, to_fmpq(c_1), to_fmpq(delta), to_fmpq(start), to_fmpq(within))
    if found.verdict.outcome is not Outcome.PROVED:
        return undecided(f"{found.verdict.reason}")
    unit = float(small) ** float(2 * to_fraction(found.beta) - 2)
    if unit < _LEAST_UNIT:
        return undecided("the reference: the deviation is too small for doubles")
    *_, b, y, v = (float(value.mid()) for value in found.deviation)
    slow = [0.0, b, y, v, b]  # the deviation of xi_6 is that of b
    moves = [(part + share * float(within)) * unit for part, share in zip(slow, shares, strict=False)]
    _, state = _begin(trajectory, start, small, moves, shares[5] * float(within) * unit)
    latest = float(found.latest(to_fmpq(small)).upper())
    return _followed(numbers, found, float(small), (float(start), latest), state)


def _followed(
    numbers: Numbers, found: UniformSide, small: float, span: tuple[float, float], state: list[float]
) -> Answer:
    """Until the force is 0, or is what was to be reached."""
    _, first, second, third = map(float, numbers)
    mean = second / (third - first)
    assert found.entered is not None
    wanted = float(found.ends[0].force.lower()) * (1 - 1e-9) if found.side == "impact" else 1e9 * mean
    solution = _run(
        numbers, small, span, state, lambda _, state: (state[4] - state[2]) * (wanted - state[4] + state[2])
    )
    if not solution.success:
        return undecided("the reference: the integration fails")
    force = float(solution.y[4, -1] - solution.y[2, -1])
    shown = f"at delta = {small}: the reference ends at s = {solution.t[-1]} of {span}, force {force}\n{found}"
    if solution.status != 1:
        return wrong(f"neither until then {shown}")
    lost = abs(force) < wanted / 2
    if lost != (found.side == "lift-off") or solution.t[-1] < float(to_fraction(found.entered)) - 1e-9:
        return wrong(shown)
    return AGREED
