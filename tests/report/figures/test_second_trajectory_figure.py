"""The figure of the second smooth trajectory."""

from __future__ import annotations

import math

from flint import fmpq

from gspot_verified.report.figures.second_trajectory_figure import distance, second_trajectory_picture


def test_the_distance_is_that_of_the_page() -> None:
    value = distance(fmpq(1, 3))
    assert value.is_finite()
    assert value.rel_accuracy_bits() > 80
    assert math.isclose(float(value.mid()), math.exp(-9), rel_tol=1e-12)


def test_the_caption_counts_the_places_below_each_power() -> None:
    def below(k: int, power: int) -> bool:
        return -((100 / k) ** 2) < power * math.log(k / 100)

    certain = sum(below(k, power) for k in range(12, 101, 2) for power in (1, 2, 4, 8, 16))
    assert certain < 225
    assert f"at {certain} of 225 places it is certainly below" in second_trajectory_picture().caption
