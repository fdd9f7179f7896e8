"""The picture of the truncation error: its numbers against the trajectory, and that a file is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_system
from gspot_verified.mechanisms.symbolic import symbolic_system
from gspot_verified.report.truncation import save_truncation, truncation_curves


def test_the_points_are_the_difference_of_two_truncations() -> None:
    system = shipped_system("extended")
    curves = truncation_curves(expand_system(system, 6))
    assert list(curves) == [1, 2, 3, 4, 5, 6]
    for order, points in curves.items():
        for delta, size in points[::7]:
            at = fmpq(*delta.as_integer_ratio())
            omitted = list(enumerate(expand_system(system, order + 8).b))[order:]
            difference = sum((term(fmpq(1)) * at**n for n, term in omitted), start=fmpq(0))
            assert abs(arb(difference)) < size * 1.000001
            assert size < float(abs(arb(difference))) * 1.000001 + 1e-300


def test_symbols_have_no_picture(tmp_path: Path) -> None:
    trajectory = expand_system(symbolic_system(shipped_mechanism("extended", chi=None)), 3)
    with pytest.raises(TypeError, match="symbols"):
        save_truncation(trajectory, tmp_path / "x.png")
    assert not list(tmp_path.iterdir())


def test_a_png_is_written(tmp_path: Path) -> None:
    path = save_truncation(expand_system(shipped_system("extended"), 3), tmp_path / "x.png")
    assert path.read_bytes().startswith(b"\x89PNG")
    assert [entry.name for entry in tmp_path.iterdir()] == ["x.png"]
