"""A certified patch of the curve or surface that G-spots form when there are fewer conditions than unknowns.

Proof page: ``proofs/all_g_spots.md``, section 6. Where the patch is looked for is a free choice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.krawczyk import proved_zero
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Evidence

_STEPS = 40  # of Gauss-Newton: a limit of effort
_WIDTHS = (-4, -7, -10, -14, -18, -24, -30)  # exponents of the half widths, the widest patch first: any is correct


@dataclass(frozen=True)
class Graph:
    """For all values of ``parameters`` (component: interval) exactly one zero has the other components in ``alone``; it
    has them in ``box``.

    ``shown`` is the inclusion that proves it.
    """

    parameters: dict[int, arb]
    box: dict[int, arb]
    alone: dict[int, arb]
    shown: Evidence


def find_patch(functions: Sequence[Expression], variables: Sequence[int], place: Sequence[arb]) -> Graph | None:
    """A patch near the place, in the variables; None when none could be proved.

    The other components keep the balls that ``place`` gives: the patch holds for each choice of numbers in them.
    """
    with working_bits(64):
        start = _point_near(functions, variables, place)
        if start is None:
            return None
        point, solved = start
        program = BoxProgram(functions, len(place), solved)
        for width in _WIDTHS:
            parameters = {i: point[i] + arb(0, arb(2) ** width) for i in variables if i not in solved}
            state = [parameters.get(i, side) for i, side in enumerate(place)]
            proved = _proved(program, state, [point[i] for i in solved], width)
            if proved is not None:
                image, alone, shown = proved
                return Graph(
                    parameters, dict(zip(solved, image, strict=True)), dict(zip(solved, alone, strict=True)), shown
                )
    return None


def _proved(
    program: BoxProgram, state: Sequence[arb], point: Sequence[arb], width: int
) -> tuple[list[arb], list[arb], Evidence] | None:
    """A box that holds the zero over each value of the parameters, one in which it is alone, and what shows it."""

    def at(values: Sequence[arb]) -> list[arb]:
        full = list(state)
        for i, value in zip(program.variables, values, strict=True):
            full[i] = value
        return full

    for more in (1, 3, 6):
        box = [x + arb(0, arb(2) ** (width + more)) for x in point]
        zero = proved_zero(lambda x: program.values(at(x)), lambda x: program.gradients(at(x))[1], box)
        if zero is not None:
            return zero[0], box, zero[1]
    return None


def _point_near(
    functions: Sequence[Expression], variables: Sequence[int], place: Sequence[arb]
) -> tuple[dict[int, arb], list[int]] | None:
    """A point near a common zero by Gauss-Newton steps, and the components to solve for; a heuristic."""
    program = BoxProgram(functions, len(place), variables)
    point = [value.mid() for value in place]
    for _ in range(_STEPS):
        values, rows = program.gradients(point)
        matrix = [[entry.mid() for entry in row] for row in rows]
        columns = arb_mat([[row[k] for row in matrix] for k in range(len(variables))])
        try:
            weights = (arb_mat(matrix) * columns).solve(arb_mat([[value.mid()] for value in values]))
        except ZeroDivisionError:
            return None
        step = columns * weights
        moves = [step[k, 0].mid() for k in range(len(variables))]
        if not all(move.is_finite() for move in moves):
            return None
        for i, move in zip(variables, moves, strict=True):
            point[i] = (point[i] - move).mid()
        if all(abs(move) < arb(2) ** -40 for move in moves):
            return {i: point[i] for i in variables}, _pivots(program.gradients(point)[1], variables)
    return None


def _pivots(rows: Sequence[Sequence[arb]], variables: Sequence[int]) -> list[int]:
    """Components whose columns are far from dependent: complete pivoting."""
    table = [[float(entry) for entry in row] for row in rows]
    chosen: list[int] = []
    open_rows = list(range(len(table)))
    while open_rows:
        _, r, c = max(
            (abs(table[r][c]), r, c) for r in open_rows for c in range(len(variables)) if variables[c] not in chosen
        )
        chosen.append(variables[c])
        open_rows.remove(r)
        for other in open_rows:
            factor = table[other][c] / table[r][c] if table[r][c] else 0.0
            table[other] = [value - factor * own for value, own in zip(table[other], table[r], strict=True)]
    return sorted(chosen)
