"""The force for alphas in balls against the force of rational alphas in them, and every hypothesis.

Page: proofs/iwc.md, section 6.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.force_over_balls import OpenHypothesis, force_over_balls
from gspot_verified.numbers.balls import working_bits

RADIUS = Fraction(1, 1000)
OFFSET = st.fractions(-RADIUS, RADIUS, max_denominator=10**6)
ALPHAS = st.tuples(*(st.fractions(Fraction(1, 2), 3, max_denominator=9) for _ in range(3)))


def around(value: Fraction, radius: Fraction = RADIUS) -> arb:
    with working_bits(128):
        return arb(to_fmpq(value), arb(to_fmpq(radius)))


@settings(max_examples=40)
@given(ALPHAS, st.tuples(OFFSET, OFFSET, OFFSET), st.sampled_from([1, -1]), st.integers(-3, 3))
def test_every_system_in_the_balls_is_inside(
    sizes: tuple[Fraction, Fraction, Fraction], offsets: tuple[Fraction, ...], charge: int, tens: int
) -> None:
    centres = [-size for size in sizes]
    beta = centres[2] / centres[0]
    if abs(beta - round(beta)) < Fraction(1, 50) or beta < Fraction(1, 10):
        return
    every = force_over_balls(*map(around, centres), charge)
    first, second, third = (to_fmpq(a + b) for a, b in zip(centres, offsets, strict=True))
    one = contact_force(alpha_1=first, alpha_2=second, alpha_3=third, c1=charge)
    epsilon = fmpq(10) ** tens
    assert (every.case, every.direction, every.takes_impact) == (one.case, one.direction, one.takes_impact)
    slope = arb(1 if one.beta < 1 else -1)  # the opposite sign of the mean force
    with working_bits(128):
        pairs = [
            (every.beta, arb(one.beta)),
            (every.mean(), arb(one.mean)),
            (every.exponent(), arb(one.exponent)),
            (every.amplitude(), one.amplitude(30)),
            (every.level(epsilon), one.level(epsilon, 30)),
            (every.log_epsilon(slope), one.log_epsilon(slope, 30)),
            (every.value(fmpq(tens), epsilon), one.value(tens, epsilon, 30)),
        ]
    for wide, narrow in pairs:
        assert wide.is_finite()
        assert wide.contains(narrow)


def test_the_charge_that_is_left_out() -> None:
    assert force_over_balls(-1, -1, around(Fraction(-3, 2))).c1 == 1
    assert force_over_balls(-1, -1, around(Fraction(-5, 2))).c1 == -1
    assert force_over_balls(-1, around(Fraction(1)), around(Fraction(-1, 2))).case == "II"
    assert force_over_balls(-1, around(Fraction(0)), around(Fraction(-1, 2))).case is None
    assert force_over_balls(-1, 0, around(Fraction(-1, 2))).case == "none"


def test_an_open_case_is_not_said_to_be_none() -> None:
    """alpha_2 in [-1/1000, 1/1000] may be of Case I or II; alpha_2 = 0 is of none."""
    open_case, none = (force_over_balls(-1, second, around(Fraction(-1, 2))) for second in (around(Fraction(0)), 0))
    assert "no Case" not in open_case.lines()[0]
    assert "the sign of α2 is open, and with it the Case: β = " in open_case.lines()[0]
    assert open_case.to_json()["case"] is None
    assert "no Case, between I and II: β = " in none.lines()[0]
    assert none.to_json()["case"] == "none"


@pytest.mark.parametrize(
    ("alphas", "message"),
    [
        ((around(Fraction(0)), -1, -1), "alpha_1"),
        ((-1, -1, around(Fraction(0))), "alpha_3"),
        ((-1, -1, around(Fraction(-2))), "holds an integer"),
        ((-1, -1, around(Fraction(-1))), "holds an integer"),
        ((-1, -1, around(Fraction(-2) - RADIUS)), "holds an integer"),  # the integer is an end of the ball
        ((-1, around(Fraction(0)), around(Fraction(-3, 2))), "alpha_2"),
        ((-1, 0, around(Fraction(-3, 2))), "alpha_2"),
        ((-1, -1, around(Fraction(-100))), "in \\(0, 100\\]"),
    ],
)
def test_open_hypotheses(alphas: tuple[arb | int, ...], message: str) -> None:
    with pytest.raises(OpenHypothesis, match=message):
        force_over_balls(*alphas)


def test_no_charge_and_no_float() -> None:
    with pytest.raises(ValueError, match="C_1 = 0"):
        force_over_balls(-1, -1, around(Fraction(-3, 2)), 0)
    with pytest.raises(TypeError, match="alpha_2"):
        force_over_balls(-1, 0.5, around(Fraction(-3, 2)))  # type: ignore[arg-type]
