"""c_k(beta) by three derivations.

Page: proofs/asymptotic_coefficients.md.
"""

from __future__ import annotations

import pytest
from flint import fmpq, fmpq_poly

from gspot_verified.paper.appendix_a.hypergeometric import dlmf_coefficients
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient, coefficient_by_inversion
from gspot_verified.theta_function.value.integer import polynomial


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
    with pytest.raises(ValueError, match=r"at least 0|lie in 0\.\."):
        function(-1)  # type: ignore[operator]
