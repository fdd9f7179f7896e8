"""The figure of the slow force: what its caption counts."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq

from gspot_verified.report.figures import force_figure


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
