"""Mechanisms of any size for the benchmark: planar legs and chains of slender rods."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism


def leg(links: int, height: str = "2", mu: str = "1", **options: Any) -> Mechanism:
    """Slender rods of length 1 and mass 1, hinged in a row; the first hangs from a hip at the given height.

    The angles count from the vertical; the contact point is the end of the last rod.

    >>> leg(3).state
    ('a1', 'a2', 'a3', 'a1_dot', 'a2_dot', 'a3_dot')
    """
    return _rods(f"leg of {links} links", links, [], height, mu, options)


def chain(links: int, mu: str = "2", **options: Any) -> Mechanism:
    """The same rods with a first end that moves freely in the plane: two coordinates more.

    >>> len(chain(5).state)
    14
    """
    return _rods(f"chain of {links} links", links, ["X", "Y"], "0", mu, options)


def _rods(name: str, links: int, base: list[str], height: str, mu: str, options: dict[str, Any]) -> Mechanism:
    angles = [f"a{i + 1}" for i in range(links)]
    weights = [Fraction(1, 2) + links - 1 - i for i in range(links)]
    rows, forces = [], []
    for own, slope, sign, gravity in (("cos", "sin", "", ""), ("sin", "cos", "-", f" - {links}"))[: len(base)]:
        diagonal = [str(links) if word == ("X" if own == "cos" else "Y") else "0" for word in base]
        moments = list(zip(weights, angles, strict=True))
        rows.append(diagonal + [f"{weight}*{own}({angle})" for weight, angle in moments])
        forces.append(
            " + ".join(f"{sign}{weight}*{slope}({angle})*{angle}_dot^2" for weight, angle in moments) + gravity
        )
    for i, angle in enumerate(angles):
        row = [f"{weights[i]}*{own}({angle})" for own in ("cos", "sin")[: len(base)]]
        bends = f"-{weights[i]}*sin({angle})"
        for j, other in enumerate(angles):
            coupling = _coupling(links, i, j)
            row.append(f"{coupling}*cos({angle} - {other})" if i != j else str(coupling))
            bends += f" - {coupling}*sin({angle} - {other})*{other}_dot^2" if i != j else ""
        rows.append(row)
        forces.append(bends)
    x = " + ".join([*base[:1], *(f"sin({angle})" for angle in angles)])
    y = " - ".join([base[1] if base else height, *(f"cos({angle})" for angle in angles)])
    return lagrangian(name, [*base, *angles], rows, forces, x, y, mu, **options)


def _coupling(links: int, i: int, j: int) -> Fraction:
    """The coefficient of cos(a_i - a_j) in the mass matrix."""
    after = links - 1 - max(i, j)
    return (Fraction(1, 3) if i == j else Fraction(1, 2)) + after
