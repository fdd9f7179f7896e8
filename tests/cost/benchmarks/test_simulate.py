"""The benchmark of runs: every row is there, nothing is asserted about times."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from gspot_verified.cli import main
from gspot_verified.cost.benchmarks import simulate
from gspot_verified.cost.peers import lift_off_runs
from gspot_verified.cost.peers.lift_off_runs import (
    NAMES,
    bracket_decimals,
    exact_bracket,
    fmpq,
    right_decimals,
    scene_of,
)
from gspot_verified.report.pictures.cost_picture import runs_picture


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulate, "LIMITS", {"model": simulate.LIMITS["model"]})
    monkeypatch.setattr(simulate, "QUICK", 1)
    monkeypatch.setattr(simulate, "_DRAWN", {False: {"model": (0,)}})
    monkeypatch.setattr(simulate, "_TOLERANCES", (1e-4, 1e-6))
    monkeypatch.setattr(simulate, "_TOLERANCE", 1e-6)
    monkeypatch.setattr(simulate, "CERTIFIED_BITS", (160, 256))
    monkeypatch.setattr(simulate, "heyoka_missing", lambda: "not installed on this machine")


@pytest.mark.usefixtures("short")
def test_every_row_has_a_figure() -> None:
    steps: list[str] = []
    report = simulate.run(progress=steps.append)
    assert len(report.rows) == 1
    assert all(row.figure is not None and row.figure > 0 for row in report.rows)
    assert all(row.baseline is not None for row in report.rows)
    assert "lift-off, bracket" in report.rows[0].asked
    assert "model" in str(report)
    certified, floats, aim = report.curves
    assert certified.name == "certified: model, ε = 1e-3"
    assert certified.points[0][0] >= 15
    assert certified.points[1][0] > certified.points[0][0]
    assert floats.points[-1][0] < 14
    assert {seconds for _, seconds in aim.points} == {0.15}
    assert len(json.loads(json.dumps(report.to_json()))["rows"]) == 1
    assert any("epsilon = 1e-3" in step for step in steps)
    assert "not installed" in report.remarks[-1]
    drawn = runs_picture(report.curves)
    assert drawn.svg.startswith("<svg")


@pytest.mark.usefixtures("short")
def test_the_command(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert main(["cost", "simulate", "--picture", str(tmp_path / "runs.svg")]) == 0
    assert "lift-off" in capsys.readouterr().out
    assert (tmp_path / "runs.svg").stat().st_size > 10_000


def test_every_row_ends_after_its_lift_off() -> None:
    """The ends of the runs are those of the table, and epsilon is small enough for them."""
    for name in NAMES:
        for k in range(len(lift_off_runs.LIMITS[name])):
            assert scene_of(name, k).epsilon == fmpq(1, 10 ** (k + 3))


def test_decimals_are_counted_against_a_bracket_by_another_route() -> None:
    bracket = exact_bracket(scene_of("model", 0), 15)
    assert bracket is not None
    assert bracket_decimals(bracket) > 15
    assert right_decimals("model", 0, bracket[0]) == 16.0
    assert right_decimals("model", 0, bracket[0] + fmpq(1, 10**6)) == pytest.approx(6, abs=0.1)
    assert right_decimals("model", 0, fmpq(0)) is None


def test_heyoka_finds_the_same_lift_off() -> None:
    pytest.importorskip("heyoka")
    for name in NAMES:
        found = lift_off_runs.heyoka_call(scene_of(name, 0), 1e-12)
        first, second = found(), found()
        assert first is not None
        assert first == second
        assert (right_decimals(name, 0, first) or 0) > 12


def test_no_picture_without_points() -> None:
    with pytest.raises(ValueError, match="no point"):
        runs_picture(())
