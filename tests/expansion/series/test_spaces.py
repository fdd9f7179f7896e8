"""The spaces P_n: what is in them, and that + * d/ds and the integral stay in them.

Page: proofs/expansion.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, arb_poly, fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, to_fraction

from gspot_verified.expansion.series.recursion import space_of
from gspot_verified.expansion.series.spaces import SpacePolynomial, derivative, integral
from gspot_verified.expansion.series.terms import function_space
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.functions.symbols import Symbols

values = st.integers(-5, 5).map(fmpq)


@st.composite
def elements(draw: st.DrawFn, least: int = 0, most: int = 8) -> SpacePolynomial:
    n = draw(st.integers(least, most))
    coefficients = [draw(values) if (k - n) % 3 == 0 else fmpq(0) for k in range(n + 1)]
    return SpacePolynomial.from_list(n, coefficients)


def plain(element: SpacePolynomial) -> fmpq_poly:
    return fmpq_poly(element.coefficients())


@given(elements(), elements())
def test_products(left: SpacePolynomial, right: SpacePolynomial) -> None:
    product = left * right
    assert product.n == left.n + right.n
    assert plain(product) == plain(left) * plain(right)


@given(elements(), st.data())
def test_sums(left: SpacePolynomial, data: st.DataObject) -> None:
    right = data.draw(elements().filter(lambda e: (e.n - left.n) % 3 == 0))
    for found, expected in ((left + right, plain(left) + plain(right)), (left - right, plain(left) - plain(right))):
        assert plain(found) == expected
        assert found.n in (left.n, right.n)


@given(elements(), elements())
def test_sums_across_classes_are_refused(left: SpacePolynomial, right: SpacePolynomial) -> None:
    if (left.n - right.n) % 3 == 0 or left.is_zero() or right.is_zero():
        assert plain(left + right) == plain(left) + plain(right)
        return
    with pytest.raises(ValueError, match="no common space"):
        left + right


@given(elements())
def test_derivative_and_integral(element: SpacePolynomial) -> None:
    slope, area = element.derivative(), element.integral()
    assert (slope.n, area.n) == (element.n - 1, element.n + 1)
    assert plain(slope) == plain(element).derivative()
    assert plain(area) == plain(element).integral()
    assert area.derivative() == element
    assert area.at_zero() == 0


@given(elements(), st.integers(-3, 3))
def test_values(element: SpacePolynomial, s: int) -> None:
    assert element(fmpq(s)) == plain(element)(fmpq(s))
    assert element(arb(s)) == arb(plain(element)(fmpq(s)))
    assert element.at_zero() == plain(element)(fmpq(0))
    assert (-element).scale(fmpq(-2)) == element + element


@given(elements())
def test_membership(element: SpacePolynomial) -> None:
    assert element.in_space(element.n + 3) == element
    if element.is_zero():
        assert element.in_space(-1).is_zero()
        return
    for n in (element.n + 1, element.n + 2):
        with pytest.raises(ValueError, match="is not in"):
            element.in_space(n)
    with pytest.raises(ValueError, match="is not in P_"):
        element.in_space(len(element.coefficients()) - 4)


@pytest.mark.parametrize(
    ("n", "coefficients"), [(2, [1]), (2, [0, 1]), (0, [0, 1]), (1, [0, 1, 0, 0, 1]), (-1, [1]), (3, [0, 0, 5])]
)
def test_what_is_not_in_a_space(n: int, coefficients: list[int]) -> None:
    with pytest.raises(ValueError, match="is not in P_"):
        SpacePolynomial.from_list(n, coefficients)


def test_text_and_equality() -> None:
    element = SpacePolynomial.from_list(4, [0, fmpq(1, 2), 0, 0, 3])
    assert repr(element) == "SpacePolynomial.from_list(4, [0, 1/2, 0, 0, 3])"
    assert SpacePolynomial.from_list(4, element.coefficients()) == element
    assert SpacePolynomial.from_list(7, element.coefficients()) == element
    assert SpacePolynomial.zero(3) == SpacePolynomial.zero(-2)
    assert element != SpacePolynomial.zero(4)
    assert element != 5


def test_balls() -> None:
    third = arb(1) / 3
    element = SpacePolynomial.from_list(4, [0, third, 0, 0, third], BALLS)
    assert (element.derivative().at_zero() * 3).contains(1)
    assert (element.integral().coefficients()[5] * 15).contains(1)
    assert element(arb(2)).contains(6)


@pytest.mark.parametrize("nu", range(8))
def test_the_spaces_of_the_theorem(nu: int) -> None:
    even, odd = 2 * nu, 2 * nu + 1
    for name in ("xi", "p", "b"):
        assert (space_of(name, even), space_of(name, odd)) == (nu + 1, nu - 3)
    for name in ("y", "z"):
        assert (space_of(name, even), space_of(name, odd)) == (nu, nu - 1)
    assert (space_of("v", even), space_of("v", odd)) == (nu - 1, nu - 2)
    assert (space_of("lambda", even), space_of("lambda", odd)) == (nu, nu - 4)
    assert (function_space(even), function_space(odd)) == (nu, nu - 4)


def test_fractions_are_taken() -> None:
    assert SpacePolynomial.from_list(1, [0, fmpq(Fraction(2).numerator)])(fmpq(3)) == 6


# Derivative and integral of s^e c(s^3): over every ring, against the plain polynomial in s.


numbers = st.fractions(-9, 9, max_denominator=12).map(lambda value: fmpq(value.numerator, value.denominator))


def in_s(cubic: fmpq_poly, e: int) -> fmpq_poly:
    values = cubic.coeffs()
    return fmpq_poly([values[k // 3] if k % 3 == 0 else 0 for k in range(3 * len(values))]).left_shift(e)


@given(st.lists(numbers, max_size=5), st.integers(0, 2))
def test_against_the_polynomial_in_s(values: list[fmpq], e: int) -> None:
    cubic = fmpq_poly(values)
    slope, area = derivative(cubic, e, RATIONALS), integral(cubic, e, RATIONALS)
    assert in_s(slope, (e - 1) % 3) == in_s(cubic, e).derivative()
    assert in_s(area, (e + 1) % 3) == in_s(cubic, e).integral()
    ring = Symbols("chi")
    symbols = ring.polynomial([ring.number(value) for value in values])
    balls = arb_poly([arb(value) for value in values])
    for function, exact in ((derivative, slope), (integral, area)):
        assert function(symbols, e, ring).coeffs() == exact.coeffs()
        enclosed = function(balls, e, BALLS)
        assert all(value.is_finite() for value in enclosed.coeffs())
        assert enclosed.length() >= exact.length()
        assert all(holds(enclosed[k], to_fraction(exact[k])) for k in range(enclosed.length()))
