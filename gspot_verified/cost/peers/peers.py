"""Theta beside what a user could take instead, interleaved in one run: ratios of the shortest times.

Peers: one call of FLINT's three 1F2 in the entire form at the least precision that is known to suffice (found
beforehand, not timed), mpmath, and scipy's DOP853, which gives no bound. The initial values of the entire form are
those of ``proofs/initial_values.md``, nowhere 0/0; the three 1F2 are those of Theorem 4 (th:3) of the paper.
Programs outside Python: :mod:`gspot_verified.cost.peers.external`.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from flint import arb, fmpq

from gspot_verified.cost.times.baseline import LOWER, mpmath_theta
from gspot_verified.cost.times.cases import asked
from gspot_verified.cost.times.measure import Contestant, Timing, clear_caches, measure
from gspot_verified.cost.times.rows import Row, Target
from gspot_verified.numbers.balls import bits_for_digits, relative_bits, working_bits
from gspot_verified.theta_function.arrays.arrays import theta_array, theta_of_floats
from gspot_verified.theta_function.arrays.prepared import PreparedTheta
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.theta import theta

_HALF = fmpq(1, 2)  # exact, made once


def entire_form(tau: fmpq, beta: fmpq, bits: int) -> arb:
    """One evaluation at one working precision; possibly wide, or not finite.

    >>> entire_form(fmpq(3), fmpq(2), 64).contains(arb(9))
    True
    """
    with working_bits(bits):
        first, second, third = (arb((j - beta) / 3).rgamma() for j in range(3))
        log = arb(3).log()
        root = (log / 3).exp()
        constant = 2 * arb.pi() * (log * arb(2 * beta / 3 - _HALF)).exp()
        point, argument = arb(tau), arb(tau**3 / 9)
        values = constant * third * second, constant * third * root * first, constant * root * root * first * second
        powers = arb(1), point, point * point / 2
        total = arb(0)
        for j, (value, power) in enumerate(zip(values, powers, strict=True)):
            total += value * power * argument.hypgeom([arb((j - beta) / 3)], [arb(b) for b in LOWER[j]])
        return total


BETAS = (fmpq(1, 2), fmpq(7, 3), fmpq(13, 2), fmpq(7, 5), fmpq(355, 113))  # with small and large denominators
NEAR = tuple(fmpq(*pair) for pair in ((1, 10), (1, 1), (-1, 1), (10, 1), (-10, 1), (50, 1), (-50, 1)))
DECIMALS = (fmpq(7, 3), fmpq(21234567, 10**7), fmpq(2123456789012345678901234567891, 10**30))  # short, 7, 30 decimals
DIGITS = (16, 50, 1_000, 10_000)  # of one value
REACHES = (2.0, 10.0, 50.0)  # of tau on both sides, for many values
POINTS = 20_000  # values in one array
SHORT = (500, 2_000)  # values in a short one

_MPMATH_DIGITS = 50  # more take mpmath too long
_MANY_DIGITS = 50  # from these on the target of a first call is another one
_MOST_REPEATS = 101  # of one call, within the seconds below
_SECONDS = 0.15  # for each question
_MOST_MORE_BITS = 4_000  # beyond eight times the goal: then no precision is said to suffice
_TOLERANCE = 1e-13  # near the least that doubles allow
_FIRST_CALL = {
    True: Target("FLINT / first call", 0.9, at_most=False),
    False: Target("FLINT / first call", 1.0, at_most=False),
}
_FASTER = Target("DOP853 / ours", 1.0, at_most=False)
_FASTER_AGAIN = Target("DOP853 / warm", 1.0, at_most=False)
_PREPARED = Target("time", 3e-6, "s")


def one_value(
    betas: tuple[fmpq, ...] = BETAS, taus: tuple[fmpq, ...] = NEAR, digits: tuple[int, ...] = DIGITS
) -> Iterator[Row]:
    """The first and the repeated call against FLINT's three 1F2 and, at few digits, against mpmath."""
    for count, beta, tau in product(digits, betas, taus):
        bits = sufficient_bits(tau, beta, count)
        call = partial(theta, tau, beta, 0, count)
        contestants = {
            "cold": Contestant(call, clear_caches, _MOST_REPEATS),
            "warm": Contestant(call, call, _MOST_REPEATS),
        }
        if bits is not None:
            contestants["baseline"] = Contestant(
                partial(entire_form, tau, beta, bits),
                clear_caches,  # of no use to it: so that both calls come after the same work
                _MOST_REPEATS,
            )
        if count <= _MPMATH_DIGITS:
            contestants["mpmath"] = Contestant(partial(mpmath_theta, tau, beta, 0, count), None, 3)
        times = measure(contestants, _SECONDS)
        figure = times["baseline"].best / times["cold"].best if bits is not None else None
        note = f"FLINT: one call at {bits} bits" if bits is not None else "FLINT: no precision suffices"
        yield _row("one value", asked(tau, beta, count), _FIRST_CALL[count < _MANY_DIGITS], figure, times, note)


def first_calls() -> Iterator[Row]:
    """The same at few digits, for beta with few and with many decimals."""
    yield from one_value(DECIMALS, (fmpq(1), fmpq(5), fmpq(20)), (16, 30, 50, 100))


def sufficient_bits(tau: fmpq, beta: fmpq, digits: int) -> int | None:
    """About the least working precision at which FLINT's three 1F2 have the digits; None where none is found."""
    goal = bits_for_digits(digits)

    def suffice(bits: int) -> bool:
        return relative_bits(entire_form(tau, beta, bits)) >= goal

    short, bits = goal, goal + 8
    while not suffice(bits):
        short, bits = bits, bits * 9 // 8 + 4
        if bits > 8 * goal + _MOST_MORE_BITS:
            return None
    while bits - short > 4 + bits // 64:
        middle = (short + bits) // 2
        short, bits = (short, middle) if suffice(middle) else (middle, bits)
    return bits


def far_values(digits: tuple[int, ...] = (1_000, 10_000)) -> Iterator[Row]:
    """tau = +-10^6 and +-10^12 beside tau = -50, where no 1F2 answers."""
    target = Target("time / time at τ=-50", 3.0)
    for count, beta in product(digits, BETAS):
        taus = {f"{sign}10^{power}": fmpq(int(f"{sign}1") * 10**power) for sign in ("", "-") for power in (6, 12)}
        contestants = {
            name: Contestant(partial(theta, tau, beta, 0, count), clear_caches, 9)
            for name, tau in {"-50": fmpq(-50), **taus}.items()
        }
        times = measure(contestants, 0.5)
        for name, tau in taus.items():
            figure = times[name].best / times["-50"].best
            yield Row("far τ", asked(tau, beta, count), target, figure, cold=times[name].best)


def many_values(points: int = POINTS, reaches: tuple[float, ...] = REACHES) -> Iterator[Row]:
    """Arrays of doubles, first calls, against an ODE solver without a bound; then balls, and values one by one."""
    beta = fmpq(7, 3)
    source = np.random.default_rng(1)
    for reach in reaches:
        tau = source.uniform(-reach, reach, points)
        times = measure({
            "cold": Contestant(partial(theta_of_floats, tau, beta), clear_caches, 5),
            "warm": Contestant(partial(theta_of_floats, tau, beta), None, 5),
            "baseline": Contestant(partial(ode_values, np.sort(tau), beta), None, 5),
            "50 digits": Contestant(partial(theta_array, tau, beta, 0, 50), clear_caches, 2),
        }, 3.0)  # fmt: skip
        figure = times["baseline"].best / times["cold"].best
        rates = {name: points / timing.best for name, timing in times.items()}
        note = (
            f"values a second: {_thousands(rates['cold'])} (again {_thousands(rates['warm'])}), DOP853, uncertified, "
            f"{_thousands(rates['baseline'])}; balls of 50 digits {_thousands(rates['50 digits'])}"
        )
        yield _row("many values", f"{points} τ in [-{reach:g}, {reach:g}] β={beta}", _FASTER, figure, times, note)
    yield from _short_arrays(beta, reaches)
    yield _grid()
    prepared, at = PreparedTheta(beta, 15, 10), fmpq(17, 7)
    calls = 200
    seconds = measure({"it": Contestant(lambda: [prepared(at) for _ in range(calls)], None, 50)})["it"].best / calls
    yield Row("many values", f"prepared, β={beta} 15 digits, |τ| <= 10, one value", _PREPARED, seconds, warm=seconds)


def _short_arrays(beta: fmpq, reaches: tuple[float, ...]) -> Iterator[Row]:
    """Short arrays: the first one at a beta (cold), and the next ones, of which the figure is."""
    source = np.random.default_rng(2)
    for points, reach in product(SHORT, reaches):
        tau = source.uniform(-reach, reach, points)
        times = measure({
            "cold": Contestant(partial(theta_of_floats, tau, beta), clear_caches, 5),
            "warm": Contestant(partial(theta_of_floats, tau, beta), None, 15),
            "baseline": Contestant(partial(ode_values, np.sort(tau), beta), None, 5),
        }, 1.0)  # fmt: skip
        figure = times["baseline"].best / times["warm"].best
        words = f"{points} τ in [-{reach:g}, {reach:g}] β={beta}"
        yield _row("short arrays", words, _FASTER_AGAIN, figure, times, "warm: the next array at this β")


def _grid() -> Row:
    tau, beta = np.linspace(-2.0, 2.0, 200)[None, :], np.linspace(0.01, 5.0, 100)[:, None]
    times = measure({"cold": Contestant(partial(theta_of_floats, tau, beta), clear_caches, 5)}, 3.0)
    rate = tau.size * beta.size / times["cold"].best
    seconds = times["cold"].best / (tau.size * beta.size)
    note = f"{_thousands(rate)} values a second"
    return Row(
        "many values", "a grid of 200 τ and 100 β", Target("time", 1 / 192_000, "s"), seconds, seconds, note=note
    )


def ode_values(tau: Any, beta: fmpq) -> Any:
    """Theta at sorted doubles by scipy's DOP853 from 0, to the left and to the right: no bound."""
    from scipy.integrate import solve_ivp

    start = [float(value) for value in initial_values(beta, 64)]
    parameter = int(beta.p) / int(beta.q)

    def slope(at: float, y: Any) -> tuple[float, float, float]:
        return y[1], y[2], at * y[1] - parameter * y[0]

    parts = []
    for side in (tau[tau < 0][::-1], tau[tau >= 0]):
        if len(side):
            span = (0.0, float(side[-1]))
            run = solve_ivp(slope, span, start, method="DOP853", t_eval=side, rtol=_TOLERANCE, atol=_TOLERANCE)
            parts.append(run.y[0])
    return np.concatenate([parts[0][::-1], *parts[1:]]) if len(parts) > 1 else parts[0]


def _thousands(rate: float) -> str:
    return f"{rate / 1_000:.3g} k"


def _row(case: str, words: str, target: Target, figure: float | None, times: dict[str, Timing], note: str) -> Row:
    shown = {name: times[name].best for name in ("cold", "warm", "baseline", "mpmath") if name in times}
    return Row(case, words, target, figure, note=note, **shown)
