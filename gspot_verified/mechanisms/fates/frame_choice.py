"""Which orbits of the plane states are compared with: heuristics, any choice is correct.

They begin at the largest p of the range, where the orbits through its edge come from, and near the distinguished
trajectory, where the sign of C_1 changes.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from operator import itemgetter

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.fates.box_fate import Frame
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.reference import Reference, reference
from gspot_verified.mechanisms.fates.strip import region_of, strip
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide
from gspot_verified.numbers.balls import approximate

_MOST_ORBITS, _FEWEST_ORBITS = 20, 6  # at equal distances, before those that are added where the sign changes
_HALVINGS = 4  # of the distance between two orbits that end differently, beyond those of the cells
_SLICES = 64  # of the range of p
_BACK = 24  # steps of Runge and Kutta's method
_BEYOND = 1.02  # times the largest p of the range
_FRAMES, _APART = 3, 3  # the orbits begin at the largest p, a third of it, a ninth
_PARTS = (0.01, 0.05, 0.2)  # of the whole distance: where further orbits begin at both ends
_MARGIN = 2.0**-20  # by which the first slice begins below the orbits

Point = tuple[float, float]
Begun = tuple[Point, Reference]


def frames(
    plane: PlanarFlow, along: int, side: TrajectorySide, edge: Iterable[Sequence[arb]], cells: int
) -> tuple[Frame, ...]:
    """Orbits for a range of starts with these points of the plane on its edge, in frames from larger and larger p.

    ``cells``: the most along a side of the range; as many orbits suffice, or fewer.
    """
    points = []
    for states in edge:
        at = approximate(states[0]), approximate(states[1])
        p, b = _p_and_b(plane, at)
        if p > 0 and b < 0:
            points.append((at, p))
    if not points:
        return ()
    largest = _BEYOND * max(p for _, p in points)
    orbits = min(max(cells, _FEWEST_ORBITS), _MOST_ORBITS)
    tops = [largest / _APART**k for k in range(_FRAMES)]
    found = (
        _frame(plane, along, side, [each for each in points if each[1] < top], top, orbits) for top in reversed(tops)
    )
    return tuple(frame for frame in found if frame is not None)


def _frame(
    plane: PlanarFlow, along: int, side: TrajectorySide, points: Sequence[tuple[Point, float]], top: float, orbits: int
) -> Frame | None:
    begin = _starts(plane, along, points, top, orbits)
    found: list[Begun] = []
    for point in begin:
        orbit = reference(plane, along, side, [arb(value) for value in point])
        if orbit is not None:
            found.append((point, orbit))
    depth = _HALVINGS + orbits.bit_length()
    for one, other in list(itertools.pairwise(found)):
        found += _refined(plane, along, side, one, other, depth)
    found.sort(key=lambda each: each[0][along])
    return _framed(plane, side, [orbit for _, orbit in found])


def _refined(plane: PlanarFlow, along: int, side: TrajectorySide, one: Begun, other: Begun, depth: int) -> list[Begun]:
    """Orbits between two that end differently, nearer and nearer to where that changes."""
    if depth == 0 or _kind(one[1]) == _kind(other[1]):
        return []
    point = _middle(one[0], other[0])
    orbit = reference(plane, along, side, [arb(value) for value in point])
    if orbit is None:
        return []
    middle = point, orbit
    before = _refined(plane, along, side, one, middle, depth - 1)
    return [*before, middle, *_refined(plane, along, side, middle, other, depth - 1)]


def _kind(orbit: Reference) -> tuple[int, bool]:
    """The sign of C_1, and whether b seems to rise through 0 on the way."""
    heights = [approximate(orbit.plane.p_and_b.values(list(segment.after.middle))[1]) for segment in orbit.segments]
    return orbit.sign, any(a < 0 < b for a, b in itertools.pairwise(heights))


def _middle(one: Point, other: Point) -> Point:
    return (one[0] + other[0]) / 2, (one[1] + other[1]) / 2


def _starts(
    plane: PlanarFlow, along: int, points: Sequence[tuple[Point, float]], top: float, orbits: int
) -> list[Point]:
    """Points with nearly this p on the orbits through the given ones (which have their p), in the order of places."""
    rate = BoxProgram(plane.by_log_p.functions, 2)
    back = [_back(rate, point, math.log(top / p)) for point, p in points]
    known = sorted((point for point in back if point is not None), key=itemgetter(along))
    chosen = [known[round(k * (len(known) - 1) / (orbits - 1))] for k in range(orbits)] if known else []
    distinct = [point for point, _ in itertools.groupby(chosen)]
    if len(distinct) < 2:
        return distinct
    low, high = distinct[0], distinct[-1]
    return [_on(high, low, part) for part in _PARTS[::-1]] + distinct + [_on(low, high, part) for part in _PARTS]


def _on(one: Point, other: Point, part: float) -> Point:
    """Beyond the other point, by this part of the distance."""
    return other[0] + part * (other[0] - one[0]), other[1] + part * (other[1] - one[1])


def _p_and_b(plane: PlanarFlow, point: Sequence[float]) -> tuple[float, float]:
    p, b = plane.p_and_b.values([arb(value) for value in point])
    return approximate(p), approximate(b)


def _back(rate: BoxProgram, point: Sequence[float], time: float) -> Point | None:
    h = -time / _BACK
    at = list(point)

    def slope(where: Sequence[float]) -> list[float]:
        return [approximate(value) for value in rate.values([arb(value) for value in where])]

    for _ in range(_BACK):
        first = slope(at)
        second = slope([x + h / 2 * v for x, v in zip(at, first, strict=True)])
        third = slope([x + h / 2 * v for x, v in zip(at, second, strict=True)])
        fourth = slope([x + h * v for x, v in zip(at, third, strict=True)])
        moves = zip(at, first, second, third, fourth, strict=True)
        at = [x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in moves]
        if not all(math.isfinite(value) for value in at):
            return None
    return at[0], at[1]


def _framed(plane: PlanarFlow, side: TrajectorySide, orbits: Sequence[Reference]) -> Frame | None:
    if len(orbits) < 2:
        return None
    first = arb(min(approximate(orbit.start) for orbit in orbits) * (1 - _MARGIN))
    last = arb(max(approximate(orbit.end) for orbit in orbits) * (1 + _MARGIN))
    ordered = [orbits[0]]
    for orbit in orbits[1:]:
        if ordered[-1].place(first) < orbit.place(first):
            ordered.append(orbit)
    factor = approximate(last / first)
    knots = [first, *(arb(approximate(first) * factor ** (k / _SLICES)) for k in range(1, _SLICES)), last]
    strips = [strip(plane, *pair, side, knots) for pair in itertools.pairwise(ordered)]
    while strips:
        found = region_of(plane, ordered[0].along, strips)
        if found is not None:
            return Frame(plane, tuple(ordered), tuple(strips), *found, first, last)
        del strips[0], ordered[0]
    return None
