"""What the page on cost shows: the parts of a recorded measurement, in words."""

from __future__ import annotations

from typing import Any

from gspot_verified.cost.measurement.findings import certificate_prices, crossovers, growth
from gspot_verified.cost.measurement.measurement import CERTIFIED, CheapAnswer, Measurement, Part, Route
from gspot_verified.cost.measurement.text import (
    bytes_text,
    crossover_text,
    first_and_last,
    growth_text,
    limit_text,
    panel_words,
    place_text,
)
from gspot_verified.cost.times.rows import seconds_text
from gspot_verified.report.parts.cost_chart import cost_chart


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
        "shares": [(share.words, f"{100 * share.part:.0f}\N{NO-BREAK SPACE}%") for share in part.shares],
        "limit": limit_text(part),
        "remarks": part.remarks,
    }


def _route(route: Route) -> dict[str, Any]:
    ends = first_and_last(route)
    found = growth(route)
    memories = [point.memory for point in route.points if point.memory is not None]
    return {
        "name": panel_words(route.panel) + route.name,
        "certified": route.kind == CERTIFIED,
        "kind": route.kind,
        "note": route.note,
        "ends": [] if ends is None else [(place_text(end.place), seconds_text(end.best)) for end in ends],
        "memory": bytes_text(max(memories)) if memories else "",
        "growth": growth_text(found) if found.exponent is not None else "",
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
