"""F_n at integers: the recurrence against the coefficients of the exponential; Sturm's count against isolated roots.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq
from witnesses.slow_solution import polynomial_value

from gspot_verified.compliant.slow.force_polynomial import distinct_real_zeros, force_polynomial
from gspot_verified.numbers.balls import working_bits

SMALL = st.fractions(Fraction(-20), Fraction(20), max_denominator=30)


@given(st.integers(0, 16), SMALL, st.fractions(Fraction(1, 10**6), Fraction(100), max_denominator=10**6))
def test_the_recurrence_gives_the_coefficients_of_the_exponential(n: int, time: Fraction, epsilon: Fraction) -> None:
    assert force_polynomial(n, to_fmpq(epsilon))(to_fmpq(time)) == to_fmpq(polynomial_value(time, n, epsilon))


def test_the_first_ones() -> None:
    e = fmpq(1, 7)
    assert force_polynomial(2, e).coeffs() == [0, 0, 1]
    assert force_polynomial(3, e).coeffs() == [4 / e, 0, 0, -1]
    assert force_polynomial(4, e).coeffs() == [6 / e, -16 / e, 0, 0, 1]
    assert force_polynomial(5, e).coeffs() == [24 / e, -30 / e, 40 / e, 0, 0, -1]


@given(st.lists(SMALL, max_size=5), st.lists(st.tuples(SMALL, SMALL), max_size=2))
def test_sturm_counts_the_real_roots_that_were_put_in(
    real: list[Fraction], pairs: list[tuple[Fraction, Fraction]]
) -> None:
    polynomial = fmpq_poly([-3])
    for root in real:
        polynomial *= fmpq_poly([to_fmpq(-root), 1])
    for x, y in pairs:
        polynomial *= fmpq_poly([to_fmpq(x * x + y * y + 1), to_fmpq(-2 * x), 1])
    assert distinct_real_zeros(polynomial) == len(set(real))


@pytest.mark.parametrize("n", range(1, 13))
@pytest.mark.parametrize("epsilon", [fmpq(1, 1000), fmpq(1, 10), fmpq(1), fmpq(32), fmpq(500)], ids=str)
def test_sturm_against_isolated_roots(n: int, epsilon: fmpq) -> None:
    polynomial = force_polynomial(n, epsilon)
    with working_bits(100):
        real = [root for root, _ in polynomial.complex_roots() if root.imag == 0]
    assert distinct_real_zeros(polynomial) == len(real)


@pytest.mark.parametrize(("n", "epsilon"), [(-1, fmpq(1)), (3, fmpq(0)), (3, fmpq(-1))])
def test_refused(n: int, epsilon: fmpq) -> None:
    with pytest.raises(ValueError, match="n >= 0"):
        force_polynomial(n, epsilon)


def test_the_polynomial_0_is_refused() -> None:
    with pytest.raises(ValueError, match="no number"):
        distinct_real_zeros(fmpq_poly([]))
