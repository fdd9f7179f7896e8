"""The first point at which the slow force reaches a level: the first of several, to any number of digits, or none.

Page: proofs/monotone.md, section 7.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.contact import crossing as crossing_module
from gspot_verified.compliant.contact.crossing import LevelReached, NotBelow, first_crossing
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.stretches import Level
from gspot_verified.numbers.balls import approximate, working_bits

# f_0 of beta = 7/2 rises to about -3 near tau = -0.3, falls to about -9.2 near 1.5, and rises from there on.
WAVE = Profile.leading_order(fmpq(7, 2))
START = fmpq(-10)


def at(value: fmpq) -> Level:
    def level(digits: int) -> arb:
        with working_bits(4 * digits + 64):
            return arb(value)

    return level


def crossing(value: fmpq, digits: int = 12, start: fmpq = START) -> LevelReached:
    found = first_crossing(WAVE, start, at(value), digits)
    assert found is not None
    assert found.upper - found.lower <= fmpq(1, 10**digits)
    assert WAVE.value(found.lower, digits + 12) < value < WAVE.value(found.upper, digits + 12)
    return found


def test_the_first_of_three_points() -> None:
    """f_0 is -5 on the way up, on the way down and on the way up again."""
    first = crossing(fmpq(-5))
    assert fmpq(-1) < first.lower < first.upper < fmpq(-9, 10)
    again = crossing(fmpq(-5), start=fmpq(3, 5))
    assert fmpq(2) < again.lower < again.upper < fmpq(5, 2)


@pytest.mark.parametrize(("value", "low", "high"), [(-20, -2, -1), (-2, 2, 3), (1, 2, 3), (1000, 4, 6)])
def test_where_the_level_is_reached(value: int, low: int, high: int) -> None:
    """Before f_0 increases for good, on the last rise, and far beyond."""
    found = crossing(fmpq(value))
    assert low < found.lower < found.upper < high


def test_many_digits() -> None:
    crossing(fmpq(-20), 60)


def test_above_the_level_at_the_start() -> None:
    with pytest.raises(NotBelow):
        first_crossing(WAVE, START, at(fmpq(-2000)), 12)
    with pytest.raises(NotBelow):
        first_crossing(WAVE, fmpq(0), at(fmpq(-20)), 12)


def test_a_level_that_balls_cannot_tell_from_the_start() -> None:
    with working_bits(400):
        start = WAVE.value(START, 100).mid()
    assert first_crossing(WAVE, START, lambda _: start, 12) is None
    assert first_crossing(WAVE, START, lambda _: arb(0, 10**6), 12) is None


def test_a_fall_below_the_level_is_passed_over() -> None:
    """From 1.1 f_0 falls to about -9.2, and reaches -8 before the point from which on all derivatives are positive."""
    found = crossing(fmpq(-8), start=fmpq(11, 10))
    assert fmpq(9, 5) < found.lower < found.upper < 2


def test_a_level_that_the_greatest_value_nearly_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """The cells round the local maximum, near -0.33, are cut again and again: that ends, and nothing is said."""
    monkeypatch.setattr(crossing_module, "MAX_CELLS", 60)
    place = fmpq(-1, 3)
    for _ in range(6):
        slope, bend = WAVE.derivatives(place, range(1, 3), 20)
        with working_bits(64):
            place = fmpq(*approximate(place - slope / bend).as_integer_ratio())
    top = WAVE.value(place, 20)
    assert first_crossing(WAVE, START, lambda _: top + arb(0, 1e-9), 12) is None
    below = first_crossing(WAVE, START, lambda _: top - fmpq(1, 10**4), 3)
    assert below is not None
    assert below.upper < place
