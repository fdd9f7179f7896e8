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
from gspot_verified.theta_function.arrays.double_double import double_double_horner, one_double
from gspot_verified.theta_function.arrays.float_balls import float_balls
from gspot_verified.theta_function.arrays.float_horner import (
    BLOCK,
    FloatArray,
    IndexArray,
    accepted,
    arithmetic_is_ieee,
    horner,
    near_bounds,
)
from gspot_verified.theta_function.arrays.kept_panels import (
    FARTHEST_OF_ONE_POLYNOMIAL,
    GOAL,
    KeptPanels,
    kept_panels,
)
from gspot_verified.theta_function.arrays.panels import (
    COARSE,
    FARTHEST,
    FINE,
    Layout,
    is_tame,
    layout,
    panel,
)
from gspot_verified.theta_function.sums.taylor import taylor_values
from gspot_verified.theta_function.value import choice
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.routes import shifted_parameter

DOUBLE_DIGITS = 15
"""The relative accuracy that doubles can hold with a bound."""

_GUARD = 12  # bits beyond those asked for, lost on the way; any number is right
# With fewer points in a panel one value after the other costs less than the panel's series.
_LEAST_POINTS = 3
_MANY_POINTS = 10_000  # from which on short panels are worth their series
_POINTS_OF_A_PANEL = 40  # that cost as much as the panel's series; any number is right
_POINTS_OF_A_LONG_PANEL = 40  # the same in pairs of doubles
_LEAST_NEAR_ZEROS = 30  # points next to zeros from which on panels around these are worth their series
_LEAST_PAIRS = 150  # points that cost as much in balls as any number of them, at least, in pairs of doubles
_MOST_BITS = 1_200  # beyond them panels cost more than they save; any number is right
_RELATIVE = 0.999e-15  # a little below 10^-15, for what the comparison itself rounds

Results = tuple[FloatArray, FloatArray]


class _Cover(NamedTuple):
    """The panels of one beta as arrays: where they lie. ``uniform``: so many in each unit interval, if in all."""

    cells: IndexArray
    numbers: IndexArray
    counts: IndexArray
    centres: FloatArray
    inverses: FloatArray
    counts_of_cells: IndexArray
    first_of_cells: IndexArray
    uniform: int | None


@lru_cache(maxsize=64)
def _cover(chosen: Layout) -> _Cover:
    per_cell = np.array(chosen.counts, dtype=np.intp)
    first = np.concatenate(([0], np.cumsum(per_cell)[:-1]))
    cells = np.repeat(np.arange(len(per_cell)), per_cell)
    counts, numbers = per_cell[cells], np.arange(len(cells)) - first[cells]
    centres = (cells - FARTHEST) + (2 * numbers + 1) / (2 * counts)  # dyadic, exact
    inverses = (2 * counts).astype(np.float64)
    uniform = chosen.counts[0] if len(set(chosen.counts)) == 1 else None
    return _Cover(
        cells=cells - FARTHEST,
        numbers=numbers,
        counts=counts,
        centres=centres,
        inverses=inverses,
        counts_of_cells=per_cell,
        first_of_cells=first,
        uniform=uniform,
    )


def _locate(points: FloatArray, cover: _Cover) -> IndexArray:
    """The panel of each point; -1, or one beyond the cover, where there is none.

    A wrong one would be found out by :func:`accepted`.
    """
    if cover.uniform is not None:
        return np.floor(points * cover.uniform).astype(np.intp) + FARTHEST * cover.uniform
    inside = np.abs(points) < FARTHEST
    below = np.floor(np.where(inside, points, 0.0))
    cell = below.astype(np.intp) + FARTHEST
    count = cover.counts_of_cells.take(cell)
    number = np.minimum(((points - below) * count).astype(np.intp, casting="unsafe"), count - 1)
    return np.where(inside, cover.first_of_cells.take(cell) + number, -1)


def _used(panels: IndexArray, total: int) -> IndexArray:
    """The panels that hold enough points."""
    return np.flatnonzero(np.bincount(panels[(panels >= 0) & (panels < total)]) >= _LEAST_POINTS)


@np.errstate(all="ignore")  # what is not finite is left to balls, what underflows is in the bounds
def float_batch(points: FloatArray, beta: fmpq, derivative: int) -> tuple[FloatArray, FloatArray]:
    """Midpoints and radii of d^k Theta/dtau^k at every point, relative radius 10^-15 where doubles reach it.

    Where the panel's series does not reach it in doubles (next to a zero), it is evaluated in pairs of doubles, then in
    balls, and after that :func:`gspot_verified.theta_function.value.evaluate.evaluate` is asked.
    """
    if _vanishes(beta, derivative):
        return np.zeros_like(points), np.zeros_like(points)
    results = np.empty_like(points), np.empty_like(points)
    left: IndexArray
    if not (is_tame(beta) and len(points) >= _LEAST_POINTS and arithmetic_is_ieee()):
        left = np.arange(len(points))
    else:
        left = _in_doubles(points, kept_panels(int(beta.p), int(beta.q), derivative), results)
        if len(left) >= _LEAST_POINTS and np.abs(points[left]).max() <= FARTHEST_OF_ONE_POLYNOMIAL:
            values = _by_one_polynomial(points[left], beta, derivative, bits_for_digits(DOUBLE_DIGITS))
            left = _filled(results, left, *float_balls(values))
    if len(left):
        enclosures = list(_in_balls(points, left, beta, derivative, DOUBLE_DIGITS))
        places = np.array([index for index, _ in enclosures], dtype=np.intp)
        results[0][places], results[1][places] = float_balls([value for _, value in enclosures])
    return results


def _filled(results: Results, places: IndexArray, values: FloatArray, radii: FloatArray) -> IndexArray:
    """Fill in what is accurate enough; the other places."""
    good = radii <= _RELATIVE * np.abs(values)
    results[0][places[good]], results[1][places[good]] = values[good], radii[good]
    return places[np.logical_not(good)]


def _in_doubles(points: FloatArray, kept: KeptPanels, results: Results) -> IndexArray:
    """Fill what doubles reach with panels that are kept or worth it; the indices of the points that are left.

    What stands at those says nothing: it is to be filled in.
    """
    times = kept.asked(len(points))
    cells, fine = kept.worth(points, times)
    if not len(cells):
        return np.arange(len(points))
    cover = _cover(FINE if fine else kept.layout)
    first, table, errors = _tables(kept, cells, cover)
    part = slice(first, first + len(errors))
    centres, inverses = cover.centres[part], cover.inverses[part]
    missed = []
    for start in range(0, len(points), BLOCK):
        block = slice(start, start + BLOCK)
        panels = _locate(points[block], cover) - first
        values, bounds = results[0][block], results[1][block]
        sizes = horner(points[block], panels, centres, inverses, table, values)
        errors.take(panels, out=bounds, mode="clip")
        good = accepted(sizes) & (bounds <= _RELATIVE * np.abs(values))
        if not good.all():
            missed.append(start + np.flatnonzero(np.logical_not(good)))
    left = np.concatenate(missed) if missed else np.empty(0, dtype=np.intp)
    left = _around_zeros(points, left, kept, times, results)
    return _in_pairs_of_doubles(points, left, kept, times, results)


def _tables(kept: KeptPanels, cells: IndexArray, cover: _Cover) -> tuple[int, FloatArray, FloatArray]:
    """The number of the first panel, and coefficients and bounds from there on; infinite where no panel is used."""
    starts, counts = cover.first_of_cells[cells + FARTHEST].tolist(), cover.counts_of_cells[cells + FARTHEST].tolist()
    columns = [kept.columns(cell, count) for cell, count in zip(cells.tolist(), counts, strict=True)]
    first, end = starts[0], starts[-1] + counts[-1]
    table = np.zeros((max(len(one.table) for one in columns), end - first))
    errors = np.full(end - first, np.inf)
    for start, count, one in zip(starts, counts, columns, strict=True):
        part = slice(start - first, start - first + count)
        table[: len(one.table), part], errors[part] = one.table, one.errors
    return first, table, errors


def _around_zeros(points: FloatArray, left: IndexArray, kept: KeptPanels, times: float, results: Results) -> IndexArray:
    """Fill what panels around zeros reach in doubles; the indices of the points that are left."""
    if len(left) * times < _LEAST_NEAR_ZEROS:
        return left
    cover = _cover(FINE)
    panels = _locate(points[left], cover)
    numbers, columns = np.unique(panels, return_inverse=True)
    inside = (numbers >= 0) & (numbers < len(cover.cells))
    if len(left) * times < _LEAST_NEAR_ZEROS * len(numbers) or not inside.all():
        return left
    around = kept.zero_panels(numbers)
    values = np.empty(len(left))
    sizes = horner(points[left], columns, around.centres, around.inverses, around.table, values)
    radii = near_bounds(sizes, around.constants.take(columns), around.slopes.take(columns))
    radii[np.logical_not(accepted(sizes))] = np.inf
    return _filled(results, left, values, radii)


def _in_pairs_of_doubles(
    points: FloatArray, left: IndexArray, kept: KeptPanels, times: float, results: Results
) -> IndexArray:
    """Fill what pairs of doubles reach in fine panels with enough points; the indices of the points that are left."""
    if len(left) < _LEAST_PAIRS:
        return left
    cover = _cover(FINE)
    panels = _locate(points[left], cover)
    numbers, columns, counts = np.unique(panels, return_inverse=True, return_counts=True)
    worth = (counts * times >= _POINTS_OF_A_LONG_PANEL) & (numbers >= 0) & (numbers < len(cover.cells))
    chosen = worth[columns]
    if np.count_nonzero(chosen) < _LEAST_PAIRS:
        return left
    columns = (np.cumsum(worth) - 1)[columns[chosen]]
    numbers, there = numbers[worth], left[chosen]
    series = [kept.long_column(*_place(cover, number)) for number in numbers]
    high, low = np.zeros((2, max(len(one.high) for one in series), len(series)))
    for column, one in enumerate(series):
        high[: len(one.high), column], low[: len(one.low), column] = one.high, one.low
    values, rests, sizes = double_double_horner(
        points[there], columns, cover.centres[numbers], cover.inverses[numbers], high, low
    )
    radii = one_double(rests, np.array([one.error for one in series]).take(columns))
    radii[np.logical_not(accepted(sizes))] = np.inf
    return np.concatenate([left[np.logical_not(chosen)], _filled(results, there, values, radii)])


def _place(cover: _Cover, index: int) -> tuple[int, int, int]:
    return int(cover.cells[index]), int(cover.numbers[index]), int(cover.counts[index])


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
    if shared and _one_polynomial_pays(points[indices]):
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
            series = panel(beta, derivative, *at, max(goal + _GUARD, GOAL))
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


def _one_polynomial_pays(points: FloatArray) -> bool:
    """Whether the Taylor polynomial at 0 costs less than as many panels as are likely."""
    farthest = float(np.abs(points).max())
    return farthest <= FARTHEST_OF_ONE_POLYNOMIAL and len(points) < _POINTS_OF_A_PANEL * (int(farthest) + 1)


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
