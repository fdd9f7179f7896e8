"""The mean value form: what it holds, where it is attained, and that a ball of tau is as narrow as it makes it.

Page: proofs/identities.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, holds, small_heights, to_fmpq
from witnesses.theta import theta_witness

from gspot_verified import evaluate
from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.value.mean_value import mean_value_form


@given(st.integers(-40, 24), small_heights(), st.integers(-30, -2), st.sampled_from([-8, -5, 0, 3, 8]))
def test_it_holds_the_values_on_the_ball(tau: int, beta: Fraction, exponent: int, share: int) -> None:
    """By mpmath, at the ends too."""
    m, b, r = fmpq(tau, 4), to_fmpq(beta), Fraction(2) ** exponent
    wide = arb(arb(m), arb((1, exponent)))
    form = mean_value_form(b, wide.rad(), evaluate(m, b, digits=40).value, evaluate(wide, b - 1).value, 200)
    value = theta_witness(Fraction(tau, 4) + r * share / 8, beta, 40)
    lower, upper = ends(form)
    slack = abs(value) / 10**35
    assert lower - slack <= value <= upper + slack


@pytest.mark.parametrize(("beta", "center", "below"), [(1, -3, 1), (1, 2, 1), (2, 9, -3)])
def test_it_is_attained_by_linear_functions(beta: int, center: int, below: int) -> None:
    """Theta(., 1) = -tau with the slope -1; a slope b F with any constant F gives the two ends exactly."""
    radius = Fraction(1, 8)
    lower, upper = ends(mean_value_form(fmpq(beta), arb((1, -3)), arb(center), arb(below), 128))
    reach = radius * abs(beta * below)
    assert lower <= center - reach <= center + reach <= upper
    assert upper - lower <= 2 * reach * (1 + Fraction(1, 10**8))


def test_balls_of_beta_and_of_the_slope_count_with_their_farthest_number() -> None:
    form = mean_value_form(arb((2, 0), (1, 0)), arb((1, -1)), arb((5, 0), (1, 0)), arb((-1, 0), (3, 0)), 128)
    lower, upper = ends(form)
    # |beta| <= 3, |F| <= 4, r = 1/2: 6 around [4, 6].
    assert lower <= -2
    assert upper >= 12
    assert upper - lower <= 14 + Fraction(1, 10**6)


def test_what_is_not_finite_gives_nothing() -> None:
    assert not mean_value_form(fmpq(2), arb((1, -1)), arb(1), arb.nan(), 64).is_finite()
    assert not mean_value_form(fmpq(2), arb((1, -1)), arb.nan(), arb(1), 64).is_finite()


@pytest.mark.parametrize(
    ("tau", "beta"), [(-3, "7/3"), (-30, "5/2"), (2, "1/2"), (5, "-3/2"), (0, "9/2"), (-20, "-1/3")]
)
@pytest.mark.parametrize("exponent", [-12, -25, -40])
def test_a_narrow_ball_is_as_narrow_as_the_slope_allows(tau: int, beta: str, exponent: int) -> None:
    """First order: the width over the width of tau is |Theta'|, and both end values are inside."""
    wide = evaluate(arb(tau, arb((1, exponent))), beta).value
    slope = abs(evaluate(tau, beta, derivative=1, digits=20).value)
    with working_bits(128):
        assert wide.rad() < slope * arb((1, exponent)) * fmpq(11, 10)
        assert wide.rad() > slope * arb((1, exponent)) * fmpq(9, 10)
    r = Fraction(2) ** exponent
    for end in (tau - r, tau + r):
        lower, upper = ends(evaluate(end, beta, digits=40).value)
        assert holds(wide, (lower + upper) / 2)
