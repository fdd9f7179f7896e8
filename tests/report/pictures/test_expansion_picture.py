"""The picture of the residual: its points by a second route, below the bound, with the slope delta^M."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_system
from gspot_verified.mechanisms.symbolic import symbolic_system
from gspot_verified.numbers.balls import working_bits
from gspot_verified.report.pictures.expansion_picture import Residual, expansion_picture, residual_curves, truncated

SYSTEM = shipped_system("extended")
PATH = expand_system(SYSTEM, 8)


def test_residuals_by_exact_rationals() -> None:
    """The extended system is rational: the equation of p at a rational point, in exact numbers."""
    s, delta = fmpq(2, 3), fmpq(1, 7)
    cut = truncated(PATH, 5)
    value = {key: sum((t(s) * delta**n for n, t in enumerate(rows)), fmpq(0)) for key, rows in cut.terms().items()}
    state = [start + delta**2 * value[f"xi_{i + 1}"] for i, start in enumerate(SYSTEM.point)]
    series = SeriesOfFunctions((SYSTEM.alpha_1,), NumberTerms(SYSTEM.ring), SYSTEM.ring)
    series.extend(state)
    slope = sum(
        (k * c * s ** (k - 1) * delta**n for n, t in enumerate(cut.p) for k, c in enumerate(t.coefficients()) if k),
        fmpq(0),
    )
    expected = slope - series[SYSTEM.alpha_1][0]
    with working_bits(200):
        found = Residual(cut).at(s, arb(delta))[len(SYSTEM.point)]
        assert found.is_finite()
        assert found.contains(expected)
        assert expected != 0


@pytest.mark.parametrize("name", ["extended", "rod"])
def test_every_point_is_below_the_bound_and_the_slope_is_the_order(name: str) -> None:
    for curve in residual_curves(expand_system(shipped_system(name), 6)):
        assert len(curve.deltas) > 4
        assert all(size <= bound for size, bound in zip(curve.sizes, curve.bounds, strict=True))
        slope = math.log(curve.sizes[-2] / curve.sizes[-1]) / math.log(curve.deltas[-2] / curve.deltas[-1])
        assert slope >= curve.order - 0.1
        steps = list(zip(curve.sizes, curve.sizes[1:], strict=False))
        assert all(larger > smaller for larger, smaller in steps)


def test_symbols_have_no_picture() -> None:
    with pytest.raises(TypeError, match="symbols"):
        expansion_picture(expand_system(symbolic_system(load("extended", chi=None)), 3))


@pytest.mark.parametrize(("suffix", "start"), [(".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<svg")])
def test_a_file_is_written_by_its_suffix(tmp_path: Path, suffix: str, start: bytes) -> None:
    path = expansion_picture(expand_system(SYSTEM, 3)).save(tmp_path / f"x{suffix}")
    assert path.read_bytes().startswith(start)
    assert b"var(--" not in path.read_bytes()
    assert [entry.name for entry in tmp_path.iterdir()] == [f"x{suffix}"]


def test_an_unknown_suffix_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"written as \.png, \.pdf, \.svg"):
        expansion_picture(expand_system(SYSTEM, 3)).save(tmp_path / "x.jpg")
    assert not list(tmp_path.iterdir())
