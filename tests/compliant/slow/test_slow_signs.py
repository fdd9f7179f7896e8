"""Taylor coefficients and signs on intervals of tau against single values by another route.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial

import pytest
from flint import arb, arb_mat, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.compliant.slow.slow_signs import CELL, SlowSigns
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits

EPSILONS = st.sampled_from([fmpq(10), fmpq(1, 3), fmpq(1, 1000), fmpq(1, 10**12)])
B = st.fractions(Fraction(-1), Fraction(6), max_denominator=9)
ORDER = 17


def signs_at(b: fmpq, epsilon: fmpq) -> SlowSigns:
    def expansion(k: int) -> arb_mat:
        return arb_mat(ORDER + 1, 1, slow_jet((k + fmpq(1, 2)) * CELL, b, epsilon, ORDER + 1, 80))

    return SlowSigns(expansion, ORDER, 120)


@given(st.fractions(Fraction(-8), Fraction(12), max_denominator=16), B, EPSILONS, st.integers(0, 12))
@settings(max_examples=40)
def test_a_jet_against_single_derivatives(tau: Fraction, b: Fraction, epsilon: fmpq, k: int) -> None:
    jet = slow_jet(to_fmpq(tau), to_fmpq(b), epsilon, 13, 100)
    with working_bits(300):
        eta = scale(epsilon)
        factorial = fmpq(1)
        for i in range(1, k + 1):
            factorial *= i
        value = slow_value(to_fmpq(tau) / eta, to_fmpq(b), epsilon, derivative=k, digits=25).value
        scaled = value * eta ** (to_fmpq(b) - k) / factorial
        assert jet[k].is_finite()
        assert jet[k].overlaps(scaled)
        assert jet[k].rad() <= abs(scaled) * fmpq(1, 10**12) + fmpq(1, 10**12)


@given(st.integers(-12, 16), st.fractions(0, 1, max_denominator=8), st.fractions(0, 1, max_denominator=8), B, EPSILONS)
@settings(max_examples=40)
def test_coefficients_hold_at_every_point_of_the_interval(
    k: int, first: Fraction, second: Fraction, b: Fraction, epsilon: fmpq
) -> None:
    lower, upper = ((k + to_fmpq(part)) * CELL for part in sorted((first, second)))
    found = signs_at(to_fmpq(b), epsilon).coefficients(lower, upper, 3)
    for point in (lower, (2 * lower + upper) / 3, upper):
        exact = slow_jet(point, to_fmpq(b), epsilon, 3, 120)
        for enclosure, value in zip(found, exact, strict=True):
            assert enclosure.is_finite()
            assert enclosure.overlaps(value)
            if lower == upper:
                assert enclosure.rad() < (1 + abs(value)) * fmpq(1, 10**6)


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("ends", [(0, 2), (2, 4), (1, 4), (0, 3), (1, 3)])
def test_the_remainder_reaches_to_both_ends(order: int, ends: tuple[int, int]) -> None:
    """e^tau by few terms, so that the remainder is most of the radius."""

    def expansion(k: int) -> arb_mat:
        with working_bits(100):
            place = (k + fmpq(1, 2)) * CELL
            middle = arb(place).exp()
            return arb_mat([[middle / factorial(j)] for j in range(order + 1)])

    signs = SlowSigns(expansion, order, 100)
    lower, upper = (3 * CELL + end * CELL / 4 for end in ends)
    for j, found in enumerate(signs.coefficients(lower, upper, order)):
        for place in (lower, upper):
            with working_bits(100):
                assert found.contains((arb(place).exp() / factorial(j)).mid())
    # The page: reach^(K-j) binom(K, j) c_K at the middle of the next cell, and no more than that.
    for j, found in enumerate(signs.coefficients(lower, lower, order)):
        with working_bits(100):
            reach = abs(lower - fmpq(7, 4))
            page = comb(order, j) * arb(reach) ** (order - j) * arb(fmpq(9, 4)).exp() / factorial(order)
            assert abs(found.rad() - page) <= page * fmpq(1, 2**25) + arb(10) ** -25


def test_an_interval_across_two_cells_is_refused() -> None:
    with pytest.raises(ValueError, match="one cell"):
        signs_at(fmpq(1, 2), fmpq(1)).coefficients(fmpq(1, 4), fmpq(3, 4), 1)


@given(B, EPSILONS)
@settings(max_examples=15)
def test_the_ends(b: Fraction, epsilon: fmpq) -> None:
    n = -(-b.numerator // b.denominator) - 1
    signs = signs_at(to_fmpq(b), epsilon)
    left = next(-k * CELL for k in range(1, 60) if signs.positive_before(-k * CELL, n))
    for distance in (0, 1, 7, 40):
        assert slow_jet(left - distance, to_fmpq(b), epsilon, 1, 80)[0] > 0
    if b != n + 1:
        right = next(k * CELL for k in range(60) if signs.changes(k * CELL, n) == 0)
        for distance in (0, 1, 5):
            assert slow_jet(right + distance, to_fmpq(b), epsilon, 1, 80)[0] * (-1) ** (n + 1) > 0


def test_the_left_end_is_refused_where_a_derivative_has_the_other_sign() -> None:
    """b = 1.5: G < 0 at 0; b = 2.5: G > 0 at 0 but G_(b-1) < 0."""
    assert not signs_at(fmpq(3, 2), fmpq(1)).positive_before(fmpq(0), 1)
    assert not signs_at(fmpq(5, 2), fmpq(1)).positive_before(fmpq(0), 2)
    assert signs_at(fmpq(5, 2), fmpq(1)).positive_before(fmpq(0), 0)
