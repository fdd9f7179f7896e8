"""What is made once for all boxes of one question: the starts, the plane, the orbits to compare with.

Which points are tried is a heuristic. Proof page: ``proofs/fates.md``, sections 1 and 3: any choice is correct.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.fates.box_fate import BoxFate, Fate, Frame, box_fate
from gspot_verified.mechanisms.fates.frame_choice import frames
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.starts import Starts
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide, trajectory_side
from gspot_verified.mechanisms.spots.g_spot import place_in, prove_near
from gspot_verified.mechanisms.sweep.sweep_grid import Axis
from gspot_verified.numbers.balls import add_remainder, approximate, current_bits, hull

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
