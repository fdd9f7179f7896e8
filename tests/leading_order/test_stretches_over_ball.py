"""Brackets and values over a ball of beta against those at rational beta in it, and against a column of pieces.

Page: proofs/iwc.md, section 6.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified import evaluate
from gspot_verified.leading_order.stretches import stretches
from gspot_verified.leading_order.stretches_over_ball import SlopeOverBall, _widened, ends, stretches_over_ball
from gspot_verified.numbers.balls import working_bits
from gspot_verified.signs.cover.pieces import number_of_zeros
from gspot_verified.signs.cover.zero_column import zero_column
from gspot_verified.signs.zeros.slope_at import UndecidedError


def around(value: Fraction | str, radius: str) -> arb:
    with working_bits(128):
        return arb(to_fmpq(Fraction(value)), arb(fmpq(*map(int, Fraction(radius).as_integer_ratio()))))


@settings(max_examples=20)
@given(
    st.fractions(Fraction(1, 10), 8, max_denominator=12).filter(lambda beta: beta.denominator > 1),
    st.fractions(-1, 1, max_denominator=50),
    st.sampled_from(["1e-30", "1e-9", "1e-4", "1/300"]),
    st.sampled_from([1, -1]),
    st.sampled_from([-10, -2, 1]),
)
def test_a_beta_of_the_ball(beta: Fraction, part: Fraction, radius: str, sign: int, start: int) -> None:
    """Its critical points are in the brackets, and its values there and at the start in the balls."""
    every = stretches_over_ball(around(beta, radius), sign, fmpq(start), 10)
    one = stretches(to_fmpq(beta + part * Fraction(radius) * Fraction(99, 100)), sign, fmpq(start), 40)
    assert every.rises == one.rises
    assert every.start.value.is_finite()
    assert every.start.value.contains(one.start.value)
    for narrow in one.critical:
        holding = [wide for wide in every.critical if wide.lower <= narrow.lower and narrow.upper <= wide.upper]
        assert len(holding) == 1
        assert holding[0].value.is_finite()
        assert holding[0].value.contains(narrow.value)
    assert not every.whole_line or one.whole_line


@pytest.mark.parametrize("beta", ["3/2", "5/2", "10/3", "17/4", "27/5"])
def test_the_number_of_critical_points_by_a_column_of_pieces(beta: str) -> None:
    ball = around(beta, "1e-6")
    found = stretches_over_ball(ball, 1, fmpq(-30), 8)
    lower, upper = ends(ball)
    column = zero_column(lower - 1, upper - 1)
    assert column is not None
    assert len(found.critical) == number_of_zeros(column)
    for bracket in found.critical:
        assert bracket.upper - bracket.lower < fmpq(1, 1000)


@pytest.mark.parametrize("tau", [-100, -40, -7, 0, 3, 40])
def test_values_near_and_far(tau: int) -> None:
    """Far out there is no Taylor model: the balls are evaluated."""
    ball = around("7/3", "1e-20")
    slope = SlopeOverBall(ball, fmpq(abs(tau)), 20)
    for derivative in (1, 2):
        value = slope.enclosure(fmpq(tau), fmpq(tau), derivative)
        assert value.is_finite()
        assert value.contains(evaluate(tau, "7/3", derivative=derivative, digits=40).value)
        wide = slope.enclosure(fmpq(tau), fmpq(tau) + fmpq(1, 1000), derivative)
        assert wide.is_finite()
        assert wide.contains(evaluate(tau + Fraction(1, 2000), "7/3", derivative=derivative, digits=40).value)


def test_a_wide_ball_has_no_brackets() -> None:
    with pytest.raises(UndecidedError, match="too wide"):
        stretches_over_ball(around("11/2", "49/100"), 1, fmpq(-10))


@pytest.mark.parametrize(("beta", "sign"), [(("2", "1e-9"), 1), (("0", "1e-9"), 1), (("-1/2", "1e-9"), 1)])
def test_balls_that_are_refused(beta: tuple[str, str], sign: int) -> None:
    with pytest.raises(ValueError, match="no integer"):
        stretches_over_ball(around(*beta), sign, fmpq(-10))


def test_a_sign_that_is_none() -> None:
    with pytest.raises(ValueError, match="1 or -1"):
        stretches_over_ball(around("3/2", "1e-9"), 0, fmpq(-10))


def test_a_start_inside_a_bracket_cuts_it() -> None:
    ball = around("5/2", "1/300")
    whole = stretches_over_ball(ball, -1, fmpq(-10)).critical[0]
    start = (whole.lower + whole.upper) / 2
    cut = stretches_over_ball(ball, -1, start)
    assert (cut.critical[0].lower, cut.critical[0].upper) == (start, whole.upper)
    assert not cut.whole_line


class _Curvature:
    """A second derivative with simple zeros at the given places."""

    def __init__(self, *zeros: fmpq) -> None:
        self.zeros = zeros

    def enclosure(self, lower: fmpq, *_: object) -> arb:
        value = fmpq(1)
        for zero in self.zeros:
            value *= lower - zero
        return arb(value)


def test_a_bracket_of_a_critical_point_has_opposite_signs_at_its_ends() -> None:
    """One sign at both ends is no bracket, however certain it is; a wider interval may be one."""
    step = fmpq(1, 16)
    one, two, later = fmpq(1, 100), fmpq(-1, 100), fmpq(1, 7)
    assert _widened(_Curvature(one), fmpq(0), fmpq(0), step) == (-step, step)  # type: ignore[arg-type]
    assert _widened(_Curvature(later), fmpq(0), fmpq(0), step) == (-4 * step, 4 * step)  # type: ignore[arg-type]
    for zeros in ((), (one, two)):
        with pytest.raises(UndecidedError, match="no certain bracket"):
            _widened(_Curvature(*zeros), fmpq(0), fmpq(0), step)  # type: ignore[arg-type]
