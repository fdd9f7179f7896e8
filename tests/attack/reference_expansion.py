"""What a truncated expansion leaves in Lagrange's equations with the compliant contact, by mpmath at many digits.

xi' = F + G lambda, y = Y(xi), v = V(xi), p = P(xi), b = B(xi), epsilon z' = -z - epsilon^2 lambda,
epsilon^2 lambda = z - y; t = delta^2 s, epsilon = delta^3.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import mpmath
import sympy
from attack.reference_mechanism import Body

Table = Mapping[tuple[int, int], mpmath.mpf]
DIGITS = 220
ORDERS = {"xi": 0, "p": 2, "b": 2, "y": 2, "v": 2, "z": 6, "lambda_n": 6}
"""The weight of each equation: what is left over divided by delta^weight must vanish with the order."""


class Equations:
    """The functions of a state q, q_dot."""

    def __init__(self, body: Body) -> None:
        exact = body.functions()
        names = [*body.coordinates, *body.velocities]
        q, dq = sympy.Matrix(body.coordinates), sympy.Matrix(body.velocities)
        mass = sympy.hessian(body.kinetic, list(dq))
        momentum = sympy.Matrix([body.kinetic.diff(w) for w in dq])
        given = sympy.Matrix([body.kinetic.diff(c) - body.potential.diff(c) for c in q]) + sympy.Matrix(body.forces)
        free = mass.LUsolve(given - momentum.jacobian(q) * dq)
        push = mass.LUsolve((sympy.Matrix([body.y]).jacobian(q) - body.mu * sympy.Matrix([body.x]).jacobian(q)).T)
        self.size = len(q)
        wanted = [*free, *push, exact["p"], exact["b"], body.y, exact["v"]]
        self.call = sympy.lambdify(names, wanted, "mpmath")

    def left(
        self,
        point: Sequence[mpmath.mpf],
        xi: Sequence[Table],
        scalars: Mapping[str, Table],
        s: float,
        delta: mpmath.mpf,
    ) -> dict[str, mpmath.mpf]:
        """What is left of each equation, divided by delta^weight; of the state's the largest."""
        with mpmath.workdps(DIGITS):
            t, small, n = delta**2 * mpmath.mpf(s), delta**3, self.size
            state = [start + value(table, t, small) for start, table in zip(point, xi, strict=True)]
            turned = [rate(table, t, small) for table in xi]
            found = self.call(*state)
            y, v, p, b, z, force = (value(scalars[name], t, small) for name in ("y", "v", "p", "b", "z", "lambda_n"))
            field = [*state[n:], *(f + g * force for f, g in zip(found[:n], found[n : 2 * n], strict=True))]
            left = {
                "xi": max(abs(one - two) for one, two in zip(turned, field, strict=True)),
                "p": found[2 * n] - p, "b": found[2 * n + 1] - b, "y": found[2 * n + 2] - y, "v": found[2 * n + 3] - v,
                "z": small * rate(scalars["z"], t, small) + z + small**2 * force, "lambda_n": small**2 * force - z + y,
            }  # fmt: skip
            return {name: abs(each) / delta ** ORDERS[name] for name, each in left.items()}


def value(table: Table, t: mpmath.mpf, small: mpmath.mpf) -> mpmath.mpf:
    """The polynomial at t and epsilon."""
    return sum((c * t**k * small**m for (k, m), c in table.items()), mpmath.mpf(0))


def rate(table: Table, t: mpmath.mpf, small: mpmath.mpf) -> mpmath.mpf:
    """Its derivative by t."""
    return sum((k * c * t ** (k - 1) * small**m for (k, m), c in table.items() if k), mpmath.mpf(0))
