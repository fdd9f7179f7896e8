"""The page on simulators shows the recorded runs."""

from __future__ import annotations

import json

import pytest
import simulators_picture

PAGE = simulators_picture.DATA.with_suffix(".md")


@pytest.mark.parametrize("name", simulators_picture.panels())
def test_the_file_is_what_the_script_draws(name: str) -> None:
    kept = (simulators_picture.STATIC / name).read_text(encoding="utf-8")
    assert simulators_picture.picture(name) == kept, "run: python docs/extensions/simulators_picture.py"
    assert f"(static/{name})" in PAGE.read_text(encoding="utf-8")


def rows_after(heading: str) -> list[list[str]]:
    """The cells of the rows of the table behind a heading, without its head."""
    text = PAGE.read_text(encoding="utf-8").split(f"\n## {heading}\n")[1].split("\n## ")[0]
    lines = [line for line in text.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[1:]]


def test_every_recorded_run_has_its_row() -> None:
    data = json.loads(simulators_picture.DATA.read_text(encoding="utf-8"))
    table = rows_after("One rod, two starts")
    first, second = (start["runs"] for start in data["starts"])
    for row, *runs in zip(table, first, second, strict=True):
        assert row[0] == runs[0]["simulator"]
        for cell, run in zip(row[2:], runs, strict=True):
            assert cell == f"{run['happened']}, t = {run['time']:.4f}: {run['agrees']}"


def test_every_run_of_the_command_has_its_row() -> None:
    data = json.loads(simulators_picture.DATA.read_text(encoding="utf-8"))["command"]
    table = rows_after("An arm and a rod, as the command runs them")
    for row, *runs in zip(table, *(start["runs"] for start in data["starts"]), strict=True):
        assert {run["simulator"] for run in runs} == {row[0]}
        solver = runs[0]["settings"].split(",")[0]
        assert row[1].startswith(solver if "=" not in solver or "ε" in solver else solver.split("=")[0])
        for cell, run in zip(row[2:], runs, strict=True):
            found = f"{run['happened']}, t = {run['time']:.3g}: " if run["time"] is not None else ""
            assert cell == found + run["agrees"]


def test_the_certified_answer_is_that_of_today() -> None:
    from gspot_verified import approach, load

    data = json.loads(simulators_picture.DATA.read_text(encoding="utf-8"))
    for start in data["starts"]:
        state = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": start["theta_dot"]}
        found = approach(load(data["mechanism"]), state)
        assert found.side == start["certified_side"]
        assert found.time is not None
        assert abs(float(found.time.mid()) - start["certified_time"]) < 1e-9
