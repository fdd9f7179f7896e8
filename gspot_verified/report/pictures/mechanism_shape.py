"""Where the parts of a mechanism's drawing are at a state, with floats: they show, they prove nothing."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.input.mechanism import Drawing, Mechanism, MechanismError
from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.floats.float_function import float_function

_BITS = 80  # beyond a double
_CORNERS = 48  # of a circle
_EXAMPLE = 'lines = [[["X", "Y"], ["X + l*cos(theta)", "Y - l*sin(theta)"]]]'

Place = tuple[float, float]


@dataclass(frozen=True)
class Shape:
    """The drawing at one state, with closed lines for circles: ``height`` is y, the distance of the contact point from
    the surface, ``u`` its velocity in the direction of ``tangent``; this and ``normal`` have the length 1."""

    lines: tuple[tuple[Place, ...], ...]
    points: tuple[Place, ...]
    contact: Place
    normal: Place
    tangent: Place
    height: float
    u: float

    @property
    def foot(self) -> Place:
        """The place on the surface below the contact point."""
        return moved(self.contact, self.normal, -self.height)

    def reaches(self) -> Iterable[Place]:
        """Places between which the whole drawing lies."""
        yield from (place for line in self.lines for place in line)
        yield from (*self.points, self.contact, self.foot)


Corners = tuple[Place, Place]
"""The lower left and the upper right corner of a window."""


def window(places: Iterable[Place]) -> Corners:
    """The window that just holds these places."""
    xs, ys = zip(*places, strict=True)
    return (min(xs), min(ys)), (max(xs), max(ys))


def extent(corners: Corners) -> float:
    """The longer side of a window; 1 where it is a point."""
    (left, low), (right, high) = corners
    return max(right - left, high - low) or 1.0


def surface(foot: Place, normal: Place, corners: Corners, depth: float) -> list[tuple[Place, Place]]:
    """The line of the surface through ``foot``, as long as the window reaches in its direction, and its hatching, which
    stays where it is when the foot moves along the line."""
    (left, low), (right, high) = corners
    centre = (left + right) / 2, (low + high) / 2
    gap = (centre[0] - foot[0]) * normal[0] + (centre[1] - foot[1]) * normal[1]
    middle, along = moved(centre, normal, -gap), (normal[1], -normal[0])
    reach = (abs(along[0]) * (right - left) + abs(along[1]) * (high - low)) / 2
    ends = moved(middle, along, -reach), moved(middle, along, reach)
    starts = [moved(ends[0], along, depth * k) for k in range(1, math.floor(2 * reach / depth) + 1)]
    return [ends, *((start, moved(moved(start, normal, -depth), along, -depth)) for start in starts)]


def moved(place: Place, direction: Place, length: float) -> Place:
    """The place so far in that direction."""
    return place[0] + length * direction[0], place[1] + length * direction[1]


def closed_line(x: float, y: float, first: float, second: float | None = None, angle: float = 0.0) -> tuple[Place, ...]:
    """Points of a circle of this radius, or of an ellipse with these half axes, the first at this angle."""
    axes = first, first if second is None else second
    turns = (2 * math.pi * k / _CORNERS for k in range(_CORNERS + 1))
    along = ((axes[0] * math.cos(turn), axes[1] * math.sin(turn)) for turn in turns)
    cosine, sine = math.cos(angle), math.sin(angle)
    return tuple((x + cosine * a - sine * b, y + sine * a + cosine * b) for a, b in along)


def drawing_of(mechanism: Mechanism) -> Drawing:
    """Its drawing.

    :raises MechanismError: it has none; the message says how to give one.
    """
    if mechanism.drawing is None:
        raise MechanismError(
            f"{mechanism.name}: no picture: nothing says how its bodies look; add a table [drawing] to its file, as "
            f"{_EXAMPLE}"
        )
    return mechanism.drawing


class Shapes:
    """The shapes of a mechanism at states whose angles count from their references.

    :raises MechanismError: it has no drawing, or a parameter without a value.
    """

    def __init__(self, shifted: Shifted) -> None:
        drawing = drawing_of(shifted.mechanism)
        self._name, self._drawing = shifted.mechanism.name, drawing
        self._side = -1.0 if shifted.mechanism.mirrored else 1.0  # x counts to the right of the normal, or to the left
        groups = (*(point for line in drawing.lines for point in line), *drawing.circles, *drawing.points,
                  drawing.contact, drawing.normal)  # fmt: skip
        prepared = shifted.prepare([formula for group in groups for formula in group])
        with working_bits(_BITS):
            functions = shifted.expressions([*prepared, shifted.functions.y, shifted.functions.u], BALLS)
        self._values = float_function(functions)

    def at(self, state: Sequence[float]) -> Shape:
        """The shape at one state.

        :raises MechanismError: a formula of the drawing has no value there.
        """
        try:
            found = self._values(state)
        except (ValueError, ArithmeticError) as error:
            raise self._no_place(state, str(error)) from None
        if not all(isinstance(value, float | int) and math.isfinite(value) for value in found):
            raise self._no_place(state, "a formula has no finite real value there")
        values = iter(found)

        def pair() -> Place:
            return next(values), next(values)

        lines = tuple(tuple(pair() for _ in line) for line in self._drawing.lines)
        lines += tuple(closed_line(*(next(values) for _ in circle)) for circle in self._drawing.circles)
        points = tuple(pair() for _ in self._drawing.points)
        contact, normal = pair(), pair()
        length = math.hypot(*normal)
        if length == 0:
            raise self._no_place(state, "the normal has the length 0")
        unit = normal[0] / length, normal[1] / length
        tangent = self._side * unit[1], -self._side * unit[0]
        return Shape(lines, points, contact, unit, tangent, height=next(values), u=next(values))

    def _no_place(self, state: Sequence[float], why: str) -> MechanismError:
        return MechanismError(f"{self._name}: the drawing has no place at the state {list(state)}: {why}")
