"""Newton's method for the conditions of a G-spot, and a box around its limit that holds exactly one zero.

Proof page: ``proofs/krawczyk.md``.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.krawczyk import proved_zero
from gspot_verified.functions.linear import inverse
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.balls import current_bits
from gspot_verified.numbers.verdict import Evidence

_NEWTON_STEPS = 60  # a limit of effort, also for starts from which it wanders first
_INFLATIONS = 12  # tries, each 64 times as wide: any number is correct, Krawczyk's test decides


class NotFoundError(GSpotError):
    """The search from the given place ended without a G-spot. There may be some elsewhere, or none."""


def newton_point(system: System, program: BoxProgram) -> list[arb]:
    """A point near a zero of all conditions, from the system's point; a heuristic, midpoints only.

    :raises NotFoundError: no convergence.
    """
    point = [value.mid() for value in system.point]
    small = arb(2) ** (20 - current_bits())
    for _ in range(_NEWTON_STEPS):
        values, slopes = program.gradients(point)
        residual = [value.mid() for value in values]
        matrix = [[value.mid() for value in row] for row in slopes]
        rows = inverse(matrix, BALLS)
        step = [sum((a * r for a, r in zip(row, residual, strict=True)), arb(0)).mid() for row in rows]
        if not all(value.is_finite() for value in step):
            break
        point = [(x - d).mid() for x, d in zip(point, step, strict=True)]
        if all(abs(d) <= small * (1 + abs(x)) for x, d in zip(point, step, strict=True)):
            return point
    raise NotFoundError(f"{system.name}: Newton's method finds no G-spot from the given start")


def proved_box(program: BoxProgram, point: Sequence[arb]) -> tuple[list[arb], Evidence] | None:
    """A box around the point that holds exactly one zero of the program's functions; None when none was proved."""
    radius = arb(2) ** (26 - current_bits())
    for _ in range(_INFLATIONS):
        box = [x + arb(0, (radius * (1 + abs(x))).upper()) for x in point]
        proved = proved_zero(program.values, lambda at: program.gradients(at)[1], box)
        if proved is not None:
            return proved
        radius = radius * 64
    return None
