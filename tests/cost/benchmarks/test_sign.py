from __future__ import annotations

import json
from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified.cost.benchmarks import sign as benchmark
from gspot_verified.cost.benchmarks.sign import Plan, SignCost, run
from gspot_verified.cost.peers.bisection import Bisection, Choice, bisect, halves, slope
from gspot_verified.cost.times.growth import (
    FittedGrowth,
    RangeTime,
    around,
    cells,
    fitted_exponent,
    from_one,
    time_range,
)
from gspot_verified.numbers.balls import sign_of
from gspot_verified.report.pictures.cost_picture import RANGES, save_picture
from gspot_verified.signs.cover.witness import sign_at

TINY = Plan(0.05, ((-4, 10),), (2,), 2, (1,), (1, 2))
BOX = (fmpq(0), fmpq(1), fmpq(1, 4), fmpq(3, 4))
COMPARED = (fmpq(-4), fmpq(10), fmpq(1, 100), fmpq(99, 100))


@pytest.fixture(scope="module")
def report() -> SignCost:
    return run(plan=TINY)


@pytest.mark.parametrize("choice", Choice)
def test_bisection_settles_an_easy_box(choice: Choice) -> None:
    found = bisect(BOX, choice, 60.0)
    assert found.finished
    assert found.settled == 1.0
    assert found.evaluations >= 1


def test_bisection_says_how_far_it_got() -> None:
    found = bisect(COMPARED, Choice.LONGER, 0.02)
    assert not found.finished
    assert 0 <= found.settled < 1
    nothing = bisect(BOX, Choice.BETTER, 0.0)
    assert (nothing.finished, nothing.settled, nothing.evaluations) == (False, 0.0, 1)


def test_bisection_does_not_settle_what_is_false() -> None:
    found = bisect((fmpq(0), fmpq(2), fmpq(5, 4), fmpq(7, 4)), Choice.LONGER, 0.1)
    assert not found.finished


def test_the_alternative_encloses_the_slope() -> None:
    left, right, lower, upper = narrow = (fmpq(-1), fmpq(-127, 128), fmpq(1, 2), fmpq(65, 128))
    assert sign_of(slope(narrow)) == -1 == sign_at((left + right) / 2, (lower + upper) / 2)


def test_halves_cover_the_box() -> None:
    assert halves(BOX, 0) == ((*(BOX[0], fmpq(1, 2)), *BOX[2:]), (*(fmpq(1, 2), BOX[1]), *BOX[2:]))
    assert halves(BOX, 1) == ((*BOX[:3], fmpq(1, 2)), (*BOX[:2], fmpq(1, 2), BOX[3]))


def test_the_exponent_of_a_power() -> None:
    assert fitted_exponent([(2, 8.0), (3, 18.0), (5, 50.0)]) == pytest.approx(2.0)
    assert fitted_exponent([(2, 8.0)]) is None
    assert fitted_exponent([]) is None


def test_growth_of_hand_made_times() -> None:
    times = [RangeTime(3, 5, 9.0, 1.0, 4, 40, True), RangeTime(2, 6, 9.0, 2.0, 8, 80, True)]
    assert around(times).exponent == pytest.approx(1.0)
    assert around(times).name == "ranges around β = 4"
    assert "like size^1.00 (asked: about linearly)" in str(around(times))
    assert [x for x, _ in from_one(times).points] == [2, 4]
    assert cells(times[:1]).exponent is None
    assert "not fitted" in str(FittedGrowth("none", "m", ()))
    assert "not proved" in str(RangeTime(1, 2, 1.0, 1.0, 0, 0, False))


def test_time_range_gives_the_certificate() -> None:
    measured, result, text = time_range(1, 2)
    assert measured.proved
    assert measured.columns == len(result.columns) > 0
    assert text.splitlines()[-1].startswith("sha256 ")


def test_the_rows(report: SignCost) -> None:
    asked = [row.asked for row in report.rows]
    assert len(asked) == 7
    assert asked[0] == "dΘ/dτ < 0, all τ, β in (0, 1)"
    assert asked[4] == "zeros for β in (1, 2)"
    assert "(1, 2) only, --large does (1, 13)" in report.rows[4].note
    assert all(row.cold is not None and row.cold > 0 for row in report.rows)
    assert len(report.bisections) == 2
    assert [len(item.points) for item in report.growth] == [1, 1, 2]


def test_the_text_and_the_data(report: SignCost) -> None:
    text = str(report)
    for part in ("dΘ/dτ < 0, all τ", "bisection / ours >= 100 x", "of the area settled", "cells (m, m + 1)"):
        assert part in text
    assert text.endswith(report.summary())
    data = json.loads(json.dumps(report.to_json()))
    assert len(data["rows"]) == len(report.rows)
    assert data["bisections"][0]["finished"] is False
    assert data["curves"][-1]["name"] == "linear growth"


def test_the_picture(report: SignCost, tmp_path: Path) -> None:
    path = save_picture(report.curves, tmp_path / "sign.png", RANGES)
    assert path.read_bytes().startswith(b"\x89PNG")


def bisection(choice: Choice, seconds: float, finished: bool) -> Bisection:
    return Bisection(COMPARED, choice, 1.0 if finished else 0.5, 10, seconds, finished)


@pytest.mark.parametrize(
    ("longer", "better", "figure", "said"),
    [
        ((300.0, True), (200.0, True), 200.0, "halves"),
        ((150.0, True), (60.0, False), 150.0, "the longer side"),
        ((500.0, False), (500.0, False), 500.0, "lower bound"),
        ((5.0, False), (5.0, False), None, "at least 5 x"),
    ],
)
def test_speed_against_the_faster_form(
    monkeypatch: pytest.MonkeyPatch,
    longer: tuple[float, bool],
    better: tuple[float, bool],
    figure: float | None,
    said: str,
) -> None:
    monkeypatch.setattr(benchmark, "_ours", lambda _: (1.0, True))
    row = benchmark._speed([bisection(Choice.LONGER, *longer), bisection(Choice.BETTER, *better)])
    assert row.figure == figure
    assert said in row.note


def test_no_figure_without_a_proof(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(benchmark, "_ours", lambda _: (1.0, False))
    assert benchmark._speed([bisection(Choice.BETTER, 1e6, True)]).met is None
    assert benchmark._far((-10, 10)).met is None


def test_a_checker_that_is_not_there(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> Path:
        raise ValueError("not there")

    monkeypatch.setattr(benchmark, "checker_path", missing)
    row = benchmark._checked("it", "text", 1.0)
    assert row.met is None
    assert "not found" in row.note
    assert benchmark._checked("it", "", 1.0).note == "no certificate"


@pytest.mark.parametrize(
    ("script", "met", "said"),
    [
        ("print('VERIFIED it')", True, "empty Python process"),
        ("import sys; sys.exit('REJECTED: why')", None, "not verified: REJECTED: why"),
        ("print('something')", None, "not verified: something"),
    ],
)
def test_what_the_checker_says(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, script: str, met: bool | None, said: str
) -> None:
    path = tmp_path / "checker.py"
    path.write_text(script, encoding="utf-8")
    monkeypatch.setattr(benchmark, "checker_path", lambda: path)
    row = benchmark._checked("it", "text", 1e3)
    assert row.met is met
    assert said in row.note


def test_a_certificate_is_verified_by_the_checker() -> None:
    _, _, text = time_range(1, 2)
    row = benchmark._checked("it", text, 1.0)
    assert row.figure is not None, row.note
