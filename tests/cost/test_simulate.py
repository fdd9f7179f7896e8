"""The benchmark of runs: every row is there, nothing is asserted about times."""

from __future__ import annotations

import json

import pytest

from gspot_verified.cli import main
from gspot_verified.cost import simulate


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulate, "LIMITS", {"model": simulate.LIMITS["model"]})
    monkeypatch.setattr(simulate, "QUICK", 1)
    monkeypatch.setattr(simulate, "_TOLERANCES", (1e-4, 1e-8))
    monkeypatch.setattr(simulate, "_CERTIFIED_BITS", (160, 256))


@pytest.mark.usefixtures("short")
def test_every_row_has_a_figure() -> None:
    steps: list[str] = []
    report = simulate.run(progress=steps.append)
    assert len(report.rows) == 1
    assert all(row.figure is not None and row.figure > 0 for row in report.rows)
    assert "lift-off, bracket" in report.rows[0].asked
    assert "model" in str(report)
    certified, floats = report.curves
    assert certified.points[0][0] >= 15
    assert certified.points[1][0] > certified.points[0][0]
    assert floats.points[-1][0] < 14
    assert len(json.loads(json.dumps(report.to_json()))["rows"]) == 1
    assert any("epsilon = 1e-3" in step for step in steps)


@pytest.mark.usefixtures("short")
def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cost", "simulate"]) == 0
    assert "lift-off" in capsys.readouterr().out


def test_every_row_ends_after_its_lift_off() -> None:
    """The ends of the runs are those of the table, and epsilon is small enough for them."""
    for name, limits in simulate.LIMITS.items():
        for k in range(len(limits)):
            assert simulate._scene(name, k).epsilon == simulate.fmpq(1, 10 ** (k + 3))
