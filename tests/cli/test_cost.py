"""``gspot-verified cost`` over all parts: the file, the text, the JSON and what is refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from gspot_verified.cli import main
from gspot_verified.cli.app import schema_name
from gspot_verified.cli.schema import schema_of
from gspot_verified.cost import run as chapter
from gspot_verified.cost.measurement.contest import Blueprint, TimedRoute
from gspot_verified.cost.measurement.file import load, recorded, written
from gspot_verified.cost.measurement.measurement import CERTIFIED


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    def contestants() -> tuple[TimedRoute, ...]:
        return (TimedRoute("ours", CERTIFIED, (1,), lambda _: lambda: sum(range(100)), has_memory=False),)

    sizes: list[bool] = []

    def blueprints(full: bool) -> tuple[Blueprint, ...]:
        sizes.append(full)
        return (Blueprint("one", "One part", "A question.", "digits D", "D", contestants),)

    monkeypatch.setattr(chapter, "blueprints", blueprints)
    monkeypatch.setattr(chapter, "answers", lambda: recorded().answers)


def errors(data: Any) -> list[str]:
    return [error.message for error in Draft202012Validator(schema_of("cost", schema_name("cost"))).iter_errors(data)]


@pytest.mark.usefixtures("short")
def test_all_parts_are_the_default(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "cost.json"
    assert main(["cost", "--output", str(file)]) == 0
    printed = capsys.readouterr()
    assert "One part" in printed.out
    assert "... One part" in printed.err
    assert load(file).parts[0].routes[0].points[0].repeats == 15
    assert load(file).full is False
    assert errors(json.loads(file.read_text(encoding="utf-8"))) == []
    assert main(["cost", "all", "--large", "--output", str(file)]) == 0
    assert load(file).full is True


@pytest.mark.usefixtures("short")
def test_the_json_satisfies_the_schema(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cost", "--quick", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert errors(data) == []
    assert errors({**data, "surprise": 1}) != []
    data["parts"][0]["routes"][0]["kind"] = "proved"
    assert errors(data) != []


def test_the_recorded_measurement_satisfies_the_schema() -> None:
    assert errors(json.loads(written(recorded()))) == []


@pytest.mark.parametrize(
    "arguments",
    [
        ["all", "--picture", "x.png"],
        ["theta", "--output", "x.json"],
        ["all", "--peers"],
        ["everything"],
        ["all", "--output", "x.txt"],
    ],
)
def test_what_is_refused(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cost", *arguments]) == 64
    assert capsys.readouterr().err
