"""A planar chain of rigid links with a free upper end: as many coordinates as a test wants."""

from __future__ import annotations

from typing import Any

from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism


def chain(links: int, **options: Any) -> Mechanism:
    """Links of length 1, mass 1, inertia 1/12 from (X, Y) on; contact at the last tip; angles a1, a2, ... to the axis.

    The moment arms: the centre of link i is (X, Y) + sum over j < i of e(a_j) + e(a_i)/2 with e(a) = (cos a, sin a).
    """
    angles = [f"a{i}" for i in range(1, links + 1)]
    arms = [f"({links - 1 - j} + 1/2)" for j in range(links)]  # the sum over links of the arm of a_j
    rows: list[list[Any]] = [[0] * (links + 2) for _ in range(links + 2)]
    rows[0][0] = rows[1][1] = links
    forces = ["0", f"-{links}*g", *([""] * links)]
    for j, angle in enumerate(angles):
        rows[0][2 + j] = rows[2 + j][0] = f"-{arms[j]}*sin({angle})"
        rows[1][2 + j] = rows[2 + j][1] = f"{arms[j]}*cos({angle})"
        forces[0] += f" + {arms[j]}*cos({angle})*{angle}_dot^2"
        forces[1] += f" + {arms[j]}*sin({angle})*{angle}_dot^2"
        forces[2 + j] = f"-{arms[j]}*g*cos({angle})"
        for k, other in enumerate(angles):
            arm = arms[max(j, k)]
            rows[2 + j][2 + k] = f"{arm}*cos({angle} - {other})" if j != k else f"{links - 1 - j} + 1/4 + 1/12"
            if j != k:
                forces[2 + j] += f" - {arm}*sin({angle} - {other})*{other}_dot^2"
    x = "X + " + " + ".join(f"cos({angle})" for angle in angles)
    y = "Y + " + " + ".join(f"sin({angle})" for angle in angles)
    return lagrangian(f"chain of {links}", ["X", "Y", *angles], rows, forces, x, y, "mu", {"g": 1, "mu": 2}, **options)
