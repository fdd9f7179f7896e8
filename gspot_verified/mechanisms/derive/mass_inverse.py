"""The inverse of a symmetric positive definite matrix of expressions, without writing its entries out.

Up to three rows by minors: one denominator, the determinant. Above by M = L D L^T with unit lower triangular L: the
pivots D are quotients of leading minors, so none vanishes where M is positive definite. On a wide box an enclosure
of the determinant or of a pivot may contain 0: then the enclosure of the whole is not finite.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpq

from gspot_verified.functions.derivative import ONE, ZERO
from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.formulas.simplify import constant, power_of, product_of, sum_of

Row = Sequence[Expression]
_BY_MINORS = 3  # up to this size the inverse is adjugate over determinant, which is the shorter formula


class SingularMatrixError(ValueError):
    """The matrix has no inverse of this form for any state."""


class MassInverse:
    """M^-1 for a symmetric M.

    :raises SingularMatrixError: the determinant or a pivot is the zero function.

    >>> from gspot_verified.functions.expressions import Variable
    >>> two = constant(2)
    >>> MassInverse([[two, ZERO], [ZERO, two]]).form([ONE, ONE], [ONE, Variable(0)])
    Sum(terms=(Product(left=Constant(value=1/2), right=Variable(index=0)), Constant(value=1/2)))
    """

    def __init__(self, rows: Sequence[Row]) -> None:
        self._size = len(rows)
        if self._size <= _BY_MINORS:
            self._adjugate = _adjugate(rows)
            determinant = minor(rows, range(self._size), range(self._size))
            if determinant is ZERO:
                raise SingularMatrixError("the mass matrix is singular")
            self._scale: Expression = power_of(determinant, fmpq(-1))
        else:
            self._lower, self._pivots = _eliminated(rows)

    def times(self, right: Row) -> list[Expression]:
        """M^-1 times a vector."""
        if self._size <= _BY_MINORS:
            return [product_of(_dot(row, right), self._scale) for row in self._adjugate]
        solution = [product_of(part, inverse) for part, inverse in zip(self._forward(right), self._pivots, strict=True)]
        for i in reversed(range(self._size)):
            later = [_minus(self._lower[j][i], solution[j]) for j in range(i + 1, self._size)]
            solution[i] = sum_of(solution[i], *later)
        return solution

    def form(self, left: Row, right: Row) -> Expression:
        """left^T M^-1 right."""
        if self._size <= _BY_MINORS:
            return product_of(_dot(left, [_dot(row, right) for row in self._adjugate]), self._scale)
        pairs = zip(self._forward(left), self._forward(right), self._pivots, strict=True)
        return sum_of(*(product_of(a, b, inverse) for a, b, inverse in pairs))

    def _forward(self, right: Row) -> list[Expression]:
        """L^-1 times a vector."""
        solution: list[Expression] = []
        for i, part in enumerate(right):
            solution.append(sum_of(part, *(_minus(self._lower[i][j], solution[j]) for j in range(i))))
        return solution


def _eliminated(rows: Sequence[Row]) -> tuple[list[list[Expression]], list[Expression]]:
    """L below its diagonal, and the inverses of the pivots."""
    lower: list[list[Expression]] = []
    pivots: list[Expression] = []
    inverses: list[Expression] = []
    for i, row in enumerate(rows):
        scaled: list[Expression] = []  # L_ij D_j
        for j in range(i):
            scaled.append(sum_of(row[j], *(_minus(scaled[k], lower[j][k]) for k in range(j))))
        lower.append([product_of(part, inverse) for part, inverse in zip(scaled, inverses, strict=True)])
        pivot = sum_of(row[i], *(_minus(scaled[k], lower[i][k]) for k in range(i)))
        if pivot is ZERO:
            raise SingularMatrixError("the mass matrix is singular, or a leading minor of it")
        pivots.append(pivot)
        inverses.append(power_of(pivot, fmpq(-1)))
    return lower, inverses


def _adjugate(rows: Sequence[Row]) -> list[list[Expression]]:
    size = len(rows)
    others = [[k for k in range(size) if k != i] for i in range(size)]
    return [
        [product_of(constant((-1) ** (i + j)), minor(rows, others[j], others[i])) for j in range(size)]
        for i in range(size)
    ]


def minor(rows: Sequence[Row], over: Sequence[int], columns: Sequence[int]) -> Expression:
    """The determinant of the chosen rows and columns, by Laplace's expansion.

    >>> minor([[constant(1), constant(2)], [constant(3), constant(4)]], (0, 1), (0, 1))
    Constant(value=-2)
    """
    if not over:
        return ONE
    terms = []
    for k, column in enumerate(columns):
        entry = rows[over[0]][column]
        if entry is not ZERO:
            rest = minor(rows, over[1:], [other for other in columns if other != column])
            terms.append(product_of(constant((-1) ** k), entry, rest))
    return sum_of(*terms)


def _dot(left: Row, right: Row) -> Expression:
    return sum_of(*(product_of(a, b) for a, b in zip(left, right, strict=True)))


def _minus(left: Expression, right: Expression) -> Expression:
    return product_of(constant(-1), left, right)
