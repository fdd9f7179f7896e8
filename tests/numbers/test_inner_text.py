"""What is written of a ball lies in it, is nearly all of it, and is read exactly."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from flint import arb

from gspot_verified.numbers.balls import add_remainder, ball_text, exact, working_bits
from gspot_verified.numbers.inner_text import in_inner_interval, inner_ends, inner_text


def ends(value: arb) -> tuple[Fraction, Fraction]:
    """Those of the ball itself."""
    middle, radius = (
        Fraction(int(m)) * Fraction(2) ** int(e) for m, e in (value.mid().man_exp(), value.rad().man_exp())
    )
    return middle - radius, middle + radius


def test_what_is_written_lies_in_the_ball() -> None:
    draw = random.Random(5)
    with working_bits(200):
        for _ in range(200):
            middle = arb(draw.choice([0.0, draw.uniform(-1, 1) * 10.0 ** draw.randint(-12, 12)]))
            value = add_remainder(middle, arb(10.0 ** draw.randint(-20, 3) * draw.uniform(0.1, 1)))
            lower, upper = (Fraction(word) for word in inner_text(value).strip("[]").split(", "))
            first, last = ends(value)
            assert first <= lower < upper <= last
            assert upper - lower > (last - first) * Fraction(99, 100)
            assert [str(Fraction(int(end.p), int(end.q))) for end in inner_ends(value)] == [str(lower), str(upper)]


def test_the_usual_text_may_hold_several_times_as_much() -> None:
    """Why there is another one for sets of which something is said of every element."""
    with working_bits(200):
        value = add_remainder(arb("0.000912345678901234"), arb("8.7e-10"))
        shown = arb(ball_text(value))
        assert shown.rad() > 5 * value.rad()


def test_an_exact_number_is_itself_and_no_ball_is_refused() -> None:
    assert inner_text(arb(-0.75)) == "[-3/4, -3/4]"
    for value in (arb("nan"), arb("inf"), arb(0, "inf")):
        with pytest.raises(ValueError, match="finite"):
            inner_text(value)
        assert in_inner_interval(arb(0), value) is None


def test_what_lies_in_it_is_certain() -> None:
    with working_bits(200):
        value = arb("0.5", "0.00012305")
        upper = inner_ends(value)[1]
        assert upper == exact("0.500123", "upper")
        assert in_inner_interval(arb("0.5", "0.0001"), value) is not None
        assert in_inner_interval(arb("0.50012302"), value) is None  # in the ball, and not in what is written
        assert value.contains(arb("0.50012302"))
        assert in_inner_interval(arb("0.4", "0.001"), value) is None
        assert in_inner_interval(arb("nan"), value) is None
