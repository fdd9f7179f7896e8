"""Theorem 1 of the page on known systems: what is captured arrives, what is not captured may go elsewhere.

Page: proofs/approach.md.
"""

from __future__ import annotations

import pytest
from flint import arb

from gspot_verified.balls import working_bits
from gspot_verified.mechanisms.capture import Capture, capture
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.to_system import shift


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
