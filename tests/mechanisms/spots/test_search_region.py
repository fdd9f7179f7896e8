"""The region of a search: what was given, whole periods, stated bounds; inside, outside and what the balls leave open.

Page: proofs/all_g_spots.md, section 5.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from samples.strategies import ends, holds

from gspot_verified.functions.expressions import Constant, Cosine, Expression, Sine, Variable
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.spots.search_region import Region, _is_interval, search_region
from gspot_verified.mechanisms.spots.spot_conditions import take_apart
from gspot_verified.numbers.balls import working_bits

Q, THETA = Variable(0), Variable(1)
HALF = Constant(fmpq(1, 2))
STATED = "(default: more than one period)"


def rational(value: str | Fraction) -> fmpq:
    exact = Fraction(value)
    return fmpq(exact.numerator, exact.denominator)


def tilted() -> Mechanism:
    """State q, theta, q_dot, theta_dot; theta is counted from atan2(3/5, 4/5) = 0.6435..."""
    return lagrangian(
        "tilted", ["q", "theta"], [[1, 0], [0, 1]], [0, 0], "q", "sin(theta)", 1, {}, {"theta": ("3/5", "4/5")}
    )


def region(conditions: Mapping[str, Expression], box: Mapping[str, Any] | None = None) -> tuple[Region, dict[str, str]]:
    """The region after the sides of all stages were asked for, and what it says was searched."""
    apart = take_apart(conditions, 4, [tilted().state.index(word) for word in box or {}])
    found = search_region(tilted(), conditions, apart, box or {})
    for stage in apart.stages:
        for i in stage.variables:
            found.side(i)
    return found, dict(found.searched(apart))


def test_what_all_conditions_repeat_is_searched_once() -> None:
    """sin(theta/2) has the period 4 pi: one turn is [-2 pi, 2 pi], and values come back to it by whole periods."""
    found, words = region({"p": Sine(HALF * THETA) - HALF, "b": Sine(THETA) * Q - HALF})
    assert words == {
        "q": "[-10, 10] (default bound)",
        "theta": "every angle (all conditions have the period 4 pi)",
        "q_dot": "free: no condition holds it",
        "theta_dot": "free: no condition holds it",
    }
    assert found.periods() == (("theta", fmpq(2)),)
    assert found.period(0) is None
    with working_bits(100):
        period, side = found.period(1), found.side(1)
        assert period is not None
        assert period.overlaps(4 * arb.pi())
        assert period.rad() < arb("1e-20")
        assert side.contains(2 * arb.pi())
        assert side.contains(-2 * arb.pi())
        assert side < 7
        assert found.within_one_period(1, arb(13)).overlaps(13 - 4 * arb.pi())
        assert found.within_one_period(1, arb(-27)).overlaps(8 * arb.pi() - 27)
        assert found.within_one_period(0, arb(13)) == 13
    assert holds(found.side(0), 10)
    assert holds(found.side(0), -10)
    assert found.side(0) < 11
    with working_bits(4):  # where the enclosure of pi is wide
        low, high = ends(found.side(1))
    assert low < Fraction(-62832, 10000)
    assert high > Fraction(62832, 10000)


def test_an_interval_for_one_component_leaves_the_others_their_periods() -> None:
    conditions: dict[str, Expression] = {"p": Sine(THETA) * Q - HALF, "b": Q - Sine(THETA)}
    assert take_apart(conditions, 4).stages[0].variables == (0, 1)
    _, words = region(conditions, {"q": (0, 1)})
    assert words["theta"] == "every angle (all conditions have the period 2 pi)"


def test_a_period_of_one_turn() -> None:
    _, words = region({"p": Sine(THETA) - HALF, "b": Q - HALF})
    assert words["theta"] == "every angle (all conditions have the period 2 pi)"


def test_where_only_the_search_repeats_more_than_one_turn_is_searched() -> None:
    """b holds theta itself, but p alone is solved for it, with the period pi: [-13/8, 13/8] > [-pi/2, pi/2]."""
    found, words = region({"p": Sine(Constant(fmpq(2)) * THETA), "b": Q * Q - THETA})
    assert words["theta"] == f"[-13/8, 13/8] about theta_ref {STATED}"
    assert found.periods() == ()
    assert found.period(1) is None
    assert holds(found.side(1), Fraction(13, 8))
    assert holds(found.side(1), Fraction(-13, 8))
    assert found.side(1) < 2
    assert found.side(1) > -2
    _, words = region({"p": Sine(Q), "b": THETA * THETA - Q})
    assert words["q"] == f"[-13/4, 13/4] {STATED}"


@pytest.mark.parametrize(
    ("place", "interval"),
    [("2", "[-8, 12]"), ("7/3", "[-8, 12]"), ("-5/2", "[-12, 8]"), ("12345", "[12335, 12355]"), ("0.49", "[-10, 10]")],
)
def test_a_default_interval_lies_about_the_place(place: str, interval: str) -> None:
    conditions: dict[str, Expression] = {"p": Q * Q - HALF, "b": THETA * THETA - HALF}
    apart = take_apart(conditions, 4)
    found = search_region(tilted(), conditions, apart, {}, {"q": arb(rational(place)), "theta": arb(7)})
    lower, upper = (Fraction(end) for end in interval.strip("[]").split(","))
    assert holds(found.side(0), lower)
    assert holds(found.side(0), upper)
    assert abs((lower + upper) / 2 - Fraction(place)) <= Fraction(1, 2)
    found.side(1)
    assert dict(found.searched(apart))["q"] == f"{interval} (default bound)"
    assert dict(found.searched(apart))["theta"] == "[-3, 17] about theta_ref (default bound)"
    assert found.in_words(apart, {}).startswith(
        f"q in {interval} (default); theta in [-3, 17] about theta_ref (default)"
    )


def test_more_than_one_turn_about_the_place_holds_it_and_a_turn() -> None:
    """The conditions have the period pi/2 in theta where p alone is solved for it."""
    conditions: dict[str, Expression] = {"p": Sine(Constant(fmpq(4)) * THETA), "b": Q * Q - THETA}
    apart = take_apart(conditions, 4)
    for place in (Fraction(0), Fraction(5), Fraction(-77, 10), Fraction(1, 7)):
        found = search_region(tilted(), conditions, apart, {}, {"theta": arb(rational(place))})
        side = found.side(1)
        assert holds(side, place + Fraction(11, 14))
        assert holds(side, place - Fraction(11, 14))
        assert side.rad() < 1
    unknown = search_region(tilted(), conditions, apart, {}, {"theta": arb("nan")})
    assert unknown.side(1).contains(0)


def test_given_intervals_come_before_periods_and_angles_count_from_their_reference() -> None:
    found, words = region({"p": Sine(THETA) - HALF, "b": Q * Q - HALF}, {"theta": (1, "3/2"), "q": (arb(2).sqrt(), 2)})
    assert words["theta"] == "[1, 3/2]"
    assert words["q"].startswith("[[1.41421356237")
    assert found.periods() == ()
    with working_bits(60):
        side, reference = found.side(1), arb.atan2(arb(3), arb(4))
        assert side.contains(1 - reference)
        assert side.contains(1.5 - reference)
        assert (side.rad() - 0.25).overlaps(arb(0, "1e-6"))
    given, other = found.given(0), region({"p": Q * Q, "b": THETA * THETA})[0].given(0)
    assert given is not None
    assert given.contains(2)
    assert other is None


def test_a_ball_of_ends_is_written_no_wider_than_it_is() -> None:
    """What is found holds for each end in the ball; 0.601, as rounded outward, is none of them."""
    _, words = region({"p": Sine(THETA) - HALF, "b": Q * Q - HALF}, {"q": (arb("0.5", "0.1001"), arb(2))})
    assert words["q"] == "[[0.3999, 0.6001], 2]"


@pytest.mark.parametrize(
    ("value", "position"),
    [
        (arb("0.5"), "inside"), (arb("0.5", "0.1"), "inside"), (arb(0), "inside"), (arb(1), "inside"),
        (arb(1, "0.1"), "boundary"), (arb(0, "0.1"), "boundary"), (arb("0.5", 2), "boundary"), (arb("nan"), "boundary"),
        (arb("1.01"), "outside"), (arb("-0.01"), "outside"), (arb(5, 3), "outside"),
    ],
)  # fmt: skip
def test_positions(value: arb, position: str) -> None:
    found = search_region(tilted(), {}, take_apart({}, 4), {"q": (0, 1), "q_dot": (2, 3)})
    for inner, expected in (
        (arb("2.5"), position),
        (arb(2, "0.1"), "boundary" if position == "inside" else position),
        (arb(9), "outside"),
    ):
        assert found.position([value, arb(77), inner, arb(77)])[0] == expected


def test_what_follows_is_fixed_or_never_searched_is_said() -> None:
    fixed = Variable(2) - HALF
    apart = take_apart({"p": Sine(THETA), "y": Q - Cosine(THETA), "fixed q_dot": fixed}, 4)
    found = search_region(tilted(), {"p": Sine(THETA)}, apart, {})
    assert dict(found.searched(apart)) == {
        "q": "follows from y = 0",
        "theta": "every angle (all conditions have the period 2 pi)",
        "q_dot": "fixed",
        "theta_dot": "free: no condition holds it",
    }
    assert found.in_words(apart, {"q_dot": "1/2"}) == (
        "every angle theta; any theta_dot (no condition holds it); q_dot = 1/2 fixed"
    )
    closed = take_apart({"p": THETA * THETA - HALF}, 4)
    region = search_region(tilted(), closed.functions, closed, {"q": (0, "3/2")})
    assert region.in_words(closed, {}) == (
        "every value of theta; any q in [0, 3/2], q_dot, theta_dot (no condition holds them)"
    )
    assert dict(search_region(tilted(), closed.functions, closed, {}).searched(closed))["theta"] == "every value"


def test_the_ends_of_an_interval_are_certainly_in_order() -> None:
    for lower, upper in ((fmpq(1), fmpq(1)), (fmpq(0), fmpq(1)), (arb(0, "0.5"), fmpq(1)), (fmpq(1), arb(3, 1))):
        assert _is_interval(lower, upper)
        assert _is_interval(arb(lower), arb(upper))
    for lower, upper in ((fmpq(1), fmpq(0)), (arb(2, "0.5"), fmpq(1)), (arb(0, 1), fmpq(1, 2)), (fmpq(1), arb(1, 1))):
        assert not _is_interval(lower, upper)
        assert not _is_interval(arb(lower), arb(upper))


def test_bad_boxes_are_named() -> None:
    def asked(box: Mapping[str, Any]) -> Region:
        return search_region(tilted(), {}, take_apart({}, 4), box)

    with pytest.raises(MechanismError, match=r"tilted: box: 'r' is no component of the state: q, theta, q_dot, theta_"):
        asked({"r": (0, 1)})
    with pytest.raises(MechanismError, match=r"tilted: box, q: a float is not taken as exact"):
        asked({"q": (0.5, 1)})
    root = arb(2).sqrt()
    for bad in ((1, 0), (root, 1), (2, root), (root, root)):  # two balls that overlap may be reversed
        with pytest.raises(MechanismError, match="tilted: box: the interval of q is empty or reversed"):
            asked({"q": bad})
    for good in ((1, 1), (1, root), (root, 2)):
        assert asked({"q": good}).given(0) is not None
