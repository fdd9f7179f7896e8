"""Theta at one rational beta and many doubles tau: grouped by panel, each panel's series evaluated at all its points.

Proof pages: ``proofs/local_series.md``, ``proofs/float_horner.md``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate, bits_for_digits, relative_bits, working_bits
from gspot_verified.theta_function.arrays.float_balls import float_balls
from gspot_verified.theta_function.arrays.float_horner import (
    FloatArray,
    IndexArray,
    accepted,
    arithmetic_is_ieee,
    float_polynomial,
    horner,
)
from gspot_verified.theta_function.arrays.panels import COARSE, FARTHEST, Layout, is_tame, layout, panel
from gspot_verified.theta_function.sums.taylor import taylor_values
from gspot_verified.theta_function.value import choice
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.routes import shifted_parameter

DOUBLE_DIGITS = 15
"""The relative accuracy that doubles can hold with a bound."""

_DOUBLE_GOAL = 56  # bits of a panel's series: a few more than a double has
_GUARD = 12  # bits beyond those asked for, lost on the way; any number is right
# With fewer points in a panel one value after the other costs less than the panel's series.
_LEAST_POINTS = 3
_MANY_POINTS = 10_000  # from which on short panels are worth their series
_FARTHEST_OF_ONE_POLYNOMIAL = 10.0  # |tau| up to which one series at 0 loses few digits; any number is right
_POINTS_OF_A_PANEL = 40  # that cost as much as the panel's series; any number is right
_MOST_BITS = 1_200  # beyond them panels cost more than they save; any number is right
_RELATIVE = 0.999e-15  # a little below 10^-15, for what the comparison itself rounds

BoolArray = np.ndarray[Any, np.dtype[np.bool_]]


class _Cover(NamedTuple):
    """The panels of one beta as arrays: where they lie."""

    cells: IndexArray
    numbers: IndexArray
    counts: IndexArray
    centres: FloatArray
    inverses: FloatArray
    counts_of_cells: IndexArray
    first_of_cells: IndexArray


@lru_cache(maxsize=64)
def _cover(chosen: Layout) -> _Cover:
    per_cell = np.array(chosen.counts, dtype=np.intp)
    first = np.concatenate(([0], np.cumsum(per_cell)[:-1]))
    cells = np.repeat(np.arange(len(per_cell)), per_cell)
    counts, numbers = per_cell[cells], np.arange(len(cells)) - first[cells]
    centres = (cells - FARTHEST) + (2 * numbers + 1) / (2 * counts)  # dyadic, exact
    inverses = (2 * counts).astype(np.float64)
    return _Cover(cells - FARTHEST, numbers, counts, centres, inverses, per_cell, first)


def _locate(points: FloatArray, cover: _Cover) -> IndexArray:
    """The panel of each point; -1 where there is none. A wrong one would be found out by :func:`accepted`."""
    inside = np.abs(points) < FARTHEST
    below = np.floor(np.where(inside, points, 0.0))
    cell = below.astype(np.intp) + FARTHEST
    count = cover.counts_of_cells.take(cell)
    number = np.minimum(((points - below) * count).astype(np.intp, casting="unsafe"), count - 1)
    return np.where(inside, cover.first_of_cells.take(cell) + number, -1)


def _used(panels: IndexArray, total: int) -> IndexArray:
    """The panels that hold enough points."""
    return np.flatnonzero(np.bincount(panels[panels >= 0], minlength=total) >= _LEAST_POINTS)


def float_batch(points: FloatArray, beta: fmpq, derivative: int) -> tuple[FloatArray, FloatArray]:
    """Midpoints and radii of d^k Theta/dtau^k at every point, relative radius 10^-15 where doubles reach it.

    Where the panel's series does not reach it in doubles (next to a zero), the same series is evaluated in balls, and
    after that :func:`gspot_verified.theta_function.value.evaluate.evaluate` is asked.
    """
    if _vanishes(beta, derivative):
        return np.zeros_like(points), np.zeros_like(points)
    middles, radii = np.zeros_like(points), np.full_like(points, np.inf)
    left: IndexArray = np.arange(len(points))
    if is_tame(beta) and len(points) >= _LEAST_POINTS and arithmetic_is_ieee():
        cover = _cover(layout(math.ceil(abs(approximate(beta)))))
        panels = _locate(points, cover)
        used = _used(panels, len(cover.cells))
        if _one_polynomial_pays(points, len(used)):
            middles, radii = float_balls(_by_one_polynomial(points, beta, derivative, bits_for_digits(DOUBLE_DIGITS)))
            left = np.flatnonzero(np.logical_not(radii <= _RELATIVE * np.abs(middles)))
        elif len(used):
            left = _in_doubles(points, panels, used, cover, (beta, derivative), (middles, radii))
    if len(left):
        enclosures = list(_in_balls(points, left, beta, derivative, DOUBLE_DIGITS))
        places = np.array([index for index, _ in enclosures], dtype=np.intp)
        middles[places], radii[places] = float_balls([value for _, value in enclosures])
    return middles, radii


def _in_doubles(
    points: FloatArray,
    panels: IndexArray,
    used: IndexArray,
    cover: _Cover,
    function: tuple[fmpq, int],
    results: tuple[FloatArray, FloatArray],
) -> IndexArray:
    """Fill what doubles reach; the indices of the points that are left."""
    series = [_float_panel(*function, *_place(cover, i)) for i in used]
    length = max(1, *(len(polynomial.coefficients) for polynomial in series))
    table = np.zeros((length, len(used)))
    for column, polynomial in enumerate(series):
        table[: len(polynomial.coefficients), column] = polynomial.coefficients
    errors = np.array([polynomial.error for polynomial in series])
    compact = np.full(len(cover.cells) + 1, -1, dtype=np.intp)
    compact[used] = np.arange(len(used))
    column_of = compact[panels]  # panel -1 is the last entry
    all_used = bool((column_of >= 0).all())
    chosen = np.arange(len(points)) if all_used else np.flatnonzero(column_of >= 0)
    columns = column_of if all_used else column_of[chosen]
    there = points if all_used else points[chosen]
    values, sizes = horner(there, columns, cover.centres[used], cover.inverses[used], table)
    bounds = errors.take(columns)
    good = accepted(sizes) & (bounds <= _RELATIVE * np.abs(values))
    if all_used and good.all():
        results[0][:], results[1][:] = values, bounds
        return np.empty(0, dtype=np.intp)
    results[0][chosen[good]], results[1][chosen[good]] = values[good], bounds[good]
    rest = np.ones(len(points), dtype=np.bool_)
    rest[chosen[good]] = False
    return np.flatnonzero(rest)


def _place(cover: _Cover, index: int) -> tuple[int, int, int]:
    return int(cover.cells[index]), int(cover.numbers[index]), int(cover.counts[index])


@lru_cache(maxsize=4_096)
def _float_panel(beta: fmpq, derivative: int, cell: int, number: int, count: int) -> Any:
    series = panel(beta, derivative, cell, number, count, _DOUBLE_GOAL)
    return float_polynomial(series.polynomial)


def ball_batch(points: FloatArray, beta: fmpq, derivative: int, digits: int) -> list[arb]:
    """Balls of d^k Theta/dtau^k at every point with relative accuracy 10^-digits."""
    enclosures: list[arb] = [arb(0)] * len(points)
    if _vanishes(beta, derivative):
        return enclosures
    for index, value in _in_balls(points, np.arange(len(points)), beta, derivative, digits):
        enclosures[index] = value
    return enclosures


def _vanishes(beta: fmpq, derivative: int) -> bool:
    """Theta is a polynomial of degree beta, and all of it is differentiated away."""
    return bool(beta.q == 1 and 0 <= beta < derivative)


def _in_balls(
    points: FloatArray, indices: IndexArray, beta: fmpq, derivative: int, digits: int
) -> Iterator[tuple[int, arb]]:
    """(index, ball) for each of the indices."""
    goal = bits_for_digits(digits)
    rest = [indices]
    shared = is_tame(beta) and len(indices) >= _LEAST_POINTS and goal <= _MOST_BITS
    if shared and _one_polynomial_pays(points[indices], 0):
        again = []
        for index, value in zip(
            indices.tolist(), _by_one_polynomial(points[indices], beta, derivative, goal), strict=True
        ):
            if relative_bits(value) >= goal:
                yield index, value
            else:
                again.append(index)
        rest = [np.array(again, dtype=np.intp)]
    elif shared:
        cover = _cover(COARSE if len(indices) < _MANY_POINTS else layout(math.ceil(abs(approximate(beta)))))
        panels = _locate(points[indices], cover)
        order = np.argsort(panels, kind="stable")
        used = _used(panels, len(cover.cells))
        starts = np.searchsorted(panels[order], used, side="left")
        ends = np.searchsorted(panels[order], used, side="right")
        rest = [indices[np.isin(panels, used, invert=True)]]
        for place, start, end in zip(used, starts, ends, strict=True):
            there = indices[order[start:end]]
            at = _place(cover, place)
            inside = accepted(np.abs((points[there] - cover.centres[place]) * cover.inverses[place]))
            rest.append(there[np.logical_not(inside)])
            series = panel(beta, derivative, *at, goal + _GUARD)
            again = []
            numbers = there[inside].tolist()
            for index, value in zip(numbers, _at_points(series, points[there[inside]], goal), strict=True):
                if relative_bits(value) >= goal:
                    yield index, value
                else:
                    again.append(index)
            rest.append(np.array(again, dtype=np.intp))
    for index in np.concatenate(rest).tolist():
        yield index, evaluate(fmpq(*float(points[index]).as_integer_ratio()), beta, derivative, digits).value


def _one_polynomial_pays(points: FloatArray, panels: int) -> bool:
    """Whether the Taylor polynomial at 0 costs less than that many panels; 0: than about as many as are likely."""
    farthest = float(np.abs(points).max())
    likely = panels or int(farthest) + 1
    return farthest <= _FARTHEST_OF_ONE_POLYNOMIAL and len(points) < _POINTS_OF_A_PANEL * likely


def _by_one_polynomial(points: FloatArray, beta: fmpq, derivative: int, goal: int) -> list[arb]:
    """Balls from one Taylor polynomial at 0 and one bound on its rest."""
    farthest = float(np.abs(points).max())
    shifted, factor = shifted_parameter(beta, derivative, goal)
    assert isinstance(shifted, fmpq)
    sign = -1.0 if float(points.min()) < 0 else 1.0
    plan = choice.taylor_plan(sign * farthest, approximate(shifted), goal + _GUARD)
    values = taylor_values(points.tolist(), farthest, shifted, plan.length, plan.bits)
    if derivative:
        with working_bits(plan.bits):
            values = [value * factor for value in values]
    return values


def _at_points(series: Any, points: FloatArray, goal: int) -> list[arb]:
    with working_bits(goal + _GUARD + 20):
        polynomial, centre = series.polynomial, arb(series.centre)
        inverse = int((1 / series.half_width).p)
        return [polynomial((arb(point) - centre) * inverse) for point in points.tolist()]
