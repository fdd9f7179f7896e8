"""The benchmark of the compliant model: every row is there, nothing is asserted about times."""

from __future__ import annotations

import json

import pytest

from gspot_verified.cli import main
from gspot_verified.cost.benchmarks import force


def test_every_row_has_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(force, "TENS", (3, 12))
    steps: list[str] = []
    report = force.run(progress=steps.append)
    assert len(report.rows) == 6
    assert all(row.figure is not None and row.figure > 0 for row in report.rows)
    assert "first zero" in str(report)
    assert len(json.loads(json.dumps(report.to_json()))["rows"]) == 6
    assert any("1e-12" in step for step in steps)


def test_the_command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(force, "TENS", (12,))
    assert main(["cost", "force"]) == 0
    assert "slow solution" in capsys.readouterr().out
    assert main(["cost", "forces"]) == 64


def test_caches_are_empty_before_a_call_from_a_state() -> None:
    from gspot_verified.compliant.fast import fast_part

    force.first_zero(*force._run_of_the_paper(6), digits=5)
    assert fast_part._oscillating.cache_info().currsize > 0
    force.forget()
    assert fast_part._oscillating.cache_info().currsize == 0
