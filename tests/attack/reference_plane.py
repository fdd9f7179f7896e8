"""Rigid slip of the model system whose alphas and F_u are polynomials in p and b, by scipy's DOP853 in the stretched
time s, dt = p ds: p' = p alpha_1, b' = p alpha_2 + b alpha_3, u' = p F_u + b.

The sign of C_1 is read off from -b/p less the power series in p of the one force that is analytic at the G-spot.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import scipy.integrate

Powers = Mapping[tuple[int, int], float]
"""The coefficients of p^i b^j."""

_TERMS = 16
_LOW = 0.01
_SPOT = 1e-9
_LONGEST = 300.0
_SURE = 1e-9


class Unsure(Exception):
    """Nearly a tie, or nothing comes."""


@dataclass(frozen=True)
class PlaneSlip:
    """alpha_1, alpha_2, alpha_3, F_u, and the velocity of the surface."""

    alphas: tuple[Powers, Powers, Powers]
    push: Powers
    surface: float

    def ended(self, start: Sequence[float]) -> tuple[str, float]:
        """How slip from p > 0, b < 0, u ends; at the G-spot with the sign of C_1, 0 if it is not certain."""
        low = min(_LOW, start[0] / 2)
        what, near = self._until(start, low)
        if what:
            return what, 0
        what, last = self._until(near, _SPOT)
        if what:
            return what, 0
        if abs(last[1]) > 1e-5 or abs(last[2] - self.surface) < 1e-7:
            raise Unsure("p falls to 0, and b or the slip velocity is not certain")
        return "G-spot", self._sign(near)

    def _until(self, start: Sequence[float], level: float) -> tuple[str, Sequence[float]]:
        """The first of lift-off, the end of slip, and p = level ("")."""

        def rates(_: float, state: Sequence[float]) -> list[float]:
            p, b, _u = state
            first, second, third = (value(alpha, p, b) for alpha in self.alphas)
            return [p * first, p * second + b * third, p * value(self.push, p, b) + b]

        watched: dict[str, Callable[[float, Sequence[float]], float]] = {
            "lift-off": lambda _, state: -state[1],
            "slip stops": lambda _, state: state[2] - self.surface,
            "": lambda _, state: state[0] - level,
        }
        for each in watched.values():
            vars(each).update(terminal=True, direction=-1)
        found: Any = scipy.integrate.solve_ivp(
            rates, (0, _LONGEST), [*start], "DOP853", events=[*watched.values()], rtol=1e-12, atol=1e-22, max_step=0.2
        )
        if found.status != 1:
            raise Unsure("nothing comes, or the integration fails")
        what = next(name for name, times in zip(watched, found.t_events, strict=True) if len(times))
        return what, [float(x) for x in found.y[:, -1]]

    def _sign(self, state: Sequence[float]) -> float:
        p, b, _ = state
        series = self.analytic_force()
        force = sum(c * p**k for k, c in enumerate(series))
        rest = sum(abs(c) * p ** (_TERMS - 2 + k) for k, c in enumerate(series[-2:]))
        off = -b / p - force
        if not abs(off) > _SURE * (1 + abs(force)) + 100 * rest:
            return 0
        return -1 if off > 0 else 1

    def analytic_force(self) -> list[float]:
        """L(p) with alpha_1 p L' = -alpha_2 - (alpha_1 - alpha_3) L on b = -p L: each coefficient from those before."""
        force = [0.0] * _TERMS
        first, _, third = (alpha[0, 0] for alpha in self.alphas)
        for k in range(_TERMS):
            place = [0.0, *(-c for c in force[:-1])]
            one, two, three = (_composed(alpha, place) for alpha in self.alphas)
            slope = _product(one, [n * c for n, c in enumerate(force)])[k]
            left = slope + two[k] + _product([x - y for x, y in zip(one, three, strict=True)], force)[k]
            force[k] = -left / (k * first + first - third)
        return force


def value(powers: Powers, p: float, b: float) -> float:
    """The polynomial at p and b."""
    return sum(c * p**i * b**j for (i, j), c in powers.items())


def _product(one: Sequence[float], other: Sequence[float]) -> list[float]:
    return [sum(one[i] * other[k - i] for i in range(k + 1)) for k in range(_TERMS)]


def _composed(powers: Powers, place: Sequence[float]) -> list[float]:
    """The polynomial on b = place(p), a series in p."""
    total = [0.0] * _TERMS
    for (i, j), c in powers.items():
        term = [c if k == i else 0.0 for k in range(_TERMS)]
        for _ in range(j):
            term = _product(term, place)
        total = [x + y for x, y in zip(total, term, strict=True)]
    return total
