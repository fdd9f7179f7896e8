"""The map of zeros at finite epsilon: a PNG file, its caption, bad input."""

from __future__ import annotations

from pathlib import Path

import pytest

from gspot_verified.compliant.zeros.zero_map import zero_map
from gspot_verified.report.pictures.zero_map_picture import _caption, save_zero_map, zero_map_picture


def test_a_file_is_written(tmp_path: Path) -> None:
    found = zero_map("1..5", "1/2..1", budget=0)
    path = save_zero_map(found, tmp_path / "map.png")
    assert path.read_bytes().startswith(b"\x89PNG")
    assert list(tmp_path.iterdir()) == [path]
    left = sum(len(row.unfinished) for row in found.rows)
    caption = zero_map_picture(found).caption
    assert f"White: {left} ranges of β not settled." in caption
    assert "by 0 columns" in caption


def test_one_epsilon_is_refused() -> None:
    with pytest.raises(ValueError, match="epsilon"):
        zero_map_picture(zero_map("1..3", "1"))


def test_of_which_curve_a_fold_is_is_not_said_to_be_certified() -> None:
    """fold_point shows a fold; that it lies on the curve from 6 is how it was sought."""
    words = _caption(zero_map("1..3", "1/2..1"), [3, 0])
    assert "The curves join 3 certified folds, sought from β = 6 on; that they are one curve is not shown." in words
