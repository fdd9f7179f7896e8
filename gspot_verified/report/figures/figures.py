"""The figures of the report: atlas, Theta, its slope, routes, side-switching, the series at tau -> -oo, and others.

Each caption is written from the numbers that were certified while the figure was drawn, so it cannot claim more.

What they draw are numbers taken from certified enclosures: the floats bound each ball from outside
(:func:`gspot_verified.numbers.balls.float_bounds`).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.report.figures.atlas import atlas_picture
from gspot_verified.report.figures.force_figure import force_picture
from gspot_verified.report.figures.second_trajectory_figure import second_trajectory_picture
from gspot_verified.report.figures.side_map import coarse_side_map
from gspot_verified.report.figures.uniform_figure import uniform_picture
from gspot_verified.report.pictures.canvas import (
    BLUE,
    COLOURS,
    GREEN,
    INK,
    ORANGE,
    STYLES,
    VERMILION,
    Picture,
    canvas,
    picture,
    styled,
)
from gspot_verified.signs.gamma.count_law import negative_zeros, number_of_zeros, positive_zeros
from gspot_verified.signs.gamma.side import side
from gspot_verified.signs.zeros.zeros import zeros_on_range

if TYPE_CHECKING:
    from matplotlib.axes import Axes
from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from gspot_verified.numbers.balls import (
    ball,
    bits_for_digits,
    certainly_less,
    exact,
    float_bounds,
    relative_bits,
    sign_of,
    working_bits,
)
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.theta import theta
from gspot_verified.theta_function.value.routes import theta_by

_LAST = 12  # end of the range of beta


@styled
def count_law_picture() -> Picture:
    """The positive and the negative zeros on each open interval between integers, and all zeros at the integers."""
    figure = canvas(3.4)
    axes = figure.add_subplot()
    middles = [fmpq(2 * m + 1, 2) for m in range(_LAST)]
    at = [float(beta.p) / float(beta.q) for beta in middles]
    positive, negative = [positive_zeros(b) for b in middles], [negative_zeros(b) for b in middles]
    axes.bar(at, positive, width=0.94, color=BLUE, alpha=0.8, label="τ > 0")
    axes.bar(at, negative, width=0.94, bottom=positive, color=ORANGE, alpha=0.8, hatch="//", label="τ < 0")
    integers = range(1, _LAST + 1)
    axes.plot(integers, [number_of_zeros(n) for n in integers], "o", color=INK, label="β an integer: all, τ = 0 too")
    axes.set(xlabel="β", ylabel="real zeros of dΘ/dτ", xlim=(0, _LAST + 0.3), xticks=range(_LAST + 1))
    axes.set_yticks(range(max(map(sum, zip(positive, negative, strict=True))) + 2))
    axes.legend(loc="upper left", ncols=3)
    return picture(
        figure,
        "count_law",
        "The count law: how many real zeros dΘ/dτ has",
        f"Certified: the number for every β in (0, {_LAST}], by the count law (proofs/count_law.md). It is the same on "
        f"each of the {_LAST} open intervals between integers (bars; all zeros are simple there); at the integers "
        "different zeros are counted once each (dots). On (0, 1) there are none. Not shown: larger β, for which the "
        "law holds, too.",
        "Bars that grow by one at beta = 1, 4, 7, 10, with one more in each third interval, for a negative zero.",
    )


_DIGITS_PER_BIT = math.log10(2)  # relative_bits counts in bits
_BOX_BITS = 6  # an enclosure with so many certain bits is narrow: its box is not halved again
_NARROWEST = Fraction(1, 1024)  # nor is a box of this width
_SERIES_DIGITS = 60  # the smallest errors drawn are near 1e-19: the value must be far more accurate


@dataclass(frozen=True, slots=True)
class SampledEnclosures:
    """Enclosures at points: the exact value at ``at[i]`` lies in ``[lower[i], upper[i]]``."""

    label: str
    at: tuple[float, ...]
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    accurate: int
    """At how many points the enclosure has the accuracy that was asked for."""

    @property
    def middle(self) -> tuple[float, ...]:
        """The middle of each enclosure: where the line is drawn."""
        return tuple((low + high) / 2 for low, high in zip(self.lower, self.upper, strict=True))


@dataclass(frozen=True, slots=True)
class Boxes:
    """Enclosures on touching intervals: for *every* tau in ``[edges[i], edges[i+1]]`` the value is in the bounds i."""

    label: str
    edges: tuple[float, ...]
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    negative: int
    """How many of the boxes are certainly below 0."""


@dataclass(frozen=True, slots=True)
class SeriesError:
    """The relative error of the series cut after ``terms`` terms, and its proved bound."""

    terms: int
    error: SampledEnclosures
    bound: SampledEnclosures
    certain: int
    """At how many points error < bound is certain."""


def _curve(label: str, points: Sequence[Fraction], balls: Sequence[arb], digits: int) -> SampledEnclosures:
    bounds = [float_bounds(value) for value in balls]
    accurate = sum(relative_bits(value) >= bits_for_digits(digits) for value in balls)
    at = tuple(float(point) for point in points)
    return SampledEnclosures(label, at, tuple(low for low, _ in bounds), tuple(high for _, high in bounds), accurate)


def grid(first: int, last: int, per_unit: int) -> tuple[Fraction, ...]:
    """The multiples of 1/per_unit from ``first`` to ``last``.

    >>> [str(point) for point in grid(0, 1, 2)]
    ['0', '1/2', '1']
    """
    return tuple(Fraction(k, per_unit) for k in range(first * per_unit, last * per_unit + 1))


def theta_curve(beta: str, points: Sequence[Fraction]) -> SampledEnclosures:
    """Theta(tau, beta) at the points.

    >>> theta_curve("1", [Fraction(-2)]).middle
    (2.0,)
    """
    return _curve(beta, points, [theta(tau, beta, digits=12) for tau in points], 12)


def slope_boxes(beta: str, first: int, last: int) -> Boxes:
    """dTheta/dtau on a cover of [first, last] by boxes of width 1/8, each the hull of enclosures on narrower boxes."""
    steps = range(8 * first, 8 * last)
    parts = [_slope_parts(Dyadic(k, k + 1, -3), beta) for k in steps]
    bounds = [[float_bounds(value) for value in part] for part in parts]
    return Boxes(
        beta,
        tuple(k / 8 for k in [*steps, 8 * last]),
        tuple(min(low for low, _ in part) for part in bounds),
        tuple(max(high for _, high in part) for part in bounds),
        sum(all(sign_of(value) == -1 for value in part) for part in parts),
    )


def _slope_parts(box: Dyadic, beta: str) -> list[arb]:
    """Enclosures of dTheta/dtau on pieces that cover the box, halved until they are narrow or 1/1024 wide."""
    value = theta(box.to_ball(), beta, derivative=1, digits=12)
    start, end = box.endpoints()
    if relative_bits(value) >= _BOX_BITS or end - start <= _NARROWEST:
        return [value]
    middle = (start + end) / 2
    return _slope_parts(_interval(start, middle), beta) + _slope_parts(_interval(middle, end), beta)


def _interval(start: Fraction, end: Fraction) -> Dyadic:
    """Both denominators are powers of two."""
    scale = math.lcm(start.denominator, end.denominator)
    return Dyadic(int(start * scale), int(end * scale), 1 - scale.bit_length())


def route_digits(route: str, beta: str, points: Sequence[Fraction], digits: int) -> tuple[float, ...]:
    """How many digits the route certifies at each point when it is planned for ``digits``; NaN where it has no answer.

    >>> route_digits("negative", "7/3", [Fraction(1)], 30)
    (nan,)
    """
    balls = (theta_by(route, tau, beta, digits=digits) for tau in points)
    return tuple(max(0, relative_bits(ball)) * _DIGITS_PER_BIT if ball.is_finite() else math.nan for ball in balls)


def reciprocal_gamma_curve(points: Sequence[Fraction]) -> SampledEnclosures:
    """1/Gamma(-beta) at the points; exactly 0 at beta = 0, 1, 2, ..."""
    with working_bits(64):
        balls = [reciprocal_gamma(fmpq(-beta.numerator, beta.denominator), 64) for beta in points]
    return _curve("1/Gamma(-beta)", points, balls, 15)


def series_error(beta: str, terms: int, points: Sequence[Fraction]) -> SeriesError:
    """\\|Theta - S_N\\|/Theta at tau = -x, S_N the N = ``terms`` terms of the series; its bound: the next term.

    Written out here once more, in balls, so that the figure does not lean on the route that it is about.
    """
    errors, bounds, certain = [], [], 0
    for x in points:
        value = theta(-x, beta, digits=_SERIES_DIGITS)
        with working_bits(256):
            error = abs(value - sum((_term(k, x, beta) for k in range(terms)), arb(0))) / value
            bound = abs(_term(terms, x, beta)) / value
        errors.append(error)
        bounds.append(bound)
        certain += certainly_less(error, bound) is True
    return SeriesError(terms, _curve("error", points, errors, 12), _curve("bound", points, bounds, 12), certain)


def _term(k: int, x: Fraction, beta: str) -> arb:
    """(-beta)_(3k) (-1)^k / (3^k k!) x^(beta - 3k)."""
    parameter = ball(exact(beta, "beta"))
    coefficient: arb = (-parameter).rising(3 * k) / ((-3) ** k * arb.fac_ui(k))
    return coefficient * ball(exact(x, "x")) ** (parameter - 3 * k)


_ROUTES = {
    "taylor": "Taylor series\nat 0",
    "negative": "series at\nτ → −∞",
    "positive": "series at\nτ → +∞",
    "laplace": "Laplace\nintegral",
}


@styled
def theta_picture() -> Picture:
    """Theta(tau, beta) for five beta."""
    figure = canvas(3.9)
    axes = figure.add_subplot()
    points = grid(-6, 2, 16) + grid(2, 3, 16)[1:9]
    betas = ("1/2", "3/2", "7/3", "5/2", "3")
    curves = [theta_curve(beta, points) for beta in betas]
    for curve, colour, style in zip(curves, COLOURS, STYLES, strict=True):
        axes.fill_between(curve.at, curve.lower, curve.upper, color=colour, alpha=0.3, linewidth=0)
        axes.plot(curve.at, curve.middle, color=colour, linestyle=style, label=f"β = {curve.label}")
    _stretched(axes, (-10, -1, 0, 1, 10, 100))
    axes.axhline(0, color=INK, linewidth=0.7)
    axes.set(xlabel="τ", ylabel="Θ(τ, β)", xlim=(-6, 2.5), ylim=(-25, 300))
    axes.legend(loc="lower left", ncols=2)
    return picture(
        figure,
        "theta",
        "Θ(τ, β) for five β",
        f"Certified: an enclosure of the value at each of the {len(points)} points τ = −6, −95/16, …, 5/2 for each β; "
        f"{sum(curve.accurate for curve in curves)} of {len(points) * len(curves)} have 12 significant digits. Only "
        "drawn: the lines between the points. The vertical scale is linear near 0 and logarithmic far from it.",
        "Five curves. On the left all are positive and ordered by beta; on the right each turns upward or downward.",
    )


@styled
def slope_picture() -> Picture:
    """dTheta/dtau on a cover of [-6, 3], for beta in (0, 1)."""
    figure = canvas(3.9)
    axes = figure.add_subplot()
    betas = ("1/10", "1/4", "1/2", "3/4", "9/10")
    covers = [slope_boxes(beta, -6, 3) for beta in betas]
    for boxes, colour in zip(covers, COLOURS, strict=True):
        label = f"β = {boxes.label}"
        axes.stairs(
            boxes.upper,
            boxes.edges,
            baseline=boxes.lower,
            fill=True,
            facecolor=colour,
            edgecolor=colour,
            linewidth=1.2,
            snap=False,
            label=label,
        )
    axes.set_yscale("symlog", linthresh=0.01, linscale=0.35)
    axes.axhline(0, color=INK, linewidth=1)
    axes.set_yticks([0, -0.01, -0.1, -1, -10], ["0", "−0.01", "−0.1", "−1", "−10"])
    axes.set(xlabel="τ", ylabel="dΘ/dτ (τ, β)", xlim=(-6, 3), ylim=(-30, 0.004))
    axes.minorticks_off()
    axes.legend(loc="lower left")
    boxes_in_all = sum(len(boxes.lower) for boxes in covers)
    negative = sum(boxes.negative for boxes in covers)
    finding = (
        f"all {boxes_in_all} boxes lie below 0, so dΘ/dτ < 0 at every τ in [−6, 3] for these five β"
        if negative == boxes_in_all
        else f"{negative} of {boxes_in_all} boxes lie below 0; for the others the sign is not settled here"
    )
    return picture(
        figure,
        "slope",
        "dΘ/dτ for β between 0 and 1: the slope behind the impact without collision",
        "Certified: each coloured box is an enclosure of dΘ/dτ for every τ in its interval, and the intervals cover "
        f"[−6, 3]; {finding}. Not shown by this figure: other β and other τ; the table of statements says what is "
        "proved there. Boxes have an outline, so that thin ones stay visible. The vertical scale is linear "
        "between −0.01 and 0 and logarithmic below.",
        "Five bands, all below the zero line, falling steeply on the right.",
    )


@styled
def routes_picture() -> Picture:
    """How many digits each route certifies, planned for 30."""
    figure = canvas(4.6)
    digits, beta = 30, "7/3"
    points = [Fraction(5 * k, 2) for k in range(-80, 81)]
    at = [float(point) for point in points]
    certified = {route: route_digits(route, beta, points, digits) for route in _ROUTES}
    top = max(value for values in certified.values() for value in values if not math.isnan(value))
    rows = figure.subplots(len(_ROUTES), 1, sharex=True, sharey=True)
    for axes, (route, values), colour in zip(rows, certified.items(), COLOURS, strict=False):
        axes.fill_between(at, values, color=colour, alpha=0.25, linewidth=0)
        axes.plot(at, values, color=colour)
        axes.axhline(digits, color=INK, linewidth=0.8, linestyle=(0, (4, 3)))
        axes.set_ylabel(_ROUTES[route], rotation=0, ha="right", va="center")
        axes.set(xlim=(-200, 200), ylim=(0, 1.15 * top), yticks=(0, 15, 30, 45))
    rows[0].set_title(f"certified digits of Θ(τ, {beta})", loc="left")
    rows[-1].set_xlabel("τ")
    return picture(
        figure,
        "routes",
        "Where each route works",
        f"Certified: the number of digits, from the radius of the enclosure that the route returns at β = {beta} for "
        f"τ = −200, −197.5, …, 200, asked for {digits} digits (dashed) and with no second attempt. Nothing is drawn "
        f"where a route has no answer: a hypothesis of its bound does not hold there, or {digits} digits are out of "
        "its reach. A value below the dashed line is a valid enclosure that is wider than asked; the library then "
        "raises the precision. Only drawn: the lines between the points.",
        "Four rows. Taylor series and Laplace integral answer everywhere, the two asymptotic series far from zero.",
    )


@styled
def sides_picture() -> Picture:
    """The sign of Gamma(-beta), and the side that lifts off."""
    figure = canvas(3.6)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    points = grid(-1, 4, 32) + grid(4, 7, 128)[1:]
    curve = reciprocal_gamma_curve(points)
    signed = (
        (GREEN, [low > 0 for low in curve.lower]),
        (VERMILION, [high < 0 for high in curve.upper]),
    )
    for colour, where in signed:
        near = [a or b or c for a, b, c in zip([False, *where[:-1]], where, [*where[1:], False], strict=True)]
        upper.fill_between(curve.at, curve.middle, where=near, color=colour, alpha=0.25, linewidth=0)
    upper.plot(curve.at, curve.middle, color=INK)
    _stretched(upper, (-100, -10, -1, 0, 1, 10, 100))
    upper.axhline(0, color=INK, linewidth=0.7)
    upper.plot(range(8), [0] * 8, "o", color=INK, markersize=4, clip_on=False, zorder=5)
    upper.set(ylabel="1/Γ(−β)", xlim=(-1, 7), ylim=(-1500, 2000))
    lower.set(yticks=(), ylim=(0, 1), xlabel="β", ylabel="lifts off")
    switching = side(-1, 7)
    for interval in switching.intervals:
        middle = float(interval.lower + interval.upper) / 2
        colour = GREEN if interval.sign > 0 else VERMILION
        if interval.lift_off_sign is not None:
            text = "C₁ < 0" if interval.lift_off_sign < 0 else "C₁ > 0"
            lower.axvspan(float(interval.lower), float(interval.upper), color=colour, alpha=0.25, linewidth=0)
            lower.text(middle, 0.5, text, ha="center", va="center", color=INK)
        else:
            lower.text(middle, 0.5, "—", ha="center", va="center", color=INK)
        upper.text(middle, 700, "+" if interval.sign > 0 else "−", ha="center", va="center", fontsize=13, color=INK)
    for integer in switching.integers:
        lower.axvline(integer, color=INK, linewidth=1)
    return picture(
        figure,
        "sides",
        "Side-switching: which sign of C₁ lifts off",
        f"Certified: the sign of Γ(−β) on each of the {len(switching.intervals)} open intervals between integers, for "
        f"every β in it; 1/Γ(−β) = 0 exactly at the integers 0 to 7 (dots); the value at {len(points)} points. Only "
        "drawn: the curve between the points. The strip applies the paper's criterion, lift-off if and only if "
        "C₁/Γ(−β) < 0; the criterion itself is the paper's and is not certified by this figure. It is stated for Case "
        "III, β > 1, so the strip is empty (—) for β < 1. The vertical scale "
        "is linear near 0 and logarithmic far from it.",
        "The sign of 1/Γ(−β) alternates between consecutive integers, and so does the sign of C₁ that lifts off.",
    )


@styled
def series_picture() -> Picture:
    """The error of the series at tau -> -infinity against its bound."""
    figure = canvas(4.4)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(2.2, 1))
    points = [Fraction(round(64 * 2 ** (k / 8)), 64) for k in range(41)]
    certain = drawn = 0
    for terms, colour, marker in zip((1, 2, 3, 5), COLOURS, "os^D", strict=False):
        marked: dict[str, Any] = {"color": colour, "marker": marker, "markevery": 4, "markersize": 4}
        errors = series_error("1/2", terms, points)
        upper.plot(errors.error.at, errors.error.middle, **marked, label=f"N = {terms}")
        upper.plot(errors.bound.at, errors.bound.middle, color=colour, linestyle="--", linewidth=1)
        ratios = [e / b for e, b in zip(errors.error.middle, errors.bound.middle, strict=True)]
        lower.plot(errors.error.at, ratios, **marked)
        certain, drawn = certain + errors.certain, drawn + len(points)
    upper.plot([], [], color=INK, linestyle="--", linewidth=1, label="bound")
    upper.set(xscale="log", yscale="log", ylabel="|Θ − sum| / Θ", xlim=(1, 32), ylim=(1e-19, 1e7))
    upper.legend(loc="lower left", ncols=2)
    lower.axhline(1, color=INK, linewidth=1, linestyle="--")
    lower.set(xlabel="x = −τ", ylabel="error / bound", ylim=(0, 1.1))
    lower.set_xticks([1, 2, 4, 8, 16, 32], ["1", "2", "4", "8", "16", "32"])
    lower.minorticks_off()
    return picture(
        figure,
        "series",
        "The series at τ → −∞ and its bound, β = 1/2",
        "Relative error of the sum of the first N terms (full lines) and the proved bound, the size of the first "
        f"omitted term over Θ (dashed). Certified: both, at {len(points)} points x for each N, from enclosures of Θ to "
        f"60 digits; error < bound is certain at {certain} of {drawn} points. Only drawn: the lines between them. "
        "Every fourth point is marked. That the bound holds for every x > 0 is a theorem with the hypothesis 3N > β, "
        "not a finding of this figure.",
        "Error curves fall with x, faster for larger N; each stays below its dashed bound and approaches it.",
    )


def _stretched(axes: Axes, ticks: tuple[int, ...]) -> None:
    """A vertical scale that is linear near 0 and logarithmic far from it."""
    axes.set_yscale("asinh", linear_width=1.0)
    axes.set_yticks(ticks, [str(tick).replace("-", "−") for tick in ticks])
    axes.minorticks_off()


def atlas_figure() -> Picture:
    """The sign atlas on beta in (0, 6)."""
    return atlas_picture(zeros_on_range("0..6"))


_PICTURES: tuple[Callable[[], Picture], ...] = (
    atlas_figure,
    theta_picture,
    slope_picture,
    routes_picture,
    sides_picture,
    series_picture,
    force_picture,
    count_law_picture,
    second_trajectory_picture,
    coarse_side_map,
    uniform_picture,
)


def drawings() -> dict[str, Callable[[], Picture]]:
    """What draws each figure of the report, in the order in which it shows them."""
    return {f"figure {number} of {len(_PICTURES)}": draw for number, draw in enumerate(_PICTURES, start=1)}
