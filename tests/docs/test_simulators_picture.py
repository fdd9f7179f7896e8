"""The page on simulators shows the recorded runs."""

from __future__ import annotations

import json

import simulators_picture

PAGE = simulators_picture.DATA.with_suffix(".md")


def test_the_file_is_what_the_script_draws() -> None:
    kept = simulators_picture.PLACE.read_text(encoding="utf-8")
    assert simulators_picture.picture() == kept, "run: python docs/extensions/simulators_picture.py"


def test_every_recorded_run_has_its_row() -> None:
    data = json.loads(simulators_picture.DATA.read_text(encoding="utf-8"))
    table = [line.split(" | ") for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    first, second = (start["runs"] for start in data["starts"])
    assert len(table) == 1 + len(first) == 1 + len(second)
    for row, *runs in zip(table[1:], first, second, strict=True):
        assert row[0] == f"| {runs[0]['simulator']}"
        for cell, run in zip(row[2:], runs, strict=True):
            assert cell.removesuffix(" |") == f"{run['happened']}, t = {run['time']:.4f}: {run['agrees']}"


def test_the_certified_answer_is_that_of_today() -> None:
    from gspot_verified import approach, load

    data = json.loads(simulators_picture.DATA.read_text(encoding="utf-8"))
    for start in data["starts"]:
        state = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": start["theta_dot"]}
        found = approach(load(data["mechanism"]), state)
        assert found.side == start["certified_side"]
        assert found.time is not None
        assert abs(float(found.time.mid()) - start["certified_time"]) < 1e-9
