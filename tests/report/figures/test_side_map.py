"""The picture of the exact side rule."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.compliant.side.side_map import SidePoint
from gspot_verified.report.figures.side_map import side_map_picture

POINTS = [
    SidePoint(fmpq(3, 2), fmpq(1, 10), 1, 1),
    SidePoint(fmpq(3, 2), fmpq(1, 100), 1, 1),
    SidePoint(fmpq(13, 2), fmpq(1, 10), -1, 1),
    SidePoint(fmpq(13, 2), fmpq(1, 100), None, 1),
]


def test_the_caption_counts() -> None:
    found = side_map_picture(POINTS)
    assert "at 4 points" in found.caption
    assert "(1 open)" in found.caption
    assert "(one point)" in found.caption
    assert found.svg.startswith("<svg")
    assert found.png.startswith(b"\x89PNG")


def test_no_points() -> None:
    with pytest.raises(ValueError, match="no points"):
        side_map_picture([])
