"""Blocks of cells divided until they have one fate, and divided again along a journal, which is not believed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from flint import ctx, fmpq

from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.fates import fate_work as module
from gspot_verified.mechanisms.fates.box_fate import BoxFate, Fate
from gspot_verified.mechanisms.fates.fate_piece import StartBox
from gspot_verified.mechanisms.fates.fate_work import (
    FateQuestion,
    digest,
    examine,
    open_journal,
    proved_again,
    read_line,
)
from gspot_verified.mechanisms.fates.starts import Starts
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.sweep.sweep_grid import Grid, axes_of
from gspot_verified.work.journal_file import JournalFile

MODEL = shipped_mechanism("model system")
GIVEN = (("x", "0"), ("u", "3"), ("p", "1/2"))


def question(over: str = "-2..2:8", given: tuple[tuple[str, str], ...] = GIVEN) -> FateQuestion:
    return FateQuestion(MODEL, given, Grid(axes_of({"b": over})), fmpq(0))


class Staged:
    """A stand-in for a question: below 0 one fate, from 1 on another, between them open; what is asked is noted."""

    sides = (fmpq(1, 2),)

    def __init__(self) -> None:
        self.asked: list[tuple[fmpq, fmpq]] = []

    def prepared(self) -> Staged:
        return self

    def fate(self, lower: tuple[fmpq, ...], upper: tuple[fmpq, ...]) -> BoxFate:
        (low,), (high,) = lower, upper
        self.asked.append((low, high))
        if high <= 0:
            return BoxFate(Fate.BELOW)
        if low >= 1:
            return BoxFate(Fate.ABOVE)
        return BoxFate(Fate.SPOT if low >= 0 else Fate.UNDECIDED, why="here" if low < 0 else "")


WHOLE = [StartBox((fmpq(-2),), (fmpq(2),), (8,))]


def test_boxes_are_divided_until_they_have_one_fate_or_are_cells() -> None:
    staged: Any = Staged()
    pieces, _, choices = examine(staged, WHOLE)
    found = [(piece.lower[0], piece.upper[0], piece.fate) for piece in pieces]
    half = fmpq(1, 2)
    assert found == [
        (-2, 0, Fate.BELOW), (0, half, Fate.SPOT), (half, 1, Fate.SPOT), (1, 2, Fate.ABOVE),
    ]  # fmt: skip
    assert json.loads(choices) == "1011000"
    assert len(staged.asked) == 7


def test_along_known_choices_only_the_last_boxes_are_asked() -> None:
    staged, again = Staged(), Staged()
    first = examine(staged, WHOLE)  # type: ignore[arg-type]
    same = examine(again, WHOLE, json.loads(first.choices))  # type: ignore[arg-type]
    assert same == first
    assert again.asked == [(-2, 0), (0, fmpq(1, 2)), (fmpq(1, 2), 1), (1, 2)]
    # A cell is asked whatever stands there, and what is missing counts as 0.
    cell, both = StartBox((fmpq(0),), (fmpq(1, 2),), (1,)), Staged()
    assert [piece.fate for piece in examine(both, [cell], "1").pieces] == [Fate.SPOT]  # type: ignore[arg-type]
    assert examine(both, WHOLE, "1").pieces == first.pieces  # type: ignore[arg-type]


def test_a_forged_line_changes_nothing() -> None:
    """More is divided than need be: other pieces, another digest, so all is asked again."""
    staged: Any = Staged()
    honest = examine(staged, WHOLE)
    line = json.dumps([3, honest.digest, "11"])
    assert proved_again(staged, WHOLE, line) == honest
    staged.asked.clear()
    assert proved_again(staged, WHOLE, json.dumps([3, honest.digest, json.loads(honest.choices)])) == honest
    assert len(staged.asked) == 4
    assert proved_again(staged, WHOLE, json.dumps([3, "forged", json.loads(honest.choices)])) == honest
    assert examine(staged, WHOLE, "11").digest != honest.digest
    assert len(examine(staged, WHOLE, "11").pieces) == 5


def test_the_digest_holds_all_that_pieces_say() -> None:
    staged: Any = Staged()
    pieces = examine(staged, WHOLE).pieces
    assert digest(pieces) == digest(list(pieces))
    assert len({digest(pieces), digest(pieces[:-1]), digest(pieces[::-1])}) == 3


def test_lines_that_are_none() -> None:
    assert read_line('[4, "ab", "0110"]') == (4, "ab", "0110")
    assert read_line('[4, "ab", ""]') == (4, "ab", "")
    for line in ('["4", "ab", "01"]', '[true, "ab", "01"]', '[4, "ab", ["0"]]', '[4, "ab", "012"]'):
        with pytest.raises(ValueError, match="a portion has a number, a digest, and 0 or 1"):
            read_line(line)


def test_what_a_journal_is_about() -> None:
    header = question().header()
    assert header["kind"] == "fates 1"
    assert header["from"] == [["x", "0"], ["u", "3"], ["p", "1/2"]]
    assert header["over"] == [str(axis) for axis in question().grid.axes]
    assert header["surface_velocity"] == "0"
    other = FateQuestion(shipped_mechanism("model system", alpha_1=-2), GIVEN, question().grid, fmpq(0))
    assert header["mechanism"] != other.header()["mechanism"]
    assert json.loads(json.dumps(header)) == header
    assert question().sides == (fmpq(1, 2),)
    with open_journal(None, question()) as kept:
        assert kept is None


def test_the_journal_is_of_this_question(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    with open_journal(path, question()) as kept:
        assert isinstance(kept, JournalFile)
    with pytest.raises(ValueError, match="journal"):
        open_journal(path, question("-2..2:4"))


def test_a_question_is_checked_before_any_work() -> None:
    question().check()
    with pytest.raises(StateError, match="leave out two components"):
        question(given=GIVEN[:2]).check()
    turning = FateQuestion(
        shipped_mechanism("oscillator"), (("phi", "0"),), Grid(axes_of({"phi_dot": "-1..-1/2"})), fmpq(0)
    )
    with pytest.raises(MechanismError, match="two components"):
        turning.check()


def test_it_is_prepared_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """With what varies, and the velocity of the surface."""
    made: list[Any] = []

    def noted(shifted: Any, starts: Any, axes: Any, surface: Any) -> Any:
        made.append((shifted.mechanism, isinstance(starts, Starts), axes, surface, ctx.prec))
        return object()

    monkeypatch.setattr(module, "prepared", noted)
    module._prepared.cache_clear()
    try:
        one = FateQuestion(MODEL, GIVEN, question().grid, fmpq(1, 7))
        assert one.prepared() is one.prepared()
        assert made == [(MODEL, True, question().grid.axes, fmpq(1, 7), module.BITS)]
    finally:
        module._prepared.cache_clear()
