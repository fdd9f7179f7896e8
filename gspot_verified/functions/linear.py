"""Linear equations over any ring whose numbers can be divided: a small matrix, and one with two diagonals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import fmpq, fmpq_poly, fmpz, fmpz_poly

from gspot_verified.functions.rings import Rationals, Ring


def inverse(matrix: list[list[Any]], ring: Ring) -> list[list[Any]]:
    """The inverse matrix.

    :raises ZeroDivisionError: no pivot is certainly nonzero: the matrix is singular, or not certainly regular.

    >>> from flint import fmpq
    >>> from gspot_verified.functions.rings import RATIONALS
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


def solve_from_above(right: Any, diagonal: Sequence[Any], above: Sequence[Any], ring: Ring) -> Any:
    """The polynomial with diagonal_i c_i + above_i c_(i+1) = right_i for its coefficients, and none beyond the last.

    No number of ``diagonal`` is 0; there are as many as coefficients are asked for.

    >>> from gspot_verified.functions.rings import RATIONALS
    >>> solve_from_above(fmpq_poly([5, 6]), [fmpq(1), fmpq(2)], [fmpq(1, 2), fmpq(7)], RATIONALS)
    3*x + 7/2
    """
    if isinstance(ring, Rationals):
        return _solve_in_integers(right, diagonal, above)
    values = right.coeffs()
    values += [ring.number(0)] * (len(diagonal) - len(values))
    coefficients: list[Any] = []
    last = ring.number(0)
    for value, factor, coupling in zip(reversed(values), reversed(diagonal), reversed(above), strict=True):
        last = (value - coupling * last) / factor
        coefficients.append(last)
    return ring.polynomial(coefficients[::-1])


def _solve_in_integers(right: fmpq_poly, diagonal: Sequence[fmpq], above: Sequence[fmpq]) -> fmpq_poly:
    """c_i = x_i/(d q_i) with q_i = diagonal_i q_(i+1) and d the denominator of the right side: no fraction is reduced.

    The equation times q_(i+1) is x_i + above_i x_(i+1) = right_i d q_(i+1), once the diagonals are integers.
    """
    unit = fmpz(1)
    for value in (*diagonal, *above):
        unit = unit.lcm(value.q)
    numerator = right.numer() * unit
    q, x = fmpz(1), fmpz(0)
    solved: list[tuple[fmpz, fmpz]] = []
    for i in range(len(diagonal) - 1, -1, -1):
        x = numerator[i] * q - (above[i] * unit).p * x
        q = q * (diagonal[i] * unit).p
        solved.append((x, q))
    return fmpq_poly(fmpz_poly([x * (q // own) for x, own in reversed(solved)]), right.denom() * q)
