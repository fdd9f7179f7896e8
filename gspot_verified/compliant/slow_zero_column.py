"""Pieces over the whole tau-axis that tell how many real zeros G_b(. ; eta) has, for a box of b and epsilon.

Proof page: ``proofs/finite_epsilon_zeros.md``, sections 1 and 2.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.compliant.slow_signs import CELL, SlowSigns
from gspot_verified.signs.pieces import Column, Kind, Piece, number_of_zeros
from gspot_verified.signs.zero_column import cover, right_tail

_MAX_REACH = 256


def slow_zero_column(
    signs: SlowSigns, lower: fmpq, upper: fmpq, n: int, least: fmpq, changes: tuple[int, ...] = (0, 1)
) -> Column | None:
    """A column of certain pieces over beta in [lower, upper], n + 1 <= beta <= n + 2, or None.

    ``changes``: how many zeros may stay in the right tail, in the order of preference; ``least``: the narrowest piece.
    """
    left = left_end(signs, n)
    if left is None:
        return None
    for tail in changes:
        right = _right(signs, n, tail)
        middle = cover(signs, left, right, least) if right is not None and left < right else None
        if right is not None and middle is not None:
            pieces = (Piece(Kind.LEFT, None, left), *middle, Piece(Kind.RIGHT, right, None, tail))
            column = Column(lower, upper, pieces)
            if number_of_zeros(column) is not None:
                return column
    return None


def left_end(signs: SlowSigns, n: int) -> fmpq | None:
    """A grid point up to which G_b > 0, or None."""
    k = 1
    while k * CELL <= _MAX_REACH:
        if signs.positive_before(-k * CELL, n):
            return -k * CELL
        k += max(1, k // 4)
    return None


def _right(signs: SlowSigns, n: int, tail: int) -> fmpq | None:
    """A grid point beyond which G_b has ``tail`` = 0 or 1 zeros, or None."""
    reach = fmpq(8)
    while reach <= _MAX_REACH:
        right = right_tail(signs, n, reach, tail)
        if right is not None:
            return right
        reach *= 2
    return None
