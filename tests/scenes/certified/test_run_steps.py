"""The steps of a run: what a journal offers, when it is left, the budget, and what is said on the way."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from flint import arb

from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.scenes.certified import run_steps
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.certified.run_steps import RunSteps
from gspot_verified.scenes.certified.step_journal import StepJournal
from gspot_verified.scenes.scene.file import load_scene


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    """The first steps of a run, as a journal has them."""
    path = tmp_path_factory.mktemp("run") / "journal"
    integrated_run(load_scene("fig-varsim1", epsilon="1/20"), bits=(96,), journal=path, budget=3)
    return [json.loads(line)[1]["step"] for line in path.read_text().splitlines()[1:]]


class Kept:
    """A journal at a place, with these lines: (bits, phase, number of the step)."""

    def __init__(self, path: Path, made: list[dict[str, Any]], *lines: tuple[int, int, int]) -> None:
        self.journal, self.made = StepJournal(path, {"question": 1}), made
        for bits, phase, number in lines:
            self.journal.add({"bits": bits, "phase": phase, "step": made[number]})

    def steps(self, bits: int, budget: int = 9) -> RunSteps:
        return RunSteps(budget, bits, 0.5, 1.0, self.journal, lambda _: None)

    @property
    def lines(self) -> list[tuple[int, int, int]]:
        return [(line["bits"], line["phase"], self.made.index(line["step"])) for line in self.journal.lines]


def offered(steps: RunSteps, made: list[dict[str, Any]]) -> int | None:
    found = steps.known()
    return None if found is None else made.index(found.to_json())


def again(steps: RunSteps) -> None:
    """What was offered is proved."""
    found = steps.known()
    assert found is not None
    steps.proved(found, arb(1))


def test_the_steps_of_a_journal_are_offered_in_order_phase_after_phase(tmp_path: Path, made: list[Any]) -> None:
    lines = [(96, 0, 0), (96, 0, 1), (96, 1, 2)]
    kept = Kept(tmp_path / "journal", made, *lines)
    steps = kept.steps(96)
    assert steps.known() is None  # no phase has begun
    steps.begins("slip", arb(0))
    assert offered(steps, made) == 0
    again(steps)
    again(steps)
    assert steps.known() is None  # the next line is of the next phase
    steps.begins("flight", arb(3))
    assert offered(steps, made) == 2
    again(steps)
    assert steps.known() is None
    assert steps.left == 6
    assert kept.lines == lines


def test_a_step_that_is_not_the_one_offered_drops_it_and_all_after_it(tmp_path: Path, made: list[Any]) -> None:
    kept = Kept(tmp_path / "journal", made, (96, 0, 0), (96, 0, 1), (96, 1, 2))
    steps = kept.steps(96)
    steps.begins("slip", arb(0))
    again(steps)
    assert offered(steps, made) == 1
    steps.proved(ChosenStep.from_json(made[2]), arb(2))
    assert kept.lines == [(96, 0, 0), (96, 0, 2)]
    steps.proved(ChosenStep.from_json(made[1]), arb(3))
    assert kept.lines == [(96, 0, 0), (96, 0, 2), (96, 0, 1)]
    assert steps.known() is None
    assert steps.left == 6


def test_an_equal_step_that_was_found_anew_is_not_the_one_offered(tmp_path: Path, made: list[Any]) -> None:
    kept = Kept(tmp_path / "journal", made, (96, 0, 0), (96, 0, 1))
    steps = kept.steps(96)
    steps.begins("slip", arb(0))
    assert offered(steps, made) == 0
    steps.proved(ChosenStep.from_json(made[0]), arb(1))
    assert kept.lines == [(96, 0, 0)]


def test_each_precision_begins_at_its_own_lines(tmp_path: Path, made: list[Any]) -> None:
    kept = Kept(tmp_path / "journal", made, (96, 0, 0), (128, 0, 1), (128, 0, 2))
    steps = kept.steps(128)
    steps.begins("slip", arb(0))
    assert offered(steps, made) == 1
    none = kept.steps(160)
    none.begins("slip", arb(0))
    assert none.known() is None
    none.proved(ChosenStep.from_json(made[0]), arb(1))
    assert kept.lines == [(96, 0, 0), (128, 0, 1), (128, 0, 2), (160, 0, 0)]
    first = kept.steps(96)
    first.begins("slip", arb(0))
    again(first)
    assert first.known() is None  # the next line is of more bits


def test_a_line_that_is_no_step_is_not_offered(tmp_path: Path, made: list[Any]) -> None:
    journal = StepJournal(tmp_path / "journal", {"question": 1})
    journal.add({"bits": 96, "phase": 0, "step": made[0]})
    journal.add({"bits": 96, "phase": 0, "step": {"h": "far"}})
    steps = RunSteps(9, 96, 0.5, 1.0, journal, lambda _: None)
    steps.begins("slip", arb(0))
    again(steps)
    assert steps.known() is None
    steps.proved(ChosenStep.from_json(made[0]), arb(1))
    assert [line["step"] for line in journal.lines] == [made[0], made[0]]


def test_without_a_journal_steps_are_counted_alone(made: list[Any]) -> None:
    steps = RunSteps(2, 96, 0.5, 1.0, None, lambda _: None)
    steps.begins("slip", arb(0))
    assert steps.known() is None
    steps.proved(ChosenStep.from_json(made[0]), arb(1))
    assert (steps.budget, steps.left) == (2, 1)


def test_what_is_said_on_the_way(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, made: list[Any]) -> None:
    """More than two seconds after the last word: the time in the paper's unit, all steps, those of the journal."""
    now = 100.0
    monkeypatch.setattr(run_steps.clock, "monotonic", lambda: now)
    said: list[str] = []
    kept = Kept(tmp_path / "journal", made, (96, 0, 0))
    steps = RunSteps(9, 96, 0.25, 1.0, kept.journal, said.append)
    steps.begins("slip", arb(8))
    again(steps)
    now = 102.0
    steps.proved(ChosenStep.from_json(made[1]), arb(2))
    assert said == []
    now = 102.5
    steps.proved(ChosenStep.from_json(made[1]), arb(4))
    now = 104.5
    steps.proved(ChosenStep.from_json(made[1]), arb(5))
    now = 104.75
    steps.begins("flight", arb(16))
    steps.proved(ChosenStep.from_json(made[1]), arb(1))
    assert said == [
        "96 bits: slip at t = 3 of 1 after 3 steps, 1 of them from the journal",
        "96 bits: flight at t = 4.25 of 1 after 5 steps, 1 of them from the journal",
    ]
    silent = RunSteps(9, 96, 1.0, 1.0, None, said.append)
    silent.begins("slip", arb(0))
    now = 110.0
    silent.proved(ChosenStep.from_json(made[0]), arb("1.23456789"))
    assert said[2:] == ["96 bits: slip at t = 1.23457 of 1 after one step"]
