"""The integer polynomials.

Page: proofs/initial_values.md.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial
from typing import Any

import pytest
from flint import fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq, to_fraction

from gspot_verified.theta_function.value.integer import polynomial, polynomial_value


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


@pytest.mark.parametrize("n", [20_001, 100_000, pytest.param(10**5000, id="long"), -1])
def test_a_polynomial_that_would_fill_the_memory_is_refused_beforehand(n: int) -> None:
    """n = 100,000 took 40 s and gigabytes."""
    with pytest.raises(ValueError, match=r"n must lie in 0\.\.20000"):
        polynomial(n)


@pytest.mark.parametrize("n", [1.5, "3", True, None])
def test_the_degree_is_an_int(n: Any) -> None:
    with pytest.raises(TypeError, match="n must be an int"):
        polynomial(n)
