"""Measurements as files: round trip, and every way in which a file is none."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from gspot_verified.cli.app import schema_name
from gspot_verified.cost.measurement.file import SCHEMA, load, parsed, recorded, save, written
from gspot_verified.cost.measurement.measurement import Measurement
from gspot_verified.cost.run import blueprints


def test_round_trip(made_up: Measurement, tmp_path: Path) -> None:
    save(made_up, tmp_path / "cost.json")
    assert load(tmp_path / "cost.json") == made_up
    assert [path.name for path in tmp_path.iterdir()] == ["cost.json"]


def test_the_schema_is_that_of_the_command() -> None:
    assert schema_name("cost") == SCHEMA


def test_the_recorded_measurement_has_every_part() -> None:
    found = recorded()
    assert [part.key for part in found.parts] == [blueprint.key for blueprint in blueprints(False)]
    assert parsed(written(found)) == found
    for part in found.parts:
        assert any(route.points for route in part.routes), part.key


def test_the_recorded_measurement_has_the_words_and_routes_of_today() -> None:
    """Routes that were missing then stand there, too, and say why."""
    for part, blueprint in zip(recorded().parts, blueprints(recorded().full), strict=True):
        assert (part.title, part.question, part.axis, part.symbol) == (
            blueprint.title, blueprint.question, blueprint.axis, blueprint.symbol,
        )  # fmt: skip
        assert [(route.panel, route.name) for route in part.routes] == [c.own_name for c in blueprint.contestants()]
        assert (part.remarks, part.targets) == (blueprint.remarks, blueprint.targets)


CHANGES: list[tuple[str, Callable[[Any], object]]] = [
    ("expected the keys", lambda data: data.pop("machine")),
    ("expected the keys", lambda data: data.update(surprise=1)),
    ("schema: expected", lambda data: data.update(schema="gspot-verified/cost/1")),
    ("date: expected YYYY-MM-DD", lambda data: data.update(date="yesterday")),
    ("full: expected bool", lambda data: data.update(full=1)),
    ("parts: expected a list", lambda data: data.update(parts={})),
    ("different keys", lambda data: data["parts"].append(data["parts"][0])),
    ("different keys", lambda data: data["parts"][0].update(key="../x")),
    ("expected one of certified", lambda data: data["parts"][0]["routes"][0].update(kind="proved")),
    ("no measurement", lambda data: data["parts"][0]["routes"][0]["points"][0].update(best=0)),
    ("no measurement", lambda data: data["parts"][0]["routes"][0]["points"][0].update(median=0.5)),
    ("no measurement", lambda data: data["parts"][0]["routes"][0]["points"][0].update(best=5e-324)),
    ("no measurement", lambda data: data["parts"][0]["routes"][0]["points"][0].update(median=1e308)),
    ("no measurement", lambda data: data["parts"][0]["routes"][0]["points"][0].update(place=1e308)),
    ("expected float", lambda data: data["parts"][0]["routes"][0]["points"][0].update(place="1")),
    ("expected float", lambda data: data["parts"][0]["routes"][0]["points"][0].update(place=True)),
    ("expected int", lambda data: data["parts"][0]["routes"][0]["points"][0].update(repeats=1.5)),
    ("not in 0..1", lambda data: data["parts"][0]["shares"][0].update(part=1.5)),
    ("limit is not positive", lambda data: data["parts"][0]["limit"].update(seconds=0)),
    ("not finite", lambda data: data["parts"][0]["routes"][0]["points"][0].update(place=10**400)),
    ("out of range", lambda data: data["parts"][0]["routes"][0]["points"][0].update(memory=10**400)),
    ("out of range", lambda data: data["parts"][0]["routes"][0]["points"][0].update(memory=-1)),
    ("target is not positive", lambda data: data["parts"][0].update(targets=[["", 0]])),
    ("no text", lambda data: data["parts"][0].update(axis="digits\0")),
    ("no text", lambda data: data["answers"][0].update(question="\ud800")),
    ("expected 2 entries", lambda data: data["answers"][0].update(routes=["one"])),
]


@pytest.mark.parametrize(("message", "change"), CHANGES)
def test_a_changed_file_is_refused(made_up: Measurement, message: str, change: Callable[[Any], object]) -> None:
    data = json.loads(written(made_up))
    change(data)
    with pytest.raises(ValueError, match=message):
        parsed(json.dumps(data))


def test_a_number_beyond_all_doubles_is_refused(made_up: Measurement) -> None:
    """JSON has no infinity, and Python's reader makes one of 1e999."""
    point = '"place": 1e999'
    text = written(made_up)
    place = f'"place": {json.loads(text)["parts"][0]["routes"][0]["points"][0]["place"]}'
    assert place in text
    with pytest.raises(ValueError, match="not finite"):
        parsed(text.replace(place, point, 1))


@pytest.mark.parametrize("text", ["", "[]", "{}", "null", '{"schema": NaN}', "[" * 100_000])
def test_other_texts_are_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r".+"):
        parsed(text)


def test_a_refusal_names_the_file(tmp_path: Path) -> None:
    (tmp_path / "bad.json").write_bytes(b"\xff")
    with pytest.raises(ValueError, match=r"bad\.json: not UTF-8"):
        load(tmp_path / "bad.json")
    (tmp_path / "large.json").write_bytes(b" " * 20_000_001)
    with pytest.raises(ValueError, match=r"large\.json: larger than"):
        load(tmp_path / "large.json")
