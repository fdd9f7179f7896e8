"""The cells of a sweep, and near each of them the spot that Newton's method follows from cell to cell: a heuristic."""

from __future__ import annotations

import itertools
import math
from array import array
from collections import deque
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from typing import Any, overload

from flint import arb, arb_mat, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.input.mechanism import exact_rational
from gspot_verified.mechanisms.sweep.sweep_cell import Cell
from gspot_verified.mechanisms.sweep.sweep_start import Origin
from gspot_verified.numbers.balls import ExactInput, approximate, exact, working_bits
from gspot_verified.numbers.written import Written
from gspot_verified.work.ranges import Range

_BITS = 64  # working precision of a search that proves nothing
_STEPS = 6  # of Newton's method from a neighbour's spot: further away it may end at another spot
_MOST_PLACES = {1: 2_048, 2: 64}  # that are followed on each axis, by the number of ranges: any number is correct
_SMALL = 1e-6  # relative size of the last step: the tube finds the rest

DEFAULT_CELLS = {1: 64, 2: 32}  # on each axis, by the number of ranges
MAX_CELLS = 1_000_000  # a limit against endless work

Ranges = Mapping[str, str | tuple[ExactInput, ExactInput] | tuple[ExactInput, ExactInput, int]]
Index = tuple[int, ...]
Near = tuple[int, bytes] | Origin | None
"""The number of a cell with centre and slopes in its middle, as doubles; or a place of its own; or no place."""


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

    def value_in(self, values: Mapping[str, ExactInput]) -> fmpq:
        """The value of this parameter.

        :raises ValueError: it is missing, no rational, or outside of the range.
        """
        value = exact(values[self.name], self.name) if self.name in values else None
        if not isinstance(value, fmpq) or not self.lower <= value <= self.upper:
            raise ValueError(f"{self.name}: a rational in [{self.lower}, {self.upper}] is needed")
        return value

    def __str__(self) -> str:
        return f"{self.name}={self.lower}..{self.upper}:{self.cells}"


@dataclass(frozen=True, slots=True)
class Grid:
    """All cells; the last axis runs fastest."""

    axes: tuple[Axis, ...]

    def __len__(self) -> int:
        return math.prod(axis.cells for axis in self.axes)

    def coarser(self, most: int) -> Grid:
        """The same ranges with at most so many cells on each axis."""
        return Grid(tuple(replace(axis, cells=min(axis.cells, most)) for axis in self.axes))

    def indices(self) -> list[Index]:
        """All cells, in order."""
        return list(itertools.product(*(range(axis.cells) for axis in self.axes)))

    def index(self, number: int) -> Index:
        """The cell with this number in that order."""
        index = []
        for axis in reversed(self.axes):
            number, own = divmod(number, axis.cells)
            index.append(own)
        return tuple(reversed(index))

    def number(self, index: Index) -> int:
        """The number of a cell in that order."""
        number = 0
        for axis, own in zip(self.axes, index, strict=True):
            number = number * axis.cells + own
        return number

    def ends(self, index: Index) -> tuple[tuple[fmpq, ...], tuple[fmpq, ...]]:
        """The corners of a cell."""
        pairs = list(zip(self.axes, index, strict=True))
        return tuple(axis.cut(i) for axis, i in pairs), tuple(axis.cut(i + 1) for axis, i in pairs)

    def corners(self) -> Iterator[tuple[tuple[fmpq, ...], tuple[fmpq, ...]]]:
        """Those of all cells, in order."""
        *slow, fast = self.axes
        for index in itertools.product(*(range(axis.cells) for axis in slow)):
            pairs = list(zip(slow, index, strict=True))
            lower, upper = tuple(axis.cut(i) for axis, i in pairs), tuple(axis.cut(i + 1) for axis, i in pairs)
            start = fast.lower
            for number in range(fast.cells):
                end = fast.cut(number + 1)
                yield (*lower, start), (*upper, end)
                start = end

    def middle(self, index: Index) -> tuple[fmpq, ...]:
        """The middle of a cell."""
        return tuple((low + high) / 2 for low, high in zip(*self.ends(index), strict=True))

    def cell_of(self, place: Sequence[fmpq]) -> Index:
        """A cell that holds the parameter values."""
        index = []
        for axis, value in zip(self.axes, place, strict=True):
            number = int(((value - axis.lower) * axis.cells / (axis.upper - axis.lower)).floor())
            index.append(min(max(number, 0), axis.cells - 1))
        return tuple(index)

    def cells_at(self, place: Sequence[fmpq]) -> Iterator[Index]:
        """All cells that hold the parameter values: several where these are at their ends."""
        first = self.cell_of(place)
        ranges = [range(max(own - 1, 0), min(own + 2, axis.cells)) for own, axis in zip(first, self.axes, strict=True)]
        for index in itertools.product(*ranges):
            lower, upper = self.ends(index)
            if all(low <= value <= high for low, value, high in zip(lower, place, upper, strict=True)):
                yield index

    def neighbours(self, index: Index) -> Iterator[Index]:
        """The cells that share a side with a cell."""
        for side, axis in enumerate(self.axes):
            for step in (-1, 1):
                if 0 <= index[side] + step < axis.cells:
                    yield (*index[:side], index[side] + step, *index[side + 1 :])


def axes_of(ranges: Ranges) -> tuple[Axis, ...]:
    """One or two ranges: name to "lower..upper", "lower..upper:cells" or (lower, upper, cells).

    :raises ValueError: another number of ranges, an empty or infinite one, or too many cells.
    """
    if len(ranges) not in DEFAULT_CELLS:
        raise ValueError(f"a sweep has one or two parameters, got {len(ranges)}")
    axes = []
    for name, given in ranges.items():
        lower, upper, count = _ends(name, given)
        cells_asked = DEFAULT_CELLS[len(ranges)] if count is None else count
        if type(cells_asked) is not int or cells_asked < 1:
            raise ValueError(f"{name}: the number of cells must be an int >= 1")
        if not lower < upper:
            raise ValueError(f"{name}: the range must have a lower end below its upper end, got {lower}..{upper}")
        axes.append(Axis(name, lower, upper, cells_asked))
    total = math.prod(axis.cells for axis in axes)
    if total > MAX_CELLS:
        raise ValueError(f"a sweep has at most {MAX_CELLS} cells, got {total}")
    return tuple(axes)


def _ends(name: str, given: Any) -> tuple[fmpq, fmpq, int | None]:
    if not isinstance(given, str):
        lower, upper, *count = given
        return exact_rational(lower, name), exact_rational(upper, name), count[0] if count else None
    text, colon, number = given.partition(":")
    parsed = Range.parse(text, name)
    if parsed.lower is None or parsed.upper is None:
        raise ValueError(f"{name}: the range must be finite")
    if colon and not number.strip().isdecimal():
        raise ValueError(f'{name}: expected "lower..upper:cells" such as "1.4..2:200", got {given[:60]!r}')
    return parsed.lower, parsed.upper, int(number) if colon else None


class GridCells(Sequence[Cell]):
    """Cells of a grid, each made when it is asked for: of a place near which to look its numbers are kept as doubles.

    ``near`` has for each cell of ``places``, by its number, the number of the cell whose place that is, and the centre
    and slopes there, or nothing; ``ends`` those next to which there is none. ``numbers`` are those of the cells. It
    pickles, with the places of its cells alone.
    """

    def __init__(self, grid: Grid, places: Grid, near: Mapping[int, Near], ends: Set[int], numbers: range) -> None:
        self._grid, self._places, self._near, self._ends, self._numbers = grid, places, near, ends, numbers

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, index: int) -> Cell: ...
    @overload
    def __getitem__(self, index: slice) -> GridCells: ...
    def __getitem__(self, index: int | slice) -> Cell | GridCells:
        if isinstance(index, slice):
            return GridCells(self._grid, self._places, self._near, self._ends, self._numbers[index])
        own = self._grid.index(self._numbers[index])
        return Cell(*self._grid.ends(own), self._origin(self._near[self._place(own)]))

    def __reduce__(self) -> tuple[Any, ...]:
        own = {self._place(self._grid.index(number)) for number in self._numbers}
        near = {number: self._near[number] for number in sorted(own)}
        return GridCells, (self._grid, self._places, near, self._ends & own, self._numbers)

    @property
    def numbers(self) -> range:
        """Those of the cells in the grid."""
        return self._numbers

    def located(self, program: BoxProgram) -> Iterator[Cell]:
        """The cells, where there are fewer places than cells and the spot may end each with a place of its own, by
        Newton's method from the one that is kept, or with that of a neighbour; without one where none is found."""
        for number, cell in zip(self._numbers, self, strict=True):
            index = self._grid.index(number)
            sought = self._places != self._grid and cell.origin is not None and self._place(index) in self._ends
            yield replace(cell, origin=self._found(program, index, cell.origin)) if sought and cell.origin else cell

    def _found(self, program: BoxProgram, index: Index, near: Origin) -> Origin | None:
        for other in (index, *self._grid.neighbours(index)):
            middle = self._grid.middle(other)
            with working_bits(_BITS):
                predicted = near.predicted(middle)
                jump = max(
                    abs(approximate(new) - approximate(old)) for new, old in zip(predicted, near.centre, strict=True)
                )
                found = newton_origin(program, middle, predicted, jump + _SMALL)
            if found is not None:
                return found
        return None

    def _place(self, index: Index) -> int:
        """The number of the cell of ``places`` that holds the middle of a cell."""
        axes = zip(index, self._grid.axes, self._places.axes, strict=True)
        return self._places.number(tuple((2 * i + 1) * few.cells // (2 * many.cells) for i, many, few in axes))

    def _origin(self, near: Near) -> Origin | None:
        if near is None or isinstance(near, Origin):
            return near
        number, values = near
        exact = [fmpq(*value.as_integer_ratio()) for value in array("d", values)]
        k = len(self._places.axes)
        n = len(exact) // (1 + k)
        rows = tuple(tuple(exact[n + i * k : n + (i + 1) * k]) for i in range(n))
        return Origin(self._places.middle(self._places.index(number)), tuple(exact[:n]), rows)


def cells(program: BoxProgram, grid: Grid, place: Sequence[fmpq], spot: Sequence[arb]) -> GridCells:
    """All cells with a place near which to look; ``program`` gives the conditions, ``spot`` is known at ``place``.

    A cell without a spot of its own looks from a neighbour's. Of a large grid only so many places are followed that
    neither time nor memory grow with it: cells look from the one that is next.
    """
    places = grid.coarser(_MOST_PLACES[len(grid.axes)])
    with working_bits(_BITS):
        origins = _followed(program, places, place, spot)
    near = {
        number: origins[number]
        or next(
            (own for other in places.neighbours(places.index(number)) if (own := origins[places.number(other)])), None
        )
        for number in range(len(places))
    }
    ends = {
        number
        for number, index in enumerate(places.indices())
        if not all(origins[places.number(other)] for other in (index, *places.neighbours(index)))
    }
    return GridCells(grid, places, near, ends, range(len(grid)))


@dataclass(frozen=True, slots=True)
class _Near:
    """A spot that is nearly known, in doubles: the place, centre and slopes."""

    place: tuple[float, ...]
    centre: list[float]
    slopes: list[list[float]]

    def predicted(self, place: Sequence[float]) -> list[float]:
        """The centre at another place, by the slopes."""
        moves = [value - own for value, own in zip(place, self.place, strict=True)]
        return [start + sum(slope * move for slope, move in zip(row, moves, strict=True))
                for start, row in zip(self.centre, self.slopes, strict=True)]  # fmt: skip

    def packed(self) -> bytes:
        """Centre and slopes; nothing where one is too large for a double."""
        values = [*self.centre, *(slope for row in self.slopes for slope in row)]
        return array("d", values).tobytes() if all(map(math.isfinite, values)) else b""


def _followed(program: BoxProgram, grid: Grid, place: Sequence[fmpq], spot: Sequence[arb]) -> list[Near]:
    found: list[Near] = [None] * len(grid)
    start = newton_origin(program, tuple(place), [value.mid() for value in spot], math.inf)
    first = grid.cell_of(place)
    if start is None:
        return found
    rows = [[approximate(slope) for slope in row] for row in start.slopes]
    own = _Near(tuple(map(approximate, place)), [*map(approximate, start.centre)], rows)
    waiting: deque[tuple[Index, _Near]] = deque([(first, own)])
    while waiting:
        index, near = waiting.popleft()
        number = grid.number(index)
        if found[number] is not None:
            continue
        at = [arb(value).mid() for value in grid.middle(index)]
        middle = tuple(map(float, at))
        predicted = near.predicted(middle)
        jump = max(abs(new - old) for new, old in zip(predicted, near.centre, strict=True))
        solved = _newton(program, at, [arb(value) for value in predicted], jump / 2 + _SMALL, _STEPS)
        if solved is None:
            continue
        point, slopes = solved
        here = _Near(middle, [*map(float, point)], [[*map(float, row)] for row in slopes])
        if values := here.packed():
            found[number] = number, values
            beside = (other for other in grid.neighbours(index) if found[grid.number(other)] is None)
            waiting.extend((other, here) for other in beside)
    if not any(found):
        found[grid.number(first)] = start
    return found


def newton_origin(
    program: BoxProgram, place: tuple[fmpq, ...], centre: Sequence[arb], reach: float, limit: int = _STEPS
) -> Origin | None:
    """Newton's method at one parameter value, with so many steps; None where it leads far away or nowhere."""
    solved = _newton(program, [arb(value).mid() for value in place], centre, reach, limit)
    if solved is None:
        return None
    point, slopes = solved
    return Origin(place, tuple(map(_exact, point)), tuple(tuple(map(_exact, row)) for row in slopes))


def _newton(
    program: BoxProgram, at: Sequence[arb], centre: Sequence[arb], reach: float, limit: int
) -> tuple[list[arb], list[list[arb]]] | None:
    """The point that is found, and the slopes there."""
    n = len(centre)
    point, moved = list(centre), 0.0
    for _ in range(limit):
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
        size = max(map(abs, map(float, steps)))
        moved += size
        if moved > reach:
            return None
        if size <= _SMALL * (1 + max(map(abs, map(float, point)))):
            return point, [[(-solved[i, j + 1]).mid() for j in range(len(at))] for i in range(n)]
    return None


def _exact(value: arb) -> fmpq:
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
