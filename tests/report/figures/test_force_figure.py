"""The figure of the slow force: what its caption counts."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq

from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.report.figures import force_figure
from gspot_verified.report.figures.force_figure import ThresholdPoint, threshold_picture, threshold_points


def test_curves_approach_leading_order_from_above() -> None:
    points = force_figure.grid(-1, 1, 1)
    assert points == [Fraction(-1), Fraction(0), Fraction(1)]
    coarse = force_figure.force_curve(fmpq(3, 2), fmpq(1), points)
    fine = force_figure.force_curve(fmpq(3, 2), fmpq(1, 10**6), points)
    assert all(coarse.above)
    assert all(fine.above)
    assert all(a > b for a, b in zip(coarse.values, fine.values, strict=True))


def test_the_sign_follows_the_cell() -> None:
    # b = 1/2: Gamma(-1/2) < 0, so the curve is -G.
    (value,) = force_figure.force_curve(fmpq(1, 2), fmpq(1, 10), [Fraction(0)]).values
    assert value < 0


def test_the_excess_lies_inside_its_bound() -> None:
    excess, bound = force_figure._tube(force_figure.grid(-2, 2, 2))
    assert all(0 < one < other for one, other in zip(excess, bound, strict=True))


def test_the_caption_counts() -> None:
    points = [*threshold_points([fmpq(5, 2), fmpq(21, 4)]), ThresholdPoint(fmpq(7, 2), arb(2), fmpq(1), fmpq(3))]
    found = threshold_picture(points)
    assert "at 3 values" in found.caption
    assert "at most 200.00 %" in found.caption
    assert "at leading order at 1 of them, and smaller at 1;" in found.caption
    assert found.svg.startswith("<svg")
    assert found.png.startswith(b"\x89PNG")


def test_an_exact_epsilon_0_within_the_ball_of_the_leading_one_is_not_compared() -> None:
    """The lower end of what encloses the leading one is no bound on it from above."""
    leading = leading_order_iwc("3/2")
    assert leading.epsilon_0 is not None
    assert leading.largest_epsilon is not None
    point = ThresholdPoint(fmpq(3, 2), leading.largest_epsilon, leading.epsilon_0, 2 * leading.epsilon_0)
    assert "at leading order at 0 of them, and smaller at 0;" in threshold_picture([point]).caption


def test_points_lie_where_they_are_known() -> None:
    (point,) = threshold_points([fmpq(7, 2)])
    assert point.lower <= fmpq(1289908164, 10**11) <= point.upper
    assert point.upper - point.lower < point.lower / 1000


def test_no_points() -> None:
    with pytest.raises(ValueError, match="no points"):
        threshold_picture([])
