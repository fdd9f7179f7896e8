"""Polynomials that follow a slow manifold over many fast units. Heuristic: the norm step proves what they are worth.

Newton's method for dx/dτ = h f(x) in the coefficients of a polynomial on [0, 1]: the slow directions start where the
set is, the fast ones are free, so that no decaying part is resolved. Corrections in floats, residuals in balls.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb, arb_poly, arb_series, fmpz_poly
from numpy.typing import NDArray

from gspot_verified.integrator.box_steps.choice import log2_of
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.adapted_basis import Matrix, spectral_basis
from gspot_verified.integrator.norm_steps.taylor_recurrence import fixed
from gspot_verified.numbers.balls import approximate, series_length

_ITERATIONS = 10  # of Newton's method, against endless work
_FACTORISATIONS = 2  # after which the matrix is kept: it changes little
_NEGLIGIBLE = 1e-18  # relative size of a coefficient of J that is left out: below the last bit of a double
_GAIN_BITS = 8.0  # by which an iteration must lower the residual, or it was the last
FAST = 30.0  # eigenvalue times length from which on a direction is left to decay


@dataclass(frozen=True)
class SlowCurve:
    """``solution``: polynomials in τ; ``tail``: log2 of the last coefficients; ``start``: log2 of the distance from the
    states at the start; ``jacobian``: float coefficients of J along them."""

    solution: list[arb_poly]
    tail: float
    start: float
    jacobian: NDArray[np.float64]


def slow_curve(field: VectorField, middle: Sequence[arb], h: float, order: int, bits: int) -> SlowCurve | None:
    """The polynomials of degree ``order`` from near exact states, or None when Newton's method stalls.

    ``bits``: after the point.

    :raises NoSeriesError: the field has no Taylor series along a curve that was tried.
    :raises numpy.linalg.LinAlgError: a linear system has no solution in floats.
    """
    size, unit = len(middle), arb((1, -bits))
    values, rows = field.on_box(middle)
    spectral = spectral_basis([[approximate(entry) for entry in row] for row in rows], FAST / h)
    if spectral is None:
        return None
    basis, slow = spectral
    x = [[fixed(m, bits), fixed(h * v, bits)] + [0] * (order - 1) for m, v in zip(middle, values, strict=True)]
    start = [row[0] for row in x]
    solver: _Solver | None = None
    jacobian = np.zeros((order + 1, size, size))
    last = float("inf")
    for count in range(_ITERATIONS):
        polynomials = [arb_poly(fmpz_poly(row)) * unit for row in x]
        series = [arb_series(p.coeffs(), order + 1) for p in polynomials]
        with series_length(order + 1):
            if count < _FACTORISATIONS:
                rates, entries = field.series_with_jacobian(series)
                jacobian = _coefficients(entries, order)
                solver = _Solver(jacobian, basis, slow, h)
            else:
                rates = field.series(series)
        residuals = [
            [*(arb_poly(f.coeffs()) * h - p.derivative()).coeffs()] for f, p in zip(rates, polynomials, strict=True)
        ]
        gap = [(a - row[0]) * unit for a, row in zip(start, x, strict=True)]
        level = max(max(map(log2_of, row), default=-1e9) for row in residuals)
        if not math.isfinite(level):
            return None
        if count > 1 and level > last - _GAIN_BITS:
            break
        last = level
        assert solver is not None
        moves = solver.moves(residuals, gap, level, order)
        for i, column in enumerate(_scaled(moves.T, bits + round(level))):
            x[i] = [value + move for value, move in zip(x[i], column, strict=True)]
    solution = [arb_poly(fmpz_poly(row)) * unit for row in x]
    tail = max(abs(row[k]).bit_length() for row in x for k in (order - 1, order)) - bits
    distance = max(abs(a - row[0]).bit_length() for a, row in zip(start, x, strict=True)) - bits
    return SlowCurve(solution, float(tail), float(distance), jacobian)


class _Solver:
    """δ' - h J(τ) δ = r in coefficients, with the slow coordinates of δ(0) given and the fast ones free.

    The unknowns stand by degree, the start of the slow coordinates before all equations: so the entries fill a band as
    wide as the degree of J. LAPACK's routines for bands are faster than a full LU, and leave other cores alone.

    :raises numpy.linalg.LinAlgError: an equation whose coefficients are all 0, or one is not finite.
    """

    def __init__(self, jacobian: NDArray[np.float64], basis: Matrix, slow: NDArray[np.bool_], h: float) -> None:
        length, size, _ = jacobian.shape
        self._basis, self._inverse, self._slow = basis, np.linalg.inv(basis), slow
        turned = h * np.einsum("ij,kjl,lm->kim", self._inverse, jacobian, basis)
        table = np.zeros((length, size, length, size))
        each = np.arange(length)
        seen = np.flatnonzero(np.abs(turned).max(axis=(1, 2)) > _NEGLIGIBLE * np.abs(turned).max())
        for j in seen:
            table[each[j:], :, each[: length - j], :] -= turned[j]
        table[each[:-1], :, each[1:], :] += each[1:, None, None] * np.eye(size)
        self._kept = np.concatenate([np.ones((length - 1) * size, dtype=bool), np.logical_not(slow)])
        flat = np.concatenate([np.eye(size, length * size)[slow], table.reshape(length * size, -1)[self._kept]])
        largest = np.abs(flat).max(axis=1)
        if not (np.isfinite(largest) & (largest >= np.finfo(float).tiny)).all():
            raise np.linalg.LinAlgError("an equation without a coefficient, or with one that is not finite")
        self._scale = 1 / largest
        given = int(slow.sum())
        below = min(int(seen.max(initial=0)) * size + size - 1 + given, length * size - 1)
        self._band = _Band(flat * self._scale[:, None], below, size - given)

    def moves(self, residuals: list[list[arb]], gap: list[arb], level: float, order: int) -> Matrix:
        """The corrections of the coefficients, by degree and component, in units of 2^level.

        :raises numpy.linalg.LinAlgError: one is not finite.
        """
        unit = arb((1, -round(level)))
        size = len(gap)
        right = np.zeros((order + 1, size))
        for i, row in enumerate(residuals):
            for k, value in enumerate(row[: order + 1]):
                right[k, i] = approximate(value * unit)
        right = np.dot(right, self._inverse.T)
        start = np.dot(self._inverse, np.array([approximate(value * unit) for value in gap]))
        ordered = np.concatenate([start[self._slow], right.ravel()[self._kept]])
        corrections: Matrix = np.dot(self._band.solve(ordered * self._scale).reshape(order + 1, size), self._basis.T)
        if not np.isfinite(corrections).all():
            raise np.linalg.LinAlgError("a correction is not finite")
        return corrections


class _Band:
    """The factors of a matrix with entries in so many diagonals below and above the main one.

    :raises numpy.linalg.LinAlgError: the matrix is singular.
    """

    def __init__(self, matrix: Matrix, below: int, above: int) -> None:
        from scipy.linalg.lapack import dgbtrf

        self._widths = below, above
        stored = np.zeros((2 * below + above + 1, len(matrix)))
        for offset in range(-above, below + 1):
            entries = np.diagonal(matrix, -offset)
            first = max(-offset, 0)
            stored[below + above + offset, first : first + len(entries)] = entries
        self._factors, self._pivots, failure = dgbtrf(stored, below, above)
        if failure:
            raise np.linalg.LinAlgError("singular")

    def solve(self, right: NDArray[np.float64]) -> NDArray[np.float64]:
        """The solution for one right-hand side."""
        from scipy.linalg.lapack import dgbtrs

        solution: NDArray[np.float64] = dgbtrs(self._factors, *self._widths, right, self._pivots)[0]
        return solution


def _coefficients(entries: list[list[arb_series]], order: int) -> NDArray[np.float64]:
    coefficients = np.zeros((order + 1, len(entries), len(entries)))
    for i, row in enumerate(entries):
        for j, entry in enumerate(row):
            for k, value in enumerate(entry.coeffs()[: order + 1]):
                coefficients[k, i, j] = approximate(value)
    return coefficients


def _scaled(values: Matrix, shift: int) -> list[list[int]]:
    """Integers near values * 2^shift."""
    mantissas, exponents = np.frexp(values)
    wholes, moves = (
        (mantissas * 2.0**53).astype(np.int64).tolist(),
        (exponents.astype(np.int64) + (shift - 53)).tolist(),
    )
    return [
        [whole << more if more >= 0 else whole >> -more for whole, more in zip(*rows, strict=True)]
        for rows in zip(wholes, moves, strict=True)
    ]
