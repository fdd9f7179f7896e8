"""The cells of a sweep, and near each of them the spot that Newton's method follows from cell to cell: a heuristic."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.sweep.sweep_cell import Cell
from gspot_verified.mechanisms.sweep.sweep_start import Origin
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.numbers.written import Written

_BITS = 64  # working precision of a search that proves nothing
_STEPS = 6  # of Newton's method from a neighbour's spot: further away it may end at another spot
_SMALL = 1e-6  # relative size of the last step: the tube finds the rest

Index = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Axis(Written):
    """One parameter's range, cut into equal cells."""

    name: str
    lower: fmpq
    upper: fmpq
    cells: int

    def cut(self, number: int) -> fmpq:
        """The lower end of a cell."""
        return self.lower + (self.upper - self.lower) * number / self.cells

    def __str__(self) -> str:
        return f"{self.name}={self.lower}..{self.upper}:{self.cells}"


@dataclass(frozen=True, slots=True)
class Grid:
    """All cells; the last axis runs fastest."""

    axes: tuple[Axis, ...]

    def indices(self) -> list[Index]:
        """All cells, in order."""
        return list(itertools.product(*(range(axis.cells) for axis in self.axes)))

    def ends(self, index: Index) -> tuple[tuple[fmpq, ...], tuple[fmpq, ...]]:
        """The corners of a cell."""
        pairs = list(zip(self.axes, index, strict=True))
        return tuple(axis.cut(i) for axis, i in pairs), tuple(axis.cut(i + 1) for axis, i in pairs)

    def cell_of(self, place: Sequence[fmpq]) -> Index:
        """A cell that holds the parameter values."""
        index = []
        for axis, value in zip(self.axes, place, strict=True):
            number = int(((value - axis.lower) * axis.cells / (axis.upper - axis.lower)).floor())
            index.append(min(max(number, 0), axis.cells - 1))
        return tuple(index)

    def neighbours(self, index: Index) -> Iterator[Index]:
        """The cells that share a side with a cell."""
        for side, axis in enumerate(self.axes):
            for step in (-1, 1):
                if 0 <= index[side] + step < axis.cells:
                    yield (*index[:side], index[side] + step, *index[side + 1 :])


def cells(program: BoxProgram, grid: Grid, place: Sequence[fmpq], spot: Sequence[arb]) -> list[Cell]:
    """All cells with a place near which to look; ``program`` gives the conditions, ``spot`` is known at ``place``.

    A cell without a spot of its own looks from a neighbour's.
    """
    with working_bits(_BITS):
        origins = _followed(program, grid, place, spot)
    placed = []
    for index in grid.indices():
        near = origins.get(index) or next((origins[n] for n in grid.neighbours(index) if n in origins), None)
        placed.append(Cell(*grid.ends(index), near))
    return placed


def _followed(program: BoxProgram, grid: Grid, place: Sequence[fmpq], spot: Sequence[arb]) -> dict[Index, Origin]:
    start = _corrected(program, tuple(place), [value.mid() for value in spot], float("inf"))
    first = grid.cell_of(place)
    if start is None:
        return {}
    origins: dict[Index, Origin] = {}
    waiting: deque[tuple[Index, Origin]] = deque([(first, start)])
    while waiting:
        index, near = waiting.popleft()
        if index in origins:
            continue
        lower, upper = grid.ends(index)
        middle = tuple((low + high) / 2 for low, high in zip(lower, upper, strict=True))
        predicted = near.predicted(middle)
        jump = max(abs(approximate(new) - approximate(old)) for new, old in zip(predicted, near.centre, strict=True))
        origin = _corrected(program, middle, predicted, jump / 2 + _SMALL)
        if origin is not None:
            origins[index] = origin
            waiting.extend((other, origin) for other in grid.neighbours(index) if other not in origins)
    return origins or {first: start}


def _corrected(program: BoxProgram, place: tuple[fmpq, ...], centre: Sequence[arb], reach: float) -> Origin | None:
    """Newton's method at one parameter value; None where it leads far away or nowhere."""
    n = len(centre)
    point, moved = list(centre), 0.0
    at = [arb(value).mid() for value in place]
    for _ in range(_STEPS):
        values, rows = program.gradients([*point, *at])
        matrix = arb_mat([[value.mid() for value in row[:n]] for row in rows])
        right = arb_mat(
            [[value.mid(), *(slope.mid() for slope in row[n:])] for value, row in zip(values, rows, strict=True)]
        )
        try:
            solved = matrix.solve(right)
        except ZeroDivisionError:
            return None
        steps = [solved[i, 0].mid() for i in range(n)]
        if not all(step.is_finite() for step in steps):
            return None
        point = [(value - step).mid() for value, step in zip(point, steps, strict=True)]
        size = max(abs(approximate(step)) for step in steps)
        moved += size
        if moved > reach:
            return None
        if size <= _SMALL * (1 + max(abs(approximate(value)) for value in point)):
            slopes = tuple(tuple(_exact(-solved[i, j + 1]) for j in range(len(place))) for i in range(n))
            return Origin(place, tuple(_exact(value) for value in point), slopes)
    return None


def _exact(value: arb) -> fmpq:
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
