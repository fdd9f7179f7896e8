"""The inverse of a matrix over any ring whose numbers can be divided: elimination with certain pivots."""

from __future__ import annotations

from typing import Any

from gspot_verified.expansion.rings import Ring


def inverse(matrix: list[list[Any]], ring: Ring) -> list[list[Any]]:
    """The inverse matrix.

    :raises ZeroDivisionError: no pivot is certainly nonzero: the matrix is singular, or not certainly regular.

    >>> from flint import fmpq
    >>> from gspot_verified.expansion.rings import RATIONALS
    >>> inverse([[fmpq(0), fmpq(2)], [fmpq(1), fmpq(0)]], RATIONALS)
    [[0, 1], [1/2, 0]]
    """
    size = len(matrix)
    rows = [[*row, *(ring.number(int(i == j)) for j in range(size))] for i, row in enumerate(matrix)]
    for j in range(size):
        pivot = next((i for i in range(j, size) if ring.is_nonzero(rows[i][j])), None)
        if pivot is None:
            raise ZeroDivisionError("the matrix is singular")
        rows[j], rows[pivot] = rows[pivot], rows[j]
        rows[j] = [value / rows[j][j] for value in rows[j]]
        for i in range(size):
            if i != j and not ring.is_zero(rows[i][j]):
                factor = rows[i][j]
                rows[i] = [value - factor * own for value, own in zip(rows[i], rows[j], strict=True)]
    return [row[size:] for row in rows]
