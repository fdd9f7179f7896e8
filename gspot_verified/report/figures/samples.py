"""What the figures draw: numbers taken from certified enclosures, and what was certified about them.

The floats bound each ball from outside (:func:`gspot_verified.numbers.balls.float_bounds`). No drawing here.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, fmpq

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

_DIGITS_PER_BIT = math.log10(2)
_BOX_BITS = 6
_NARROWEST = Fraction(1, 1024)
_SERIES_DIGITS = 60


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
