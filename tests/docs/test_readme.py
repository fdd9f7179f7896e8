"""README.md: its commands print what it shows, the commands of its table exist, its times are the recorded ones."""

from __future__ import annotations

import json
import re
from importlib import resources
from pathlib import Path

import pytest
from samples import page_examples

from gspot_verified.cli.main import COMMANDS
from gspot_verified.cost.times.rows import seconds_text

README = Path(__file__).resolve().parents[2] / "README.md"
TEXT = README.read_text(encoding="utf-8")
# The rows of its table of times: part, route, panel and what was asked of the recorded measurement.
TIMES = {
    "Θ(7/3, 1/2), 15 digits, as the first call": ("theta", "this library", "", "15"),
    "the same, 1 000 digits": ("theta", "this library", "", "1000"),
    "the same, 100 000 digits": ("theta", "this library", "", "100000"),
    r"dΘ/dτ < 0 for \|τ\| ≤ 50 and every β in [1/100, 99/100]": ("signs", "this library", "", "τ in [−50, 50]"),
    "all real zeros of dΘ/dτ for every β in (1, 5)": ("atlas", "this library", "", "β in (1, 5)"),
    "Theorem 1, exact, orders below 60": ("expansions", "this library, exact", "", "60"),
    "a certified run of the oscillator, ε = 10⁻³": (
        "scenes",
        "certified, integrator",
        "oscillator, ε = 10⁻³",
        "160 bits",
    ),
    "the same, ε = 10⁻⁶": ("scenes", "certified, integrator", "oscillator, ε = 10⁻⁶", "160 bits"),
}


def test_the_examples(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert page_examples.run_page(README, tmp_path) > 6


def test_python_imports_from_the_front_door_only() -> None:
    imports = re.findall(r"^>>> ((?:from|import) .*)$", TEXT, re.MULTILINE)
    assert imports
    assert [line for line in imports if not line.startswith("from gspot_verified import ")] == []


def test_every_command_that_is_named_exists() -> None:
    named = set(re.findall(r"gspot-verified ([a-z]+(?:-[a-z]+)*)", TEXT))
    assert len(named) > 10
    assert named - set(COMMANDS) == set()


def test_every_target_of_make_that_is_named_exists() -> None:
    targets = re.findall(r"^([a-z-]+)[a-z -]*:", (README.parent / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    named = set(re.findall(r"`make ([a-z-]+)", TEXT))
    assert {"verify", "test", "docs"} <= named <= set(targets)


def test_the_times_are_those_of_the_recorded_measurement() -> None:
    measurement = resources.files("gspot_verified.cost.measurement") / "recorded.json"
    recorded = json.loads(measurement.read_text(encoding="utf-8"))
    best = {
        (part["key"], route["name"], route.get("panel") or "", point["asked"]): point["best"]
        for part in recorded["parts"]
        for route in part["routes"]
        for point in route["points"]
    }
    table = TEXT.partition("## What it costs")[2].partition("\n## ")[0]
    stated = dict(re.findall(r"^\| (.+) \| ([\d.]+ [a-zµ]+) \|$", table, re.MULTILINE))
    assert stated == {row: seconds_text(best[where]) for row, where in TIMES.items()}
    assert recorded["date"] in table
    assert recorded["machine"].partition(",")[0] in table
