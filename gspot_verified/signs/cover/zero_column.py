"""Pieces over the whole tau-axis that tell how many zeros F has, for one range of beta inside a cell."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Protocol

from flint import fmpq

from gspot_verified.signs.cover.column_models import ColumnModels
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, cell_of, fold_integer, number_of_zeros
from gspot_verified.signs.cover.tails import left_threshold

_STEP = fmpq(1, 2)  # of the grid in tau, to begin with
FOLD_HALF_WIDTHS = tuple(fmpq(1, 2**j) for j in range(1, 7))
LEAST_LEFT_OF_FOLD = fmpq(-1)
"""The tail on the left holds nearly up to 0 next to an integer: it makes room for a fold."""

_NARROW = fmpq(1, 16)  # in beta: in a wider range the last zero is to be bracketed too
_LEAST_WIDTH = fmpq(1, 2**7)  # of a piece in tau; a column that needs narrower ones is cut
_POINT_WIDTH = fmpq(1, 2**120)  # likewise at one beta, which cannot be cut
_LONGEST_CUT = 512  # bits of a cut that is taken from a journal, which may hold anything


class CertainSigns(Protocol):
    """Certain signs of a function and of its tau-derivatives over one range of b."""

    def sign(self, lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        """The sign of the derivative on [lower, upper] and the whole range of b, or None."""

    def changes(self, tau: fmpq, n: int) -> int | None:
        """The number v of ``proofs/tails.md`` at tau, or None."""


def zero_column(lower: fmpq, upper: fmpq, along: Column | None = None) -> Column | None:
    """A column of certain pieces over beta in [lower, upper], or None when the range is too wide for one.

    ``along``: pieces to try first. Nothing is taken from them but where to cut.

    :raises ValueError: the range crosses an integer.
    """
    n = cell_of(lower, upper)
    if n < 0:
        return Column(lower, upper, (ColumnPiece(Kind.LAPLACE, None, None),))
    reach = reach_of_cell(n)
    models = ColumnModels(lower - 1, upper - 1, reach)
    left = -left_threshold(lower - 1, upper - 1, n)
    has_fold = fold_integer(lower, upper) is not None
    if has_fold:
        left = min(left, LEAST_LEFT_OF_FOLD)
    least = _least_width(lower, upper, n)
    # One zero may stay in the tail only if the range is narrow: a wide one is cut, to bracket that zero too.
    for changes in (0, 1) if upper - lower <= _NARROW else (0,):
        right = right_tail(models, n, reach, changes, along)
        middle = _middle(models, left, right, has_fold, least, along) if right is not None else None
        if right is not None and middle is not None:
            pieces = (ColumnPiece(Kind.LEFT, None, left), *middle, ColumnPiece(Kind.RIGHT, right, None, changes))
            column = Column(lower, upper, pieces)
            if number_of_zeros(column) is not None:
                return column
    return None


def _least_width(lower: fmpq, upper: fmpq, n: int) -> fmpq:
    """No box is cut below it. A heuristic: at a distance d from an integer of a fold F has its least value, of the size
    d, on an interval of about sqrt(d), a little less for large n."""
    if lower == upper:
        return _POINT_WIDTH
    third = 3 * int(((lower + upper) / 6 + fmpq(1, 2)).floor())
    distance = max(lower - third, third - upper)
    if distance <= 0:
        return _LEAST_WIDTH
    return min(_LEAST_WIDTH, fmpq(1, 2 ** (3 + n.bit_length() // 5 + int((1 / distance).ceil()).bit_length() // 2)))


def reach_of_cell(n: int) -> fmpq:
    """How far to the right the pieces are sought: beyond the zeros of the polynomial Theta(., n + 1). A heuristic."""
    return fmpq(math.ceil(2 * (n + 1) ** (2 / 3)) + 4)


def right_tail(models: CertainSigns, n: int, reach: fmpq, changes: int, along: Column | None = None) -> fmpq | None:
    """The least T of the grid beyond which F has ``changes`` = 0 or 1 zeros, certainly; ``along``: that of its tail, if
    it is such a T."""
    last = int((reach / _STEP).floor())
    if along is not None and along.pieces[-1].kind is Kind.RIGHT:
        place, mark = along.pieces[-1].lower, along.pieces[-1].mark
        within = place is not None and (place / _STEP).q == 1 and _STEP <= place <= last * _STEP
        return place if place is not None and within and mark == changes == models.changes(place, n) else None
    if changes:
        places = (k * _STEP for k in range(1, last + 1) if models.changes(k * _STEP, n) == 1)
        return next(places, None)
    if models.changes(last * _STEP, n) != 0:
        return None
    # The number of changes does not grow with T (Budan and Fourier), so bisection finds the least T.
    low, high = 0, last
    while high - low > 1:
        middle = (low + high) // 2
        if models.changes(middle * _STEP, n) == 0:
            high = middle
        else:
            low = middle
    return high * _STEP


def _middle(
    models: ColumnModels, left: fmpq, right: fmpq, has_fold: bool, least: fmpq, along: Column | None
) -> tuple[ColumnPiece, ...] | None:
    if not has_fold:
        return cover(models, left, right, least, along)
    for half_width in FOLD_HALF_WIDTHS:
        if -half_width > left and half_width < right and models.fold(-half_width, half_width):
            before = cover(models, left, -half_width, least, along)
            after = cover(models, half_width, right, least, along) if before is not None else None
            if before is None or after is None:
                return None
            return (*before, ColumnPiece(Kind.FOLD, -half_width, half_width), *after)
    return None


def cover(
    models: CertainSigns, left: fmpq, right: fmpq, least: fmpq, along: Column | None = None
) -> tuple[ColumnPiece, ...] | None:
    """Pieces SIGN and MONOTONE from left to right, by bisection; None as soon as one box is narrower than ``least``."""
    waiting = grid(left, right) if along is None else grid_along(left, right, along)
    pieces: list[ColumnPiece] = []
    while waiting:
        lower, upper = waiting.pop()
        if sign := models.sign(lower, upper):
            pieces.append(ColumnPiece(Kind.SIGN, lower, upper, sign))
        elif direction := models.sign(lower, upper, 1):
            pieces.append(ColumnPiece(Kind.MONOTONE, lower, upper, direction))
        elif upper - lower <= least:
            return None
        else:
            middle = (lower + upper) / 2
            waiting += [(middle, upper), (lower, middle)]
    return tuple(pieces)


def grid(left: fmpq, right: fmpq, step: fmpq = _STEP) -> list[tuple[fmpq, fmpq]]:
    """[left, right] cut at the multiples of the step, the last interval first."""
    points = [left]
    k = int((left / step).floor()) + 1
    while k * step < right:
        points.append(k * step)
        k += 1
    points.append(right)
    return [(a, b) for a, b in pairwise(points) if a < b][::-1]


def grid_along(left: fmpq, right: fmpq, along: Column) -> list[tuple[fmpq, fmpq]]:
    """[left, right] cut at the multiples of the step and at the ends of a column's pieces, the last interval first.

    Ends with long numerators or denominators are left out: a journal may hold anything.
    """
    ends = {end for piece in along.pieces for end in (piece.lower, piece.upper) if end is not None}
    near = {end for end in ends if left < end < right and end.height_bits() <= _LONGEST_CUT}
    return list(pairwise(sorted({left, right, *near, *(end for cell in grid(left, right) for end in cell)})))[::-1]
