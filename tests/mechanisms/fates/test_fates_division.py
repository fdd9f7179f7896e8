"""Open cells are divided again as the budget says, in portions: the pieces cover the range, whatever is kept."""

from __future__ import annotations

import json
from concurrent.futures import Executor
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.fates import fates as module
from gspot_verified.mechanisms.fates.box_fate import BoxFate, Fate
from gspot_verified.mechanisms.fates.fate_work import FateQuestion
from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.work.executors import InProcessExecutor

MODEL = shipped_mechanism("model system")
STATE = {"x": 0, "u": "3", "p": "1/2"}


class Staged:
    """Below -1 one fate, above 1 another, between them open; of what holds a border nothing is certain."""

    def fate(self, lower: tuple[fmpq, ...], upper: tuple[fmpq, ...]) -> BoxFate:
        (low,), (high,) = lower, upper
        if high <= -1:
            return BoxFate(Fate.BELOW)
        if low >= 1:
            return BoxFate(Fate.ABOVE)
        return BoxFate(Fate.SPOT if low >= -1 and high <= 1 else Fate.UNDECIDED, why="here")


@pytest.fixture(autouse=True)
def _staged(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(FateQuestion, "prepared", lambda _: Staged())


def found(over: str = "-2..2:12", **words: Any) -> Fates:
    return fates(MODEL, STATE, {"b": over}, **words)


def cover(result: Fates) -> list[fmpq]:
    """The ends of the pieces, which follow each other; each has the fate of its numbers."""
    pieces = result.pieces
    assert all(one.upper == two.lower for one, two in pairwise(pieces))
    for piece in pieces:
        assert piece.fate is Staged().fate(piece.lower, piece.upper).fate
    return [pieces[0].lower[0], *(piece.upper[0] for piece in pieces)]


def is_open(result: Fates) -> int:
    return sum(piece.fate in (Fate.UNDECIDED, Fate.SPOT) for piece in result.pieces)


@pytest.mark.parametrize("budget", [0, 1, 3, 6, 8, 40])
@pytest.mark.parametrize("portion", [1, 2, 16])
def test_a_budget_is_spent_on_open_cells_alone(budget: int, portion: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PORTION", portion)
    coarse, fine = found(), found(budget=budget)
    assert cover(coarse)[0] == cover(fine)[0] == -2
    assert cover(coarse)[-1] == cover(fine)[-1] == 2
    assert len(fine.pieces) == len(coarse.pieces) + budget  # each that is divided becomes two
    assert is_open(coarse) == 6
    assert fine.pieces[0].lower == (-2,)
    assert fine.pieces[0].upper == (-1,)


def test_without_open_cells_nothing_is_divided() -> None:
    assert len(found("-4..-2:4", budget=9).pieces) == 1


def test_progress_is_that_of_cells_and_then_of_the_budget(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PORTION", 2)
    told: list[tuple[int, int]] = []
    found("-2..2:20", budget=5, progress=lambda done, count: told.append((done, count)))
    assert told == [(16, 20), (20, 20), (22, 25), (24, 25), (25, 25)]


@pytest.mark.parametrize("portion", [2, 16])
def test_a_journal_has_a_line_for_each_portion(portion: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PORTION", portion)
    path, whole = tmp_path / "journal", found("-2..2:20", budget=20)
    assert found("-2..2:20", budget=20, journal=path).pieces == whole.pieces
    lines = path.read_text().splitlines()
    assert [json.loads(line)[0] for line in lines[1:]] == list(range(len(lines) - 1))
    for kept in (2, len(lines) - 1, len(lines)):
        path.write_text("\n".join(lines[:kept]) + "\n")
        assert found("-2..2:20", budget=20, journal=path).pieces == whole.pieces
        assert path.read_text().splitlines() == lines


def test_what_is_refused() -> None:
    for budget in (-1, True, 1.0, "3"):
        with pytest.raises(ValueError, match="budget must be an int >= 0, got "):
            found(budget=budget)
    with pytest.raises(StateError, match="leave out two components"):
        fates(MODEL, {"x": 0}, {"b": "-2..2:12"})
    with pytest.raises(MechanismError, match="p"):
        fates(MODEL, {**STATE, "p": 0.5}, {"b": "-2..2:12"})
    with pytest.raises(TypeError, match="mechanism"):
        fates("model system", STATE, {"b": "-2..2:12"})  # type: ignore[arg-type]


def test_what_was_asked_stands_in_the_result() -> None:
    result = found(surface_velocity="1/3")
    assert result.state == (("x", "0"), ("u", "3"), ("p", "1/2"))
    assert result.surface_velocity == fmpq(1, 3)
    assert result.sides.below == "lift-off"
    assert found().surface_velocity == 0
    text = fates(MODEL, {**STATE, "p": "0.50", "u": fmpq(6, 2)}, {"b": "-2..2:12"})
    assert text.state == (("x", "0"), ("u", "3"), ("p", "0.50"))


def test_the_work_is_done_by_the_executor_that_is_given() -> None:
    asked: list[Any] = []

    class Noting(Executor):
        def submit(self, *words: Any, **more: Any) -> Any:
            asked.append(words)
            return InProcessExecutor().submit(*words, **more)

    assert cover(found(executor=Noting())) == cover(found())
    assert len(asked) == 1
