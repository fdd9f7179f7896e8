"""The part on one value of Theta: digits against time, beside everything else that answers the question."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable
from functools import partial
from typing import Any

from flint import fmpq

from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, best_time
from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Limit
from gspot_verified.cost.peers.external import PROGRAMS, ExternalTime, Program, ask
from gspot_verified.cost.times.baseline import flint_theta, mpmath_theta, right_digits
from gspot_verified.cost.times.limits import products_of_the_series
from gspot_verified.numbers.balls import approximate
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.theta import theta

TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)  # relative and absolute, for the curves of the solver


def ode_run(beta: fmpq, end: float, tolerance: float, **options: Any) -> Any:
    """``solve_ivp`` on theta''' = tau theta' - beta theta from the initial values at 0 to ``end``."""
    from scipy.integrate import solve_ivp

    start = [approximate(value) for value in initial_values(beta, 64)]
    parameter = approximate(beta)

    def slope(at: float, y: Any) -> tuple[float, float, float]:
        return y[1], y[2], at * y[1] - parameter * y[0]

    return solve_ivp(slope, (0.0, end), start, method="DOP853", rtol=tolerance, atol=tolerance, **options)


def ode_value(tau: fmpq, beta: fmpq, tolerance: float) -> float:
    """Theta(tau, beta)."""
    return float(ode_run(beta, approximate(tau), tolerance).y[0, -1])


def ode_zeros(beta: fmpq, first: float, last: float, tolerance: float) -> list[float]:
    """Where dTheta/dtau changes its sign between the solver's steps: zeros closer than a step are not seen."""

    def derivative(_: float, y: Any) -> float:
        return float(y[1])

    zeros: list[float] = []
    for end in (first, last):
        zeros += ode_run(beta, end, tolerance, events=derivative).t_events[0].tolist()
    return sorted(zeros)


def right_decimals(value: float, known: float) -> float | None:
    """Minus the decimal logarithm of the relative error, at most 15.5; None where not one digit is right.

    >>> right_decimals(1.001, 1.0), right_decimals(2.0, 1.0)
    (3.0, None)
    """
    error = abs(value - known) / abs(known)
    digits = 15.5 if error == 0 else min(15.5, round(-math.log10(error), 1))
    return digits if digits >= 1 else None


TAU, BETA = fmpq(7, 3), fmpq(1, 2)  # the value that is computed
_DIGITS, _MORE = (15, 50, 200, 1_000, 3_000, 10_000), (30_000, 100_000)  # more in full
_FEW, _FEW_MORE = (15, 50, 200), (1_000,)  # fewer digits: mpmath is slower
_LIMIT_DIGITS = {False: 10_000, True: 100_000}  # by whether the measurement is full


def _ours(digits: int) -> Call:
    return partial(theta, TAU, BETA, 0, digits)


def _correct_digits(digits: int, value: Any) -> float | None:
    return right_digits(value, theta(TAU, BETA, digits=digits + 5), digits) or None


def _of_the_ode(_: float, value: Any) -> float | None:
    return right_decimals(value, approximate(theta(TAU, BETA, digits=20)))


def _contestants() -> tuple[TimedRoute, ...]:
    return (
        TimedRoute(
            "this library", CERTIFIED, _DIGITS, _ours, _MORE, exponent=1.0,
            theory="binary splitting: O(M(D) log² D) for D digits, so a little above 1",
        ),
        TimedRoute(
            "FLINT, three 1F2", CERTIFIED, _DIGITS, lambda digits: partial(flint_theta, TAU, BETA, 0, digits),
            _MORE[:1], exponent=2.0,
            theory="D/log D terms, each with products of D digits: a little below 2 with fast products",
        ),
        TimedRoute(
            "mpmath hyp1f2", NO_BOUND, _FEW, lambda digits: partial(mpmath_theta, TAU, BETA, 0, digits), _FEW_MORE,
            place=_correct_digits, exponent=2.0, theory="the same sum, on Python integers",
        ),
        TimedRoute(
            "scipy DOP853", NO_BOUND, TOLERANCES, lambda tolerance: partial(ode_value, TAU, BETA, tolerance),
            place=_of_the_ode, words=lambda tolerance: f"tolerance {tolerance:g}",
            theory="order 8: time grows like 10^(D/8), an exponential and no power",
        ),
        *(_external(program) for program in PROGRAMS),
    )  # fmt: skip


def _external(program: Program) -> TimedRoute:
    missing = "" if shutil.which(program.executable) else "not installed on this machine"

    def call(digits: int) -> Call:
        return partial(ask, program, TAU, BETA, digits, 60.0)

    def place(_: int, answer: Any) -> float | None:
        return answer.right or None

    return TimedRoute(
        program.name, NO_BOUND if program.executable == "gp" else CERTIFIED, (15, 50, 200, 1_000), call, (10_000,),
        place=place, seconds=_own_time, missing=missing,
    )  # fmt: skip


def _own_time(answer: ExternalTime) -> float:
    return answer.first if answer.first is not None else 0.0


def _profiled(full: bool) -> tuple[str, Call]:
    digits = _LIMIT_DIGITS[full]
    return f"{digits} digits", _ours(digits)


def _limit(full: bool) -> Limit:
    digits = _LIMIT_DIGITS[full]
    count, product = products_of_the_series(TAU, BETA, digits)
    words = f"{count:.0f} products of integers of {digits} digits, those of the sum by binary splitting"
    call: Callable[[], object] = _ours(digits)
    return Limit(f"{digits} digits", words, count * best_time(product, 9, fresh=False), best_time(call))


THETA = Blueprint(
    key="theta",
    title="One value of Θ",
    question="Θ(7/3, 1/2) to D digits, as the first call.",
    axis="digits D",
    symbol="D",
    contestants=_contestants,
    profiled=_profiled,
    limit=_limit,
    remarks=(
        "FLINT’s precision is doubled until the accuracy is met, as one would who does not know the cancellation. "
        "A route without a bound stands where its answer is right, which it does not know.",
        "FLINT, mpmath and PARI keep constants (π, Bernoulli numbers) between calls; the median sees them kept.",
    ),
)
