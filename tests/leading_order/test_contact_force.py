"""The force against the printed formulas in mpmath, and every hypothesis of the system one by one.

Page: proofs/iwc.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import holds, to_fmpq
from witnesses.force import force_by_mpmath

from gspot_verified import evaluate, gamma_sign
from gspot_verified.leading_order.contact_force import LEAST_TENS, contact_force, rounded_down
from gspot_verified.numbers.balls import bits_for_digits, relative_bits, working_bits

NOT_INTEGER = st.fractions(Fraction(11, 10), 8, max_denominator=12).filter(lambda beta: beta.denominator > 1)


@settings(max_examples=25)
@given(NOT_INTEGER, st.fractions(-6, 6, max_denominator=9), st.fractions(Fraction(1, 100), 3, max_denominator=100))
def test_the_force_is_the_printed_formula(beta: Fraction, tau: Fraction, epsilon: Fraction) -> None:
    force = contact_force(beta, alpha_1="-3/2", alpha_2="-2/7", c1="-5/3")
    value = force.value(tau, epsilon, 20)
    expected = force_by_mpmath(force, to_fmpq(tau), to_fmpq(epsilon))
    assert abs(float(value.mid()) - float(expected)) <= 1e-12 * (1 + abs(float(expected)))
    with working_bits(128):
        parts = force.direction * evaluate(tau, beta, derivative=1).value + force.level(to_fmpq(epsilon))
    assert not (parts > 0 and value < 0)
    assert not (parts < 0 and value > 0)


@given(st.fractions(-200, 200, max_denominator=7), st.integers(1, 40))
def test_rounded_down(logarithm: Fraction, digits: int) -> None:
    with working_bits(400):
        ball = arb(to_fmpq(logarithm))
        found = rounded_down(ball, digits)
        assert found is not None
        assert arb(found).log() <= ball
        assert arb(found).log() > ball - 20 * arb(10) ** -digits or found == fmpq(10) ** 100


def test_rounded_down_where_it_gives_up() -> None:
    with working_bits(128):
        ten = arb(10).log()
        assert rounded_down((LEAST_TENS - 1) * ten, 5) is None
        assert rounded_down((LEAST_TENS + 1) * ten, 5) is not None
        assert rounded_down(10**6 * ten, 5) == fmpq(10) ** 100
        assert rounded_down(arb.nan(), 5) is None
        assert rounded_down(arb.neg_inf(), 5) is None
        assert rounded_down(arb(0, 10**7), 5) is None


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({"beta": "7/3"}, (-1, "-7/3")),
        ({"alpha_3": "-3/2"}, (-1, "-3/2")),
        ({"alpha_1": -2, "alpha_3": -3}, (-2, -3)),
        ({"beta": "3/2", "alpha_3": -3}, (-2, -3)),
        ({"beta": "3/2", "alpha_1": -4}, (-4, -6)),
        ({"beta": "3/2", "alpha_1": -4, "alpha_3": -6}, (-4, -6)),
    ],
)
def test_what_is_left_out(arguments: dict[str, object], expected: tuple[object, object]) -> None:
    force = contact_force(**arguments)  # type: ignore[arg-type]
    assert (force.alpha_1, force.alpha_3) == tuple(fmpq(*map(int, str(x).split("/"))) for x in expected)
    assert force.beta == force.alpha_3 / force.alpha_1
    assert force.alpha_2 == -1


@pytest.mark.parametrize("beta", ["1/2", "3/2", "5/2", "7/2", "99/100", "1999/20"])
@pytest.mark.parametrize("charge", [None, 1, -1, "1/1000", -1000])
def test_the_side(beta: str, charge: object) -> None:
    """C_1/Gamma(-beta) > 0 takes an impact; C_1 left out has the sign of Gamma(-beta)."""
    force = contact_force(beta, c1=charge)  # type: ignore[arg-type]
    assert force.direction == (1 if force.c1 > 0 else -1)
    assert force.takes_impact == (force.c1 / (gamma_sign(beta) or 0) > 0)
    assert charge is not None or (force.takes_impact and abs(force.c1) == 1)
    # At infinity: far to the right the deviation has the sign of the side.
    far = force.value(200, 1)
    assert (far > 0) if force.takes_impact else (far < 0)


def test_the_three_cases_and_what_lies_between() -> None:
    assert contact_force("1/2").case == "I"
    assert contact_force("1/2", alpha_2=1).case == "II"
    assert contact_force("1/2", alpha_2=0).case == "none"
    assert contact_force("3/2").case == "III"
    # line 284: alpha_2/(alpha_3 - alpha_1)
    assert contact_force(alpha_1=-2, alpha_2=-5, alpha_3=-3).mean == 5
    assert contact_force(alpha_1=-2, alpha_2=-5, alpha_3=-1).mean == -5


@settings(max_examples=25)
@given(NOT_INTEGER, st.fractions(Fraction(1, 100), 100, max_denominator=100), st.integers(5, 40))
def test_level_and_logarithm_are_where_the_force_is_zero(beta: Fraction, epsilon: Fraction, digits: int) -> None:
    force = contact_force(beta, alpha_1="-3", alpha_2="-2/7", c1="5/3")
    small = to_fmpq(epsilon)
    with working_bits(300):
        # At slope = -level the force is 0, so the logarithm of eps comes back.
        again = force.log_epsilon(-force.level(small, digits), digits)
        assert again.is_finite()
        assert again.overlaps(arb(small).log())
        assert again.rad() < arb(10) ** (2 - digits)
        size = force.amplitude(digits) * arb(small) ** arb(force.exponent)
        assert (force.level(small, digits) * size).overlaps(arb(force.mean))


def test_amplitude_at_a_place_without_powers() -> None:
    # alpha_1 = -2: kappa = 1, so A = |C_1/alpha_3|.
    force = contact_force("5/2", alpha_1=-2, c1="-3/7")
    assert holds(force.amplitude(), Fraction(3, 35))
    # alpha_1 = -16: kappa = 2, beta = 5/2, A = |C_1/alpha_3| 2^(-3/2), A^2 = (1/40)^2/8 for C_1 = 1.
    square = contact_force("5/2", alpha_1=-16, c1=1).amplitude() ** 2
    assert holds(square, Fraction(1, 12800))
    assert contact_force("5/2").exponent == 1


BAD = [
    ({}, ValueError, "beta: give beta"),
    ({"beta": 2}, ValueError, "beta: .* not an integer"),
    ({"beta": 1}, ValueError, "beta: .* not an integer"),
    ({"alpha_1": -1, "alpha_3": -3}, ValueError, "beta: .* not an integer"),
    ({"beta": "7/3", "alpha_1": -1, "alpha_3": -2}, ValueError, "beta: 7/3 was given, but alpha_3/alpha_1 = 2"),
    ({"beta": "7/3", "alpha_3": 1}, ValueError, "alpha_3: expected a number < 0"),
    ({"beta": "7/3", "alpha_3": 0}, ValueError, "alpha_3: expected a number < 0"),
    ({"beta": "7/3", "alpha_1": 0}, ValueError, "alpha_1: expected a number < 0"),
    ({"beta": "7/3", "alpha_1": 1}, ValueError, "alpha_1: expected a number < 0"),
    ({"beta": "7/3", "alpha_2": 0}, ValueError, "alpha_2: Case III"),
    ({"beta": "7/3", "alpha_2": 1}, ValueError, "alpha_2: Case III"),
    ({"beta": "-1/2"}, ValueError, "beta: expected a number in"),
    ({"beta": 0}, ValueError, "beta: expected a number in"),
    ({"beta": "201/2"}, ValueError, "beta: expected a number in"),
    ({"beta": "7/3", "c1": 0}, ValueError, "c1: .* canard"),
    ({"beta": "1/2", "c1": "0/5"}, ValueError, "c1: .* canard"),
    ({"beta": arb(2, fmpq(1, 9))}, ValueError, "beta: .* a ball"),
    ({"beta": "7/3", "alpha_2": arb(-1, fmpq(1, 9))}, ValueError, "alpha_2: .* a ball"),
    ({"beta": 2.5}, TypeError, "beta: a float"),
    ({"beta": "7/3", "c1": 1.5}, TypeError, "c1: a float"),
]


@pytest.mark.parametrize(("arguments", "error", "message"), BAD)
def test_bad_input(arguments: dict[str, object], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        contact_force(**arguments)  # type: ignore[arg-type]


@pytest.mark.parametrize("epsilon", [0, -1])
def test_bad_epsilon_of_the_force(epsilon: int) -> None:
    with pytest.raises(ValueError, match="epsilon"):
        contact_force("7/3").value(0, epsilon)


@pytest.mark.parametrize("beta", ["101/100", "3/2", "5/2"])
@pytest.mark.parametrize("alpha_2", [0, "1/100"])
def test_case_iii_needs_a_negative_alpha_2(beta: str, alpha_2: object) -> None:
    with pytest.raises(ValueError, match=r"alpha_2: Case III \(beta > 1\) needs a number < 0"):
        contact_force(beta, alpha_2=alpha_2)  # type: ignore[arg-type]


@pytest.mark.parametrize("digits", [5, 20, 60])
def test_the_digits_of_the_force_are_those_asked_for(digits: int) -> None:
    value = contact_force("7/3").value(1, "1/1000", digits)
    assert relative_bits(value) >= bits_for_digits(digits)


def test_rounded_down_is_below_the_whole_ball() -> None:
    """The lower end counts: for its size, for its digits, and for whether there is a number at all."""
    with working_bits(128):
        assert rounded_down(arb(0, 1), 5) == fmpq(36787, 10**5)  # e^-1 = 0.367879...
        assert rounded_down(arb(2, 3), 3) == fmpq(367, 1000)
        assert rounded_down(arb(0, 10**6), 5) is None
        assert rounded_down(arb(300, 1), 5) == fmpq(10) ** 100
        assert rounded_down(arb(1000, 900), 5) == fmpq(26881, 10**4) * fmpq(10) ** 43  # e^100 = 2.68811...e43


def test_rounded_down_where_the_exponential_is_not_told_from_1() -> None:
    with working_bits(128):
        least = -(arb(2) ** -300)
        found = rounded_down(least, 5)
    assert found is not None
    assert fmpq(9999, 10**4) <= found < 1  # e^least < 1


@pytest.mark.parametrize(("charge", "side"), [(-1, "> 0, λ_N → +∞"), (1, "< 0, λ_N → -∞")])
def test_the_text_names_the_side(charge: int, side: str) -> None:
    first, _ = contact_force("5/2", c1=charge).lines()
    assert first == f"  Case III: β = 5/2, α1 = -1, α2 = -1, α3 = -2.5, C1 = {charge}: the side C1/Γ(-β) {side}"
