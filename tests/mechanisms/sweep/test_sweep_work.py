"""The work of a sweep in portions: in order, each once, and kept in a journal that a second run reads again."""

from __future__ import annotations

import json
from array import array
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq
from samples.families import family

from gspot_verified import load
from gspot_verified.functions.expressions import Constant
from gspot_verified.mechanisms.input.mechanism import Lagrangian
from gspot_verified.mechanisms.sweep import sweep_work
from gspot_verified.mechanisms.sweep.sweep_cell import Cell
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_pieces import PieceStore, packed
from gspot_verified.mechanisms.sweep.sweep_work import (
    Answer,
    Question,
    digest,
    examine,
    open_journal,
    portions,
    results,
)
from gspot_verified.work.executors import InProcessExecutor

QUESTION = Question(family("q - k", "0"), Grid((Axis("k", fmpq(-1), fmpq(1), 70),)), ("x", "u"), 8)
CELLS = [Cell(*QUESTION.grid.ends(index), None) for index in QUESTION.grid.indices()]
WORK = list(portions(CELLS))


def test_portions_hold_every_cell_in_order() -> None:
    assert [len(portion) for portion in WORK] == [32, 32, 6]
    assert [cell for portion in WORK for cell in portion] == CELLS
    assert list(portions([])) == []
    assert [len(portion) for portion in portions(CELLS[:1] * 9_000)] == [64] * 140 + [40]
    assert {len(portion) for portion in portions(CELLS[:1] * 2**16)} == {256}
    assert QUESTION.parameters == ("k",)


def test_cells_without_a_place_have_no_tube() -> None:
    pieces = [[SweepPiece(cell.lower, cell.upper, Kind.NO_TUBE)] for cell in CELLS[:2]]
    groups = array("I", [0, 1])
    assert examine(QUESTION, CELLS[:2]) == Answer(packed(pieces), groups, digest(pieces), "[[], []]")
    assert examine(QUESTION, CELLS[:2], kept=False) == Answer(packed(pieces), groups)


def test_the_journal_s_first_line_tells_mechanisms_apart() -> None:
    """Also where they differ far behind what is shown of one."""
    lagrangian = load("genot_brogliato_rod")
    motion = lagrangian.motion
    assert isinstance(motion, Lagrangian)
    weight = replace(motion, forces=(*motion.forces[:-1], motion.forces[-1] + Constant(fmpq(1, 10**9))))
    changed = [lagrangian, replace(lagrangian, motion=weight), lagrangian.with_parameters(mu="7/5")]
    heads = [replace(QUESTION, mechanism=each).header([], {})["mechanism"] for each in changed]
    assert len({*heads}) == 3
    assert replace(QUESTION, mechanism=load("genot_brogliato_rod")).header([], {})["mechanism"] == heads[0]


def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many cells each portion had that was examined."""
    calls: list[int] = []

    def own(question: Question, cells: list[Cell], known: Any = None, kept: bool = True) -> Answer:  # noqa: ARG001
        assert question is QUESTION
        if known is None:
            calls.append(len(cells))
        pieces = [[SweepPiece(cell.lower, cell.upper, Kind.OPEN, unsure=("beta - 2",))] for cell in cells]
        groups = array("I", range(len(cells)))
        return Answer(packed(pieces), groups, digest(pieces), json.dumps([[None] for _ in cells]))

    monkeypatch.setattr(sweep_work, "examine", own)
    return calls


def flat(found: list[Answer]) -> list[tuple[fmpq, ...]]:
    store = PieceStore(QUESTION.grid)
    return [store[number].lower for portion in found for number in store.add(portion.block)]


@pytest.mark.parametrize("threads", [False, True])
def test_answers_come_in_order_and_are_not_computed_again(
    threads: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    calls = counted(monkeypatch)
    path = tmp_path / "journal"
    pool: Any = ThreadPoolExecutor(1) if threads else InProcessExecutor()
    with pool:
        with open_journal(path, QUESTION, ["0"], {}) as journal:
            first = list(results(QUESTION, WORK, pool, journal))
        assert calls == [32, 32, 6]
        assert flat(first) == [cell.lower for cell in CELLS]
        lines = path.read_text().splitlines()
        path.write_text("\n".join(lines[:3]) + "\n")  # killed before the last portion
        with open_journal(path, QUESTION, ["0"], {}) as journal:
            assert list(results(QUESTION, WORK, pool, journal)) == first
        assert calls == [32, 32, 6, 6]
        assert path.read_text().splitlines() == lines
        assert list(results(QUESTION, WORK, pool, None)) == first
        assert calls == [32, 32, 6, 6, 32, 32, 6]


def test_another_executor_is_given_every_portion(monkeypatch: pytest.MonkeyPatch) -> None:
    counted(monkeypatch)
    given: list[int] = []

    class Counting(ThreadPoolExecutor):
        def submit(self, function: Any, /, *args: Any, **kwargs: Any) -> Any:
            assert isinstance(function, partial)
            given.append(len(function.args[1]))
            return super().submit(function, *args, **kwargs)

    with Counting(1) as pool:
        assert flat(list(results(QUESTION, WORK, pool, None))) == [cell.lower for cell in CELLS]
    assert given == [32, 32, 6]


def test_in_process_nothing_is_done_before_its_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = counted(monkeypatch)
    answers = results(QUESTION, WORK, InProcessExecutor(), None)
    next(answers)
    assert calls == [32]


def test_a_journal_is_of_one_question(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    with open_journal(None, QUESTION, ["0"], {}) as none:
        assert none is None
    for _ in range(2):
        with open_journal(path, QUESTION, ["0"], {"x": "0"}):
            pass
    header = json.loads(path.read_text().splitlines()[0])["journal"]
    assert header["over"] == ["k=-1..1:70"]
    assert header["kind"] == "sweep 2"
    assert (header["digits"], header["fixed"], header["start"], header["spot"]) == (8, ["x", "u"], ["0"], {"x": "0"})
    other = Question(family("q - 2*k", "0"), QUESTION.grid, QUESTION.fixed, 8)
    for question, start, spot in (
        (other, ["0"], {"x": "0"}), (QUESTION, ["1"], {"x": "0"}), (QUESTION, ["0"], {"x": "1"}),
        (Question(QUESTION.mechanism, QUESTION.grid, QUESTION.fixed, 9), ["0"], {"x": "0"}),
    ):  # fmt: skip
        with pytest.raises(ValueError, match="not a journal of this question"):
            open_journal(path, question, start, spot)


@pytest.mark.parametrize(
    "line",
    [
        "[0, [[{}]]]",
        "[0]",
        '{"a": 1}',
        "[null, []]",
        "no JSON",
        '["0", "d", []]',
        '[0, "d", [[5]]]',
        "[" * 10**5,
        '[0, "d", [[[[[1, 0.5]], [], []]]]]',
        f'[0, "d", [[[[[1, {10**9}]], [], []]]]]',
        '[0, "d", [[[[1], [], []]]]]',
    ],
)
def test_a_line_that_cannot_be_read_is_said(line: str, tmp_path: Path) -> None:
    path = tmp_path / "journal"
    with open_journal(path, QUESTION, ["0"], {}):
        pass
    path.write_text(path.read_text() + line + "\n")
    with (
        pytest.raises(ValueError, match="journal: a line of the journal cannot be read"),
        open_journal(path, QUESTION, ["0"], {}) as journal,
    ):
        list(results(QUESTION, WORK, InProcessExecutor(), journal))
