"""Values of truncated expansions in balls and exactly: sums that cancel, points where terms vanish, wide balls."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds

from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.trajectory import scaled_value, value_in_time
from gspot_verified.functions.rings import BALLS, RATIONALS

numbers = st.fractions(-3, 3, max_denominator=30)


def exact(number: Fraction) -> fmpq:
    return fmpq(number.numerator, number.denominator)


@given(st.lists(st.lists(numbers, max_size=4), min_size=1, max_size=5), numbers, numbers, st.integers(20, 120))
def test_against_fractions(rows: list[list[Fraction]], s: Fraction, delta: Fraction, bits: int) -> None:
    terms = [SpacePolynomial(n % 3 + 9, fmpq_poly([exact(c) for c in row])) for n, row in enumerate(rows)]
    table = {(n % 3 + 3 * k, n): exact(c) for n, row in enumerate(rows) for k, c in enumerate(row)}
    value = sum(
        (c * s ** (n % 3 + 3 * k) * delta**n for n, row in enumerate(rows) for k, c in enumerate(row)), Fraction(0)
    )
    place = exact(s), exact(delta)
    for found in (scaled_value(terms, place, bits, True), value_in_time(table, place, bits, True)):
        assert found.is_finite()
        assert holds(found, value)
        assert found.is_exact() or found.rel_accuracy_bits() >= bits - 10


def test_a_sum_that_cancels_far_below_every_precision_tried() -> None:
    """1 + s^3 - (1 + 2^-2000) at s = 1/3: 10^-600 of what is summed is left of it, and all bits are right."""
    small = fmpq(1, 2**2000)
    terms = [SpacePolynomial(3, fmpq_poly([fmpq(1), fmpq(27)])), SpacePolynomial(3, fmpq_poly([small - 2]))]
    found = scaled_value(terms, (fmpq(1, 3), fmpq(1)), 60, True)
    assert holds(found, Fraction(1, 2**2000))
    assert found.is_exact() or found.rel_accuracy_bits() >= 50


def test_a_value_of_zero_is_exact() -> None:
    terms = [SpacePolynomial(3, fmpq_poly([fmpq(1, 7), fmpq(-27, 7)]))]
    assert scaled_value(terms, (fmpq(1, 3), fmpq(5)), 60, True) == 0
    assert scaled_value([SpacePolynomial.zero(2, RATIONALS)], (fmpq(1, 3), fmpq(5)), 60, True) == 0
    assert value_in_time({}, (fmpq(1, 3), fmpq(5)), 60, True) == 0


def test_coefficients_and_places_that_are_balls() -> None:
    wide = SpacePolynomial(1, BALLS.polynomial([arb(2, fmpq(1, 8))]), BALLS)
    found = scaled_value([wide], (fmpq(1, 3), fmpq(1)), 60, False)
    assert all(holds(found, Fraction(k, 24)) for k in (15, 16, 17))
    found = value_in_time({(1, 0): fmpq(6)}, (arb(1, fmpq(1, 8)), fmpq(1)), 60, True)
    assert all(holds(found, Fraction(3 * k, 4)) for k in (7, 8, 9))


@pytest.mark.parametrize("rational", [True, False])
def test_a_place_that_is_not_finite(rational: bool) -> None:
    found = value_in_time({(1, 0): fmpq(6)}, (arb("nan"), fmpq(1)), 60, rational)
    assert not found.is_finite()
