"""Theorem 1 of the page on known systems: what is captured arrives, what is not captured may go elsewhere.

Page: proofs/approach.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import cast

import pytest
from flint import arb
from samples.strategies import ends

from gspot_verified.mechanisms.approach.capture import Capture, _keeps_pressing, _reach, capture
from gspot_verified.mechanisms.approach.slip_flow import Numbers, SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import add_remainder, working_bits


def caught(alphas: tuple[str, str, str], p: str, b: str, u: str = "5", surface: arb | None = None) -> Capture | None:
    names = ("alpha_1", "alpha_2", "alpha_3")
    mechanism = shipped_mechanism("model system", **dict(zip(names, alphas, strict=True)))
    numbers = SlipNumbers(SlipFlow.of(shift(mechanism)))
    return capture(numbers, [arb(0), arb(u), arb(0), arb(0), arb(p), arb(b)], surface)


def test_what_is_captured_arrives_in_the_box() -> None:
    """α = (-1, -1, -3/2): p = -t, and u, x at the G-spot by hand from λ = 2 + (λ_1 - 2)(p/p_1)^(1/2)."""
    with working_bits(100):
        found = caught(("-1", "-1", "-3/2"), "0.01", "-0.05", surface=arb(0))
        assert found is not None
        p, force = arb("0.01"), arb(5)
        # u falls by the integral of λ: 2 p + (λ_1 - 2) (2/3) p.
        slip = 5 - 2 * p - (force - 2) * p * 2 / 3
        assert all(side.is_finite() for side in found.box)
        assert found.box[1].contains(slip)
        assert found.box[4].contains(0)
        assert found.box[5].contains(0)
        assert found.time >= p.mid() * arb("0.999")


def test_a_motion_that_is_small_beside_the_radius_of_a_ball_is_captured() -> None:
    """A radius has few bits: v = 0 within 10^-30, and y moves by 10^-50 while p falls from 10^-20."""
    with working_bits(192):
        numbers = SlipNumbers(SlipFlow.of(shift(shipped_mechanism("model system"))))
        small = arb(0, "1e-30")
        found = capture(numbers, [arb(0), arb(5), small, small, arb("1e-20"), arb("-3e-20")], arb(0))
        assert found is not None
        assert all(side.is_finite() for side in found.box)
        assert found.box[2].contains_interior(add_remainder(small, arb("9e-51")))


@pytest.mark.parametrize(
    ("alphas", "p", "b"),
    [
        (("1", "-1", "-3/2"), "0.01", "-0.05"),  # p grows
        (("-1", "-1", "3/2"), "0.01", "-0.05"),  # b does not tend to 0
        (("-2", "1", "-1"), "0.01", "-0.005"),  # Case II below the separatrix λ = 1: lifts off
        (("-2", "1", "-1"), "0.01", "-0.01"),  # on it
        (("-1", "1", "-3/2"), "0.01", "-0.05"),  # the force tends to -2: lifts off
        (("-1", "-1", "-3/2"), "-0.01", "-0.05"),
        (("-1", "-1", "-3/2"), "0.01", "0.05"),
        (("-1", "-1", "-3/2"), "nan", "-0.05"),
    ],
)
def test_what_is_not_captured(alphas: tuple[str, str, str], p: str, b: str) -> None:
    with working_bits(100):
        assert caught(alphas, p, b) is None


def test_slip_that_stops_is_not_captured() -> None:
    with working_bits(100):
        assert caught(("-1", "-1", "-3/2"), "0.01", "-0.05", u="0.02", surface=arb(0)) is None
        assert caught(("-1", "-1", "-3/2"), "0.01", "-0.05", u="0.02") is not None
        assert caught(("-2", "1", "-1"), "0.01", "-0.02") is not None


def numbers(**given: arb) -> Numbers:
    """p = 1, b = -2, u = 5, all alphas -1, one component with F = G = 0, where nothing else is given."""
    known = {"p": arb(1), "b": arb(-2), "u": arb(5), "alpha_1": arb(-1), "alpha_2": arb(-1), "alpha_3": arb(-1)} | given
    F, G = known.pop("F", arb(0)), known.pop("G", arb(0))
    return Numbers(**known, F=(F,), G=(G,))


def test_the_ways_by_hand() -> None:
    """-α_1 >= 2, -α_3 >= 3, |α_2| <= 4, |F| <= 5, |G| <= 7, p <= 3, |b| <= 6: time 3/2, ∫|b| (6 + 4 · 3/2)/3 = 4."""
    at = numbers(p=arb(2, 1), b=arb(-4, 2))
    inside = numbers(alpha_1=arb(-3, 1), alpha_2=arb(-1, 3), alpha_3=arb(-5, 2), F=arb(-2, 3), G=arb(-3, 4))
    with working_bits(80):
        found = _reach(at, inside)
        assert found is not None
        (way,), time, integral, first, third = found
        for bound, exact in ((way, Fraction(71, 2)), (time, Fraction(3, 2)), (integral, Fraction(4))):
            assert exact <= ends(bound)[0] <= exact * (1 + Fraction(1, 10**6))
        for rate, least in ((first, 2), (third, 3)):
            assert least * (1 - Fraction(1, 10**6)) < ends(rate)[0]
            assert ends(rate)[1] <= least


def test_the_time_left_is_no_less_than_a_third() -> None:
    """p = 1 and α_1 = -3, exact: 1/3 is no number of arb, and the bound lies above it."""
    found = _reach(numbers(), numbers(alpha_1=arb(-3)))
    assert found is not None
    assert Fraction(1, 3) <= ends(found[1])[0]


@pytest.mark.parametrize("name", ["alpha_1", "alpha_3"])
@pytest.mark.parametrize("value", [arb(0), arb(1), arb(-1, 2), arb("nan")])
def test_no_ways_without_decay(name: str, value: arb) -> None:
    assert _reach(numbers(), numbers(**{name: value})) is None


@pytest.mark.parametrize(
    ("second", "third", "force", "stays"),
    [
        (arb(-1), arb(-9), arb(1), True),
        (arb(-1, "0.5"), arb(-9), arb(1), True),
        (arb(1), arb(1), arb(1), True),  # 2 · 1 > 1
        (arb(1), arb(1), arb("0.5"), False),  # at rest
        (arb(1), arb(1), arb("0.4"), False),
        (arb(1), arb(-1), arb(9), False),
        (arb(1), arb(-2), arb(-9), False),  # (-1) (-9) > 1, but λ < 0 and α_3 < α_1
        (arb(0, 1), arb(-2), arb(1), False),
        (arb("nan"), arb(1), arb(9), False),
    ],
)
def test_when_the_force_stays_positive(second: arb, third: arb, force: arb, stays: bool) -> None:
    """dλ/ds = -α_2 + (α_3 - α_1) λ with α_1 = -1."""
    assert (_keeps_pressing(force, numbers(alpha_2=second, alpha_3=third)) is not None) is stays


class Steep:
    """F = steepness |ξ|: it moves further than any neighbourhood that was tried, where it is steep."""

    def __init__(self, steepness: int) -> None:
        self.steepness = steepness

    def on(self, box: Sequence[arb]) -> Numbers:
        return numbers(F=arb(self.steepness) * box[0].abs_upper())


@pytest.mark.parametrize(("steepness", "caught"), [(0, True), (10**6, False)])
def test_a_neighbourhood_that_is_left_is_none(steepness: int, caught: bool) -> None:
    with working_bits(80):
        found = capture(cast(SlipNumbers, Steep(steepness)), [arb(0)], None)
    assert (found is not None) is caught
