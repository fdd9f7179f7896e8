"""The contact force over the first stretch of a motion, by its power series: > 0, or its first zero in a bracket.

Proof pages: ``proofs/contact_series.md``, section 4; ``proofs/force_range.md``, section 2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial

from flint import arb, arb_poly, fmpq

from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.motion.contact_series import SeriesCell, series_cells, series_rate, series_work
from gspot_verified.numbers.balls import add_remainder, hull, sign_of, working_bits
from gspot_verified.numbers.evidence import Ends, cover, every, less
from gspot_verified.numbers.verdict import Evidence

MOST_WORK = 3_000
"""Rate times duration up to which a stretch is looked at, unless a caller says otherwise."""

_STRETCHES = (30, 300)
_WORK_OF_A_CELL = 3  # rate times time of one power series; chosen by trial: any number is right
_LEAST_PIECE = fmpq(1, 2**24)  # of a cell; a shorter one is not cut
_BITS = 128  # where only a sign is wanted
_BITS_OF_LARGE = 30  # a force so much above the state's size is taken to grow for ever: the search gives up


@dataclass(frozen=True, slots=True)
class Piece:
    """The force lambda = mean + Z - Y and its slope on a part [left, right] of a cell, 0 <= left < right <= 1."""

    cell: SeriesCell
    mean: fmpq
    left: fmpq
    right: fmpq

    def force(self) -> arb:
        """An enclosure of lambda over the piece."""
        _, _, Y, Z = self.cell.variables
        return self.mean + _range(Z - Y, self.cell.rests[2] + self.cell.rests[3], self.left, self.right)

    def slope(self) -> arb:
        """An enclosure of d lambda/dT = -(2 Z - Y + V) over the piece."""
        _, V, Y, Z = self.cell.variables
        _, v, y, z = self.cell.rests
        return -_range(2 * Z - Y + V, 2 * z + y + v, self.left, self.right)

    def halves(self) -> tuple[Piece, Piece]:
        """The left and the right half."""
        middle = (self.left + self.right) / 2
        return Piece(self.cell, self.mean, self.left, middle), Piece(self.cell, self.mean, middle, self.right)

    def force_at(self, x: fmpq) -> arb:
        """lambda at a point of the cell."""
        _, _, Y, Z = self.cell.at(arb(x))
        return self.mean + Z - Y

    def time(self, x: fmpq) -> fmpq:
        """The time of a point of the cell, since the state."""
        return self.cell.first + x * self.cell.width

    def shown_positive(self) -> Evidence | None:
        """lambda > 0 on the piece: by its range, or because it falls and is still positive at the right end."""
        return less(0, self.force()) or every(
            less(one, other) for one, other in ((self.slope(), 0), (0, self.force_at(self.right)))
        )


def _range(polynomial: arb_poly, rest: arb, left: fmpq, right: fmpq) -> arb:
    """An enclosure over [left, right]: the coefficients in u, x = left + (right - left) u, and 0 <= u^k <= 1."""
    shifted = polynomial(arb_poly([left, right - left])).coeffs()
    total = shifted[0] if shifted else arb(0)
    for coefficient in shifted[1:]:
        total += hull([arb(0), coefficient])
    return add_remainder(total, rest)


@dataclass(frozen=True, slots=True)
class SeriesZero:
    """Two times since the state, in T, with the first zero of lambda between them, and what was compared."""

    lower: fmpq
    upper: fmpq
    evidence: Evidence


@dataclass(slots=True)
class Shown:
    """The pieces on which lambda > 0 was shown, by their times, and how."""

    pieces: list[Ends] = field(default_factory=list)
    evidence: list[Evidence] = field(default_factory=list)

    def note(self, piece: Piece, positive: Evidence) -> None:
        """One more piece."""
        self.pieces.append((piece.time(piece.left), piece.time(piece.right)))
        self.evidence.append(positive)


def positive_by_series(state: Deviation, mean: fmpq, duration: fmpq, work: int = MOST_WORK) -> Evidence | None:
    """lambda > 0 from the state up to the time ``duration`` in T after it, certainly; None where it is not shown."""
    if series_work(state, duration) > work:
        return None
    if duration == 0:
        return less(0, state.force + mean)
    shown = Shown()
    if not_positive(_cells(state, duration, _BITS), mean, _BITS, shown) is not None:
        return None
    return every([cover(shown.pieces, (fmpq(0), duration)), *shown.evidence])


def zero_by_series(
    state: Deviation, mean: fmpq, width: fmpq, bits: int, most_work: int = MOST_WORK
) -> SeriesZero | None:
    """Two times since the state, in T, ``width`` or less apart: the first zero of lambda lies between them.

    lambda > 0 from the state up to it, and its slope is < 0 there. ``bits``: the accuracy of lambda that this asks for.
    None where no such bracket is found.
    """
    for work in (*(stretch for stretch in _STRETCHES if stretch < most_work), most_work):
        shown = Shown()
        cells = _cells(state, duration_of(state, work), bits)
        piece = not_positive(cells, mean, bits, shown, partial(_has_grown, _large(state, mean)))
        if piece is not None:
            return bracket(piece, width / piece.cell.width, bits, shown)
    return None


def duration_of(state: Deviation, work: int) -> fmpq:
    """About the time at which this work is done: a heuristic."""
    duration = work / series_rate(state, fmpq(0))
    for _ in range(4):
        duration = work / series_rate(state, duration)
    return duration


def cell_count(state: Deviation, duration: fmpq, work: int = _WORK_OF_A_CELL) -> int:
    """How many cells of about this work a stretch is cut into."""
    return max(1, int((series_work(state, duration) / work).ceil()))


def _cells(state: Deviation, duration: fmpq, bits: int) -> Iterator[SeriesCell]:
    return series_cells(state, duration, cell_count(state, duration), bits)


def _large(state: Deviation, mean: fmpq) -> arb:
    """A force after which no zero is to be expected: a heuristic."""
    return arb(2) ** _BITS_OF_LARGE * (1 + abs(arb(mean)) + abs(arb(state.b)) + abs(arb(state.V)) + arb(state.force))


def _has_grown(large: arb, cell: SeriesCell) -> bool:
    _, _, Y, Z = cell.at(arb(1))
    return large < Z - Y


def not_positive(
    cells: Iterable[SeriesCell],
    mean: fmpq,
    bits: int,
    shown: Shown,
    stops: Callable[[SeriesCell], bool] = lambda _: False,
    rising: bool = False,
) -> Piece | None:
    """The first piece on which lambda > 0 is not shown and its slope is < 0, or that is too short to be cut; ``shown``
    notes the pieces before it. None when lambda > 0 up to the end, or up to the end of a cell at which it ``stops``.

    ``rising``: lambda >= 0 at the start is known, so that a slope > 0 is enough on the first piece, the start apart.
    """
    for cell in cells:
        with working_bits(bits + 64):
            waiting = [Piece(cell, mean, fmpq(0), fmpq(1))]
            while waiting:
                piece = waiting.pop()
                positive = piece.shown_positive()
                if positive is None and rising and piece.left == 0 and cell.first == 0:
                    positive = less(0, piece.slope())
                if positive is not None:
                    shown.note(piece, positive)
                    continue
                falls = piece.slope() < 0 and piece.force_at(piece.right) < 0
                if falls or piece.right - piece.left <= _LEAST_PIECE:
                    return piece
                waiting += reversed(piece.halves())
            if stops(cell):
                return None
    return None


def bracket(piece: Piece, width: fmpq, bits: int, shown: Shown) -> SeriesZero | None:
    """Halved down to a part of length ``width`` of the cell, while the signs at both ends are certain."""
    with working_bits(bits + 64):
        left, right = piece.left, piece.right
        while right - left > width:
            middle = (left + right) / 2
            sign = sign_of(piece.force_at(middle))
            if sign not in (1, -1):
                return None
            left, right = (middle, right) if sign == 1 else (left, middle)
        lower, upper = piece.time(left), piece.time(right)
        evidence = every([
            # lambda > 0 before the piece, and on it up to ``lower``: it falls there.
            cover([*shown.pieces, (piece.time(piece.left), lower)], (fmpq(0), lower)), *shown.evidence,
            less(piece.slope(), 0), less(0, piece.force_at(left)), less(piece.force_at(right), 0),
        ])  # fmt: skip
    return None if evidence is None else SeriesZero(lower, upper, evidence)
