"""What the page on cost shows: the parts of a recorded measurement, in words.

Each part is drawn as SVG: time against place on logarithmic scales, each line with its name at its end.

Written as text, without matplotlib: a page has ten of them. Certified routes have full lines and filled marks, routes
without a bound broken lines and open marks, so that no line is told by its colour alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

from gspot_verified.cost.measurement.measurement import CERTIFIED, CheapAnswer, Measurement, Part, Route
from gspot_verified.cost.measurement.text import (
    bytes_text,
    certificate_prices,
    crossover_text,
    crossovers,
    first_and_last,
    growth,
    growth_text,
    limit_text,
    panel_words,
    place_text,
)
from gspot_verified.cost.times.rows import seconds_text
from gspot_verified.report.pictures.canvas import COLOURS, GRID, INK, PAPER, two_themes

_WIDTH, _LEFT, _RIGHT, _TOP, _BOTTOM = 760.0, 74.0, 196.0, 48.0, 46.0  # pixels: a chart and its margins
_HEIGHT, _SMALL_HEIGHT = 300.0, 190.0  # pixels: a panel that is alone, and one of several
_LINE = 14.0  # pixels between two names at the right
_TICKS = {-7: "0.1 µs", -6: "1 µs", -5: "10 µs", -4: "0.1 ms", -3: "1 ms", -2: "10 ms", -1: "0.1 s", 0: "1 s",
          1: "10 s", 2: "100 s", 3: "1000 s"}  # fmt: skip
GONE = "files that this version no longer has"
_PACKAGE = Path(__file__).resolve().parents[2]
_FONT = "font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif"


@dataclass(frozen=True, slots=True)
class _Scales:
    """From places and seconds to the picture; the panel begins at ``top``."""

    places: tuple[float, float]
    seconds: tuple[float, float]
    top: float
    height: float

    def x(self, place: float) -> float:
        low, high = (math.log10(end) for end in self.places)
        return _LEFT + (_WIDTH - _LEFT - _RIGHT) * (math.log10(place) - low) / (high - low)

    def y(self, seconds: float) -> float:
        low, high = (math.log10(end) for end in self.seconds)
        return self.top + self.height * (high - math.log10(seconds)) / (high - low)


def cost_chart(part: Part) -> str:
    """The SVG, light and dark in one; empty when no route has a point."""
    if not any(route.points for route in part.routes):
        return ""
    panels = [panel for panel in dict.fromkeys(r.panel for r in part.routes)
              if any(r.points for r in part.routes if r.panel == panel)]  # fmt: skip
    height = _HEIGHT if len(panels) == 1 else _SMALL_HEIGHT
    names = list(dict.fromkeys(route.name for route in part.routes))
    colours = {name: COLOURS[number % len(COLOURS)] for number, name in enumerate(names)}
    total = len(panels) * (height + _TOP) + _BOTTOM
    body = []
    for number, panel in enumerate(panels):
        routes = [route for route in part.routes if route.panel == panel and route.points]
        targets = [seconds for name, seconds in part.targets if name == panel]
        scales = _scales(part, targets, number * (height + _TOP) + _TOP, height)
        aims = "".join(f", dotted: the aim of {seconds:g} s for certified runs" for seconds in targets)
        body += [*_grid(scales, panel + aims), *_targets(scales, targets)]
        for route in routes:
            body += _line(scales, route, colours[route.name])
        body += _names(scales, routes, colours)
    middle = (_LEFT + _WIDTH - _RIGHT) / 2
    body.append(_text(middle, total - 8, part.axis, "middle"))
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:g}" height="{total:g}" '
        f'viewBox="0 0 {_WIDTH:g} {total:g}">'
        f'<rect width="{_WIDTH:g}" height="{total:g}" style="fill:{PAPER}"/>{"".join(body)}</svg>'
    )
    return two_themes(svg)


def _scales(part: Part, targets: Sequence[float], top: float, height: float) -> _Scales:
    """The same in every panel, so that they can be compared."""
    points = [point for route in part.routes for point in route.points]
    places = min(p.place for p in points), max(p.place for p in points)
    if places[0] == places[1]:
        places = places[0] / 2, places[1] * 2
    seconds = [*(point.best for point in points), *targets, *(target for _, target in part.targets)]
    low, high = math.floor(math.log10(min(seconds))), math.ceil(math.log10(max(seconds)))
    return _Scales(places, (10.0**low, 10.0 ** max(high, low + 1)), top, height)


def _grid(scales: _Scales, panel: str) -> Iterator[str]:
    left, right, bottom = _LEFT, _WIDTH - _RIGHT, scales.top + scales.height
    decades = range(round(math.log10(scales.seconds[0])), round(math.log10(scales.seconds[1])) + 1)
    step = 1 if scales.height > 250 or len(decades) <= 6 else 2
    for number, power in enumerate(decades):
        y = scales.y(10.0**power)
        yield _stroke(left, y, right, y, GRID, 0.7)
        if number % step == 0:
            yield _text(left - 6, y + 4, _TICKS.get(power, f"10^{power} s"), "end")
    for place in _place_ticks(*scales.places):
        x = scales.x(place)
        yield _stroke(x, scales.top, x, bottom, GRID, 0.7)
        yield _text(x, bottom + 16, place_text(place), "middle")
    yield _stroke(left, bottom, right, bottom, INK, 0.9)
    if panel:
        yield _text(left, scales.top - 8, panel, "start", True)


def _place_ticks(first: float, last: float) -> list[float]:
    """Powers of ten over a long range; over a short one 1, 2, 5 or every number too."""
    decades = range(math.floor(math.log10(first)), math.ceil(math.log10(last)) + 1)
    for digits in ((1,), (1, 3), (1, 2, 5), (1, 2, 3, 4, 5, 6, 7, 8)):
        ticks = [digit * 10.0**power for power in decades for digit in digits]
        inside = [value for value in ticks if first * 0.999 <= value <= last * 1.001]
        if len(inside) >= 4:
            break
    return inside


def _targets(scales: _Scales, targets: Sequence[float]) -> Iterator[str]:
    for seconds in targets:
        y = scales.y(seconds)
        yield _stroke(_LEFT, y, _WIDTH - _RIGHT, y, INK, 1.0, "2 3")


def _line(scales: _Scales, route: Route, colour: str) -> Iterator[str]:
    places = [(scales.x(p.place), scales.y(p.best)) for p in sorted(route.points, key=lambda p: p.place)]
    sure = route.kind == CERTIFIED
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    dashes = "" if sure else ";stroke-dasharray:6 3"
    yield f'<polyline points="{path}" style="fill:none;stroke:{colour};stroke-width:1.9{dashes}"/>'
    for (x, y), point in zip(places, sorted(route.points, key=lambda p: p.place), strict=True):
        fill = colour if sure else PAPER
        yield (
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.2" style="fill:{fill};stroke:{colour};stroke-width:1.5">'
            f"<title>{escape(route.name)}, {escape(point.asked)}</title></circle>"
        )


def _names(scales: _Scales, routes: Sequence[Route], colours: dict[str, str]) -> Iterator[str]:
    """Each name right of the last mark of its line, moved up or down until no two overlap."""
    ends = []
    for route in routes:
        last = max(route.points, key=lambda point: point.place)
        ends.append((scales.y(last.best), scales.x(last.place), route))
    ends.sort(key=lambda end: end[0])
    wanted = [end[0] for end in ends]
    heights = spread(wanted, _LINE, scales.top + 4, scales.top + scales.height)
    for height, (y, x, route) in zip(heights, ends, strict=True):
        start = _WIDTH - _RIGHT + 10
        yield _stroke(x + 5, y, start - 3, height, colours[route.name], 0.8, "1 3")
        yield _text(start, height + 4, route.name, "start", False, colours[route.name])


def spread(wanted: Sequence[float], distance: float, lowest: float, highest: float) -> list[float]:
    """Numbers near the wanted ones (which ascend), at least ``distance`` apart, in the range if they have room there.

    >>> spread([10, 11, 50], 14, 0, 100)
    [10, 24, 50]
    """
    placed: list[float] = []
    for value in wanted:
        placed.append(max(value, lowest, placed[-1] + distance) if placed else max(value, lowest))
    limit = highest
    for number in range(len(placed) - 1, -1, -1):
        placed[number] = min(placed[number], limit)
        limit = placed[number] - distance
    return placed


def _stroke(x: float, y: float, to_x: float, to_y: float, colour: str, width: float, dashes: str = "") -> str:
    broken = f";stroke-dasharray:{dashes}" if dashes else ""
    ends = f'x1="{x:.1f}" y1="{y:.1f}" x2="{to_x:.1f}" y2="{to_y:.1f}"'
    return f'<line {ends} style="stroke:{colour};stroke-width:{width:g}{broken}"/>'


def _text(x: float, y: float, words: str, anchor: str, bold: bool = False, colour: str = INK) -> str:
    weight = ";font-weight:600" if bold else ""
    style = f"fill:{colour};{_FONT};font-size:12px{weight}"
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" style="{style}">{escape(words)}</text>'


def cost_figures(measurement: Measurement) -> dict[str, str]:
    """The SVG of each part that has points, by the name of its file without the suffix."""
    drawn = {f"cost-{part.key}": cost_chart(part) for part in measurement.parts}
    return {name: svg for name, svg in drawn.items() if svg}


def shown_measurement(measurement: Measurement) -> dict[str, Any]:
    """Plain data for the template."""
    figures = {f"cost-{part.key}" for part in measurement.parts if any(route.points for route in part.routes)}
    return {
        "date": measurement.date,
        "machine": measurement.machine,
        "load": measurement.load,
        "size": "full" if measurement.full else "quick",
        "minutes": f"{measurement.seconds / 60:.0f}",
        "versions": measurement.versions,
        "of_other_files": measurement.of_other_files,
        "prices": [row for part in measurement.parts for row in _prices(part)],
        "parts": [_part(part, f"cost-{part.key}" in figures) for part in measurement.parts],
        "answers": [_answer(answer) for answer in measurement.answers],
    }


def _prices(part: Part) -> list[dict[str, str]]:
    return [
        {
            "part": part.key,
            "title": part.title + (f", {price.panel}" if price.panel else ""),
            "place": f"{part.symbol} = {place_text(price.place)}",
            "certified": price.certified,
            "cheap": price.cheap,
            "factor": f"{price.factor:.2g}" if price.factor < 100 else f"{price.factor:,.0f}".replace(",", "\u202f"),
        }
        for price in certificate_prices(part)
    ]


def _part(part: Part, has_figure: bool) -> dict[str, Any]:
    return {
        "key": part.key,
        "title": part.title,
        "question": part.question,
        "axis": part.axis,
        "figure": f"cost-{part.key}" if has_figure else None,
        "alternative": f"Lines of time against {part.axis}: {', '.join(dict.fromkeys(r.name for r in part.routes))}.",
        "routes": [_route(route) for route in part.routes],
        "crossovers": [crossover_text(item, part) for item in crossovers(part)],
        "shares_of": part.shares_of,
        "shares": [(words, f"{100 * share:.0f}\N{NO-BREAK SPACE}%") for words, share in _shares(part).items()],
        "limit": limit_text(part),
        "remarks": part.remarks,
    }


def _shares(part: Part) -> dict[str, float]:
    """The parts of the time by the files in which they are spent now; those of files that are gone together."""
    found: dict[str, float] = {}
    for share in part.shares:
        words = file_of_module(share.words)
        found[words] = found.get(words, 0.0) + share.part
    return found


def file_of_module(module: str) -> str:
    """The file of the package that a measured module is now: files move, a record keeps their old names.

    >>> file_of_module("theta_function.routes"), file_of_module("numpy")
    ('theta_function/value/routes.py', 'numpy')
    >>> file_of_module("theta_function.no_such_file") == GONE
    True
    """
    *rooms, name = module.split(".")
    files = sorted(path.relative_to(_PACKAGE) for path in _PACKAGE.rglob(f"{name}.py"))
    near = [path for path in files if rooms and path.parts[0] == rooms[0]]
    if len(near or files) == 1:
        return (near or files)[0].as_posix()
    return GONE if rooms or files else module


def _route(route: Route) -> dict[str, Any]:
    ends = first_and_last(route)
    fitted = growth(route)
    memories = [point.memory for point in route.points if point.memory is not None]
    return {
        "name": panel_words(route.panel) + route.name,
        "certified": route.kind == CERTIFIED,
        "kind": route.kind,
        "note": route.note,
        "ends": [] if ends is None else [(place_text(end.place), seconds_text(end.best)) for end in ends],
        "memory": bytes_text(max(memories)) if memories else "",
        "growth": growth_text(fitted) if fitted.exponent is not None else "",
        "theory": route.theory,
        "points": [
            {
                "asked": point.asked,
                "place": place_text(point.place),
                "best": seconds_text(point.best),
                "median": seconds_text(point.median),
                "repeats": point.repeats,
                "memory": "" if point.memory is None else bytes_text(point.memory),
            }
            for point in route.points
        ],
    }


def _answer(answer: CheapAnswer) -> dict[str, Any]:
    return {
        "question": answer.question,
        "why": answer.why,
        "certified": answer.certified,
        "routes": " and ".join(answer.routes),
        "doubles": answer.doubles,
        "doubles_how": answer.doubles_how,
        "doubles_wrong": answer.wrong(answer.doubles),
        "mpmath": answer.mpmath,
        "mpmath_wrong": answer.wrong(answer.mpmath),
    }
