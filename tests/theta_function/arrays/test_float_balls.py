"""Balls of doubles enclose the balls that they come from."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, make_ball

from gspot_verified.theta_function.arrays.float_balls import FloatBalls, float_balls

_MANTISSAS = st.integers(-(2**120), 2**120)
_RADII = st.integers(0, 2**29)


@given(
    st.lists(st.tuples(_MANTISSAS, st.integers(-1300, 1000), _RADII, st.integers(-1300, 900)), min_size=1, max_size=5)
)
def test_the_doubles_enclose_the_balls(numbers: list[tuple[int, int, int, int]]) -> None:
    values = [make_ball((m, e), (r, x)) for m, e, r, x in numbers]
    middles, radii = float_balls(values)
    found = FloatBalls(middles, radii)
    for i, value in enumerate(values):
        lower, upper = ends(value)
        if np.isinf(radii[i]):
            assert max(abs(lower), abs(upper)) > Fraction(10) ** 290
            continue
        middle, radius = Fraction(float(middles[i])), Fraction(float(radii[i]))
        assert middle - radius <= lower
        assert upper <= middle + radius
        assert radius <= (upper - lower) * Fraction(51, 100) + abs(middle) / 2**52 + Fraction(1, 2**880)
        if np.isfinite(found.lower[i]) and np.isfinite(found.upper[i]):
            assert Fraction(float(found.lower[i])) <= lower
            assert upper <= Fraction(float(found.upper[i]))


def test_exact_numbers_and_no_information() -> None:
    middles, radii = float_balls([arb(3), arb(0), arb.nan(), arb(10) ** 400, arb(0, 1)])
    assert middles.tolist()[:2] == [3.0, 0.0]
    assert radii[:2].tolist() == [0.0, 0.0]
    assert np.isinf(radii[2:4]).all()
    assert 1 <= radii[4] < 1.01
    assert float_balls([])[0].size == 0


def test_they_are_taken_apart_as_arrays_are() -> None:
    grid = FloatBalls(np.arange(6.0).reshape(2, 3), np.full((2, 3), 0.5))
    assert (len(grid), grid.shape, grid[1].shape, grid[1, 2].shape) == (2, (2, 3), (3,), ())
    assert [row.midpoint.tolist() for row in grid] == [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]]
    assert grid[grid.midpoint > 3].midpoint.tolist() == [4.0, 5.0]
    ends_of_all = grid.to_numpy()
    assert ends_of_all.shape == (2, 3, 2)
    assert (ends_of_all[..., 0] == grid.lower).all()
    assert (ends_of_all[..., 1] == grid.upper).all()
    with pytest.raises(IndexError):
        grid[2]
    with pytest.raises(TypeError, match="no truth value"):
        bool(grid)
    with pytest.raises(TypeError):
        len(grid[0, 0])
