import math
from fractions import Fraction

import mpmath
import pytest

from gspot_verified.report.figures import figures


def reference(tau, beta, derivative=0):
    """mpmath's Theta at 60 digits, from the hypergeometric form of the paper."""
    with mpmath.workdps(60):
        t, b = mpmath.mpf(tau.numerator) / tau.denominator, mpmath.mpf(beta.numerator) / beta.denominator
        factor = 1
        for j in range(derivative):
            factor *= j - b
        b -= derivative
        total = mpmath.mpf(0)
        for j, lower in enumerate(((1, 2), (2, 4), (4, 5))):
            start = mpmath.gamma((j - b) / 3) * mpmath.rgamma(-b) / mpmath.power(3, (3 - j + b) / 3)
            series = mpmath.hyp1f2((j - b) / 3, *(mpmath.mpf(n) / 3 for n in lower), t**3 / 9)
            total += start * t**j / math.factorial(j) * series
        return factor * total


def test_grid_is_exact_and_includes_both_ends():
    assert figures.grid(-1, 1, 2) == (-1, Fraction(-1, 2), 0, Fraction(1, 2), 1)


@pytest.mark.parametrize("beta", ["1/2", "3/2", "7/3", "-5/4"])
def test_theta_curve_holds_the_values(beta):
    points = figures.grid(-4, 2, 4)
    curve = figures.theta_curve(beta, points)
    assert curve.accurate == len(points)
    for tau, low, high in zip(points, curve.lower, curve.upper, strict=True):
        assert math.isfinite(low)
        assert math.isfinite(high)
        assert low < reference(tau, Fraction(beta)) < high


def test_slope_boxes_touch_cover_and_hold_the_values_inside():
    boxes = figures.slope_boxes("1/4", -2, 2)
    assert boxes.edges == tuple(k / 8 for k in range(-16, 17))
    assert boxes.negative == len(boxes.lower) == 32
    for left, right, low, high in zip(boxes.edges, boxes.edges[1:], boxes.lower, boxes.upper, strict=False):
        for share in (Fraction(0), Fraction(1, 3), Fraction(1)):
            tau = Fraction(left) + share * (Fraction(right) - Fraction(left))
            assert low <= reference(tau, Fraction(1, 4), 1) <= high < 0


def test_slope_boxes_do_not_call_a_sign_change_negative():
    boxes = figures.slope_boxes("3/2", -2, 2)
    assert 0 < boxes.negative < len(boxes.lower)
    assert boxes.negative == sum(high < 0 for high in boxes.upper)
    assert any(low < 0 < high for low, high in zip(boxes.lower, boxes.upper, strict=True))


def test_a_box_that_touches_zero_is_not_called_negative():
    assert figures.slope_boxes("2", -1, 1).negative == 7  # dTheta/dtau = 2 tau


def test_route_digits_is_nan_where_the_route_has_no_answer():
    points = [Fraction(-50), Fraction(-1), Fraction(50)]
    negative = figures.route_digits("negative", "7/3", points, 30)
    assert negative[0] >= 30
    assert math.isnan(negative[1])
    assert math.isnan(negative[2])
    assert all(digits > 25 for digits in figures.route_digits("taylor", "7/3", points, 30))


def test_reciprocal_gamma_is_zero_at_the_integers():
    points = figures.grid(-1, 4, 2)
    curve = figures.reciprocal_gamma_curve(points)
    for beta, low, high in zip(points, curve.lower, curve.upper, strict=True):
        value = mpmath.rgamma(mpmath.mpf(-beta.numerator) / beta.denominator)
        assert low <= value <= high
        assert (low < 0 < high) == (beta.denominator == 1 and beta >= 0)


@pytest.mark.parametrize("terms", [1, 2, 3, 5])
def test_series_error_is_below_the_next_term(terms):
    points = [Fraction(k) for k in (1, 3, 10, 30)]
    found = figures.series_error("1/2", terms, points)
    assert found.certain == len(points)
    with mpmath.workdps(60):
        for x, error, bound in zip(points, found.error.middle, found.bound.middle, strict=True):
            series = [
                mpmath.rf(-mpmath.mpf(1) / 2, 3 * k) * (-1) ** k / (mpmath.mpf(3) ** k * mpmath.factorial(k))
                * mpmath.mpf(int(x)) ** (mpmath.mpf(1) / 2 - 3 * k)
                for k in range(terms + 1)
            ]  # fmt: skip
            exact = reference(-x, Fraction(1, 2))
            assert error == pytest.approx(float(abs(exact - sum(series[:-1])) / exact), rel=1e-12)
            assert bound == pytest.approx(float(abs(series[-1]) / exact), rel=1e-12)
