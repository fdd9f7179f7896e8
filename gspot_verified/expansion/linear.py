"""A linear system over any ring whose numbers can be divided: Gaussian elimination with certain pivots."""

from __future__ import annotations

from typing import Any

from gspot_verified.expansion.rings import Ring


def solve(matrix: list[list[Any]], right: list[Any], ring: Ring) -> list[Any]:
    """The solution of matrix x = right.

    :raises ZeroDivisionError: no pivot is certainly nonzero: the matrix is singular, or not certainly regular.
    """
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    size = len(rows)
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
    return [row[size] for row in rows]
