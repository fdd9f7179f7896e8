"""What is made once for all boxes of one question: the starts, the plane, the orbits to compare with.

Which points are tried is a heuristic, and which orbits are followed: they begin at the largest p of the range, where
those through its edge come from, and near the distinguished trajectory, where the sign of C_1 changes.
Proof page: ``proofs/fates.md``, sections 1 and 3: any choice is correct.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from operator import itemgetter

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.fates.box_fate import BoxFate, Fate, Frame, box_fate
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.reference import Reference, reference
from gspot_verified.mechanisms.fates.starts import Starts
from gspot_verified.mechanisms.fates.strip import region_of, strip
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide, trajectory_side
from gspot_verified.mechanisms.spots.g_spot import place_in, prove_near
from gspot_verified.mechanisms.sweep.sweep_grid import Axis
from gspot_verified.numbers.balls import add_remainder, approximate, current_bits, hull

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


_EDGE = 12  # points on each side of the range whose orbits are looked for; of a line twice as many
_ORDER = 10  # of the distinguished trajectory's polynomial: any number is correct
_SIZES = 12  # radii of its region that are tried, each half of the one before
_LENGTHS = 8  # of its stretch of p, too
_FORCES = (4, 2)  # the region's forces are from 1/4 to 4 times that at the G-spot, or nearer
_DISC = 4  # radius of Cauchy's disc, in lengths of the stretch


@dataclass(frozen=True)
class Prepared:
    """The starts, the plane and the frames of one question."""

    starts: Starts
    plane: PlanarFlow
    frames: tuple[Frame, ...]
    surface: fmpq

    def fate(self, lower: Sequence[fmpq], upper: Sequence[fmpq]) -> BoxFate:
        """Of all states with these values of what varies, at the precision in force."""
        states = self.starts.whole(lower, upper)
        if states is None:
            return BoxFate(Fate.UNDECIDED, why="y = v = 0 do not certainly determine the other components")
        return box_fate(self.plane, self.frames, states, arb(self.surface))


def prepared(shifted: Shifted, starts: Starts, axes: Sequence[Axis], surface: fmpq) -> Prepared:
    """At the precision in force.

    :raises MechanismError: the flow is not planar.
    :raises GSpotError: there is no G-spot at the mechanism's place.
    """
    plane = PlanarFlow(shifted)
    place = plane.of_state(prove_near(shifted, place_in(shifted, BALLS), current_bits()).system.point)
    side = _side(plane, place)
    edge = [plane.of_state(states) for at in _edge(axes) if (states := starts.whole(at, at)) is not None]
    cells = max(axis.cells for axis in axes)
    # The place is the component on which p depends less.
    slopes = [abs(approximate(slope)) for slope in plane.p_and_b.gradients(place)[1][0]]
    along = int(slopes[0] > slopes[1])
    return Prepared(starts, plane, () if side is None else frames(plane, along, side, edge, cells), surface)


def _edge(axes: Sequence[Axis]) -> Iterator[tuple[fmpq, ...]]:
    """Points on the edge of the range; of one axis, points of it."""
    count = _EDGE if len(axes) > 1 else 2 * _EDGE
    steps = [[axis.lower + (axis.upper - axis.lower) * k / count for k in range(count + 1)] for axis in axes]
    if len(steps) == 1:
        yield from ((value,) for value in steps[0])
        return
    first, second = steps
    yield from ((value, end) for value in first for end in (second[0], second[-1]))
    yield from ((end, value) for value in second[1:-1] for end in (first[0], first[-1]))


def _side(plane: PlanarFlow, place: Sequence[arb]) -> TrajectorySide | None:
    """The distinguished trajectory of the G-spot, as far as the hypotheses let it be followed: a heuristic."""
    first, second, third = plane.alphas.values(place)
    force = second / (third - first)
    if not force > 0:
        return None
    speeds = plane.flow.by_p().on_box([*place, force])[0][:-1]
    fastest = max(1.0, *(abs(approximate(speed)) for speed in speeds))
    for size in range(_SIZES):
        sides = [add_remainder(value, arb(2) ** -size) for value in place]
        for factor in _FORCES:
            region = [*sides, hull([force / factor, force * factor])]
            for length in range(_LENGTHS):
                last = arb(2.0 ** -(size + length) / fastest)
                found = trajectory_side(plane.flow, place, region, _ORDER, last, _DISC * last, plane.p_and_b)
                if found is not None:
                    return found
    return None
