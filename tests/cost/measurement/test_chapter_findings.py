"""Growth, crossovers and prices of points whose laws are known."""

from __future__ import annotations

import pytest

from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Measurement, Part, Point, Route
from gspot_verified.cost.measurement.text import (
    Crossover,
    certificate_prices,
    crossovers,
    growth,
    measurement_text,
    time_at,
)


def route(name: str, *pairs: tuple[float, float], kind: str = CERTIFIED, panel: str = "") -> Route:
    return Route(name, kind, tuple(Point(place, "", best, best, 1) for place, best in pairs), panel=panel)


def part(*routes: Route) -> Part:
    return Part("key", "Title", "Question", "digits D", "D", routes)


def test_the_exponent_is_that_of_the_last_four_points(made_up: Measurement) -> None:
    ours, other, absent = made_up.parts[0].routes
    assert growth(ours).exponent == pytest.approx(1)
    assert growth(other).exponent == pytest.approx(3)
    assert growth(absent).exponent is None
    bent = route("bent", (1, 9.0), (10, 1.0), (20, 4.0), (40, 16.0), (80, 64.0))
    assert (growth(bent).exponent, growth(bent).first, growth(bent).last) == (pytest.approx(2), 10, 80)


def test_no_exponent_over_a_short_range() -> None:
    assert growth(route("short", (10, 1.0), (29, 5.0))).exponent is None
    assert growth(route("long", (10, 1.0), (30, 3.0))).exponent == pytest.approx(1)


def test_the_place_where_two_laws_cross(made_up: Measurement) -> None:
    [found] = crossovers(made_up.parts[0])
    assert (found.faster, found.slower) == ("ours", "other")
    assert found.place == pytest.approx(10)


def test_noise_is_no_crossover() -> None:
    near = part(route("a", (1, 1.0), (2, 1.0), (3, 1.0)), route("b", (1, 1.2), (2, 0.9), (3, 1.2)))
    assert crossovers(near) == []
    apart = part(route("a", (1, 1.0), (2, 1.0), (4, 1.0)), route("b", (1, 2.0), (2, 0.95), (4, 0.5)))
    assert crossovers(apart) == [Crossover("b", "a", pytest.approx(2), "")]


def test_routes_of_two_panels_do_not_cross() -> None:
    assert crossovers(part(route("a", (1, 1.0), (4, 4.0)), route("b", (1, 4.0), (4, 1.0), panel="other"))) == []


def test_the_price_is_taken_where_both_answer() -> None:
    sure, cheap = route("sure", (10, 1.0), (50, 5.0)), route("cheap", (3, 0.1), (20, 0.5), (90, 1.0), kind=NO_BOUND)
    [price] = certificate_prices(part(sure, cheap))
    assert (price.place, price.certified, price.cheap) == (20, "sure", "cheap")
    assert price.factor == pytest.approx(4)  # 20 on the line from (10, 1) to (50, 5): 2 seconds
    assert certificate_prices(part(sure)) == []


def test_no_time_outside_the_points() -> None:
    points = route("a", (2, 2.0), (8, 8.0)).points
    assert time_at(points, 1) is None
    assert time_at(points, 9) is None
    assert time_at(points, 8) == 8


def test_the_text_says_everything(made_up: Measurement) -> None:
    text = measurement_text(made_up)
    for words in (
        "ours: power 1.00 from 1 to 64, expected in the long run 1",
        "From D ≈ 10 on, ours is faster than other.",
        "not installed",
        "8 times the limit",
        "53 bits, series: negative (wrong)",
        "mpmath: no answer\n",
        "2020-01-02",
    ):
        assert words in text, words
