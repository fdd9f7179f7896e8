"""Theta by scipy's DOP853 from tau = 0, as one would do without this library: doubles, no bound."""

from __future__ import annotations

import math
from typing import Any

from flint import fmpq

from gspot_verified.numbers.balls import approximate
from gspot_verified.theta_function.gamma.initial_values import initial_values

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
