"""Polynomials at many points in IEEE double arithmetic, with a bound on every rounding error.

Proof page: ``proofs/float_horner.md``.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from flint import arb_poly

from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.sums.local_series import REACH

FloatArray = np.ndarray[Any, np.dtype[np.float64]]
IndexArray = np.ndarray[Any, np.dtype[np.intp]]

UNIT = 2.0**-53  # u: the relative rounding error of a double
REACH_OF_DOUBLES = int(REACH.p) / int(REACH.q)  # exact: 1 + 2^-10
_ACCEPTED = 1.0 + 2.0**-11  # bound of |s| as computed: statement F1
SMALLEST = 2.0**-900  # a coefficient below it is replaced by 0: far above 2^-1022
UNDERFLOW = 2.0**-880  # what underflows, at most: statement F2
_LARGEST_ERROR = 2.0**900  # the coefficients are below 2^954 then, and no sum of theirs overflows: statement F2
ROUNDED_UP = 1.0 + 2.0**-30  # covers what the sum of the bound rounds: statement F2
BLOCK = 8_192
"""Points at a time: they stay in the processor's cache."""


class FloatPolynomial(NamedTuple):
    """Double coefficients; ``error`` bounds what :func:`horner` and the coefficients are wrong by on |s| <= REACH.

    ``constant`` and ``slope``: the parts of :func:`near_bounds`, which is the smaller one next to s = 0.
    """

    coefficients: tuple[float, ...]
    error: float
    constant: float
    slope: float


def float_polynomial(polynomial: arb_poly) -> FloatPolynomial:
    """The polynomial in doubles; ``error`` is infinite where doubles do not hold it.

    error = sum over k of (gamma_(3k+1) |A_k| + |a_k - A_k|) REACH^k, and 2^-880 for what underflows, rounded up;
    constant + REACH slope is the same sum.
    """
    with working_bits(53):
        rounded = [+value for value in polynomial.coeffs()]
    middles = [float(value) for value in rounded]  # exact: 53 bits
    radii = [float(value.rad()) for value in rounded]
    coefficients, error, parts = [], UNDERFLOW, [UNDERFLOW, 0.0]
    reach = below = 1.0  # REACH^k, and REACH^(k - 1)
    for k, (middle, radius) in enumerate(zip(middles, radii, strict=True)):
        kept = middle if abs(middle) > SMALLEST else 0.0
        coefficients.append(kept)
        lost = radius + (SMALLEST if kept == 0.0 and middle else 0.0)
        gamma = (3 * k + 1) * UNIT * ROUNDED_UP
        own = gamma * abs(kept) + lost
        error += own * reach
        parts[min(k, 1)] += own * below
        reach, below = reach * REACH_OF_DOUBLES, reach
    if not error <= _LARGEST_ERROR:
        return FloatPolynomial((0.0,), math.inf, math.inf, math.inf)
    constant, slope = (part * ROUNDED_UP for part in parts)
    return FloatPolynomial(tuple(coefficients), error * ROUNDED_UP, constant, slope)


def _both_signs(values: list[float]) -> FloatArray:
    return np.array([values, [-value for value in values]])


# Their sums and products, rounded to nearest, ties to even; all that stands here is exact.
_TERMS = _both_signs([1.0, 1.0 + 2 * UNIT, 1.0]), _both_signs([UNIT, UNIT, UNIT * (1.0 + 2 * UNIT)])
_SUMS = _both_signs([1.0, 1.0 + 4 * UNIT, 1.0 + 2 * UNIT])
_FACTORS = _both_signs([1.0 + 2.0**-30, 1.0 + 2.0**-27]), np.array([1.0 + 2.0**-30, 1.0 + 2.0**-26])
_PRODUCTS = _both_signs([1.0 + 2.0**-29, 1.0 + 2.0**-26 + 2.0**-27])


def arithmetic_is_ieee() -> bool:
    """Whether numpy rounds sums and products of doubles to nearest, ties to even, and only once: here and now, as each
    thread may change it.

    The bound stands on it. Other rounding directions, and intermediate results of more bits, show in these cases.
    """
    sums, products = _TERMS[0] + _TERMS[1], _FACTORS[0] * _FACTORS[1]
    return bool((sums == _SUMS).all() and (products == _PRODUCTS).all())


def horner(
    points: FloatArray,
    panels: IndexArray,
    centres: FloatArray,
    inverses: FloatArray,
    table: FloatArray,
    values: FloatArray,
) -> FloatArray:
    """Fill in for each point the value of its panel's polynomial at s = (point - centre) * inverse; |s| as computed.

    ``table[k]`` holds the coefficients of s^k by panel; the inverses are powers of two. A number of a panel beyond the
    table counts as the nearest one: a point that does not lie there is not :func:`accepted`.
    """
    sizes = np.empty_like(points)
    room = np.empty(min(BLOCK, len(points)))
    for start in range(0, len(points), BLOCK):
        part = slice(start, start + BLOCK)
        index, s, total = panels[part], sizes[part], values[part]
        taken = room[: len(index)]
        np.subtract(points[part], centres.take(index, out=taken, mode="clip"), out=s)
        s *= inverses.take(index, out=taken, mode="clip")
        table[-1].take(index, out=total, mode="clip")
        for row in table[-2::-1]:
            total *= s
            total += row.take(index, out=taken, mode="clip")
        np.abs(s, out=s)
    return sizes


def near_bounds(sizes: FloatArray, constants: FloatArray, slopes: FloatArray) -> FloatArray:
    """Bounds on the errors of :func:`horner` that become smaller with |s|, by statement F5."""
    bounds: FloatArray = (constants + (sizes + SMALLEST) * slopes) * ROUNDED_UP
    return bounds


def accepted(sizes: FloatArray) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Where the point certainly lies in its panel: |s| <= REACH for the exact s."""
    return sizes <= _ACCEPTED
