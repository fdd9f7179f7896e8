"""None"""

from __future__ import annotations

import io
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from matplotlib import image

from gspot_verified.report.figures import figures
from gspot_verified.work.executors import as_they_end, executor

NAMES = ["atlas", "theta", "slope", "routes", "sides", "series", "force"]
OF_WHAT_IS_NEW = ["count_law", "second_trajectory", "side_map", "uniform"]


def test_the_figures_have_texts(pictures):
    assert [picture.name for picture in pictures] == NAMES + OF_WHAT_IS_NEW
    for picture in pictures:
        assert "Certified:" in picture.caption
        assert "nan" not in (picture.title + picture.caption + picture.alternative).lower().split()


def test_figures_are_finite_and_not_empty(pictures):
    for picture in pictures:
        assert len(ElementTree.fromstring(picture.svg).findall(".//{*}path")) > 20
        for path in re.findall(r'\bd="([^"]*)"', picture.svg):
            assert not re.search(r"nan|inf", path)
        pixels = image.imread(io.BytesIO(picture.png))
        assert pixels.shape[1] > 1000
        assert len(np.unique(pixels[::7, ::7].reshape(-1, pixels.shape[2]), axis=0)) > 50


def test_a_fresh_process_draws_the_same_bytes(pictures):
    with executor(2) as pool:
        drawn = dict(as_they_end(pool, {"theta": figures.theta_picture, "sides": figures.sides_picture}))
    assert (drawn["theta"], drawn["sides"]) == (pictures[1], pictures[4])


def test_captions_count_what_was_certified(pictures):
    captions = {picture.name: picture.caption for picture in pictures}
    assert "685 of 685 have 12 significant digits" in captions["theta"]
    assert "all 360 boxes lie below 0" in captions["slope"]
    assert "certain at 164 of 164 points" in captions["series"]
    assert "at 244 of 244 of them the value, in units in which leading order is Θ, lies above it" in captions["force"]


def test_slope_caption_says_so_when_a_box_is_not_settled(monkeypatch):
    monkeypatch.setattr(figures, "slope_boxes", lambda _, first, last: original("3/2", first, last))
    caption = figures.slope_picture().caption
    assert "of 360 boxes lie below 0; for the others the sign is not settled here" in caption
    assert "at every τ" not in caption


original = figures.slope_boxes


def test_importing_the_report_loads_no_matplotlib():
    code = "import sys, gspot_verified.report; sys.exit('matplotlib' in sys.modules or 'jinja2' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_the_bars_are_those_of_the_law(monkeypatch) -> None:
    drawn = {}
    original = figures.picture

    def kept(figure, *texts):
        [axes] = figure.axes
        drawn["bars"] = [[bar.get_height() for bar in container] for container in axes.containers]
        drawn["dots"] = list(axes.lines[0].get_ydata())
        return original(figure, *texts)

    monkeypatch.setattr(figures, "picture", kept)
    found = figures.count_law_picture()
    positive, negative = drawn["bars"]
    assert positive == [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4]
    assert negative == [0, 0, 1] * 4
    # β = n, n - 1 = 3s + r: s positive zeros, and τ = 0 for r > 0.
    assert drawn["dots"] == [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4]
    assert re.search(r"12\W open intervals|12 open intervals", found.caption)


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
