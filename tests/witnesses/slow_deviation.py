"""The deviation of the model system from its distinguished trajectory, typed from the mechanism's own equations.

They share no formula with the package: the force's equation is c Z' = -k_1 Z - lambda, lambda = k_2 (Z - Y).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from samples.strategies import to_fraction
from scipy.integrate import solve_ivp


class Dual:
    """A number and its derivative."""

    def __init__(self, value: Any, slope: Any = 0) -> None:
        self.value, self.slope = value, slope

    def __add__(self, other: Any) -> Dual:
        other = other if isinstance(other, Dual) else Dual(other)
        return Dual(self.value + other.value, self.slope + other.slope)

    def __mul__(self, other: Any) -> Dual:
        other = other if isinstance(other, Dual) else Dual(other)
        return Dual(self.value * other.value, self.slope * other.value + self.value * other.slope)

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, other: Dual) -> Dual:
        value = self.value / other.value
        return Dual(value, (self.slope - value * other.slope) / other.value)

    def __pow__(self, power: int) -> Dual:
        result = Dual(Fraction(1))
        for _ in range(power):
            result = result * self
        return result


def at(polynomial: Any, h: Dual, r: Dual) -> Dual:
    """A polynomial in h and r with rational coefficients."""
    terms = polynomial.to_dict().items()
    return sum((to_fraction(value) * h ** int(i) * r ** int(n) for (i, n), value in terms), Dual(Fraction(0)))


def rates(beta: Any, springs: Sequence[Any], e: Any, p: Any, state: Sequence[Any]) -> tuple[Any, Any, Any, Any]:
    """d/dT of (L, V, W, phi), by way of (b, Y, V, lambda) as deviations; alpha_1 = -1, so e = epsilon."""
    k_1, k_2, c = springs
    kappa, g = k_1 * k_2 / (k_1 + k_2), (k_1 + k_2) / c
    l = k_2 - kappa  # noqa: E741 - the page's name
    L, V, W, phi = state
    b, force = -p * L, L + W / p
    Y = (phi - force - l / g * V) / kappa
    Z = Y + force / k_2
    b_rate, p_rate = e * beta * force, -e
    force_rate = k_2 * ((-k_1 * Z - force) / c - V)
    L_rate = -b_rate / p + b * p_rate / p**2
    W_rate = b_rate + p_rate * force + p * force_rate
    return L_rate, W, W_rate, force_rate + kappa * V + l / g * W


def motion(
    beta: float, e: float, start: float, state: Sequence[float], places: Sequence[float]
) -> list[tuple[float, float, float, float]]:
    """(L, V, W, phi) at the places of p, from p = ``start`` downwards; the paper's contact."""

    def field(time: float, x: np.ndarray) -> tuple[float, float, float, float]:
        return rates(beta, (1.0, 1.0, 1.0), e, start - e * time, x)

    times = [(start - p) / e for p in places]
    found = solve_ivp(field, (0, max(times)), list(state), method="DOP853", rtol=1e-12, atol=1e-15, t_eval=times)
    assert found.success
    return [tuple(row) for row in found.y.T]  # type: ignore[misc]


def end_of_contact(beta: float, epsilon: float, p: float, force: float, highest: float) -> str | None:
    """Lift-off or impact of a mechanism with m = 4 whose alpha_i depend on p, b and v, from p and lambda = ``force``.

    alpha_1 = -1 + b/4 - p/5, alpha_2 = -1 + p/3 + v/2, alpha_3 = -beta (1 + p/4 - b/5). The start is not on a slow
    manifold: v = epsilon/20, and the force is 5 % off.
    """

    def field(_: float, x: np.ndarray) -> tuple[float, ...]:
        p, b, Y, V, Z = x
        pushed = Z - Y
        v = epsilon * V
        alpha = (-1 + b / 4 - p / 5, -1 + p / 3 + v / 2, -beta * (1 + p / 4 - b / 5))
        return (
            epsilon * alpha[0],
            epsilon * (alpha[1] - alpha[2] * pushed),
            V,
            b + p * pushed,
            -Z - pushed,
        )

    def lost(_: float, x: np.ndarray) -> float:
        return float(x[4] - x[2])

    def pressed(_: float, x: np.ndarray) -> float:
        return float(x[4] - x[2] - highest)

    lost.terminal = pressed.terminal = True  # type: ignore[attr-defined]
    pushed = 1.05 * force
    start = (p, -p * force, -2 * pushed, 0.05, -pushed)
    found = solve_ivp(
        field, (0, 4 * p / epsilon), start, method="DOP853", rtol=1e-10, atol=1e-13, events=(lost, pressed)
    )
    assert found.success
    return "lift-off" if found.t_events[0].size else "impact" if found.t_events[1].size else None
