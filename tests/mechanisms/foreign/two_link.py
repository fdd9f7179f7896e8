"""A two-link arm with a fixed base: by sympy.mechanics in three ways, and as textbooks write it.

Links of lengths l1, l2, masses m1, m2, slender, joint torques none; the angles q1, q2 are those of the links to the
horizontal. From the textbook (Spong, Hutchinson, Vidyasagar, Robot Modeling and Control, Sec. 7.4, "planar elbow
manipulator with remotely driven link", whose second angle is absolute too): d11 = m1 lc1^2 + m2 l1^2 + I1,
d12 = m2 l1 lc2 cos(q2 - q1), d22 = m2 lc2^2 + I2, c221 = -c112 = -m2 l1 lc2 sin(q2 - q1),
phi_1 = (m1 lc1 + m2 l1) g cos q1, phi_2 = m2 lc2 g cos q2.
"""

from __future__ import annotations

from typing import Any

import sympy
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism

q1, q2 = dynamicsymbols("q1 q2")
u1, u2 = dynamicsymbols("u1 u2")
m1, m2, l1, l2, g, mu, h = sympy.symbols("m1 m2 l1 l2 g mu h")
VALUES: dict[Any, Any] = {m1: 2, m2: 1, l1: 1, l2: "3/2", g: "9.81", mu: 2, h: "3/2"}


def arm(first: Any, second: Any) -> tuple[Any, Any, Any, Any, Any]:
    """The frame, the point at the base, the tip, the bodies and their weights; the rates of the angles are given."""
    N = ReferenceFrame("N")
    A, B = N.orientnew("A", "Axis", [q1, N.z]), N.orientnew("B", "Axis", [q2, N.z])
    A.set_ang_vel(N, first * N.z)
    B.set_ang_vel(N, second * N.z)
    base = Point("O")
    base.set_vel(N, 0)
    bodies, weights, start = [], [], base
    for frame, length, mass in ((A, l1, m1), (B, l2, m2)):
        centre, end = start.locatenew("G", length / 2 * frame.x), start.locatenew("E", length * frame.x)
        centre.v2pt_theory(start, N, frame)
        end.v2pt_theory(start, N, frame)
        body = RigidBody("body", centre, frame, mass, (inertia(frame, 0, 0, mass * length**2 / 12), centre))
        body.potential_energy = mass * g * centre.pos_from(base).dot(N.y)
        bodies.append(body)
        weights.append((centre, -mass * g * N.y))
        start = end
    return N, base, start, bodies, weights


def contact() -> dict[str, Any]:
    """The tip above a floor that lies h below the base."""
    return {"x": l1 * sympy.cos(q1) + l2 * sympy.cos(q2), "y": h + l1 * sympy.sin(q1) + l2 * sympy.sin(q2), "mu": mu}


def by_lagrange(**options: Any) -> Any:
    """LagrangesMethod, with its equations."""
    N, _, _, bodies, _ = arm(q1.diff(), q2.diff())
    method = LagrangesMethod(Lagrangian(N, *bodies), [q1, q2], **options)
    method.form_lagranges_equations()
    return method


def by_kane(first: Any = u1, second: Any = u2) -> Any:
    """KanesMethod, with its equations, for q1' = first, q2' = second in the speeds u1, u2."""
    N, _, _, bodies, weights = arm(first, second)
    method = KanesMethod(N, [q1, q2], [u1, u2], kd_eqs=[q1.diff() - first, q2.diff() - second])
    method.kanes_equations(bodies, weights)
    return method


def by_textbook(**values: Any) -> Mechanism:
    """M and f as texts."""
    d12, c = "m2*l1*l2/2*cos(q2 - q1)", "m2*l1*l2/2*sin(q2 - q1)"
    return lagrangian(
        "arm",
        ["q1", "q2"],
        [["m1*(l1/2)^2 + m2*l1^2 + m1*l1^2/12", d12], [d12, "m2*(l2/2)^2 + m2*l2^2/12"]],
        [f"{c}*q2_dot^2 - (m1/2 + m2)*l1*g*cos(q1)", f"-{c}*q1_dot^2 - m2*l2/2*g*cos(q2)"],
        "l1*cos(q1) + l2*cos(q2)",
        "h + l1*sin(q1) + l2*sin(q2)",
        "mu",
        {str(key): value for key, value in VALUES.items()} | values,
    )
