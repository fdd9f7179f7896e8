from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from gspot_verified import theta
from gspot_verified.balls import relative_bits
from gspot_verified.theta_function.arrays import bounds, theta_array


def test_arrays_of_floats_are_exact_binary_values() -> None:
    grid = np.linspace(-3.0, 2.0, 11)
    values = theta(grid, "1/2")
    assert values.shape == grid.shape
    for tau, value in zip(grid, values, strict=True):
        exact = theta(Fraction(float(tau)), "1/2")
        assert value.overlaps(exact)
        assert relative_bits(value) >= 50
    lower, upper = bounds(values)
    assert np.isfinite(lower).all()
    assert (lower < upper).all()


def test_arrays_of_objects_and_integers() -> None:
    assert theta_array(np.array([Fraction(1, 2), "1/3"], dtype=object), 3)[1].overlaps(theta("1/3", 3))
    assert theta(np.array([[1, 2], [3, 4]]), 2).shape == (2, 2)
    with pytest.raises(ValueError, match="finite"):
        theta(np.array([1.0, np.nan]), "1/2")
