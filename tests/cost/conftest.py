from __future__ import annotations

import pytest

from gspot_verified.cost.measurement.measurement import (
    CERTIFIED,
    NO_BOUND,
    CheapAnswer,
    Limit,
    Measurement,
    Part,
    Point,
    Route,
    Share,
)


def points(*pairs: tuple[float, float]) -> tuple[Point, ...]:
    return tuple(Point(place, f"{place:g} digits", 2 * best, best, 3, 2048) for place, best in pairs)


@pytest.fixture
def made_up() -> Measurement:
    """A measurement that nobody measured: ours takes x, the other x^3 / 100, so that they cross at 10."""
    ours = Route("ours", CERTIFIED, points((1, 1.0), (4, 4.0), (16, 16.0), (64, 64.0)), 1.0, "by hand")
    other = Route("other", NO_BOUND, points((1, 0.01), (4, 0.64), (16, 40.96), (64, 2621.44)), 3.0)
    absent = Route("absent", NO_BOUND, (), note="not installed")
    limit = Limit("64 digits", "one product", 8.0, 64.0)
    part = Part(
        "made-up", "A part", "A question.", "digits D", "D", (ours, other, absent), "all", (Share("x", 1.0),), limit
    )
    answer = CheapAnswer("the sign", "why", "positive", ("one", "two"), "negative", "series", "no answer")
    versions = (("Python", "3"), ("gspot-verified", "0"))
    return Measurement((part,), (answer,), "2020-01-02", "a machine", versions, "no load", False, 60.0)
