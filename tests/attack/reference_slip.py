"""Rigid slip of a body from its Lagrangian by scipy's DOP853 in the stretched time s, dt = p ds: xi' = p F - b G.

It ends where b rises to 0 (lift-off), where the slip velocity falls to the surface's (slip stops), or at p = b = 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import scipy.integrate
import scipy.optimize
import sympy
from attack.reference_mechanism import Body

NEAR = 1e-9
_FAR = 1e-7
_SMALL = (1e-3, 3e-4, 1e-4, 3e-5)
_LONGEST = 400.0


class Unsure(Exception):
    """Nearly a tie, or nothing comes."""


@dataclass
class End:
    """``what``: "lift-off", "slip stops", "G-spot"; the time, the state and the alphas there; C_1 if it was read."""

    what: str
    time: float
    state: list[float]
    alphas: tuple[float, float, float]
    coefficient: float | None


class Slip:
    """The functions of a state q, q_dot."""

    def __init__(self, body: Body) -> None:
        self.body = body
        exact = body.functions()
        names = [*body.coordinates, *body.velocities]
        q, dq = sympy.Matrix(body.coordinates), sympy.Matrix(body.velocities)
        mass = sympy.hessian(body.kinetic, list(dq))
        momentum = sympy.Matrix([body.kinetic.diff(w) for w in dq])
        given = sympy.Matrix([body.kinetic.diff(c) - body.potential.diff(c) for c in q]) + sympy.Matrix(body.forces)
        free = mass.LUsolve(given - momentum.jacobian(q) * dq)
        row = sympy.Matrix([body.y]).jacobian(q) - body.mu * sympy.Matrix([body.x]).jacobian(q)
        push = mass.LUsolve(row.T)
        scalars = [exact[name] for name in ("p", "b", "u", "alpha_1", "alpha_2", "alpha_3")]
        self.size = len(q)
        self.call = sympy.lambdify(names, [*free, *push, *scalars], "math", cse=True)
        self.place = sympy.lambdify(names, [body.y, exact["v"], exact["p"], exact["b"], exact["u"]], "math")

    def at(self, state: Sequence[float]) -> tuple[list[float], list[float], list[float]]:
        """Free acceleration, the contact's push, and p, b, u, alpha_1, alpha_2, alpha_3."""
        n, found = self.size, self.call(*map(float, state[: 2 * self.size]))
        return found[:n], found[n : 2 * n], found[2 * n :]

    def rates(self, _: float, state: Sequence[float]) -> list[float]:
        """The right side in s; the last component is the time."""
        free, push, (p, b, *_rest) = self.at(state)
        turn = [p * f - b * g for f, g in zip(free, push, strict=True)]
        return [*(p * w for w in state[self.size : 2 * self.size]), *turn, p]

    def ended(self, start: Sequence[float], surface: float | None) -> End:
        """Follow slip from the state."""
        solver = scipy.integrate.DOP853(self.rates, 0.0, [*start, 0.0], _LONGEST, rtol=2e-13, atol=1e-15, max_step=0.25)
        watched: dict[str, Callable[[Sequence[float]], float]] = {"lift-off": lambda s: -self.at(s)[2][1]}
        if surface is not None:
            watched["slip stops"] = lambda s: self.at(s)[2][2] - surface
        samples: list[tuple[float, float]] = []
        first = self.at(solver.y)[2]
        if first[0] < _FAR or first[1] > -_FAR or (surface is not None and first[2] - surface < _FAR):
            raise Unsure("the start is at an event, or beyond it")
        while solver.status == "running":
            solver.step()
            if solver.status == "failed" or not all(map(math.isfinite, solver.y)):
                raise Unsure("the integration fails")
            p, b, *_ = self.at(solver.y)[2]
            hits = {name: watch(solver.y) for name, watch in watched.items() if watch(solver.y) < 0}
            if hits and p < 1e-6:
                raise Unsure("next to the G-spot")
            if hits:
                return self._hit(solver, watched, hits)
            while len(samples) < len(_SMALL) and p < _SMALL[len(samples)]:
                dense, level = solver.dense_output(), _SMALL[len(samples)]
                s = scipy.optimize.brentq(
                    lambda x, d=dense, e=level: self.at(d(x))[2][0] - e, solver.t_old, solver.t, xtol=1e-15
                )
                samples.append((level, -self.at(dense(s))[2][1] / self.at(dense(s))[2][0]))
            if p < NEAR and -b < 1e3 * NEAR:
                return self._spot(solver.y, samples)
            if p < NEAR:
                raise Unsure("p falls to 0 and b does not")
        raise Unsure("nothing comes")

    def _hit(self, solver: Any, watched: dict[str, Any], hits: dict[str, float]) -> End:
        dense = solver.dense_output()
        found = sorted(
            (scipy.optimize.brentq(lambda x, w=watched[name]: w(dense(x)), solver.t_old, solver.t, xtol=1e-15), name)
            for name in hits
        )
        if len(found) > 1 and abs(found[0][0] - found[1][0]) < 1e-7:
            raise Unsure("two events nearly coincide")
        state = [float(x) for x in dense(found[0][0])]
        return End(found[0][1], state[-1], state[:-1], tuple(self.at(state)[2][3:]), None)

    def _spot(self, state: Sequence[float], samples: list[tuple[float, float]]) -> End:
        alphas = tuple(self.at(state)[2][3:])
        return End("G-spot", float(state[-1]), [float(x) for x in state[:-1]], alphas, _fitted(alphas, samples))


def _fitted(alphas: Sequence[float], samples: list[tuple[float, float]]) -> float | None:
    """C_1 from lambda = lambda_0 + k p + m p^2 - C_1 |alpha_1|^-beta p^(beta-1): four samples; None if not certain."""
    beta = alphas[2] / alphas[0]
    if len(samples) < len(_SMALL) or beta < 0.05 or beta > 2.7 or min(abs(beta - n) for n in (1, 2, 3)) < 0.12:
        return None
    with mpmath.workdps(30):
        rows = [[1, level, level**2, mpmath.mpf(level) ** (beta - 1)] for level, _ in samples]
        found = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix([value for _, value in samples]))
        part = found[3] * rows[0][3]
        if abs(part) < 1e-6 * (abs(found[0]) + abs(samples[0][1])):
            return None
        return float(-found[3] * mpmath.mpf(-alphas[0]) ** beta)
