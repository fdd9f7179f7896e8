"""Which undecided pieces of a sweep are divided further, and near what spot is looked there: heuristics.

Any choice is correct: what a part says comes from its own examination, and the links are made anew with the parts.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Collection, Iterator, Sequence
from itertools import islice

from flint import arb, fmpq

from gspot_verified.mechanisms.sweep.sweep_cell import Cell
from gspot_verified.mechanisms.sweep.sweep_findings import HYPOTHESES, TOO_LARGE
from gspot_verified.mechanisms.sweep.sweep_grid import Grid
from gspot_verified.mechanisms.sweep.sweep_links import Links, common_place
from gspot_verified.mechanisms.sweep.sweep_piece import Kind
from gspot_verified.mechanisms.sweep.sweep_pieces import Block, PieceStore
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations

_BOXES = 16  # of one undecided piece: few, so that the budget goes where it helps
_SMALLEST = {1: fmpq(1, 2**14), 2: fmpq(1, 2**24)}  # parts of the range, by the number of parameters
_ENDS = (*HYPOTHESES, TOO_LARGE)
_SMALLEST_AT_ENDS = fmpq(1, 2**14)  # of a map: along a fold, or where a hypothesis ends, no piece is small enough


class Patchwork:
    """The pieces of all cells by numbers that stay theirs; parts take a piece's place. They are linked as they come.

    Cells come in their order. ``place``, ``spot``: where the continued spot is known, and what encloses it there.
    """

    def __init__(self, grid: Grid, equations: Equations, place: Sequence[fmpq], spot: Sequence[arb]) -> None:
        self.store = PieceStore(grid)
        self._grid, self._equations, self._place, self._spot = grid, equations, place, spot
        self._whole = _volume(tuple(axis.lower for axis in grid.axes), tuple(axis.upper for axis in grid.axes))
        self._line = len(grid.axes) == 1
        self._row = math.prod(axis.cells for axis in grid.axes[1:])
        self._starting = {grid.number(index) for index in grid.cells_at(place)}
        self._links = Links(self.store, equations, place, spot)
        self._parts: dict[int, list[int]] = {}  # of the cells where pieces were replaced
        self._cells: dict[int, int] = {}  # of the parts
        self._beside: dict[int, frozenset[int]] = {}  # pieces of the continued spot, when it was last looked
        self._in_vain: dict[int, frozenset[int]] = {}  # the same of pieces that did not fall into parts

    def add_cells(self, block: Block, groups: Sequence[int]) -> None:
        """The pieces of the next cells, with the groups of :func:`groups_in_a_row`."""
        ends = self.store.ends
        first = len(ends) - 1
        self._links.add(block, groups)
        cells = range(first, first + len(block.counts))
        for cell in cells[:1] if self._line else cells:
            for step in self._steps(cell):
                if cell == first or step > 1:  # the last cell of the same block was looked at there
                    self._links.link(self._in_cell(cell), self._in_cell(cell - step))
            row_begins = cell == first or cell % self._row == 0
            if row_begins and self._links.are_one(ends[max(first - self._row, 0)], ends[-1]):
                break  # no other link says more
        for cell in self._starting.intersection(cells):
            self._links.begin(self._in_cell(cell))

    def replace(self, numbers: Sequence[int], block: Block, groups: Sequence[int]) -> None:
        """Put the parts of some pieces in their places. One that did not fall into parts is divided again only where
        others are beside it than before."""
        added = iter(self._links.add(block, groups))
        for number, count in zip(numbers, block.counts, strict=True):
            parts, cell = list(islice(added, count)), self._cell_of(number)
            if len(parts) == 1 and number in self._beside:
                self._in_vain[parts[0]] = self._beside[number]
            rest = [other for other in self._in_cell(cell) if other != number]
            self._parts[cell] = [*rest, *parts]
            self._cells.update(dict.fromkeys(parts, cell))
            self._links.link(parts, [*rest, *self._around(cell)])
            if cell in self._starting:
                self._links.begin(parts)

    def own(self) -> list[bool]:
        """Of each piece, by its number, whether it holds the continued spot."""
        return self._links.own()

    def order(self) -> Sequence[int]:
        """The numbers of the pieces that are there, cell by cell in the order of their lower ends."""
        ends = self.store.ends
        if not self._parts:
            return range(ends[-1])
        order, start = array("I"), 0
        for cell, parts in sorted(self._parts.items()):
            order.extend(range(start, ends[cell]))
            order.extend(sorted(parts, key=lambda number: self.store.box(number)[0]))
            start = ends[cell + 1]
        order.extend(range(start, ends[-1]))
        return order

    def touching(self, number: int) -> list[int]:
        """The pieces that share a point of a line, or a part of a side."""
        cell, box = self._cell_of(number), self.store.box(number)
        return [
            other
            for other in (*self._in_cell(cell), *self._around(cell))
            if other != number and common_place(box, self.store.box(other)) is not None
        ]

    def divisible(self) -> list[tuple[int, Cell]]:
        """The undecided pieces that may be divided with some hope, the largest first, each as a cell.

        Those that hold the continued spot and are open; of a map also those beside them that do not hold it, or that at
        the start, if none holds it.
        """
        own, order, chosen = self.own(), self.order(), list[tuple[int, Origin]]()
        found = any(map(own.__getitem__, order))
        self._beside = {}
        for number in self._undecided(own, order, found):
            near = () if own[number] else self.touching(number)
            beside = frozenset(other for other in near if own[other])
            if self._in_vain.get(number) == beside or self._is_small(number):
                continue
            origin = self._origin(number, own[number], beside, found)
            if origin is not None:
                chosen.append((number, origin))
                self._beside[number] = beside
        boxes = {number: self.store.box(number) for number, _ in chosen}
        chosen.sort(key=lambda pair: -_volume(*boxes[pair[0]]))
        return [(number, Cell(*boxes[number], origin, _BOXES)) for number, origin in chosen]

    def _undecided(self, own: Sequence[bool], order: Sequence[int], found: bool) -> list[int]:
        """The pieces that may be divisible, in order. ``found``: whether some piece holds the continued spot."""
        codes, is_open = self.store.codes, [what.kind is Kind.OPEN for what in self.store.said]
        undecided = [number for number in order if not own[number] or is_open[codes[number]]]
        if self._line:
            return [number for number in undecided if own[number]]
        if not found:
            return [number for number in undecided if self._cell_of(number) in self._starting]
        cells = {self._cell_of(number) for number in undecided if not own[number]}
        hopeful = {cell for cell in cells if any(own[k] for k in (*self._in_cell(cell), *self._around(cell)))}
        return [number for number in undecided if own[number] or self._cell_of(number) in hopeful]

    def _origin(self, number: int, own: bool, beside: Collection[int], found: bool) -> Origin | None:
        """Where to look for the spot in an undecided piece; None: there is no hope."""
        piece = self.store[number]
        if own:
            tube = piece.tube()
            return None if tube is None else Origin.of_tube(tube)
        if not found:
            place, start = tuple(self._place), _standing(self._place, self._spot)
            at = proved_tube(self._equations, place, place, start) if piece.holds(place) else None
            return None if at is None else Origin.of(at)
        origins = [Origin.of_tube(tube) for other in sorted(beside) if (tube := self.store[other].tube())]
        return min(origins, key=lambda each: each.distance(piece.lower, piece.upper), default=None)

    def _is_small(self, number: int) -> bool:
        what, least = self.store.what(number), _SMALLEST[len(self._grid.axes)]
        if what.kind is Kind.NO_TUBE or any(name in _ENDS for name in what.unsure):
            if self._line:  # halved often enough in its cell
                return True
            least = _SMALLEST_AT_ENDS
        return bool(_volume(*self.store.box(number)) < least * self._whole)

    def _steps(self, cell: int) -> Iterator[int]:
        """How far before a cell those stand that share a side with it."""
        step = 1
        for axis in reversed(self._grid.axes):
            if cell // step % axis.cells:
                yield step
            step *= axis.cells

    def _in_cell(self, cell: int) -> Sequence[int]:
        return self._parts.get(cell) or range(self.store.ends[cell], self.store.ends[cell + 1])

    def _around(self, cell: int) -> list[int]:
        others = map(self._grid.number, self._grid.neighbours(self._grid.index(cell)))
        return [number for other in others for number in self._in_cell(other)]

    def _cell_of(self, number: int) -> int:
        return self._cells[number] if number in self._cells else self.store.cell(number)


def _volume(lower: Sequence[fmpq], upper: Sequence[fmpq]) -> fmpq:
    volume = fmpq(1)
    for low, high in zip(lower, upper, strict=True):
        volume *= high - low
    return volume


def _standing(place: Sequence[fmpq], spot: Sequence[arb]) -> Origin:
    """The spot at one place; how it moves is not known yet."""
    centre = []
    for value in spot:
        mantissa, exponent = value.mid().man_exp()
        centre.append(fmpq(mantissa) * fmpq(2) ** int(exponent))
    return Origin(tuple(place), tuple(centre), tuple((fmpq(0),) * len(place) for _ in spot))
