"""Choices for Taylor models: positive integers for every input, and good enough where models are used."""

from __future__ import annotations

from itertools import product

import pytest
from flint import fmpq

from gspot_verified.numbers.balls import approximate, float_bounds
from gspot_verified.theta_function.boxes.box import taylor_model
from gspot_verified.theta_function.boxes.box_choice import (
    bits_for_box,
    degree_for_box,
    growth_bits,
    length_for_box,
    order_for_box,
)
from gspot_verified.theta_function.boxes.parameter_series import parameter_series

_REACHES = (0.0, 1e-12, 0.3, 1.0, 7.5, 40.0, 200.0)
_SIZES = (0.0, 1e-9, 0.5, 3.0, 60.0, 500.0)
# A radius above 3 is refused by parameter_series, with its own message: the choice before it must not fail.
_RADII = (0.0, 1e-320, 1e-30, 0.01, 1.0, 2.999, 3.0, 5.9, 6.0, 7.0, 1e6)


def _is_count(value: object) -> bool:
    return type(value) is int and 1 <= value < 10**6


def test_every_choice_is_a_positive_integer() -> None:
    for reach, size in product(_REACHES, _SIZES):
        assert growth_bits(reach, size) >= 0
        bits = bits_for_box(reach, size)
        assert _is_count(bits)
        assert bits % 32 == 0
        assert _is_count(length_for_box(reach, size, bits))
        assert length_for_box(reach, size, bits) >= 3
        for radius in _RADII:
            assert _is_count(degree_for_box(reach, size, radius)), (reach, size, radius)
        for half_width in (0.0, 1e-300, 1e-9, 0.25, 3.0, 100.0):
            for middle in (-reach, reach):
                # Every derivative 0, 1, 2 needs an order above it.
                assert 3 <= order_for_box(middle, half_width, size) < 10**4


def test_the_length_has_an_end() -> None:
    """Where the terms never fall below the precision within reason, the search stops."""
    assert _is_count(length_for_box(1e6, 10.0, 64))
    assert _is_count(length_for_box(10.0, 10.0, 10**9))


@pytest.mark.parametrize("centre", [fmpq(-7, 3), fmpq(1, 2), fmpq(6)])
@pytest.mark.parametrize("reach", [1, 5, 12])
@pytest.mark.parametrize("radius", [fmpq(0), fmpq(1, 16), fmpq(1, 2)])
def test_the_choices_give_useful_models(centre: fmpq, reach: int, radius: fmpq) -> None:
    """The remainder is far below the largest coefficient; each derivative costs some of it."""
    size = approximate(abs(centre)) + 0.5
    bits = bits_for_box(reach, size)
    degree = degree_for_box(reach, size, approximate(radius))
    series = parameter_series(centre, radius, degree, length_for_box(reach + 1, size, bits), bits)
    for lower, upper in ((fmpq(-reach), fmpq(-reach) + fmpq(1, 4)), (fmpq(reach), fmpq(reach)), (-fmpq(1), fmpq(0))):
        order = order_for_box(approximate((lower + upper) / 2), approximate((upper - lower) / 2), size)
        for derivative in (0, 1) if reach <= 5 else (0,):
            model = taylor_model(series, lower, upper, order, derivative)
            largest = max(float_bounds(abs(value))[0] for row in model.coefficients for value in row)
            assert model.remainder.is_finite()
            assert float_bounds(model.remainder)[1] < largest / 2**10


@pytest.mark.parametrize("centre", [fmpq(0), fmpq(1, 10**9), fmpq(1, 3), fmpq(1), fmpq(-8)])
@pytest.mark.parametrize("reach", [0, 1, 2, 3, 6, 11])
def test_the_length_keeps_every_remainder_finite(centre: fmpq, reach: int) -> None:
    """At b = 0 all terms vanish, but the ratio test of the second derivative wants a longer series."""
    size = approximate(abs(centre))
    bits = bits_for_box(reach, size)
    series = parameter_series(centre, fmpq(0), 1, length_for_box(reach + 1, size, bits), bits)
    for derivative in (0, 1, 2):
        assert taylor_model(series, fmpq(reach), fmpq(reach), 4, derivative).remainder.is_finite()
        assert taylor_model(series, fmpq(-reach) - 1, fmpq(reach), 4, derivative).remainder.is_finite()
