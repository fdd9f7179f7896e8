"""Pieces over the whole tau-axis that tell how many real zeros G_b(. ; eta) has, for a box of b and epsilon.

Proof page: ``proofs/finite_epsilon_zeros.md``, sections 1 and 2.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.compliant.slow.slow_signs import CELL, SlowSigns
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, number_of_zeros
from gspot_verified.signs.cover.zero_column import cover, right_tail

MAX_REACH = 256  # tau up to which tails are looked for, against endless work
MAP_REACH = 16  # the same in a map: a column that needs more is cut
_FIRST_REACH = 2  # tau up to which they are looked for at first, then twice as far: models are wide at large tau


def slow_zero_column(
    signs: SlowSigns,
    lower: fmpq,
    upper: fmpq,
    n: int,
    least: fmpq,
    reach: int = MAX_REACH,
    along: Column | None = None,
) -> Column | None:
    """A column of certain pieces over beta in [lower, upper], n + 1 <= beta <= n + 2, or None.

    ``least``: the narrowest piece; ``reach``: how far from 0 the tails may begin. ``along``: pieces to try first, of
    which nothing is taken but where to cut.
    """
    left = left_end(signs, n, reach)
    if left is None:
        return None
    for tail in tails(lower, n):
        right = right_end(signs, n, tail, reach, along)
        middle = cover(signs, left, right, least, along) if right is not None and left < right else None
        if right is not None and middle is not None:
            pieces = (ColumnPiece(Kind.LEFT, None, left), *middle, ColumnPiece(Kind.RIGHT, right, None, tail))
            column = Column(lower, upper, pieces)
            if number_of_zeros(column) is not None:
                return column
    return None


def tails(lower: fmpq, n: int) -> tuple[int, ...]:
    """How many zeros may stay in the right tail, in the order of preference; none of it can be empty from an integer
    on."""
    return (1,) if lower == n + 1 else (0, 1)


def left_end(signs: SlowSigns, n: int, reach: int) -> fmpq | None:
    """A grid point up to which G_b > 0, or None."""
    k = 1
    while k * CELL <= reach:
        if signs.positive_before(-k * CELL, n):
            return -k * CELL
        k += max(1, k // 4)
    return None


def right_end(signs: SlowSigns, n: int, tail: int, reach: int, along: Column | None = None) -> fmpq | None:
    """A grid point beyond which G_b has ``tail`` = 0 or 1 zeros, or None."""
    if along is not None:
        return right_tail(signs, n, fmpq(reach), tail, along)
    end = _FIRST_REACH
    while end <= reach:
        right = right_tail(signs, n, fmpq(end), tail)
        if right is not None:
            return right
        end *= 2
    return None
