"""A mechanism in motion along a run of a scene: one SVG that browsers play without a script.

The places are those of the drawing in the mechanism's file, as a rigid one, at samples of the run (of a certified one
at the middles of its enclosures); between them a browser draws straight ways. It shows, it proves nothing.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from html import escape

from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PAPER,
    PURPLE,
    Picture,
    two_themes,
)
from gspot_verified.report.pictures.mechanism_picture import shape_picture
from gspot_verified.report.pictures.mechanism_shape import (
    Corners,
    Place,
    Shape,
    Shapes,
    drawing_of,
    extent,
    moved,
    surface,
    window,
)
from gspot_verified.report.pictures.scene_curves import phase_rows
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.floats.whole_states import whole_states
from gspot_verified.scenes.scene.run import CERTIFIED, SceneRun
from gspot_verified.scenes.scene.samples import RADIUS, Samples
from gspot_verified.scenes.scene.scene import Scene, SceneError

_COLOURS = {SLIP: BLUE, STICK: ORANGE, REVERSE: PURPLE, FLIGHT: GREEN}
_SLIPS = {SLIP: 1.0, REVERSE: -1.0}  # the direction along the tangent
_SECONDS = 8  # of one round, the last of them at rest
_MOVING = 7 / 8  # of a round
_FRAMES = 120  # about, at equal times
_WIDTH, _EDGE, _HEAD, _FOOT, _TALLEST = 720, 20, 62, 88, 460  # of the picture, in its own units
_ARROW, _BELOW, _HATCHING, _MARGIN = 0.22, 0.1, 0.04, 0.08  # of the size of the mechanism
_SLIT = (30, 54)  # from where to where down the picture the time is seen
_MOST_EVENTS = 4  # that are named with their times


def mechanism_animation(scene: Scene, run: SceneRun) -> Picture:
    """The animation of one run of the scene as SVG; the picture's PNG and PDF show its start.

    :raises SceneError: the scene has no mechanism, or the run no samples.
    :raises MechanismError: the mechanism has no drawing.
    """
    check_animated(scene)
    assert scene.mechanism is not None
    if run.samples is None or len((samples := _known(run.samples)).phases) < 2:
        raise SceneError(f"{scene.name}: an animation needs a run with samples: give points")
    shapes = Shapes(shift(scene.mechanism, slip_speed=True))
    states, rows = whole_states(scene, samples), chosen_rows(samples)
    film = Film.of(samples, rows, [shapes.at(states[row]) for row in rows])
    title = f"{scene.mechanism.name} in the scene {scene.name}, ε = {scene.epsilon}"
    caption = _caption(scene, run)
    still = shape_picture("animation", title, film.shapes[0], caption)
    seen = "The mechanism on its surface, which moves through the phases that a bar below shows over time."
    return replace(still, alternative=seen, svg=two_themes("\n".join(_svg(film, title, _strength(scene, run), run))))


def check_animated(scene: Scene) -> None:
    """Passes for a scene whose mechanism can be drawn.

    :raises SceneError: the scene has no mechanism.
    :raises MechanismError: the mechanism has no drawing.
    """
    if scene.mechanism is None:
        raise SceneError(f"{scene.name}: no animation: the model system of the paper has no bodies")
    drawing_of(scene.mechanism)


def _known(samples: Samples) -> Samples:
    """The rows up to the first of which an enclosure has no bounds."""
    radii = [column for name, column in samples.columns.items() if name.endswith(RADIUS)]
    end = next((row for row in range(len(samples.phases)) if not all(math.isfinite(each[row]) for each in radii)), None)
    return Samples({name: column[:end] for name, column in samples.columns.items()}, samples.phases[:end])


def chosen_rows(samples: Samples) -> list[int]:
    """The rows next to equal times, and the first and the last row of each phase."""
    times = samples.columns["t"].tolist()
    rows, ends = {row for pair in phase_rows(samples) for row in pair}, (times[0], times[-1])
    row = 0
    for k in range(_FRAMES + 1):
        goal = ends[0] + (ends[1] - ends[0]) * k / _FRAMES
        while row + 1 < len(times) and abs(times[row + 1] - goal) <= abs(times[row] - goal):
            row += 1
        rows.add(row)
    return sorted(rows)


@dataclass(frozen=True)
class Film:
    """What is shown at which time: ``shares`` are the times as shares of a round, ``stretches`` the phases, each with
    the shares at which it begins and ends."""

    times: tuple[float, ...]
    shares: tuple[float, ...]
    shapes: tuple[Shape, ...]
    stretches: tuple[tuple[str, float, float], ...]

    @property
    def phases(self) -> tuple[str, ...]:
        """Each phase once."""
        return tuple(dict.fromkeys(name for name, _, _ in self.stretches))

    @classmethod
    def of(cls, samples: Samples, rows: Sequence[int], shapes: Sequence[Shape]) -> Film:
        """The film of these rows of the samples."""
        times = tuple(float(samples.columns["t"][row]) for row in rows)
        span = (times[-1] - times[0]) or 1.0
        shares = tuple(_MOVING * (time - times[0]) / span for time in times)
        share = dict(zip(rows, shares, strict=True))
        firsts = [(samples.phases[first], share[first]) for first, _ in phase_rows(samples)]
        ends = [*(begin for _, begin in firsts[1:]), 1.0]
        stretches = tuple((phase, begin, end) for (phase, begin), end in zip(firsts, ends, strict=True))
        return cls(times, shares, tuple(shapes), stretches)

    def animated(self, attribute: str, values: Sequence[str]) -> str:
        """The element that gives the attribute these values one after the other; nothing where all are the same."""
        if len(set(values)) == 1:
            return ""
        keys = ";".join(f"{share:.5f}" for share in self.shares)
        return (
            f'<animate attributeName="{attribute}" dur="{_SECONDS}s" repeatCount="indefinite" keyTimes="{keys};1" '
            f'values="{";".join([*values, values[-1]])}"/>'
        )

    def only_in(self, phase: str, inside: str) -> str:
        """What is shown during this phase alone; where nothing moves, that of the first phase."""
        keys = ";".join(f"{begin:.5f}" for _, begin, _ in self.stretches)
        values = ["visible" if name == phase else "hidden" for name, _, _ in self.stretches]
        return (
            f'<g visibility="{values[0]}"><animate attributeName="visibility" dur="{_SECONDS}s" '
            f'repeatCount="indefinite" calcMode="discrete" keyTimes="{keys}" values="{";".join(values)}"/>{inside}</g>'
        )


class _View:
    """From places of the mechanism to places of the picture."""

    def __init__(self, shapes: Sequence[Shape]) -> None:
        self.size = extent(window(place for shape in shapes for place in shape.reaches()))
        places = [
            place for shape in shapes for place in (*shape.reaches(), *self.arrow(shape, 1), *self.arrow(shape, -1))
        ]
        (left, low), (right, high) = window(places)
        room = _MARGIN * self.size
        self.corners: Corners = (left - room, low - room), (right + room, high + room)
        (left, low), (right, high) = self.corners
        self._scale = min((_WIDTH - 2 * _EDGE) / (right - left), _TALLEST / (high - low))
        self._left, self._top = _WIDTH / 2 - self._scale * (left + right) / 2, _HEAD + self._scale * high
        self.box = self._at((left, high)), self._at((right, low))
        self.bottom = self.box[1][1]

    def _at(self, place: Place) -> Place:
        return self._left + self._scale * place[0], self._top - self._scale * place[1]

    def line(self, places: Sequence[Place]) -> str:
        """The places as the attribute ``points`` has them."""
        return " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self._at, places))

    def path(self, lines: Sequence[tuple[Place, Place]]) -> str:
        """Straight pieces as the attribute ``d`` has them."""
        return "".join(f"M{self.line([begin])}L{self.line([end])}" for begin, end in lines)

    def arrow(self, shape: Shape, sign: float) -> list[Place]:
        """An arrow below the contact point, along the tangent."""
        begin, size = moved(shape.contact, shape.normal, -_BELOW * self.size), self.size
        end = moved(begin, shape.tangent, sign * _ARROW * size)
        back = moved(end, shape.tangent, -sign * 0.04 * size)
        return [begin, end, moved(back, shape.normal, 0.02 * size), moved(back, shape.normal, -0.02 * size), end]


def _svg(film: Film, title: str, strength: str, run: SceneRun) -> list[str]:
    view = _View(film.shapes)
    height = round(view.bottom) + _FOOT
    return [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height}" width="{_WIDTH}" height="{height}" '
        f'font-family="DejaVu Sans, sans-serif" font-size="13"><title>{escape(title)}</title>',
        _cover(0, height),
        _clock(film),
        _cover(0, _SLIT[0]),
        _cover(_SLIT[1], height),
        _text(_EDGE, 24, title),
        *(film.only_in(name, _text(_EDGE, 48, name, size=16, colour=_COLOURS[name])) for name in film.phases),
        *_bodies(film, view),
        *_timeline(film, view.bottom + 14),
        _text(_EDGE, height - 30, _events(run), size=12),
        _text(_EDGE, height - 12, strength, size=12),
        "</svg>",
    ]


def _cover(top: float, bottom: float) -> str:
    return f'<rect y="{top}" width="{_WIDTH}" height="{bottom - top}" style="fill:{PAPER}"/>'


def _text(
    x: float, y: float, words: str, size: int = 13, colour: str = INK, inside: str = "", anchor: str = "start"
) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" style="fill:{colour}">{escape(words)}'
        f"{inside}</text>"
    )


def _bodies(film: Film, view: _View) -> list[str]:
    def drawn(tag: str, style: str, **values: list[str]) -> str:
        first = " ".join(f'{name}="{each[0]}"' for name, each in values.items())
        moves = "".join(film.animated(name, each) for name, each in values.items())
        return f'<{tag} {first} style="{style}">{moves}</{tag}>'

    def dot(centres: list[Place], radius: str, style: str) -> str:
        xs, ys = zip(*(view.line([centre]).split(",") for centre in centres), strict=True)
        return drawn("circle", style, cx=list(xs), cy=list(ys), r=[radius])

    shapes, start = film.shapes, film.shapes[0]
    body = f"fill:none;stroke:{INK};stroke-width:5;stroke-linecap:round;stroke-linejoin:round"
    depth = _HATCHING * view.size
    ground = [view.path(surface(shape.foot, shape.normal, view.corners, depth)) for shape in shapes]
    parts = [drawn("path", f"fill:none;stroke:{INK};stroke-width:1", d=ground)]
    for i in range(len(start.lines)):
        parts.append(drawn("polyline", body, points=[view.line(shape.lines[i]) for shape in shapes]))
    for i in range(len(start.points)):
        mark = f"fill:{PAPER};stroke:{INK};stroke-width:2"
        parts.append(dot([shape.points[i] for shape in shapes], "4", mark))
    for phase in film.phases:
        colour = _COLOURS[phase]
        inside = dot([shape.contact for shape in shapes], "6", f"fill:{colour}")
        if phase in _SLIPS:
            arrows = [view.line(view.arrow(shape, _SLIPS[phase])) for shape in shapes]
            inside += drawn("polyline", f"fill:{colour};stroke:{colour};stroke-width:2.5", points=arrows)
        parts.append(film.only_in(phase, inside))
    return parts


def _clock(film: Film) -> str:
    """The time: a column of texts that moves up behind a slit. What is drawn later covers the rest of it."""
    places, room = max(0, math.ceil(2 - math.log10(film.times[-1] - film.times[0] or 1.0))), _SLIT[1] - _SLIT[0]
    texts = [f"t = {time:.{places}f}" for time in film.times]
    keys = ";".join(f"{share:.5f}" for share in film.shares)
    steps = ";".join(f"0 {-room * k}" for k in range(len(texts)))
    column = (_text(_WIDTH - _EDGE, 48 + room * k, text, size=16, anchor="end") for k, text in enumerate(texts))
    return (
        f'<g aria-hidden="true"><animateTransform attributeName="transform" type="translate" dur="{_SECONDS}s" '
        f'repeatCount="indefinite" calcMode="discrete" keyTimes="{keys}" values="{steps}"/>{"".join(column)}</g>'
    )


def _timeline(film: Film, top: float) -> list[str]:
    """The phases over time, each in its colour, and a mark that moves along them."""
    width = (_WIDTH - 2 * _EDGE) / _MOVING
    bars = [
        f'<rect x="{_EDGE + width * begin:.1f}" y="{top}" width="{width * (min(end, _MOVING) - begin):.1f}" height="8" '
        f'style="fill:{_COLOURS[phase]}"><title>{phase}</title></rect>'
        for phase, begin, end in film.stretches
    ]
    marks = [f"{_EDGE + width * share:.1f}" for share in film.shares]
    moves = film.animated("x", marks)
    mark = f'<rect x="{marks[0]}" y="{top - 4}" width="2" height="16" style="fill:{INK}">{moves}</rect>'
    x, legend = float(_EDGE), []
    for phase in film.phases:
        legend.append(_text(x, top + 24, phase, size=12, colour=_COLOURS[phase]))
        x += 9 * len(phase) + 14
    return [*bars, mark, *legend]


def _events(run: SceneRun) -> str:
    shown = [event.rounded(4) for event in run.events[:_MOST_EVENTS]]
    more = len(run.events) - _MOST_EVENTS
    return ", ".join([*shown, *([f"and {more} more"] if more > 0 else [])]) or "no event"


def _strength(scene: Scene, run: SceneRun) -> str:
    how = "the middles of certified enclosures" if run.strength == CERTIFIED else "a run with floats"
    belt = ", the surface at rest though it moves" if "belt" in scene.effects else ""
    return f"From {how}, as rigid bodies{belt}: it shows, it proves nothing."


def _caption(scene: Scene, run: SceneRun) -> str:
    how = "the middles of the enclosures of a certified run" if run.strength == CERTIFIED else "a float run"
    belt = " The surface moves, and is drawn at rest; the arrow is slip on it." if "belt" in scene.effects else ""
    return (
        f"The mechanism along {how} ({run.fate}), as a rigid one: what the drawing in its file says. Deviations of the "
        f"order of ε² are too small to be seen.{belt} {_MOVING * _SECONDS:g} seconds show the time from the first "
        "to the last sample; between samples a browser draws straight ways. An animation shows, it proves nothing."
    )
