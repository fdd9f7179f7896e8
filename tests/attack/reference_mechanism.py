"""The contact equations of a mechanism from its energies, by sympy: M, the contact's rows, A, B, C, a, b, p and the
alphas of the paper (Sec. 1); all G-spots by sampling, exact roots in the velocities, random starts of Newton."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from random import Random
from typing import Any

import mpmath
import scipy.optimize
import sympy

_POINTS = 3000
_DIGITS = 40


@dataclass(frozen=True)
class Body:
    """Lagrange's equations of T, V and further forces, and the contact point x, y with friction mu."""

    coordinates: tuple[sympy.Symbol, ...]
    velocities: tuple[sympy.Symbol, ...]
    kinetic: sympy.Expr
    potential: sympy.Expr
    forces: tuple[sympy.Expr, ...]
    x: sympy.Expr
    y: sympy.Expr
    mu: sympy.Expr

    def functions(self) -> dict[str, sympy.Expr]:
        """a, b, A, B, C, p, u, v, y and alpha_1, alpha_2, alpha_3."""
        q, dq = sympy.Matrix(self.coordinates), sympy.Matrix(self.velocities)
        mass = sympy.hessian(self.kinetic, list(dq))
        momentum = sympy.Matrix([self.kinetic.diff(velocity) for velocity in dq])
        given = sympy.Matrix([self.kinetic.diff(c) - self.potential.diff(c) for c in q]) + sympy.Matrix(self.forces)
        free = mass.LUsolve(given - momentum.jacobian(q) * dq)
        rows = {name: sympy.Matrix([place]).jacobian(q) for name, place in (("x", self.x), ("y", self.y))}
        push = {name: mass.LUsolve(row.T) for name, row in rows.items()}
        u, v = ((rows[name] * dq)[0] for name in "xy")

        def rate(function: sympy.Expr) -> sympy.Expr:
            """Along the motion without contact."""
            return sum((function.diff(c) * w for c, w in zip(q, dq, strict=True)), sympy.Integer(0)) + sum(
                (function.diff(w) * f for w, f in zip(dq, free, strict=True)), sympy.Integer(0)
            )

        A, B, C = ((rows[i] * push[j])[0] for i, j in ("xx", "xy", "yy"))
        p, b = C - self.mu * B, rate(v)
        slip = push["y"] - self.mu * push["x"]
        against = sum((b.diff(w) * f for w, f in zip(dq, slip, strict=True)), sympy.Integer(0))
        return {
            "a": rate(u), "b": b, "A": A, "B": B, "C": C, "p": p, "u": u, "v": v, "y": self.y,
            "alpha_1": rate(p), "alpha_2": rate(b), "alpha_3": -against,
        }  # fmt: skip


@dataclass(frozen=True)
class Plane:
    """A body with X, H, th and a contact x = X + f(th), y = H + g(th): p depends on th alone, b on th and th_dot.

    ``spots`` finds th by samples of p, th_dot as roots of a polynomial, H_dot and H from v = y = 0.
    """

    body: Body
    fixed: tuple[mpmath.mpf, mpmath.mpf]

    def spots(self, random: Random, starts: int = 60) -> tuple[list[dict[str, mpmath.mpf]], bool]:
        """The states, and whether random starts of Newton's method found no other and nothing was nearly double."""
        exact = self.body.functions()
        names = [*self.body.coordinates, *self.body.velocities]
        call = {name: sympy.lambdify(names, function, "mpmath") for name, function in exact.items()}
        quick = {name: sympy.lambdify(names, exact[name], "math") for name in ("p", "b")}
        with mpmath.workdps(_DIGITS):
            angles, sure = _roots_on_circle(lambda th: quick["p"](*_state(self.fixed, th, 0)),
                                            lambda th: call["p"](*_state(self.fixed, th, mpmath.mpf(0))))  # fmt: skip
            found = []
            for angle in angles:
                rates, fine = _velocities(lambda w, th=angle: call["b"](*_state(self.fixed, th, w)))
                sure = sure and fine
                for rate in rates:
                    zero = _state(self.fixed, angle, rate)
                    H, H_dot = -call["y"](*zero), -call["v"](*zero)
                    state = (self.fixed[0], H, angle, self.fixed[1], H_dot, rate)
                    found.append({name: function(*state) for name, function in call.items() if name != "y"}
                                 | {str(n): value for n, value in zip(names, state, strict=True)})  # fmt: skip
            return found, sure and not self._others(random, starts, quick, found)

    def _others(
        self, random: Random, starts: int, quick: dict[str, Callable[..., Any]], found: list[dict[str, Any]]
    ) -> bool:
        """Whether Newton's method in (th, th_dot) comes to another solution."""

        def both(unknown: Sequence[float]) -> list[float]:
            state = _state((float(self.fixed[0]), float(self.fixed[1])), *unknown)
            return [quick["p"](*state), quick["b"](*state)]

        for _ in range(starts):
            start = [random.uniform(-3.2, 3.2), random.uniform(-6, 6)]
            end = scipy.optimize.root(both, start, tol=1e-13)
            if not end.success or max(map(abs, both(end.x))) > 1e-9 or abs(end.x[1]) > 1e4:
                continue
            th, w = end.x
            if not any(abs(math.sin((th - s["th"]) / 2)) < 1e-4 and abs(w - s["th_dot"]) < 1e-4 for s in found):
                return True
        return False


def _state(fixed: Sequence[Any], th: Any, rate: Any) -> tuple[Any, ...]:
    return (fixed[0], 0, th, fixed[1], 0, rate)


def _roots_on_circle(quick: Callable[[float], float], exact: Callable[[Any], Any]) -> tuple[list[mpmath.mpf], bool]:
    """The zeros in one turn; False where one may be double."""
    step = 2 * 3.141592653589793 / _POINTS
    shift = 0.000123
    values = [quick(shift + k * step) for k in range(_POINTS + 1)]
    size = max(map(abs, values))
    found, sure = [], True
    for k in range(_POINTS):
        left, right = shift + k * step, shift + (k + 1) * step
        if values[k] * values[k + 1] < 0:
            found.append(mpmath.findroot(exact, (left, right), solver="anderson", tol=1e-60))
        elif k > 0 and abs(values[k]) < min(abs(values[k - 1]), abs(values[k + 1])) and abs(values[k]) < 1e-4 * size:
            sure = False
    return found, sure


def _velocities(function: Callable[[Any], Any]) -> tuple[list[mpmath.mpf], bool]:
    """The real zeros of a polynomial of degree at most 2 from its values at -1, 0, 1, and 2 to see that it is one."""
    low, middle, high, more = (function(mpmath.mpf(w)) for w in (-1, 0, 1, 2))
    first, second = (high - low) / 2, (high + low) / 2 - middle
    if abs(middle + 2 * first + 4 * second - more) > mpmath.mpf(10) ** -25 * (1 + abs(more)):
        raise ValueError("b is no polynomial of degree 2 in the angular velocity")
    if abs(second) < mpmath.mpf(10) ** -25:
        return ([-middle / first], True) if abs(first) > mpmath.mpf(10) ** -20 else ([], False)
    part = first**2 - 4 * second * middle
    if abs(part) < mpmath.mpf(10) ** -8:
        return [], False
    if part < 0:
        return [], True
    return [(-first + sign * mpmath.sqrt(part)) / (2 * second) for sign in (1, -1)], True
