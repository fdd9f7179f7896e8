"""What the figures draw: numbers taken from certified enclosures, and what was certified about them.

Every function returns floats that bound a ball from outside (:func:`gspot_verified.balls.float_bounds`). No drawing here.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, fmpq

from gspot_verified.balls import ball, certainly_less, exact, float_bounds, relative_bits, sign_of, working_bits
from gspot_verified.dyadic import Dyadic
from gspot_verified.theta.evaluate import theta
from gspot_verified.theta.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta.routes import theta_by

_DIGITS_PER_BIT = math.log10(2)
_BOX_BITS = 4
_LARGEST_EXPONENT = 6
_SERIES_DIGITS = 60


@dataclass(frozen=True, slots=True)
class Curve:
    """Enclosures at points: the exact value at ``at[i]`` lies in ``[lower[i], upper[i]]``."""

    label: str
    at: tuple[float, ...]
    lower: tuple[float, ...]
    upper: tuple[float, ...]

    @property
    def middle(self) -> tuple[float, ...]:
        """The middle of each enclosure: where the line is drawn."""
        return tuple((low + high) / 2 for low, high in zip(self.lower, self.upper, strict=True))


@dataclass(frozen=True, slots=True)
class Boxes:
    """Enclosures on touching intervals: for *every* tau in ``[edges[i], edges[i+1]]`` the value lies in the i-th bounds."""

    label: str
    edges: tuple[float, ...]
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    negative: int
    """How many of the boxes are certainly below 0."""


@dataclass(frozen=True, slots=True)
class SeriesError:
    """The relative error of the series cut after ``terms`` terms, its proved bound, and how often error < bound is certain."""

    terms: int
    error: Curve
    bound: Curve
    certain: int


def _curve(label: str, points: Iterable[Fraction], value: Callable[[Fraction], arb]) -> Curve:
    points = tuple(points)
    bounds = [float_bounds(value(point)) for point in points]
    return Curve(label, tuple(map(float, points)), tuple(b[0] for b in bounds), tuple(b[1] for b in bounds))


def grid(first: int, last: int, per_unit: int) -> tuple[Fraction, ...]:
    """The multiples of 1/per_unit from ``first`` to ``last``.

    >>> [str(point) for point in grid(0, 1, 2)]
    ['0', '1/2', '1']
    """
    return tuple(Fraction(k, per_unit) for k in range(first * per_unit, last * per_unit + 1))


def theta_curve(beta: str, points: Sequence[Fraction]) -> Curve:
    """Theta(tau, beta) at the points.

    >>> theta_curve("1", [Fraction(-2)]).middle
    (2.0,)
    """
    return _curve(beta, points, lambda tau: theta(tau, beta, digits=12))


def slope_boxes(beta: str, first: int, last: int) -> Boxes:
    """dTheta/dtau on a cover of [first, last] by boxes, each halved until its enclosure is narrow."""
    edges, bounds, negative = [float(first)], [], 0
    waiting = [Dyadic(k, k + 1, -3) for k in reversed(range(8 * first, 8 * last))]
    while waiting:
        box = waiting.pop()
        value = theta(box.to_ball(), beta, derivative=1, digits=12)
        start, end = box.endpoints()
        if relative_bits(value) < _BOX_BITS and (end - start) * 2**_LARGEST_EXPONENT > Fraction(1, 8):
            middle = (start + end) / 2
            waiting += [_interval(middle, end), _interval(start, middle)]
            continue
        bounds.append(float_bounds(value))
        edges.append(float(end))
        negative += sign_of(value) == -1
    return Boxes(beta, tuple(edges), tuple(b[0] for b in bounds), tuple(b[1] for b in bounds), negative)


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


def reciprocal_gamma_curve(points: Sequence[Fraction]) -> Curve:
    """1/Gamma(-beta) at the points; exactly 0 at beta = 0, 1, 2, ..."""

    def value(beta: Fraction) -> arb:
        with working_bits(64):
            return reciprocal_gamma(fmpq(-beta.numerator, beta.denominator), 64)

    return _curve("1/Gamma(-beta)", points, value)


def series_error(beta: str, terms: int, points: Sequence[Fraction]) -> SeriesError:
    """\\|Theta - S_N\\|/Theta at tau = -x, S_N the first N = ``terms`` terms at tau -> -infinity, and the bound: the next term.

    Written out here once more, in balls, so that the figure does not lean on the route that it is about.
    """
    errors, bounds, certain = [], [], 0
    for x in points:
        value = theta(-x, beta, digits=_SERIES_DIGITS)
        with working_bits(256):
            error = abs(value - sum((_term(k, x, beta) for k in range(terms)), arb(0))) / value
            bound = abs(_term(terms, x, beta)) / value
        errors.append(float_bounds(error))
        bounds.append(float_bounds(bound))
        certain += certainly_less(error, bound) is True
    at = tuple(map(float, points))
    curves = [
        Curve(label, at, tuple(low for low, _ in found), tuple(high for _, high in found))
        for label, found in (("error", errors), ("bound", bounds))
    ]
    return SeriesError(terms, curves[0], curves[1], certain)


def _term(k: int, x: Fraction, beta: str) -> arb:
    """(-beta)_(3k) (-1)^k / (3^k k!) x^(beta - 3k)."""
    parameter = ball(exact(beta, "beta"))
    return (-parameter).rising(3 * k) * ball(exact(x, "x")) ** (parameter - 3 * k) / ((-3) ** k * arb.fac_ui(k))
