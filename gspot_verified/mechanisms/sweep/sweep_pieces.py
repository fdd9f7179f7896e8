"""All pieces of a sweep in little memory: what is said on each by a number, its box and numbers in blocks of bytes.

A block holds the pieces of one portion of cells. It is packed where the portion is examined, crosses processes as
bytes, and is read only where its pieces are asked for; they come back as they were. A box that is a whole cell of the
grid is not kept: it is that cell's. What pieces say: ``proofs/sweep.md``, section 5.
"""

from __future__ import annotations

import pickle
from array import array
from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, overload

from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_piece import NO_NUMBERS, Box, Kind, Passing, SweepPiece, TubeRecord
from gspot_verified.numbers.packed import PackedIntervals
from gspot_verified.work.kept_blocks import KeptBlocks

_Row = tuple[bytes, tuple[int, bytes] | None]  # of a piece the numbers and the tube

OTHER = "the continued spot"
"""What is unsure on a piece that may hold another spot: its numbers are not said."""
_OPEN_BLOCKS = 8  # that were read last: any number is correct
_TOGETHER = 512  # pieces that one task writes: any number is correct


class Said(NamedTuple):
    """What is said on a piece, but for numbers: the same on many."""

    kind: Kind
    case: str | None = None
    lift_off_sign: int | None = None
    impact_sign: int | None = None
    unsure: tuple[str, ...] = ()
    passing: Passing | None = None
    slip_sign: int | None = None
    """Of the slip velocity, None where not certain."""
    whole: bool = False
    """Whether the piece is a cell of the grid."""

    @property
    def answer(self) -> tuple[str | None, int | None, int | None]:
        """Case and the two signs of C_1."""
        return self.case, self.lift_off_sign, self.impact_sign


class Block(NamedTuple):
    """The pieces of some cells, one after the other: it pickles."""

    said: tuple[Said, ...]
    codes: array[int]
    """Of each piece which of ``said``."""
    counts: array[int]
    """Of each cell how many pieces it has."""
    of_grid: bool
    """Whether the cells are those of the grid, in their order."""
    boxes: bytes
    """Of the pieces that are no whole cell."""
    data: bytes
    """Numbers and tubes."""


def packed(pieces_by_cell: Sequence[Sequence[SweepPiece]], cells: Sequence[Box] = ()) -> Block:
    """A block. ``cells``: those of the grid, one for each list; nothing where they are none of the grid."""
    said: dict[Said, int] = {}
    codes, boxes, rows = array("I"), list[Box](), list[_Row]()
    for k, pieces in enumerate(pieces_by_cell):
        for piece in pieces:
            whole = bool(cells) and piece.box == cells[k]
            if not whole:
                boxes.append(piece.box)
            codes.append(said.setdefault(_said(piece, whole), len(said)))
            record = piece.record
            rows.append((piece.numbers.data, None if record is None else (record.unknowns, record.sides.data)))
    counts = array("I", map(len, pieces_by_cell))
    return Block(tuple(said), codes, counts, bool(cells), pickle.dumps(boxes), pickle.dumps(rows))


def _said(piece: SweepPiece, whole: bool) -> Said:
    slip = piece.number("slip_velocity")
    sign = None if slip is None else slip.sign()
    return Said(piece.kind, *piece.answer, piece.unsure, piece.passing, sign, whole)


class PackedBlock(NamedTuple):
    """A block with what is said on its pieces now, and the number of the cell that each of them is."""

    said: Mapping[int, Said]
    codes: array[int]
    cells: array[int]
    boxes: bytes
    data: bytes

    def pieces(self, grid: Grid) -> list[SweepPiece]:
        """The pieces, as they were; where another spot may be meant without their numbers."""
        boxes, rows, found = iter(pickle.loads(self.boxes)), pickle.loads(self.data), []
        for code, cell, row in zip(self.codes, self.cells, rows, strict=True):
            what = self.said[code]
            found.append(_piece(what, grid.ends(grid.index(cell)) if what.whole else next(boxes), row))
        return found


def _piece(what: Said, box: Box, row: _Row) -> SweepPiece:
    numbers, record = row
    return SweepPiece(
        *box,
        kind=what.kind,
        case=what.case,
        lift_off_sign=what.lift_off_sign,
        impact_sign=what.impact_sign,
        unsure=what.unsure,
        passing=what.passing,
        numbers=NO_NUMBERS if what.unsure == (OTHER,) else PackedIntervals.of_bytes(numbers),
        record=None if record is None else TubeRecord(record[0], PackedIntervals.of_bytes(record[1])),
    )


@dataclass(frozen=True, slots=True)
class PackedPortion:
    """Some pieces: it pickles. ``places``: the block and the place in it of each."""

    grid: Grid
    blocks: Mapping[int, PackedBlock]
    places: Sequence[tuple[int, int]]

    def __iter__(self) -> Iterator[SweepPiece]:
        pieces = {number: block.pieces(self.grid) for number, block in self.blocks.items()}
        return (pieces[number][place] for number, place in self.places)


class PieceStore:
    """All pieces that were found, by numbers that stay theirs. Those of the grid's cells come first, in their order."""

    def __init__(self, grid: Grid) -> None:
        self.grid = grid
        self.said: list[Said] = []
        self.codes = array("I")
        """Of each piece which of ``said``."""
        self.ends = array("I", [0])
        """A 0, and where the pieces of each cell end."""
        self._known: dict[Said, int] = {}
        self._starts = array("I")
        self._blocks = KeptBlocks()
        self._rows: dict[int, list[_Row]] = {}
        self._boxes: dict[int, dict[int, Box]] = {}

    def __len__(self) -> int:
        return len(self.codes)

    def add(self, block: Block) -> range:
        """The numbers that the pieces of a block get."""
        start = len(self)
        own = [self._code(what) for what in block.said]
        self._starts.append(start)
        self.codes.extend(own[code] for code in block.codes)
        for count in block.counts if block.of_grid else ():
            self.ends.append(self.ends[-1] + count)
        self._blocks.append(block.boxes)
        self._blocks.append(block.data)
        return range(start, len(self))

    def what(self, number: int) -> Said:
        """What is said on a piece."""
        return self.said[self.codes[number]]

    def unsay(self, numbers: Iterable[int]) -> None:
        """These pieces may hold another spot: nothing is said on them but that."""
        for number in numbers:
            what = self.what(number)
            if what.kind is not Kind.NO_TUBE:
                self.codes[number] = self._code(Said(Kind.OPEN, unsure=(OTHER,), whole=what.whole))

    def cell(self, number: int) -> int:
        """The number of the cell of the grid in which a piece was found first."""
        return bisect_right(self.ends, number) - 1

    def box(self, number: int) -> Box:
        """The corners of a piece."""
        if self.what(number).whole:
            return self.grid.ends(self.grid.index(self.cell(number)))
        block = self.block(number)
        if block not in self._boxes:
            numbers = (k for k in self._numbers(block) if not self.what(k).whole)
            _keep(self._boxes, block, dict(zip(numbers, pickle.loads(self._blocks[2 * block]), strict=True)))
        return self._boxes[block][number]

    def __getitem__(self, number: int) -> SweepPiece:
        block = self.block(number)
        if block not in self._rows:
            _keep(self._rows, block, pickle.loads(self._blocks[2 * block + 1]))
        return _piece(self.what(number), self.box(number), self._rows[block][number - self._starts[block]])

    def block(self, number: int) -> int:
        """The number of the block that holds a piece."""
        return bisect_right(self._starts, number) - 1

    def portion(self, numbers: Sequence[int]) -> PackedPortion:
        """These pieces, with the blocks that hold them."""
        blocks = [self.block(number) for number in numbers]
        places = [(block, number - self._starts[block]) for block, number in zip(blocks, numbers, strict=True)]
        return PackedPortion(self.grid, {block: self._packed(block) for block in sorted({*blocks})}, places)

    def _packed(self, block: int) -> PackedBlock:
        numbers = self._numbers(block)
        codes = self.codes[numbers.start : numbers.stop]
        said = {code: self.said[code] for code in sorted({*codes})}
        cells = array("q", (self.cell(k) if self.what(k).whole else -1 for k in numbers))
        return PackedBlock(said, codes, cells, self._blocks[2 * block], self._blocks[2 * block + 1])

    def _numbers(self, block: int) -> range:
        ends = [*self._starts[block : block + 2], len(self)]
        return range(ends[0], ends[1])

    def _code(self, what: Said) -> int:
        if what not in self._known:
            self._known[what] = len(self.said)
            self.said.append(what)
        return self._known[what]


def _keep(opened: dict[int, Any], block: int, what: Any) -> None:
    """Remember the last few that were read."""
    while len(opened) >= _OPEN_BLOCKS:
        del opened[next(iter(opened))]
    opened[block] = what


class SweptPieces(Sequence[SweepPiece]):
    """The pieces that cover a range, in the order of their lower ends, each read when it is asked for."""

    def __init__(self, store: PieceStore, order: Sequence[int]) -> None:
        self._store, self._order = store, order

    @classmethod
    def of(cls, axes: tuple[Axis, ...], pieces: Iterable[SweepPiece]) -> SweptPieces:
        """The same of pieces that are there."""
        store = PieceStore(Grid(axes))
        return cls(store, store.add(packed([[*pieces]])))

    def __len__(self) -> int:
        return len(self._order)

    @overload
    def __getitem__(self, index: int) -> SweepPiece: ...
    @overload
    def __getitem__(self, index: slice) -> SweptPieces: ...
    def __getitem__(self, index: int | slice) -> SweepPiece | SweptPieces:
        if isinstance(index, slice):
            return SweptPieces(self._store, self._order[index])
        return self._store[self._order[index]]

    def __iter__(self) -> Iterator[SweepPiece]:
        return (piece for portion in self.portions() for piece in portion)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Sequence):
            return NotImplemented
        return len(self) == len(other) and all(own == its for own, its in zip(self, other, strict=True))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<{len(self)} pieces>"

    def __reduce__(self) -> tuple[object, ...]:
        return SweptPieces.of, (self._store.grid.axes, tuple(self))

    def portions(self) -> Iterator[PackedPortion]:
        """The pieces in their order, some hundreds in each portion, for an executor."""
        return (self._store.portion(self._order[i : i + _TOGETHER]) for i in range(0, len(self), _TOGETHER))

    def counts(self) -> dict[Said, int]:
        """How often each thing is said; what comes first is first."""
        found: dict[int, int] = Counter(map(self._store.codes.__getitem__, self._order))
        return {self._store.said[code]: count for code, count in found.items()}

    def said(self) -> Iterator[Said]:
        """What is said on each piece."""
        return map(self._store.what, self._order)

    def boxes(self, asked: Callable[[Said], bool] = lambda _: True) -> Iterator[tuple[Said, Box]]:
        """The pieces on which something is said that is asked for, with their corners."""
        wanted = {code for code, what in enumerate(self._store.said) if asked(what)}
        cell, corner, corners = -1, None, self._store.grid.corners()
        ends, codes = self._store.ends, self._store.codes
        for number in self._order:
            code = codes[number]
            if code not in wanted:
                continue
            what = self._store.said[code]
            if not what.whole:
                yield what, self._store.box(number)
                continue
            while ends[cell + 1] <= number:  # whole cells come in their order
                cell, corner = cell + 1, next(corners)
            assert corner is not None
            yield what, corner
