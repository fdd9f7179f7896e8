"""Polynomials in double arithmetic: the error against exact fractions, and the bound against the page.

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

from gspot_verified import theta_of_floats
from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.arrays import float_horner
from gspot_verified.theta_function.arrays.float_horner import accepted, arithmetic_is_ieee, float_polynomial, horner

_REACH = Fraction(1025, 1024)
_NUMBERS = st.floats(-1e6, 1e6, allow_nan=False)
_TINY = st.floats(-1e-300, 1e-300)


def _evaluated(coefficients: list[float], points: list[float], centre: float, inverse: float) -> list[float]:
    table = np.array(coefficients, dtype=np.float64)[:, None]
    index = np.zeros(len(points), dtype=np.intp)
    values = np.empty(len(points))
    sizes = horner(np.array(points), index, np.array([centre]), np.array([inverse]), table, values)
    assert accepted(sizes).all()
    return [float(value) for value in values]


@given(
    st.lists(st.one_of(_NUMBERS, _TINY), min_size=1, max_size=25),
    st.integers(-64, 63),
    st.sampled_from([1, 2, 8]),
    st.lists(st.floats(-1, 1), min_size=1, max_size=6),
)
@example([0.0, 0.0], 0, 1, [5e-324])
@example([1.0, -1.0, 5e-324], -64, 8, [1.0, -1.0])
def test_the_computed_value_is_within_the_bound(
    coefficients: list[float], cell: int, count: int, places: list[float]
) -> None:
    """The exact value of the polynomial at the exact s, in fractions."""
    centre, inverse = cell + 1 / (2 * count), 2.0 * count
    points = [centre + place / inverse for place in places]
    polynomial = float_polynomial(arb_poly([arb(value) for value in coefficients]))
    values = _evaluated(list(polynomial.coefficients) or [0.0], points, centre, inverse)
    for point, value in zip(points, values, strict=True):
        s = (Fraction(point) - Fraction(centre)) * Fraction(inverse)
        assert abs(s) <= _REACH
        exact = sum((Fraction(a) * s**k for k, a in enumerate(coefficients)), Fraction(0))
        assert abs(Fraction(value) - exact) <= Fraction(polynomial.error)


@given(st.lists(st.tuples(_NUMBERS, st.floats(0, 1e-3)), min_size=1, max_size=20))
def test_the_bound_is_that_of_the_page(balls: list[tuple[float, float]]) -> None:
    given_balls = [arb(middle, radius) for middle, radius in balls]
    error = Fraction(float_polynomial(arb_poly(given_balls)).error)
    page = Fraction(0)
    for k, ball in enumerate(given_balls):
        middle, radius = (Fraction(float(part)) for part in (ball.mid(), ball.rad()))
        page += ((3 * k + 1) * Fraction(1, 2**53) * abs(middle) + radius) * _REACH**k
    assert page <= error <= page * (1 + Fraction(1, 10**6)) + Fraction(1, 2**800)


def test_balls_with_more_bits_than_a_double() -> None:
    with working_bits(200):
        third = arb(1) / 3
        polynomial = float_polynomial(arb_poly([third, third]))
        for k, coefficient in enumerate(polynomial.coefficients):
            assert abs(arb(coefficient) - third) < arb(2) ** -53, k
        assert polynomial.error > 2.0**-56


@pytest.mark.parametrize("coefficient", [arb(10) ** 400, arb.nan(), arb(0, 1) * arb(10) ** 400])
def test_what_doubles_do_not_hold_has_no_bound(coefficient: arb) -> None:
    assert math.isinf(float_polynomial(arb_poly([coefficient, arb(1)])).error)


@pytest.mark.parametrize("size", [2.0**1023, 2.0**960])
def test_a_sum_that_may_overflow_has_no_bound(size: float) -> None:
    """The coefficients are doubles, and so is the bound of what they are wrong by; their sum is none."""
    assert math.isinf(float_polynomial(arb_poly([arb(size), arb(size)])).error)
    assert float_polynomial(arb_poly([arb(2.0**940)])).error < 2.0**900


def test_a_point_beyond_the_panel_is_not_accepted() -> None:
    index, one = np.zeros(3, dtype=np.intp), np.array([1.0])
    points = np.array([1.0 + 2.0**-11, 1.0 + 2.0**-10, -1.5])
    sizes = horner(points, index, np.array([0.0]), one, one[:, None], np.empty_like(points))
    assert accepted(sizes).tolist() == [True, False, False]
    assert not accepted(np.array([np.nan]))[0]


class _Other(np.ndarray):
    """Rounds otherwise: ``towards`` is where every result moves by one double; a sum, a product, or both."""

    towards, kinds = np.inf, ("sum", "product")

    def __add__(self, other: object) -> np.ndarray:
        return self._moved(np.asarray(self) + np.asarray(other), "sum")

    def __mul__(self, other: object) -> np.ndarray:
        return self._moved(np.asarray(self) * np.asarray(other), "product")

    def _moved(self, result: np.ndarray, kind: str) -> np.ndarray:
        return np.nextafter(result, self.towards) if kind in self.kinds else result


@pytest.mark.parametrize("towards", [np.inf, -np.inf, 0.0])
@pytest.mark.parametrize("kind", ["sum", "product"])
def test_arithmetic_that_rounds_otherwise_is_noticed_whenever_it_does(
    monkeypatch: pytest.MonkeyPatch, towards: float, kind: str
) -> None:
    assert arithmetic_is_ieee()
    for name in ("_TERMS", "_FACTORS"):
        first, second = getattr(float_horner, name)
        monkeypatch.setattr(float_horner, name, (first.view(_Other), second))
    monkeypatch.setattr(_Other, "towards", towards)
    monkeypatch.setattr(_Other, "kinds", (kind,))
    assert not arithmetic_is_ieee()
    monkeypatch.undo()
    assert arithmetic_is_ieee()


def test_sums_and_products_are_rounded_as_the_bound_supposes() -> None:
    for (left, right), made, operation in (
        (float_horner._TERMS, float_horner._SUMS, Fraction.__add__),
        (float_horner._FACTORS, float_horner._PRODUCTS, Fraction.__mul__),
    ):
        up, down = 0, 0
        for a, b, c in zip(*np.broadcast_arrays(left.ravel(), np.resize(right, left.size), made.ravel()), strict=True):
            off = operation(Fraction(float(a)), Fraction(float(b))) - Fraction(float(c))
            assert 0 < abs(off) <= Fraction(1, 2**53)
            up, down = up + (off < 0), down + (off > 0)
        assert up
        assert down


def test_where_theta_overflows_a_double_the_radius_is_infinite() -> None:
    """A double that overflowed in Horner's rule had a finite radius."""
    found = theta_of_floats(np.linspace(62, 63.9, 700), "199/2", derivative=106)
    for _ in range(2):
        assert np.isinf(found.radius[np.logical_not(np.isfinite(found.midpoint))]).all()
        found = theta_of_floats(np.linspace(55, 63.9, 3_000), "199/2", derivative=106)
