"""Columns across a fold: two zeros meet at some beta of the column, or outside of it, and vanish as beta increases.

Proof page: ``proofs/finite_epsilon_zeros.md``, section 6.
"""

from __future__ import annotations

import math
from dataclasses import replace

from flint import fmpq

from gspot_verified.compliant.patches.slow_patch import SlowPatch
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.compliant.slow.slow_signs import CELL, SlowSigns
from gspot_verified.compliant.zeros.polynomial_zeros import number_at_integer
from gspot_verified.compliant.zeros.slow_zero_column import MAP_REACH, left_end, right_end, tails
from gspot_verified.numbers.balls import approximate
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, number_of_zeros
from gspot_verified.signs.cover.zero_column import cover, grid

_HALF_WIDTHS = (fmpq(1, 4), fmpq(1, 8), fmpq(1, 2), fmpq(3, 4), fmpq(1, 16))
_PARTS = 3  # of a cell of tau, on the fold's piece: shorter boxes, more certain signs
_SEARCH_STEP = fmpq(1, 32)  # in tau, where a minimum is looked for: a heuristic
_SEARCH_BITS = 40  # for the same search
_FAR = 0.5  # a minimum as large as that has no fold near it: a heuristic
_SEARCH_FROM, _SEARCH_TO = fmpq(-6), fmpq(8)  # in tau, where a minimum is looked for: a heuristic


def fold_column(
    lower: fmpq,
    upper: fmpq,
    n: int,
    epsilon_lower: fmpq,
    epsilon_upper: fmpq,
    least: fmpq,
    along: Column | None = None,
) -> Column | None:
    """A column with one piece FOLD over beta in [lower, upper], n + 1 <= beta <= n + 2, and the epsilon, or None.

    ``along``: pieces to try first, of which nothing is taken but where to cut.
    """
    epsilons = (max(epsilon_lower, epsilon_upper / 1000), epsilon_upper)
    minima = [nearest_minimum(b, epsilon) for b in (lower - 1, upper - 1) for epsilon in epsilons]
    places = [place for place, _ in minima if place is not None]
    values = [value for _, value in minima]
    far = _FAR * max(1.0, math.gamma(approximate(upper)) / math.gamma(6))
    if len(places) < len(minima) or min(values) > far or max(values) < -far:
        return None
    patch = SlowPatch(lower - 1, upper - 1, epsilon_lower, epsilon_upper)
    signs, slopes = patch.signs(lower - 1, upper - 1), patch.slopes(lower - 1, upper - 1)
    left = left_end(signs, n, MAP_REACH)
    if left is None:
        return None
    for half_width in _HALF_WIDTHS:
        begin, end = min(places) - half_width, max(places) + half_width
        if not is_fold(signs, slopes, begin, end):
            continue
        for tail in tails(lower, n):
            right = right_end(signs, n, tail, MAP_REACH, along)
            if right is not None and right < end:  # the tail serves from a later place on where that is certain, too
                later = (end / CELL).ceil() * CELL
                right = later if signs.changes(later, n) == tail else None
            if right is None:
                continue
            before = cover(signs, min(left, begin), begin, least, along) if left < begin else ()
            after = cover(signs, end, right, least, along) if before is not None else None
            if before is None or after is None:
                continue
            pieces = (
                ColumnPiece(Kind.LEFT, None, min(left, begin)),
                *before,
                ColumnPiece(Kind.FOLD, begin, end),
                *after,
                ColumnPiece(Kind.RIGHT, right, None, tail),
            )
            column = Column(lower, upper, pieces)
            if numbers_of_zeros(column, epsilon_lower, epsilon_upper) is not None:
                return column
    return None


def is_fold(signs: SlowSigns, slopes: SlowSigns, begin: fmpq, end: fmpq) -> bool:
    """Whether G > 0 at both ends, and G'' > 0 and dG/db > 0 between them."""
    if signs.sign(begin, begin) != 1 or signs.sign(end, end) != 1:
        return False
    parts = fold_parts(begin, end)
    return all(signs.sign(a, b, 2) == 1 and slopes.sign(a, b) == 1 for a, b in parts)


def fold_parts(begin: fmpq, end: fmpq) -> list[tuple[fmpq, fmpq]]:
    """[begin, end] in short intervals, each in one cell of tau."""
    return [
        (a + (b - a) * fmpq(i, _PARTS), a + (b - a) * fmpq(i + 1, _PARTS))
        for a, b in grid(begin, end)
        for i in range(_PARTS)
    ]


def numbers_of_zeros(column: Column, epsilon_lower: fmpq, epsilon_upper: fmpq) -> tuple[int, ...] | None:
    """The numbers of zeros that the column allows, the smaller beta first: one number, or (N + 2, N) across a fold."""
    folds = [piece for piece in column.pieces if piece.kind is Kind.FOLD]
    # Beyond the fold G > 0 on its piece.
    pieces = tuple(
        ColumnPiece(Kind.SIGN, piece.lower, piece.upper, 1) if piece.kind is Kind.FOLD else piece
        for piece in column.pieces
    )
    number = number_of_zeros(replace(column, pieces=pieces))
    if number is None:
        return None
    beyond = not folds or _is_beyond(column, number, epsilon_lower, epsilon_upper)
    return (number,) if beyond else (number + 2, number)


def _is_beyond(column: Column, number: int, epsilon_lower: fmpq, epsilon_upper: fmpq) -> bool:
    """Whether the column begins at an integer beta at which the fold's piece has no zero, by exact polynomials."""
    if column.lower is None or column.lower.q != 1:
        return False
    # The tail that begins with an integer has its one zero only beyond the integer.
    outside = number - column.pieces[-1].mark
    return number_at_integer(int(column.lower.p) - 1, epsilon_lower, epsilon_upper) == outside


def nearest_minimum(b: fmpq, epsilon: fmpq) -> tuple[fmpq | None, float]:
    """A place near the first critical point of G, from the left, and G there, nearly. A heuristic: where its sign does
    not change among the corners of a box, and it is not small, there is no fold to be looked for."""
    tau, step = _SEARCH_FROM, fmpq(1, 2)
    while tau < _SEARCH_TO:
        value, slope = slow_jet(tau + step, b, epsilon, 2, _SEARCH_BITS)
        if not slope > 0:
            tau += step
        elif step > _SEARCH_STEP:
            step /= 2
        else:
            return tau + step / 2, approximate(value)
    return None, 0.0
