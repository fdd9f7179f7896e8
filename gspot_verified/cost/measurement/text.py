"""What the points of a part say (growth exponents, where one route becomes faster than another), and it as text."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gspot_verified.cost.measurement.measurement import (
    CERTIFIED,
    NO_BOUND,
    CheapAnswer,
    Measurement,
    Part,
    Point,
    Route,
)
from gspot_verified.cost.times.growth import fitted_exponent
from gspot_verified.cost.times.rows import seconds_text

_FITTED = 4  # places: the growth is that of the last ones
_LEAST_RATIO = 3.0  # of the largest place to the smallest: over less an exponent says nothing
_CERTAIN = math.log(1.25)  # times that differ by less than a quarter are noise


@dataclass(frozen=True, slots=True)
class PowerLaw:
    """Time against place as a power, fitted between ``first`` and ``last``; ``exponent`` None: too few points."""

    route: Route
    exponent: float | None
    first: float
    last: float


@dataclass(frozen=True, slots=True)
class Crossover:
    """From ``place`` on (by a straight line between two points on logarithmic scales) ``faster`` takes less time."""

    faster: str
    slower: str
    place: float
    panel: str = ""


@dataclass(frozen=True, slots=True)
class Price:
    """What a certificate costs: the fastest certified route against the fastest without a bound, where both answer."""

    panel: str
    place: float
    certified: str
    cheap: str
    factor: float


def growth(route: Route) -> PowerLaw:
    """The exponent over the last four places, where the largest is 3 times the smallest or more."""
    points = sorted(route.points, key=lambda point: point.place)[-_FITTED:]
    if len(points) < 2 or points[-1].place < _LEAST_RATIO * points[0].place or points[0].place <= 0:
        return PowerLaw(route, None, 0.0, 0.0)
    exponent = fitted_exponent([(point.place, point.best) for point in points])
    return PowerLaw(route, exponent, points[0].place, points[-1].place)


def crossovers(part: Part) -> list[Crossover]:
    """Every place where two routes of one panel change order, by a quarter at least on either side."""
    changes = []
    for number, first in enumerate(part.routes):
        for second in part.routes[number + 1 :]:
            if first.panel == second.panel:
                changes += _crossings(first, second)
    return changes


def _crossings(first: Route, second: Route) -> list[Crossover]:
    places = sorted({point.place for point in (*first.points, *second.points) if point.place > 0})
    times = [(x, time_at(first.points, x), time_at(second.points, x)) for x in places]
    both = [(x, one, other) for x, one, other in times if one is not None and other is not None]
    certain = [(x, math.log(one / other)) for x, one, other in both if abs(math.log(one / other)) > _CERTAIN]
    changes = []
    for (x, before), (next_x, after) in pairwise(certain):
        if before * after < 0:
            place = x * (next_x / x) ** (before / (before - after))
            names = (second.name, first.name) if after > 0 else (first.name, second.name)
            changes.append(Crossover(*names, place, first.panel))
    return changes


def certificate_prices(part: Part) -> list[Price]:
    """One for each panel: at the farthest place of a route without a bound to which a certified one has a time."""
    prices = []
    for panel in dict.fromkeys(route.panel for route in part.routes):
        routes = [route for route in part.routes if route.panel == panel]
        places = sorted({point.place for route in routes if route.kind == NO_BOUND for point in route.points})
        for place in reversed(places):
            sure, cheap = (_fastest(routes, kind, place) for kind in (CERTIFIED, NO_BOUND))
            if sure is not None and cheap is not None:
                prices.append(Price(panel, place, sure[1], cheap[1], sure[0] / cheap[0]))
                break
    return prices


def _fastest(routes: Sequence[Route], kind: str, place: float) -> tuple[float, str] | None:
    """Time and name. A certified answer of more digits answers the question too: the next place counts."""
    times = []
    for route in routes:
        if route.kind == kind:
            later = [point.best for point in route.points if point.place >= place]
            known = time_at(route.points, place)
            options = [*([min(later)] if later else []), *([known] if known is not None else [])]
            if options:
                times.append((min(options), route.name))
    return min(times, default=None)


def time_at(points: Sequence[Point], place: float) -> float | None:
    """The best time there, by a straight line on logarithmic scales between neighbours; None outside.

    >>> time_at([Point(1, "", 2, 2, 1), Point(4, "", 8, 8, 1)], 2)
    4.0
    """
    known = sorted((point.place, point.best) for point in points if point.place > 0)
    for x, seconds in known:
        if x == place:
            return seconds
    for (x, one), (next_x, other) in pairwise(known):
        if x < place < next_x:
            return float(one * (other / one) ** (math.log(place / x) / math.log(next_x / x)))
    return None


_UNITS = ((2**30, "GiB"), (2**20, "MiB"), (2**10, "KiB"))


def measurement_text(measurement: Measurement) -> str:
    """All parts as aligned text."""
    blocks = ["\n".join(part_lines(part)) for part in measurement.parts]
    blocks.append("\n".join(answer_lines(measurement.answers)))
    blocks.append(
        f"{measurement.machine}; {', '.join(f'{name} {version}' for name, version in measurement.versions)}\n"
        f"{measurement.date}; {measurement.load}; {measurement.seconds:.0f} s in all. Processor time."
    )
    return "\n\n".join(blocks)


def part_lines(part: Part) -> Iterator[str]:
    """The lines of one part."""
    yield part.title
    yield f"  {part.question}"
    for route in part.routes:
        yield f"  {panel_words(route.panel)}{route.name}{'' if route.kind == CERTIFIED else f' ({route.kind})'}"
        for point in route.points:
            memory = "" if point.memory is None else f"  memory {bytes_text(point.memory)}"
            times = f"{seconds_text(point.best):>9}  median {seconds_text(point.median):>9} of {point.repeats:2}"
            yield f"    {point.asked:>16}  {place_text(point.place):>9}  {times}{memory}"
        if route.note:
            yield f"    {route.note}"
    for item in map(growth, part.routes):
        if item.exponent is not None:
            yield f"  {panel_words(item.route.panel)}{item.route.name}: {growth_text(item)}"
    for crossover in crossovers(part):
        yield f"  {crossover_text(crossover, part)}"
    for price in certificate_prices(part):
        yield (
            f"  {panel_words(price.panel)}at {place_text(price.place)}: {price.certified}, certified, takes "
            f"{price.factor:.3g} times the time of {price.cheap}, without a bound"
        )
    if part.shares:
        yield f"  the time of {part.shares_of}: " + ", ".join(f"{s.words} {s.part:.0%}" for s in part.shares)
    if part.limit is not None:
        yield f"  {limit_text(part)}"


def answer_lines(answers: tuple[CheapAnswer, ...]) -> Iterator[str]:
    """The table of cheap answers, a block for each."""
    yield "What accuracy buys: the same question at 53 bits, of mpmath as it comes, and certified"
    for answer in answers:
        yield f"  {answer.question}"
        yield f"    certified: {answer.certified} ({' and '.join(answer.routes)})"
        for name, said in ((f"53 bits, {answer.doubles_how}", answer.doubles), ("mpmath", answer.mpmath)):
            yield f"    {name}: {said}{' (wrong)' if answer.wrong(said) else ''}"


def panel_words(panel: str) -> str:
    """The panel before the name of a route, when there is one."""
    return f"{panel}: " if panel else ""


def place_text(place: float) -> str:
    """A place in up to four digits.

    >>> place_text(15.0), place_text(12.9), place_text(1e6).split()
    ('15', '12.9', ['1', '000', '000'])
    """
    text = f"{place:,.0f}" if place >= 1000 or place == int(place) else f"{place:.3g}"
    return text.replace(",", "\N{NARROW NO-BREAK SPACE}")


def bytes_text(size: int) -> str:
    """A size in memory.

    >>> bytes_text(3 * 2**20)
    '3 MiB'
    """
    for scale, unit in _UNITS:
        if size >= scale:
            return f"{size / scale:.3g} {unit}"
    return f"{size} bytes"


def growth_text(item: PowerLaw) -> str:
    """The fitted exponent, where it was fitted, and what theory expects."""
    if item.exponent is None:
        return "not fitted"
    expected = "" if item.route.exponent is None else f", expected in the long run {item.route.exponent:g}"
    return f"power {item.exponent:.2f} from {place_text(item.first)} to {place_text(item.last)}{expected}"


def crossover_text(item: Crossover, part: Part) -> str:
    """The sentence on one crossover."""
    where = f" ({item.panel})" if item.panel else ""
    place = place_text(round_place(item.place))
    return f"From {part.symbol} ≈ {place} on, {item.faster} is faster than {item.slower}{where}."


def round_place(place: float) -> float:
    """Two digits of a place that was found by interpolation.

    >>> round_place(95.37), round_place(5882.0)
    (95.0, 5900.0)
    """
    return float(f"{place:.2g}")


def limit_text(part: Part) -> str:
    """The sentence on the limit; empty where there is none."""
    limit = part.limit
    if limit is None:
        return ""
    return (
        f"{limit.asked}: {seconds_text(limit.took)}, {limit.factor:.3g} times the limit, "
        f"{seconds_text(limit.seconds)}: {limit.words}."
    )


def first_and_last(route: Route) -> tuple[Point, Point] | None:
    """The points at the least and at the largest place."""
    if not route.points:
        return None
    ordered = sorted(route.points, key=lambda point: point.place)
    return ordered[0], ordered[-1]
