"""Which undecided pieces of a sweep are divided further, and near what spot is looked there: heuristics.

Any choice is correct: what a part says comes from its own examination, and the links are made anew with the parts.
"""

from __future__ import annotations

from array import array
from collections.abc import Collection, Iterable, Sequence, Set

from flint import arb, fmpq

from gspot_verified.mechanisms.sweep.sweep_cell import Cell
from gspot_verified.mechanisms.sweep.sweep_findings import HYPOTHESES, TOO_LARGE
from gspot_verified.mechanisms.sweep.sweep_grid import Grid
from gspot_verified.mechanisms.sweep.sweep_links import common_place
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations

_BOXES = 16  # of one undecided piece: few, so that the budget goes where it helps
_SMALLEST = {1: fmpq(1, 2**14), 2: fmpq(1, 2**24)}  # parts of the range, by the number of parameters
_ENDS = (*HYPOTHESES, TOO_LARGE)
_SMALLEST_AT_ENDS = fmpq(1, 2**14)  # of a map: along a fold, or where a hypothesis ends, no piece is small enough


class Patchwork:
    """The pieces of all cells by numbers that stay theirs, with those that they touch; parts take a piece's place.

    Cells come in their order, with the groups of :func:`groups_in_a_row`.
    """

    def __init__(self, grid: Grid) -> None:
        self._grid = grid
        self._whole = _volume(tuple(axis.lower for axis in grid.axes), tuple(axis.upper for axis in grid.axes))
        self._line = len(grid.axes) == 1
        self.pieces: list[SweepPiece] = []
        self.near: list[list[int]] = []
        self.groups: list[int] = []
        """Pieces with the same number hold the same spot, continued."""
        self._cells = array("q")
        self._ends = array("q", [0])
        self._beside: dict[int, frozenset[int]] = {}  # pieces of the continued spot, when it was last looked
        self._in_vain: dict[int, frozenset[int]] = {}  # the same of pieces that did not fall into parts
        self._replaced: set[int] = set()

    def add_cells(self, pieces_by_cell: Sequence[Sequence[SweepPiece]], groups: Sequence[int]) -> None:
        """The pieces of the next cells."""
        self._add_groups(groups)
        for pieces in pieces_by_cell:
            cell = len(self._ends) - 1
            own = [self._add(piece, cell) for piece in pieces]
            self._ends.append(len(self.pieces))
            before = (self._grid.number(other) for other in self._grid.neighbours(self._grid.index(cell)))
            around = [n for other in before if other < cell for n in range(self._ends[other], self._ends[other + 1])]
            self._join(own, around)

    def _add_groups(self, groups: Sequence[int]) -> None:
        first = len(self.pieces)
        self.groups += [first + group for group in groups]

    def _add(self, piece: SweepPiece, cell: int) -> int:
        self.pieces.append(piece)
        self.near.append([])
        self._cells.append(cell)
        return len(self.pieces) - 1

    def _join(self, own: Sequence[int], around: Iterable[int]) -> None:
        """Note which of these pieces touch each other or one of those around."""
        around = [number for number in around if number not in self._replaced]
        for k, number in enumerate(own):
            for other in (*own[k + 1 :], *around):
                if common_place(self.pieces[number], self.pieces[other]) is not None:
                    self.near[number].append(other)
                    self.near[other].append(number)

    def replace(self, number: int, parts: Sequence[SweepPiece], groups: Sequence[int]) -> None:
        """Put the parts in the place of a piece. One that did not fall into parts is divided again only where others
        are beside it than before."""
        self._replaced.add(number)
        self._add_groups(groups)
        added = [self._add(part, self._cells[number]) for part in parts]
        if len(added) == 1 and number in self._beside:
            self._in_vain[added[0]] = self._beside[number]
        around = sorted(self.near[number])
        for other in around:
            self.near[other].remove(number)
        self._join(added, around)

    def order(self) -> list[int]:
        """The numbers of the pieces that are there, cell by cell in the order of their lower ends."""
        there = [number for number in range(len(self.pieces)) if number not in self._replaced]
        return sorted(there, key=lambda number: (self._cells[number], self.pieces[number].lower))

    def divisible(
        self, own: Set[int], equations: Equations, place: Sequence[fmpq], spot: Sequence[arb]
    ) -> list[tuple[int, Cell]]:
        """The undecided pieces that may be divided with some hope, the largest first, each as a cell.

        ``own``: the pieces that hold the continued spot. Those of them that are open; of a map also those beside them
        that do not hold it, or that at ``place``, where it is ``spot``, if none holds it.
        """
        chosen: list[tuple[int, Origin]] = []
        self._beside = {}
        for number in self.order():
            piece = self.pieces[number]
            if number in own and piece.kind is not Kind.OPEN:
                continue
            beside = frozenset() if number in own else frozenset(own & frozenset(self.near[number]))
            if self._in_vain.get(number) == beside or self._is_small(piece):
                continue
            origin = self._origin(number, own, beside, equations, place, spot)
            if origin is not None:
                chosen.append((number, origin))
                self._beside[number] = beside
        chosen.sort(key=lambda pair: -_volume(self.pieces[pair[0]].lower, self.pieces[pair[0]].upper))
        return [
            (number, Cell(self.pieces[number].lower, self.pieces[number].upper, origin, _BOXES))
            for number, origin in chosen
        ]

    def _origin(
        self,
        number: int,
        own: Set[int],
        beside: Collection[int],
        equations: Equations,
        place: Sequence[fmpq],
        spot: Sequence[arb],
    ) -> Origin | None:
        """Where to look for the spot in an undecided piece; None: there is no hope."""
        piece = self.pieces[number]
        if number in own:
            tube = piece.tube()
            return None if tube is None else Origin.of_tube(tube)
        if self._line:
            return None
        if not own and piece.holds(place):
            at = proved_tube(equations, tuple(place), tuple(place), _standing(place, spot))
            return None if at is None else Origin.of(at)
        origins = [Origin.of_tube(tube) for other in sorted(beside) if (tube := self.pieces[other].tube())]
        return min(origins, key=lambda each: each.distance(piece.lower, piece.upper), default=None)

    def _is_small(self, piece: SweepPiece) -> bool:
        least = _SMALLEST[len(piece.lower)]
        if piece.kind is Kind.NO_TUBE or any(name in _ENDS for name in piece.unsure):
            if self._line:  # halved often enough in its cell
                return True
            least = _SMALLEST_AT_ENDS
        return bool(_volume(piece.lower, piece.upper) < least * self._whole)


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
