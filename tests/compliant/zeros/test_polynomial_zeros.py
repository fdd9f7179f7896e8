"""The number of zeros of F_n over a range of epsilon: its discriminant by another way, against Sturm at points.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.slow.force_polynomial import distinct_real_zeros, force_polynomial
from gspot_verified.compliant.zeros.polynomial_zeros import force_discriminant, number_at_integer


@pytest.mark.parametrize("n", range(2, 8))
def test_the_discriminant_by_the_exponential_and_sympy(n: int) -> None:
    """F_n = (-1)^n n! [r^n] e^(psi/epsilon + rT), by powers of the exponent."""
    r, time, d = sympy.symbols("r T d")
    exponent = r * time + d * sum(sympy.Rational((-1) ** k, k) * r**k for k in range(4, n + 1)) - d * 2 * r**3 / 3
    series = sympy.expand(sum(exponent**k / sympy.factorial(k) for k in range(n + 1)))
    polynomial = (-1) ** n * sympy.factorial(n) * series.coeff(r, n)
    expected = sympy.Poly(sympy.discriminant(polynomial, time), d)
    found = [sympy.Rational(int(c.p), int(c.q)) for c in force_discriminant(n).coeffs()]
    assert sympy.Poly(found[::-1] or [0], d) == expected


@given(
    st.integers(2, 11),
    st.fractions(Fraction(1, 1000), Fraction(60), max_denominator=1000),
    st.fractions(Fraction(0), Fraction(1), max_denominator=50),
)
def test_the_number_holds_on_the_whole_range(n: int, upper: Fraction, part: Fraction) -> None:
    number = number_at_integer(n, fmpq(0), to_fmpq(upper))
    for epsilon in (upper, upper * part, upper / 1000):
        assert number in (None, distinct_real_zeros(force_polynomial(n, to_fmpq(epsilon or upper))))


@pytest.mark.parametrize(
    ("lower", "upper", "number"),
    [(0, 31, 2), (31, 32, None), (32, 32, None), (32, 33, None), (31, 33, None), (33, 100, 0), (1, 1, 2)],
)
def test_the_double_zero_of_f_4_at_32(lower: int, upper: int, number: int | None) -> None:
    assert number_at_integer(4, fmpq(lower), fmpq(upper)) == number


def test_where_the_folds_pass_integers() -> None:
    """The curve from 9 passes beta = 8 and 7, that from 12 beta = 9: one epsilon each, to six digits."""
    for n, epsilon in ((7, "1.527788"), (6, "17.55486"), (8, "13.75374")):
        lower = to_fmpq(Fraction(epsilon))
        upper = lower * (1 + fmpq(1, 10**5))
        assert number_at_integer(n, lower, upper) is None
        before, after = number_at_integer(n, fmpq(0), lower), number_at_integer(n, upper, fmpq(500))
        assert before is not None
        assert after == before - 2


@pytest.mark.parametrize(("n", "lower", "upper"), [(1, 0, 1), (4, 0, 0), (4, 2, 1), (4, -1, 1)])
def test_refused(n: int, lower: int, upper: int) -> None:
    with pytest.raises(ValueError, match="expected n >= 2"):
        number_at_integer(n, fmpq(lower), fmpq(upper))
