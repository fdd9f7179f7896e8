"""Solutions of the differential equation around a point, over a range of b: Taylor coefficients by their recurrence.

Proof page: ``proofs/carried_series.md``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from flint import arb, arb_mat, arb_poly, fmpq

from gspot_verified.numbers.balls import current_bits, nonfinite
from gspot_verified.theta_function.boxes.parameter_series import initial_models
from gspot_verified.theta_function.sums.recurrence import continued

Polynomials = tuple[arb_poly, arb_poly, arb_poly]
"""F, F' and F''/2 at a point, as functions of eta."""

_UNIT = arb((0, 0), (1, 0))
"""[-1, 1]."""


class ParameterRange(NamedTuple):
    """b = centre + radius eta, -1 <= eta <= 1; functions of eta are kept as polynomials of less than ``degree``.

    A polynomial with balls as coefficients encloses a function when for every eta some numbers in the balls make the
    polynomial take its value at eta: page, section 1.
    """

    centre: fmpq
    radius: fmpq
    degree: int


def initial_polynomials(b: ParameterRange, bits: int) -> Polynomials:
    """Theta, Theta' and Theta''/2 at tau = 0; ``bits`` is the working precision, which the caller has set."""
    value, slope, curvature = (
        model.polynomial + arb(0, model.error.abs_upper())
        for model in initial_models(b.centre, b.radius, b.degree, bits)
    )
    return value, slope, curvature * arb(fmpq(1, 2))


def local_series(start: Sequence[arb_poly], b: ParameterRange, point: fmpq, scale: fmpq, length: int) -> list[arb_poly]:
    """a_k = F^(k)(point) scale^k / k! for k < length, so that F(point + scale u) = sum of a_k u^k.

    ``start`` has F, F' and F''/2 at the point. The last coefficient holds all that is left out: for |u| <= 1 and
    d = 0, 1, 2 the sum of C(k, d) a_k u^(k-d) over k < length encloses scale^d F^(d)/d!. It is not finite where
    the tail lemma of the page, section 3, does not apply: ``length`` is too small.

    :raises ValueError: length < 5, or scale <= 0.
    """
    if length < 5 or scale <= 0:
        raise ValueError("length must be at least 5 and scale positive")
    a = coefficients(start, b, point, scale, length)
    a[-1] = a[-1] + _UNIT * _rest(a, b, point, scale)
    return a


def coefficients(start: Sequence[arb_poly], b: ParameterRange, point: fmpq, scale: fmpq, length: int) -> list[arb_poly]:
    """The first ``length`` >= 3 coefficients a_k alone, whatever is left out; page, section 2."""
    unit = arb(scale)
    first = [start[0], start[1] * unit, start[2] * (unit * unit)]
    middle = arb(point) * unit * unit
    factors = _factors(b.centre, b.radius, scale, length - 3, current_bits())
    if b.degree == 1 and not b.radius:
        numbers = continued([value[0] for value in first], [factor[0] for factor in factors], middle)
        return [arb_poly([value]) for value in numbers]
    return continued(first, factors, middle, lambda function: folded(function, b.degree))


@lru_cache(maxsize=64)
def _factors(centre: fmpq, radius: fmpq, scale: fmpq, count: int, bits: int) -> list[arb_poly]:
    """(k - b) scale^3/((k+1)(k+2)(k+3)) for k < count, as polynomials in eta."""
    del bits  # part of the key only
    cube = arb(scale) ** 3
    slope, b = -arb(radius) * cube, arb(centre)
    products = [(k + 1) * (k + 2) * (k + 3) for k in range(count)]
    if not radius:
        return [arb_poly([(k - b) * cube / product]) for k, product in enumerate(products)]
    return [arb_poly([(k - b) * cube / product, slope / product]) for k, product in enumerate(products)]


def folded(function: arb_poly, degree: int) -> arb_poly:
    """The same function with fewer coefficients: those from eta^degree on go into the ball of the constant one."""
    if function.length() <= degree:
        return function
    if function.length() == degree + 1:
        return function.truncate(degree) + function[degree] * _UNIT
    return function.truncate(degree) + function.right_shift(degree)(_UNIT) * _UNIT


def range_of(function: arb_poly) -> arb:
    """All values of the function for -1 <= eta <= 1."""
    return function(_UNIT)


def enclosure(ranges: Sequence[arb], derivative: int) -> arb:
    """All values of scale^d F^(d)/d! for |u| <= 1, from the ranges of a_0, a_1, ... of :func:`local_series`."""
    terms = ranges[derivative:]
    if derivative:
        terms = [math.comb(k, derivative) * value for k, value in enumerate(terms, derivative)]
    return arb_poly(terms)(_UNIT)


Table = arb_mat | arb_poly
"""A series as :func:`values_at` takes it: rows a_k of a matrix, or, for one power of eta, one polynomial in u."""


def table(series: Sequence[arb_poly], degree: int) -> Table:
    """The coefficients of a series for :func:`values_at`."""
    if degree == 1:
        return arb_poly([a[0] for a in series])
    rows = [[*a.coeffs(), *[arb(0)] * (degree - a.length())] for a in series]
    return arb_mat(rows)


def values_at(series: Table, scale: fmpq, u: fmpq) -> Polynomials:
    """F, F' and F''/2 at point + scale u, |u| <= 1, from the table of :func:`local_series`; page, section 4.

    :raises ValueError: |u| > 1.
    """
    if abs(u) > 1:
        raise ValueError("u must lie in [-1, 1]")
    if isinstance(series, arb_poly):
        at, unit, slope = arb(u), arb(scale), series.derivative()
        curvature = slope.derivative()(at) / (2 * unit * unit)
        return arb_poly([series(at)]), arb_poly([slope(at) / unit]), arb_poly([curvature])
    product = _weights(scale, u, series.nrows(), current_bits()) * series
    values, columns = product.entries(), series.ncols()
    return (
        arb_poly(values[:columns]),
        arb_poly(values[columns : 2 * columns]),
        arb_poly(values[2 * columns :]),
    )


@lru_cache(maxsize=256)
def _weights(scale: fmpq, u: fmpq, length: int, bits: int) -> arb_mat:
    """C(k, d) u^(k-d) / scale^d for d = 0, 1, 2 (rows) and k < length."""
    del bits  # part of the key only
    powers = [arb(1)]
    for _ in range(length - 1):
        powers.append(powers[-1] * arb(u))
    rows = []
    for d in range(3):
        factor = 1 / arb(scale) ** d
        rows.append([math.comb(k, d) * powers[max(k - d, 0)] * factor for k in range(length)])
    return arb_mat(rows)


def _rest(a: Sequence[arb_poly], b: ParameterRange, point: fmpq, scale: fmpq) -> arb:
    """e of the page, section 3; not finite where its hypothesis does not hold."""
    i = len(a) - 5
    size = max(fmpq(1), abs(b.centre) + b.radius + 2)
    ratio = (abs(point) * (i + 1) + (i + size) * scale) * scale**2 / ((i + 1) * (i + 2) * (i + 3))
    if not ratio <= fmpq(1, 2):
        return nonfinite()
    first, second, third = (range_of(last).abs_upper() for last in a[-3:])
    return 3 * first.max(second).max(third)
