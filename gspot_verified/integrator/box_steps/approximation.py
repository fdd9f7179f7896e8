"""Approximate Taylor coefficients of a solution and of its derivatives with respect to the initial value. Heuristic.

Newton's method on power series, doubling the length: with Y' = J Y, Y(0) = I along the current curve x, the correction
of x is Y ∫ Y⁻¹ (f(x) - x'). Nothing here is a bound; what is found is checked afterwards.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_series

from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import series_length

Series = list[arb_series]
Coefficients = list[list[arb]]


def taylor(field: VectorField, point: Sequence[arb], order: int) -> tuple[Coefficients, list[Coefficients]]:
    """Exact balls near the Taylor coefficients 0..order of the solution through ``point``, by component, and those of
    the derivative matrix up to about half that order, by row and column.
    """
    size = field.dimension
    lengths = [order + 1]
    while lengths[-1] > 1:
        lengths.append((lengths[-1] + 1) // 2)
    x = [arb_series([value.mid()], 1) for value in point]
    flow, inverse = _identity(size), _identity(size)
    for length in lengths[-2::-1]:
        x = _corrected(field, x, flow, inverse, length)
        if length < order + 1:
            flow, inverse = _flow(field, x, flow, inverse, length)
    return [_midpoints(curve, order + 1) for curve in x], [
        [_midpoints(entry, lengths[min(1, len(lengths) - 1)]) for entry in row] for row in flow
    ]


def _corrected(field: VectorField, x: Series, flow: list[Series], inverse: list[Series], length: int) -> Series:
    with series_length(length):
        x = [_exact(curve, length) for curve in x]
        rest = [f - curve.derivative() for f, curve in zip(field.series(x), x, strict=True)]
        turned = [entry.integral() for entry in _times(_longer(inverse, length), rest)]
        moves = _times(_longer(flow, length), turned)
        return [_exact(curve + move, length) for curve, move in zip(x, moves, strict=True)]


def _flow(
    field: VectorField, x: Series, flow: list[Series], inverse: list[Series], length: int
) -> tuple[list[Series], list[Series]]:
    with series_length(length):
        _, jacobian = field.series_with_jacobian(x)
        flow, inverse = _longer(flow, length), _longer(inverse, length)
        columns, turned = _columns(flow), []
        for column in columns:
            rest = [g - entry.derivative() for g, entry in zip(_times(jacobian, column), column, strict=True)]
            move = _times(flow, [entry.integral() for entry in _times(inverse, rest)])
            turned.append([_exact(a + b, length) for a, b in zip(column, move, strict=True)])
        flow = _columns(turned)
        rows = []
        for row in inverse:  # W <- W + W (I - V W) = 2 W - W V W
            product = _times(_columns(flow), row)
            again = _times(_columns(inverse), product)
            rows.append([_exact(2 * row[j] - again[j], length) for j in range(len(row))])
        return flow, rows


def _times(rows: Sequence[Series], vector: Series) -> Series:
    product = []
    for row in rows:
        total = row[0] * vector[0]
        for entry, value in zip(row[1:], vector[1:], strict=True):
            total = total + entry * value
        product.append(total)
    return product


def _columns(rows: Sequence[Series]) -> list[Series]:
    return [list(column) for column in zip(*rows, strict=True)]


def _identity(size: int) -> list[Series]:
    return [[arb_series([int(i == j)], 1) for j in range(size)] for i in range(size)]


def _longer(rows: Sequence[Series], length: int) -> list[Series]:
    return [[_exact(entry, length) for entry in row] for row in rows]


def _exact(series: arb_series, length: int) -> arb_series:
    return arb_series([value.mid() for value in series.coeffs()], length)


def _midpoints(series: arb_series, length: int) -> list[arb]:
    midpoints = [value.mid() for value in series.coeffs()]
    return midpoints + [arb(0)] * (length - len(midpoints))
