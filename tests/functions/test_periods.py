"""Periods read off a graph: certain where one is named, none where a component stands outside of sines and cosines.

proofs/all_g_spots.md, section 5.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.expressions import Constant, Cosine, Exponential, Expression, Power, Sine, Sum, Variable
from gspot_verified.functions.periods import period_factor

X, Y = Variable(0), Variable(1)


def c(value: int | Fraction) -> Constant:
    return Constant(fmpq(value.numerator, value.denominator))


@pytest.mark.parametrize(
    ("function", "factor"),
    [
        (Sine(X), 1),
        (Sine(X + Y * Y) * Y, 1),
        (Cosine(c(2) * X - Y), fmpq(1, 2)),
        (Sine(c(Fraction(1, 3)) * X) + Cosine(c(Fraction(1, 2)) * X), 6),
        (Power(c(2) + Sine(X), fmpq(-1, 2)), 1),
        (Exponential(Sine(-X)), 1),
        (Sine(X) * X, None),
        (Sine(X) + X, None),
        (Sine(X * X), None),
        (Sine(X * Y), None),
        (Sine(Sine(X) + X), None),
        (Exponential(X), None),
        (X, None),
        (Sine(Y), None),
        (c(3), None),
        (Sum((Sine(X), X, c(-1) * X)), None),
    ],
)
def test_known_periods(function: Expression, factor: fmpq | int | None) -> None:
    assert period_factor([function], 0) == factor


def test_the_period_is_that_of_all_functions() -> None:
    assert period_factor([Sine(X), Cosine(c(Fraction(3, 4)) * X), Y], 0) == 4
    assert period_factor([Sine(X), X * Y], 0) is None


@given(
    st.lists(st.fractions(-4, 4, max_denominator=6), min_size=1, max_size=4),
    st.fractions(-10, 10, max_denominator=9),
)
def test_the_function_repeats_after_the_period(rates: list[Fraction], at: Fraction) -> None:
    function = Sum(tuple(Sine(c(rate) * X + Y) for rate in rates))
    factor = period_factor([function], 0)
    if factor is None:
        assert not any(rates)
        return
    with mpmath.workprec(200):
        x, period = mpmath.mpf(at.numerator) / at.denominator, 2 * mpmath.pi * int(factor.p) / int(factor.q)

        def value(z: mpmath.mpf) -> mpmath.mpf:
            return mpmath.fsum(mpmath.sin(mpmath.mpf(r.numerator) / r.denominator * z + 1) for r in rates)

        assert abs(value(x) - value(x + period)) < mpmath.mpf(2) ** -150
