from __future__ import annotations

import json
from pathlib import Path

import pytest

from gspot_verified.cost.benchmarks import theta as benchmark
from gspot_verified.cost.benchmarks.theta import CostReport
from gspot_verified.cost.peers.external import ExternalTime
from gspot_verified.cost.times import rows as curves_module
from gspot_verified.cost.times.rows import Row, Target, TimeCurve, curve
from gspot_verified.report.pictures.cost_picture import save_picture

FAST = Target("cold", 0.005, "s")
ROWS = (Row("a", "asked 1", FAST, 0.001), Row("a", "asked 2", FAST, 0.01), Row("a", "asked 3", FAST, None))
EXTERNAL = (
    ExternalTime("PARI/GP", "1", "1/2", 20, 0.5, 0.25, 12),
    ExternalTime("Sage ore_algebra", "1", "1/2", 20, None, None, None, "not installed"),
)
CURVES = (TimeCurve("ours", ((10, 1e-4), (100, 1e-3))), TimeCurve("none", ()))


@pytest.fixture
def report() -> CostReport:
    return CostReport(ROWS, EXTERNAL, CURVES, ("a remark",), False, 1.0)


def test_the_summary_keeps_three_outcomes_apart(report: CostReport) -> None:
    assert report.summary() == "1 of 3 met, 1 missed, 1 not measured"
    assert [row.asked for row in report.missed] == ["asked 2"]


def test_the_text_has_everything(report: CostReport) -> None:
    text = str(report)
    for part in ("asked 1", "missed by 2.00 x", "500 ms, 250 ms, only 12 digits right", "not installed", "a remark"):
        assert part in text
    assert text.endswith(report.summary())


def test_the_report_is_json(report: CostReport) -> None:
    data = json.loads(json.dumps(report.to_json()))
    assert [row["outcome"] for row in data["rows"]] == ["met", "missed by 2.00 x", "not measured"]
    assert data["curves"][0] == {"name": "ours", "points": [[10, 1e-4], [100, 1e-3]]}
    assert data["external"][1]["first"] is None
    assert data["full"] is False


def test_run_collects_the_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    monkeypatch.setattr(benchmark, "_STEPS", (("one", lambda: iter(ROWS[:1])), ("two", lambda: iter(ROWS[1:]))))
    monkeypatch.setattr(benchmark, "curves", lambda full: CURVES if not full else ())
    monkeypatch.setattr(benchmark, "ask", lambda *_: EXTERNAL[1])
    report = benchmark.run(progress=said.append)
    assert report.rows == ROWS
    assert report.curves == CURVES
    assert said[:2] == ["one", "two"]
    assert report.external == (EXTERNAL[1],) * len(benchmark.PROGRAMS)
    assert any("core(s)" in remark for remark in report.remarks)


def test_the_full_run_adds_the_heavy_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(benchmark, "_STEPS", ())
    monkeypatch.setattr(benchmark, "curves", lambda _: ())
    monkeypatch.setattr(benchmark, "ask", lambda *_: EXTERNAL[0])
    for name in ("against_baseline", "general_beta_rows"):
        monkeypatch.setattr(benchmark, name, lambda _: iter(ROWS[:1]))
    monkeypatch.setattr(benchmark, "growth", lambda _: ROWS[1])
    monkeypatch.setattr(benchmark, "mpmath_at_many_digits", lambda _: "mpmath: slow")
    report = benchmark.run(full=True)
    assert report.rows == (ROWS[0], ROWS[0], ROWS[1])
    assert report.remarks[1] == "mpmath: slow"


def test_a_curve_ends_when_it_gets_slow() -> None:
    called: list[int] = []
    points = curve(called.append, (10, 30, 100), patience=-1.0)
    assert [digits for digits, _ in points] == [10]
    assert [digits for digits, _ in curve(called.append, (10, 30, 100), patience=1e9)] == [10, 30, 100]
    assert set(called) == {10, 30, 100}


def test_curves_are_four(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(curves_module, "_DIGITS", (10, 30, 100, 300))
    drawn = curves_module.curves(full=False)
    assert len(drawn) == 4
    assert all([digits for digits, _ in item.points] == [10, 30] for item in drawn)


def test_the_picture_is_a_png(tmp_path: Path) -> None:
    path = save_picture(CURVES, tmp_path / "cost.png")
    assert path.read_bytes().startswith(b"\x89PNG")
    assert [item.name for item in tmp_path.iterdir()] == ["cost.png"]


def test_a_picture_needs_a_point(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="no point"):
        save_picture([TimeCurve("none", ())], tmp_path / "cost.png")
    assert not list(tmp_path.iterdir())
