"""c_k(beta) by three derivations, and the integer polynomials."""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial

import pytest
from flint import fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from strategies import small_heights, to_fmpq, to_fraction

from gspot_verified.ledger.hypergeometric import dlmf_coefficients
from gspot_verified.theta.asymptotic_coefficients import coefficient, coefficient_by_inversion
from gspot_verified.theta.integer import polynomial, polynomial_value


@pytest.mark.parametrize("k", [*range(16), 25, 40])
def test_two_derivations_agree_as_polynomials(k: int) -> None:
    first, second = coefficient(k), coefficient_by_inversion(k)
    assert first == second
    assert first.degree() == 2 * k


@pytest.mark.parametrize("j", range(3))
def test_dlmf_recurrence_agrees_for_each_function(j: int) -> None:
    assert dlmf_coefficients(j, 9) == [coefficient(k) for k in range(9)]


def test_known_values() -> None:
    assert coefficient(0) == fmpq_poly([1])
    assert coefficient(1) == fmpq_poly([41, 48, 12]) / 72
    assert coefficient(2) == fmpq_poly([9241, 15840, 8760, 1920, 144]) / 10368


def test_airy_functions_are_the_case_minus_one() -> None:
    """beta = -1: Theta solves theta''' = (tau theta)', so theta'' - tau theta is constant and e_1 is Bi's series.

    The Bi coefficients are u_k = Gamma(3k + 1/2)/(54^k k! Gamma(k + 1/2)) in powers of (2/3) tau^(3/2) (DLMF 9.7.2),
    and c_k of this library multiplies ((2/3) tau^(3/2))^(-k): they must be equal at beta = -1.
    """
    value = fmpq(1)
    for k in range(12):
        assert coefficient(k)(fmpq(-1)) == value
        value *= fmpq((6 * k + 1) * (6 * k + 3) * (6 * k + 5), 216 * (k + 1) * (2 * k + 1))


@pytest.mark.parametrize("function", [coefficient, coefficient_by_inversion, polynomial])
def test_negative_index(function: object) -> None:
    with pytest.raises(ValueError, match="at least 0"):
        function(-1)  # type: ignore[operator]


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
