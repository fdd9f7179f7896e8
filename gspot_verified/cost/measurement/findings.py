"""What the points of a part say: growth exponents, and where one route becomes faster than another."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Part, Point, Route
from gspot_verified.cost.times.growth import fitted_exponent

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
