"""Polynomials in pairs of doubles: the error against exact fractions, and the bound against the page.

Page: proofs/float_horner.md.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, arb_poly
from hypothesis import example, given
from hypothesis import strategies as st
from samples.strategies import ends, make_ball

from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.arrays.double_double import (
    DoubleDoublePolynomial,
    double_double_horner,
    double_double_polynomial,
    one_double,
)
from gspot_verified.theta_function.arrays.float_horner import accepted

_REACH = Fraction(1025, 1024)
_LONG = st.tuples(st.integers(-(2**140), 2**140), st.integers(-160, -120))  # mantissa and exponent of a midpoint


def _evaluated(
    polynomial: DoubleDoublePolynomial, points: list[float], centre: float, inverse: float
) -> list[tuple[float, float]]:
    high, low = np.array(polynomial.high)[:, None], np.array(polynomial.low)[:, None]
    index = np.zeros(len(points), dtype=np.intp)
    at = np.array(points), index, np.array([centre]), np.array([inverse])
    values, rests, sizes = double_double_horner(*at, high, low)
    assert accepted(sizes).all()
    return list(zip(values.tolist(), rests.tolist(), strict=True))


@given(
    st.lists(_LONG, min_size=1, max_size=20),
    st.integers(-64, 63),
    st.sampled_from([1, 4, 32]),
    st.lists(st.floats(-1, 1), min_size=1, max_size=6),
)
@example([(1, 0), (-1, 0)], 0, 1, [1.0, 1.0 - 2.0**-53, 5e-324])  # next to a zero
@example([(-(3**80), -127), (2**127, -127)], 0, 32, [0.1, 5e-324, -5e-324])
def test_the_pair_is_within_the_bound(
    coefficients: list[tuple[int, int]], cell: int, count: int, places: list[float]
) -> None:
    """The exact value of the polynomial at the exact s, in fractions."""
    centre, inverse = cell + 1 / (2 * count), 2.0 * count
    points = [centre + place / inverse for place in places]
    polynomial = double_double_polynomial(arb_poly([make_ball((m, e), (0, 0)) for m, e in coefficients]))
    page = Fraction(0)
    for k, (m, e) in enumerate(coefficients):
        page += 24 * (k + 1) * abs(m) * Fraction(2) ** (e - 106) * _REACH**k
    for point, (value, rest) in zip(points, _evaluated(polynomial, points, centre, inverse), strict=True):
        s = (Fraction(point) - Fraction(centre)) * Fraction(inverse)
        exact = sum((m * Fraction(2) ** e * s**k for k, (m, e) in enumerate(coefficients)), Fraction(0))
        wrong = abs(Fraction(value) + Fraction(rest) - exact)
        assert wrong <= Fraction(polynomial.error)
        assert wrong <= page * Fraction(3, 2) + Fraction(1, 2**800)  # pairs, not single doubles
        radius = one_double(np.array([rest]), np.array([polynomial.error]))[0]
        assert abs(Fraction(value) - exact) <= Fraction(float(radius))


@given(st.lists(st.tuples(_LONG, st.integers(0, 2**29), st.integers(-160, -20)), min_size=1, max_size=20))
def test_the_bound_is_that_of_the_page(balls: list[tuple[tuple[int, int], int, int]]) -> None:
    given_balls = [make_ball(middle, (radius, exponent)) for middle, radius, exponent in balls]
    found = double_double_polynomial(arb_poly(given_balls))
    assert len(found.high) == max(1, len(arb_poly(given_balls)))
    page = Fraction(0)
    for k, (high, low) in enumerate(zip(found.high, found.low, strict=True)):
        assert abs(low) <= 2.0**-52 * abs(high)
        lost = max(abs(end - Fraction(high) - Fraction(low)) for end in ends(given_balls[k]))
        page += (24 * (k + 1) * Fraction(1, 2**106) * abs(Fraction(high)) + lost) * _REACH**k
    assert page <= Fraction(found.error) <= page * (1 + Fraction(1, 10**6)) + Fraction(1, 2**800)


@pytest.mark.parametrize("coefficient", [arb(10) ** 400, arb.nan(), arb("inf"), arb(0, 1) * arb(10) ** 400])
def test_what_doubles_do_not_hold_has_no_bound(coefficient: arb) -> None:
    assert math.isinf(double_double_polynomial(arb_poly([coefficient, arb(1)])).error)


def test_what_overflows_has_no_finite_radius() -> None:
    for large in (1e308, 1e304, 1.7e308):
        polynomial = DoubleDoublePolynomial((large, large, large), (0.0, 0.0, 0.0), 1.0)
        with np.errstate(all="ignore"):
            [(value, rest)] = _evaluated(polynomial, [1.0], 0.5, 2.0)
        radius = one_double(np.array([rest]), np.array([polynomial.error]))[0]
        assert not radius <= 1e-15 * abs(value)


def test_small_coefficients_are_counted() -> None:
    with working_bits(200):
        polynomial = double_double_polynomial(arb_poly([arb(1), arb(2) ** -950 / 3, arb(2) ** -860 / 3]))
    assert polynomial.high[1:] == (0.0, float(arb(2) ** -860 / 3))
    assert polynomial.low[2] == 0.0
