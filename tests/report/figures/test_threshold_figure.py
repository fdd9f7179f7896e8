"""The picture of the exact eps_0 against beta."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.report.figures.threshold_figure import ThresholdPoint, threshold_picture, threshold_points


def test_the_caption_counts() -> None:
    points = [*threshold_points([fmpq(3, 2), fmpq(21, 4)]), ThresholdPoint(fmpq(7, 2), fmpq(2), fmpq(1), fmpq(3))]
    found = threshold_picture(points)
    assert "at 3 values" in found.caption
    assert "at most 200.00 %" in found.caption
    assert "at leading order at 1 of them, and certainly smaller at 1;" in found.caption
    assert found.svg.startswith("<svg")
    assert found.png.startswith(b"\x89PNG")


def test_points_lie_where_they_are_known() -> None:
    (point,) = threshold_points([fmpq(7, 2)])
    assert point.lower <= fmpq(1289908164, 10**11) <= point.upper
    assert point.upper - point.lower < point.lower / 1000


def test_no_points() -> None:
    with pytest.raises(ValueError, match="no points"):
        threshold_picture([])
