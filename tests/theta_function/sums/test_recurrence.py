"""The recurrence at a point, for numbers and for functions of beta; proofs/carried_series.md, section 2."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, arb_poly, fmpq
from samples.strategies import ends

from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.sums.recurrence import continued
from gspot_verified.theta_function.value.integer import polynomial


def _exact(n: int, point: fmpq, scale: fmpq, length: int) -> list[fmpq]:
    """Taylor coefficients in u of the polynomial Theta(point + scale u, n)."""
    shifted = polynomial(n)(type(polynomial(n))([point, scale]))
    return [shifted[k] for k in range(length)]


@pytest.mark.parametrize("n", [0, 2, 5, 9])
@pytest.mark.parametrize(("point", "scale"), [(fmpq(0), fmpq(1)), (fmpq(-7, 3), fmpq(1, 2)), (fmpq(4), fmpq(5, 4))])
def test_the_polynomials_of_integer_beta_come_back(n: int, point: fmpq, scale: fmpq) -> None:
    length, exact = 14, _exact(n, point, scale, 14)
    products = [(k + 1) * (k + 2) * (k + 3) for k in range(length - 3)]
    with working_bits(200):
        start, middle = [arb(value) for value in exact[:3]], arb(scale**2 * point)
        factors = [arb(scale**3 * (k - n) / product) for k, product in enumerate(products)]
        found = continued(start, factors, middle)
        # Over b = n + eta/8, taken at eta = 0; nothing is folded.
        as_functions = continued(
            [arb_poly([value]) for value in start],
            [
                arb_poly([factor, arb(-(scale**3) / (8 * product))])
                for factor, product in zip(factors, products, strict=True)
            ],
            middle,
        )
        at_the_centre = [function(arb(0)) for function in as_functions]
    for values in (found, at_the_centre):
        assert len(values) == length
        for value, wanted in zip(values, exact, strict=True):
            lower, upper = ends(value)
            assert lower <= Fraction(int(wanted.p), int(wanted.q)) <= upper
            assert upper - lower < Fraction(1, 10**40)


def test_each_new_coefficient_is_settled_before_it_is_used() -> None:
    seen: list[arb] = []

    def doubled(value: arb) -> arb:
        seen.append(value)
        return 2 * value

    found = continued([arb(1), arb(1), arb(1)], [arb(1)] * 4, arb(0), doubled)
    assert [int(value.unique_fmpz()) for value in found] == [1, 1, 1, 2, 2, 2, 4]
    assert [int(value.unique_fmpz()) for value in seen] == [1, 1, 1, 2]
