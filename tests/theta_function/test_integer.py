"""The integer polynomials."""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial

import pytest
from flint import fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from strategies import small_heights, to_fmpq, to_fraction

from gspot_verified.theta_function.integer import polynomial, polynomial_value


@pytest.mark.parametrize("n", range(31))
def test_polynomials_from_the_generating_function(n: int) -> None:
    coefficients = polynomial(n)
    for degree in range(n + 1):
        if (n - degree) % 3:
            assert coefficients[degree] == 0
            continue
        j = (n - degree) // 3
        triples = 1
        for i in range(j):
            triples *= comb(n - 3 * i, 3)
        expected = (-1) ** (n + j) * (triples // factorial(j)) * 2**j
        assert coefficients[degree] == expected


@pytest.mark.parametrize("n", range(4, 25))
def test_polynomials_satisfy_the_recurrence_and_the_equation(n: int) -> None:
    tau = fmpq_poly([0, 1])
    assert polynomial(n) == -tau * polynomial(n - 1) + (n - 1) * (n - 2) * polynomial(n - 3)
    theta = polynomial(n)
    first = theta.derivative()
    assert first == -n * polynomial(n - 1)
    assert first.derivative().derivative() - tau * first + n * theta == fmpq_poly([0])


@given(small_heights(), st.integers(0, 30))
def test_polynomial_values(tau: Fraction, n: int) -> None:
    expected = sum(
        (to_fraction(fmpq(polynomial(n)[i])) * tau**i for i in range(n + 1)),
        Fraction(0),
    )
    assert to_fraction(polynomial_value(to_fmpq(tau), n)) == expected
