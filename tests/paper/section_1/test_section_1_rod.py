"""The rod's α's against differences of p and b, and its Case on both sides of the threshold."""

from __future__ import annotations

import math

import pytest
from flint import fmpq

from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.paper.section_1 import section_1_rod as ledger


def p_and_b(angle: float, rate: float, friction: float) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return 1 + 3 * c**2 - 3 * friction * s * c, s * rate**2 / 2 - 1


@pytest.mark.parametrize("square", [0.15, 0.3, 0.5, 0.8])
def test_alphas_by_differences(square: float) -> None:
    c, s = math.sqrt(square), math.sqrt(1 - square)
    angle, rate, friction = math.acos(c), math.sqrt(2 / s), (1 + 3 * square) / (3 * s * c)
    assert p_and_b(angle, rate, friction) == pytest.approx((0, 0), abs=1e-12)
    h = 1e-6
    later = p_and_b(angle + h * rate, rate, friction)
    before = p_and_b(angle - h * rate, rate, friction)
    first, second = ((a - b) / (2 * h) for a, b in zip(later, before, strict=True))
    turning = 6 * (friction * s - c)
    third = -(p_and_b(angle, rate + h, friction)[1] - p_and_b(angle, rate - h, friction)[1]) / (2 * h) * turning
    assert first == pytest.approx(rate * (1 - 5 * square) / (s * c), rel=1e-6)
    assert second == pytest.approx(c * rate**3 / 2, rel=1e-6)
    assert third == pytest.approx(-2 * s * rate / c, rel=1e-6)
    assert (first < third < 0 < second) is (square > 3 / 7)


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("LEAST", fmpq(2)),
        ("PLACE_OF_LEAST", fmpq(1, 4)),
        ("THRESHOLD", fmpq(1, 2)),
        ("AT_THE_SPOT", {**ledger.AT_THE_SPOT, "2 α_2/w³": "-C"}),
        ("AT_THE_SPOT", {**ledger.AT_THE_SPOT, "C α_3/(S w)": "2 + 0*C"}),
    ],
)
def test_the_other_places_are_in_no_case(monkeypatch: pytest.MonkeyPatch, name: str, wrong: object) -> None:
    assert ledger.others_are_in_no_case() is True
    monkeypatch.setattr(ledger, name, wrong)
    assert ledger.others_are_in_no_case() is False


def test_the_least_friction_with_a_place_where_p_vanishes() -> None:
    least = min((1 + 3 * q) ** 2 / (9 * q * (1 - q)) for q in (k / 1000 for k in range(1, 1000)))
    assert least == pytest.approx(float(ledger.LEAST.p) / float(ledger.LEAST.q))


def test_the_threshold() -> None:
    assert fmpq(64, 27) == ledger.BOUND
    assert math.sqrt(64 / 27) == pytest.approx(8 / (3 * math.sqrt(3)))


def test_below_the_threshold_there_is_no_case() -> None:
    assert classify(shipped_mechanism("falling rod, lower friction")).case == "none"
    assert ledger.classified(fmpq(2)) is True


def test_p_and_b_are_independent_of_each_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """p, or a function of it, in the place of b has no slope in the rate of the angle."""
    assert ledger.are_independent() is True
    found = ledger.quantities()
    for wrong in ({"b": found["p"]}, {"p": found["b"]}, {"alpha_1": 2 * found["alpha_1"]}):
        monkeypatch.setattr(ledger, "quantities", lambda wrong=wrong: {**found, **wrong})
        assert ledger.are_independent() is False
