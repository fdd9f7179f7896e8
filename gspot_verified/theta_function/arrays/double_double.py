"""Polynomials at many points in pairs of doubles, with a bound on every rounding error: where one double is too short.

Proof page: ``proofs/float_horner.md``.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from flint import arb, arb_poly

from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.arrays.float_horner import (
    REACH_OF_DOUBLES,
    ROUNDED_UP,
    SMALLEST,
    UNDERFLOW,
    UNIT,
    FloatArray,
    IndexArray,
)

_STEP = 24  # u^2 that one step of Horner's rule is wrong by, of its terms: statement F3
_SPLITTER = 2.0**27 + 1  # Veltkamp's: halves of 26 bits
_BLOCK = 2_048  # points at a time, with some twenty numbers each: they stay in the processor's cache


class DoubleDoublePolynomial(NamedTuple):
    """Coefficients ``high[k] + low[k]``; ``error`` bounds what :func:`double_double_horner` and they are wrong by."""

    high: tuple[float, ...]
    low: tuple[float, ...]
    error: float


def double_double_polynomial(polynomial: arb_poly) -> DoubleDoublePolynomial:
    """The polynomial in pairs of doubles; ``error`` is infinite where they do not hold it.

    error = sum over k of (24 (k + 1) u^2 |A_k| + |a_k - A_k - B_k|) REACH^k, and 2^-880 for what underflows, rounded
    up.
    """
    high, low, error, reach = [], [], UNDERFLOW, 1.0
    for k, value in enumerate(polynomial.coeffs() or [arb(0)]):
        first = _leading_double(value)
        with working_bits(53 + max(53, value.bits())):
            rest = value - arb(first)
        second = _leading_double(rest)
        with working_bits(53):
            lost = float((rest - arb(second)).abs_upper())
        high.append(first)
        low.append(second)
        error += (_STEP * (k + 1) * UNIT * UNIT * ROUNDED_UP * abs(first) + lost) * reach
        reach *= REACH_OF_DOUBLES
    if not math.isfinite(error):
        return DoubleDoublePolynomial((0.0,), (0.0,), math.inf)
    return DoubleDoublePolynomial(tuple(high), tuple(low), error * ROUNDED_UP)


def _leading_double(value: arb) -> float:
    """The midpoint rounded to a double; 0 for a small one."""
    with working_bits(53):
        middle = float(+value.mid())
    return middle if abs(middle) > SMALLEST else 0.0


def double_double_horner(
    points: FloatArray, panels: IndexArray, centres: FloatArray, inverses: FloatArray, high: FloatArray, low: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """For each point the value of its panel's polynomial at s = (point - centre) * inverse, as a sum of two doubles,
    and |s| as computed.

    ``high[k] + low[k]`` are the coefficients of s^k by panel; the inverses are powers of two.
    """
    values, rests, sizes = (np.empty_like(points) for _ in range(3))
    for start in range(0, len(points), _BLOCK):
        part = slice(start, start + _BLOCK)
        index = panels[part]
        inverse = inverses.take(index)
        s, s_rest = _sum(points[part], -centres.take(index))
        s *= inverse
        s_rest *= inverse
        s_high, s_low = _halves(s)
        value, rest = high[-1].take(index), low[-1].take(index)
        for k in range(len(high) - 2, -1, -1):
            product = value * s
            value_high, value_low = _halves(value)
            lost = ((value_high * s_high - product) + value_high * s_low + value_low * s_high) + value_low * s_low
            lost += rest * s + value * s_rest
            total, rounding = _sum(product, high[k].take(index))
            value, rest = _sum(total, (lost + rounding) + low[k].take(index))
        values[part], rests[part] = value, rest
        np.abs(s, out=sizes[part])
    return values, rests, sizes


def one_double(rests: FloatArray, errors: FloatArray) -> FloatArray:
    """Bounds on what the first double of each pair is wrong by: its rest and the error, rounded up."""
    radii: FloatArray = (np.abs(rests) + errors) * ROUNDED_UP
    return radii


def _sum(x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """fl(x + y), and what the rounding lost, exactly (Knuth)."""
    total = x + y
    of_y = total - x
    return total, (x - (total - of_y)) + (y - of_y)


def _halves(x: FloatArray) -> tuple[FloatArray, FloatArray]:
    """x as a sum of two doubles of 26 bits, exactly (Veltkamp, Dekker)."""
    scaled = _SPLITTER * x
    first = scaled - (scaled - x)
    return first, x - first
