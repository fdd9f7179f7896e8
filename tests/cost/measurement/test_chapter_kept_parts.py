"""A measurement that was interrupted goes on after its last part, and takes no part of another run."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import pytest

from gspot_verified.cost import run
from gspot_verified.cost.measurement.file import KeptParts
from gspot_verified.cost.measurement.measurement import Measurement, Part
from gspot_verified.work import journal_file

QUESTION: dict[str, object] = {"cost": "toy"}


@dataclass
class Toy:
    """A blueprint whose part is made already; ``fails``: the run is interrupted there."""

    part: Part
    measured_before: list[str]
    fails: bool = False

    @property
    def key(self) -> str:
        return self.part.key

    @property
    def title(self) -> str:
        return self.part.title

    def measured(self, _: object) -> Part:
        if self.fails:
            raise KeyboardInterrupt
        self.measured_before.append(self.key)
        return self.part


def test_an_interrupted_run_goes_on(made_up: Measurement, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, [first] = tmp_path / "cost.json.parts", made_up.parts
    parts = (first, replace(first, key="second", title="The second part"))
    measured: list[str] = []
    monkeypatch.setattr(run, "answers", lambda: made_up.answers)
    toys = [Toy(part, measured) for part in parts]
    toys[-1].fails = True
    monkeypatch.setattr(run, "blueprints", lambda _: toys)
    with pytest.raises(KeyboardInterrupt):
        run.measure_cost(kept=KeptParts(path, QUESTION))
    with path.open("a") as file:
        file.write('{"key": "cut sh')  # as a kill leaves it
    toys[-1].fails = False
    said: list[str] = []
    found = run.measure_cost(progress=said.append, kept=KeptParts(path, QUESTION))
    assert found.parts == parts
    assert measured == [part.key for part in parts]
    assert said[0] == "The second part; 1 of 2 parts measured"


def test_parts_of_another_run_are_refused(
    made_up: Measurement, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "parts"
    KeptParts(path, QUESTION).keep(made_up.parts[0])
    assert KeptParts(path, QUESTION).find(made_up.parts[0].key) == made_up.parts[0]
    assert KeptParts(path, QUESTION).find("another") is None
    with pytest.raises(ValueError, match="differs in: cost"):
        KeptParts(path, {"cost": "other"})
    KeptParts(path, QUESTION).remove()
    assert not path.exists()
    KeptParts(path, QUESTION)
    monkeypatch.setattr(journal_file, "source_key", lambda: "other code")
    with pytest.raises(ValueError, match="differs in: the sources"):
        KeptParts(path, QUESTION)


def test_a_damaged_part_is_refused(made_up: Measurement, tmp_path: Path) -> None:
    path = tmp_path / "parts"
    KeptParts(path, QUESTION)
    data = asdict(made_up.parts[0])
    data["routes"][0]["points"][0]["best"] = 0
    for line in (json.dumps(data), "[]", "{"):
        text = path.read_text().split("\n")[0]
        path.write_text(f"{text}\n{line}\n")
        with pytest.raises(ValueError, match=r"parts: line 2"):
            KeptParts(path, QUESTION)


def test_the_question_has_the_size() -> None:
    assert run.question(True) != run.question(False)
