"""Powers of ε of spaces: a third is no power, and a negative one is none of a smooth function."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_4.powers_of_epsilon import exponents, progressions


@pytest.mark.parametrize(("shift", "front"), [((0, -4), 1), ((1, -4), 0), ((0, -3), 0), ((2, 0), 2)])
def test_a_third_is_no_power(shift: tuple[int, int], front: int) -> None:
    assert progressions(shift, front) is None
    assert exponents(shift, front) is None


@pytest.mark.parametrize(("shift", "firsts"), [((3, -4), [-2, 3]), ((0, 2), [0, -1]), ((3, 2), [-2, -1])])
def test_a_negative_power_is_none_of_a_smooth_function(shift: tuple[int, int], firsts: list[int]) -> None:
    assert progressions(shift, 0) == [(first, 2) for first in firsts]
    assert exponents(shift, 0) is None
