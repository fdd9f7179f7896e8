"""A mechanism at one state: its bodies, the surface, the contact point with normal, tangent and slip."""

from __future__ import annotations

import math
from typing import Any

from gspot_verified.mechanisms.approach.slip_state import StateInput, slip_state
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.g_spot import find_g_spot, short_component
from gspot_verified.numbers.balls import approximate, ball, working_bits
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    PAPER,
    VERMILION,
    Picture,
    canvas,
    picture,
    styled,
)
from gspot_verified.report.pictures.mechanism_shape import (
    Place,
    Shape,
    Shapes,
    drawing_of,
    extent,
    moved,
    surface,
    window,
)

_BITS = 80  # beyond what a picture shows
_ARROW, _BELOW, _HATCHING, _MARGIN = 0.3, 0.14, 0.04, 0.1
"""Of the size of the mechanism: the length of arrows, how far below the contact that of slip is, the depth of the
hatching, the space around everything."""
_HEIGHTS = (2.4, 6.0)  # inches, the least and the largest of a picture
_WIDTH = 6.6  # inches, of what is inside the axes, roughly
_ON_A_BELT = " Here u < 0: slip is positive only on a surface that moves faster in this direction, which is not drawn."


def mechanism_picture(mechanism: Mechanism, state: StateInput | None = None, spot: int | None = None) -> Picture:
    """The mechanism at the G-spot found from the place of its file, at that of this number in the list of
    ``classify_all``, or at a state of the user's own, as for :func:`mechanisms.approach.approach.approach`.

    :raises MechanismError: it has no drawing, or is not complete.
    :raises GSpotError: it has no G-spot there.
    :raises ValueError: both ``state`` and ``spot`` are given, ``state`` is no state in contact, or there is no G-spot
        of that number.
    """
    drawing_of(mechanism)
    if state is not None and spot is not None:
        raise ValueError("the picture of a mechanism is at a state or at a G-spot: give state or spot, not both")
    if state is not None:
        where = "at the given state"
        with working_bits(_BITS):
            shifted = shift(mechanism, slip_speed=True)
            point = slip_state(shifted, state).box
    else:
        where = "at its G-spot" if spot is None else f"at G-spot {spot}"
        found = find_g_spot(at_spot(mechanism, spot), _BITS)
        shifted, point = found.shifted, found.system.point
    shape = Shapes(shifted).at([approximate(ball(value)) for value in point])
    pairs = zip(mechanism.state, point, strict=True)
    shown = ", ".join(f"{word} = {short_component(mechanism, word, value)}" for word, value in pairs)
    caption = (
        f"Drawn with floats at {shown}, as the drawing in the mechanism's file says: it shows, it proves nothing. The "
        "red point is the contact, the red arrow the direction of its velocity u along the surface."
    )
    return shape_picture("mechanism", f"{mechanism.name} {where}", shape, caption + (_ON_A_BELT if shape.u < 0 else ""))


def shape_picture(name: str, title: str, shape: Shape, caption: str) -> Picture:
    """The picture of one shape, with arrows at its contact point."""
    return styled(lambda: _draw(name, title, shape, caption))()


def _draw(name: str, title: str, shape: Shape, caption: str) -> Picture:
    size = extent(window(shape.reaches()))
    length, room = _ARROW * size, _MARGIN * size
    contact, normal, tangent = shape.contact, shape.normal, shape.tangent
    below = moved(contact, normal, -_BELOW * size)
    arrows = [
        (contact, moved(contact, normal, length), INK, "normal, y"),
        (contact, moved(contact, tangent, length), INK, "tangent, x"),
    ]
    if shape.u != 0:
        words = f"{'slip' if shape.u > 0 else 'velocity'}, u = {shape.u:.4g}".replace("-", "−")
        arrows.append((below, moved(below, tangent, math.copysign(length, shape.u)), VERMILION, words))
    places = [*shape.reaches(), below, *(end for _, end, _, _ in arrows)]
    (left, low), (right, high) = window(places)
    corners = (left - room, low - room), (right + 2 * room, high + room)
    (left, low), (right, high) = corners
    figure = canvas(min(max((high - low) / (right - left) * _WIDTH, _HEIGHTS[0]), _HEIGHTS[1]) + 0.5)
    axes = figure.add_subplot()
    axes.set_aspect("equal")
    axes.grid(visible=False)
    for begin, end in surface(shape.foot, normal, corners, _HATCHING * size):
        axes.plot(*zip(begin, end, strict=True), color=INK, linewidth=0.9, zorder=1)
    _bodies(axes, shape)
    for arrow in arrows:
        _arrow(axes, *arrow)
    axes.plot(*contact, "o", color=VERMILION, markersize=7, zorder=6)
    axes.set(xlim=(left, right), ylim=(low, high), xlabel="lengths in the units of the mechanism")
    axes.set_title(title, loc="left", parse_math=False)
    return picture(
        figure,
        name,
        title[:1].upper() + title[1:],
        caption,
        "The bodies of the mechanism, the surface that they touch, and arrows at the contact point: the normal, the "
        "tangent and the direction of slip.",
    )


def _bodies(axes: Any, shape: Shape) -> None:
    for line in shape.lines:
        axes.plot(*zip(*line, strict=True), color=BLUE, linewidth=4, solid_capstyle="round", zorder=3)
    for place in shape.points:
        axes.plot(*place, "o", markersize=7, markerfacecolor=PAPER, markeredgecolor=GREEN, markeredgewidth=2, zorder=4)


def _arrow(axes: Any, begin: Place, end: Place, colour: str, words: str) -> None:
    look = {"arrowstyle": "-|>", "color": colour, "linewidth": 1.6, "mutation_scale": 14, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, begin, arrowprops=look, zorder=5)
    beyond = (5, 4) if end[0] >= begin[0] else (-5, 4)
    anchor = "left" if end[0] >= begin[0] else "right"
    axes.annotate(words, end, xytext=beyond, textcoords="offset points", color=colour, ha=anchor, fontsize=8.5)
