"""Pieces and columns: what a certificate is made of. Their meaning: ``proofs/certificate.md``."""

from __future__ import annotations

import enum
from dataclasses import dataclass

from flint import fmpq


class Kind(enum.Enum):
    """What a piece says about F = Theta(., beta - 1) over its interval of tau and the column's range of beta."""

    LAPLACE = "laplace"
    TAYLOR = "taylor"
    LEFT = "left"
    SIGN = "sign"
    MONOTONE = "monotone"
    FOLD = "fold"
    HINGE = "hinge"
    RIGHT = "right"
    LEVEL = "level"
    DIP = "dip"


@dataclass(frozen=True, slots=True)
class ColumnPiece:
    """One piece of a column; ``None`` as an end is infinity.

    ``mark`` is the sign of F (SIGN), the direction of F (MONOTONE), the number of changes of sign (RIGHT), else 0.
    """

    kind: Kind
    lower: fmpq | None
    upper: fmpq | None
    mark: int = 0

    def to_list(self) -> list[str | int]:
        """The piece as it stands in a certificate."""
        match self.kind:
            case Kind.LAPLACE | Kind.TAYLOR:
                return [self.kind.value]
            case Kind.LEFT:
                return [self.kind.value, str(self.upper)]
            case Kind.RIGHT:
                return [self.kind.value, str(self.lower), self.mark]
            case Kind.FOLD | Kind.HINGE | Kind.LEVEL | Kind.DIP:
                return [self.kind.value, str(self.lower), str(self.upper)]
            case _:
                return [self.kind.value, str(self.lower), str(self.upper), self.mark]


@dataclass(frozen=True, slots=True)
class Column:
    """A closed range of beta and the pieces over it, in the order of tau; ``lower`` is ``None`` for minus infinity."""

    lower: fmpq | None
    upper: fmpq
    pieces: tuple[ColumnPiece, ...]

    def tubes(self) -> list[tuple[fmpq, fmpq]]:
        """Intervals of tau that hold exactly one zero each, for every beta of the column: runs of monotone
        pieces of one direction between two certain signs, of which the first is the opposite of the second."""
        if self.lower is None:
            return []
        tubes = []
        for run, before, after in monotone_runs(self.pieces, cell_of(self.lower, self.upper)):
            lower, upper = run[0].lower, run[-1].upper
            crosses = 0 not in (before, after) and before != after and {piece.mark for piece in run} == {after}
            if crosses and lower is not None and upper is not None:
                tubes.append((lower, upper))
        return tubes


def cell_of(lower: fmpq, upper: fmpq) -> int:
    """n with n <= lower - 1 and upper - 1 <= n + 1 for a range of beta inside one cell; b - 1 for an integer point b.

    :raises ValueError: the range crosses an integer.
    """
    n = int((lower - 1).floor())
    if upper - 1 > n + 1:
        raise ValueError("the range of beta must lie between two neighbouring integers")
    return n - 1 if lower == upper == n + 1 else n


def end_signs(piece: ColumnPiece, n: int) -> tuple[int, int]:
    """The signs of F at the two ends of a piece that fixes them (at an infinite end: the sign next to it)."""
    match piece.kind:
        case Kind.SIGN:
            return piece.mark, piece.mark
        case Kind.RIGHT:
            last = -1 if n % 2 == 0 else 1
            return (-last if piece.mark else last), last
        case Kind.LAPLACE | Kind.TAYLOR | Kind.LEFT | Kind.FOLD:
            return 1, 1
        case _:
            raise ValueError(f"a piece {piece.kind.value} fixes no sign at its ends")


def monotone_runs(pieces: tuple[ColumnPiece, ...], n: int) -> list[tuple[list[ColumnPiece], int, int]]:
    """Maximal runs of monotone pieces with the signs of F before and after; ``n`` is the cell of the column.

    A sign is 0 where nothing fixes it.
    """
    runs: list[tuple[list[ColumnPiece], int, int]] = []
    current: list[ColumnPiece] = []
    before = 0
    for piece in pieces:
        if piece.kind is Kind.MONOTONE:
            current.append(piece)
            continue
        left, right = end_signs(piece, n)
        if current:
            runs.append((current, before, left))
            current = []
        before = right
    if current:
        runs.append((current, before, 0))
    return runs


def number_of_zeros(column: Column) -> int | None:
    """How many real zeros F has for every b of the column inside its open cell; None if the pieces do not tell.

    The rules are those of ``proofs/certificate.md``, "zeros".
    """
    if column.lower is None:
        return 0
    n = cell_of(column.lower, column.upper)
    total = 0
    for run, before, after in monotone_runs(column.pieces, n):
        directions = {piece.mark for piece in run}
        if len(directions) != 1 or 0 in (before, after):
            return None
        if before != after:
            if after not in directions:
                return None
            total += 1
    for piece, following in zip(column.pieces, column.pieces[1:], strict=False):
        if Kind.MONOTONE not in (piece.kind, following.kind) and end_signs(piece, n)[1] != end_signs(following, n)[0]:
            return None
    for piece in column.pieces:
        if piece.kind is Kind.RIGHT:
            total += piece.mark
        if piece.kind is Kind.FOLD and column.upper - 1 == fold_integer(column.lower, column.upper):
            total += 2
    return total


def fold_integer(lower: fmpq, upper: fmpq) -> int | None:
    """The integer n = 2, 5, 8, ... among the numbers beta - 1 of the range, if there is one."""
    candidates = (int((lower - 1).ceil()), int((upper - 1).floor()))
    return next((n for n in candidates if n >= 2 and n % 3 == 2 and lower - 1 <= n <= upper - 1), None)
