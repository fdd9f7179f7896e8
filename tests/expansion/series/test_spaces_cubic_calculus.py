"""Derivative and integral of s^e c(s^3): over every ring, against the plain polynomial in s."""

from __future__ import annotations

from flint import arb, arb_poly, fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, to_fraction

from gspot_verified.expansion.series.spaces import derivative, integral
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.functions.symbols import Symbols

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
