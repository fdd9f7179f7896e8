"""Certified runs that go on after a kill: to the same answer, and to no wrong one from a journal that was changed."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from full_disk import full_after

from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.certified.step_journal import StepJournal
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import OPEN, SceneRun
from gspot_verified.scenes.scene.scene import SceneError

SCENE = load_scene("fig-varsim1", epsilon="1/20", until="1")
BITS = (128,)
Whole = tuple[SceneRun, list[bytes]]


def resumed(path: Path, **others: Any) -> SceneRun:
    return integrated_run(SCENE, bits=BITS, journal=path, **others)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Whole:
    """The run, and the lines of its journal."""
    path = tmp_path_factory.mktemp("run") / "journal"
    return resumed(path), path.read_bytes().splitlines(keepends=True)


def rewritten(path: Path, lines: list[bytes], number: int, change: Callable[[dict[str, Any]], None]) -> None:
    """The journal with one line changed and all digests right: what an adversary would write."""
    asked = json.loads(lines[0])["journal"]
    data = [json.loads(line)[1] for line in lines[1:]]
    change(data[number])
    path.unlink(missing_ok=True)
    made = StepJournal(path, asked)
    for each in data:
        made.add(each)


def test_the_run_has_events_and_phases(whole: Whole) -> None:
    """What the other tests resume: a lift-off, so two phases, and the same answer without a journal."""
    run, lines = whole
    assert run.verdict.outcome is Outcome.PROVED
    assert [event.name for event in run.events] == ["lift-off"]
    assert {json.loads(line)[1]["phase"] for line in lines[1:]} == {0, 1}
    assert run == integrated_run(SCENE, bits=BITS)


def test_killed_between_any_two_steps(whole: Whole, tmp_path: Path) -> None:
    """After each step, or within a line: the same events to the last bit, and the same journal in the end."""
    run, lines = whole
    kept = tmp_path / "journal"
    for count in range(len(lines) + 1):
        torn = lines[count][: len(lines[count]) // 2] if count < len(lines) else b""
        kept.write_bytes(b"".join(lines[:count]) + torn)
        assert resumed(kept) == run
        assert kept.read_bytes() == b"".join(lines)


def test_killed_by_the_system(whole: Whole, tmp_path: Path) -> None:
    """kill -9 after the third step, in a process of its own: what was done is there, and the run goes on from it."""
    run, lines = whole
    kept = tmp_path / "journal"
    program = """
import os, signal, sys
from gspot_verified.work.journal_file import JournalFile
write, written = JournalFile.add, []
def killed(journal, data):
    kept = write(journal, data)
    written.append(data)
    if len(written) == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return kept
JournalFile.add = killed
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.scene.file import load_scene
from pathlib import Path
integrated_run(load_scene("fig-varsim1", epsilon="1/20", until="1"), bits=(128,), journal=Path(sys.argv[1]))
"""
    ended = subprocess.run([sys.executable, "-c", program, str(kept)], check=False)
    assert ended.returncode == -9
    assert kept.read_bytes() == b"".join(lines[:4])
    assert resumed(kept) == run


def shrunk(data: dict[str, Any]) -> None:
    """Tubes of no width: the margins 0."""
    data["step"]["margins"] = [["0", 0] for _ in data["step"]["margins"]]


def moved(data: dict[str, Any]) -> None:
    """Polynomials that begin elsewhere: V at the start is 2^10 more."""
    data["step"]["solution"][2][0] = ["1", 10]


def lengthened(data: dict[str, Any]) -> None:
    """A step far beyond the time that is asked for."""
    data["step"]["h"] = [["1", 40]]


def uncovered(data: dict[str, Any]) -> None:
    """Pieces that leave the second half of the step out."""
    data["step"]["ends"][-1] = ["1", -1]


def rated(data: dict[str, Any]) -> None:
    """A basis that is singular."""
    data["step"]["bases"][0][1] = [["0", 0] for _ in data["step"]["bases"][0][1]]


def hostile(data: dict[str, Any]) -> None:
    """A number of a hostile size."""
    data["step"]["margins"][0] = ["1", 10**9]


def bare(count: int, path: Path) -> list[dict[str, int]]:
    """A journal of three lines of which all but ``count`` were dropped and one was added, read again."""
    made = StepJournal(path, {"question": 1})
    for number in range(3):
        made.add({"step": number})
    made.cut(count)
    assert made.lines == [{"step": number} for number in range(count)]
    made.add({"step": 7})
    del made  # its lock
    return StepJournal(path, {"question": 1}).lines


@pytest.mark.parametrize("count", range(4))
def test_after_lines_were_dropped_the_next_one_follows_on_the_last_that_is_left(tmp_path: Path, count: int) -> None:
    """Each digest rests on the line before it: after a cut to no line, to one, to more, the file can be read."""
    assert bare(count, tmp_path / "journal") == [*({"step": number} for number in range(count)), {"step": 7}]


def test_a_line_that_is_no_table_is_damaged(tmp_path: Path) -> None:
    """Also where its digest is right."""
    made = StepJournal(tmp_path / "journal", {"question": 1})
    made.add({"step": 1})
    made.add([1])  # type: ignore[arg-type]
    del made  # its lock
    with pytest.raises(ValueError, match="line 3 of the journal is damaged"):
        StepJournal(tmp_path / "journal", {"question": 1})


def test_a_line_that_is_nested_too_deeply_is_damaged(tmp_path: Path) -> None:
    kept = tmp_path / "journal"
    StepJournal(kept, {"question": 1})
    kept.write_text(f"{kept.read_text()}{'[' * 100_000}\n")
    with pytest.raises(ValueError, match="line 2 of the journal is damaged"):
        StepJournal(kept, {"question": 1})


@pytest.mark.parametrize("change", [shrunk, moved, lengthened, uncovered, rated, hostile])
def test_a_changed_step_is_never_believed(
    whole: Whole, tmp_path: Path, change: Callable[[dict[str, Any]], None]
) -> None:
    """With right digests, so that only the proof can tell: it fails, and the step and those after it are found anew."""
    run, lines = whole
    kept = tmp_path / "journal"
    rewritten(kept, lines, 3, change)
    assert kept.read_bytes() != b"".join(lines)
    assert resumed(kept) == run
    assert kept.read_bytes() == b"".join(lines)


def test_a_damaged_journal_is_refused(whole: Whole, tmp_path: Path) -> None:
    """One digit changed, a line left out, two exchanged, a line that is no step: each is named."""
    _, lines = whole
    kept = tmp_path / "journal"
    digit = lines[3][:-20] + bytes([lines[3][-20] ^ 1]) + lines[3][-19:]
    for damaged in (
        [*lines[:3], digit, *lines[4:]],
        [*lines[:3], *lines[4:]],
        [*lines[:3], lines[4], lines[3], *lines[5:]],
        [*lines[:3], b"[1]\n"],
        [*lines[:3], b"nothing\n"],
    ):
        kept.write_bytes(b"".join(damaged))
        with pytest.raises(ValueError, match="line 4 of the journal is damaged"):
            resumed(kept)
        assert kept.read_bytes() == b"".join(damaged)


def test_the_journal_of_another_run_is_refused(whole: Whole, tmp_path: Path) -> None:
    _, lines = whole
    kept = tmp_path / "journal"
    kept.write_bytes(b"".join(lines))
    other = SCENE.with_settings(nu=3)
    with pytest.raises(ValueError, match=r"not a journal of this question \(it differs in: start\)"):
        integrated_run(other, bits=BITS, journal=kept)
    with pytest.raises(ValueError, match=r"it differs in: digits, until"):
        integrated_run(SCENE.with_settings(until="3/4"), digits=14, bits=BITS, journal=kept)
    kept.write_text("a letter\n")
    with pytest.raises(ValueError, match="not a journal"):
        resumed(kept)
    assert kept.read_text() == "a letter\n"


def test_a_full_disk(whole: Whole, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The run ends with its answer and a note; what was written before stays, and a run after it goes on from there."""
    run, lines = whole
    kept = tmp_path / "journal"
    there = b"".join(lines[:6]) + lines[6][:14]
    full_after(len(there), kept, monkeypatch)
    found = resumed(kept)
    assert (found.fate, found.events) == (run.fate, run.events)
    assert found.notes == (
        f"the journal {kept} could not be written: [Errno 28] No space left on device; the run went on without it",
    )
    assert kept.read_bytes() == there
    monkeypatch.undo()
    assert resumed(kept) == run
    assert kept.read_bytes() == b"".join(lines)


def test_a_budget_of_steps_is_stated_and_a_larger_one_goes_on(whole: Whole, tmp_path: Path) -> None:
    """Undecided with the time that was reached; a second precision is not tried; the journal carries the next run."""
    run, lines = whole
    kept = tmp_path / "journal"
    short = resumed(kept, budget=4)
    assert short.fate == OPEN
    assert short.verdict.reason is Reason.BUDGET
    assert "the budget of 4 steps ended (t = [0.459" in short.verdict.detail
    assert "certain before it: no event" in short.verdict.detail
    assert kept.read_bytes() == b"".join(lines[:5])
    assert resumed(kept, budget=len(lines)) == run
    assert kept.read_bytes() == b"".join(lines)
    two = integrated_run(SCENE, bits=(128, 160), journal=tmp_path / "two", budget=4)
    assert two.fate == OPEN
    assert len((tmp_path / "two").read_bytes().splitlines()) == 5
    with pytest.raises(SceneError, match="budget must be >= 1, got 0"):
        integrated_run(SCENE, budget=0)


def test_a_precision_that_was_not_enough_is_not_tried_again(tmp_path: Path) -> None:
    """64 bits are few for the bracket; a run that was killed at 160 does not begin at 64 again."""
    kept = tmp_path / "journal"
    run = integrated_run(SCENE, bits=(64, 160), journal=kept)
    lines = kept.read_bytes().splitlines(keepends=True)
    bits = [json.loads(line)[1]["bits"] for line in lines[1:]]
    assert set(bits) == {64, 160}
    kept.write_bytes(b"".join(lines[:-1]))
    said: list[str] = []
    monotonic = iter(range(0, 10**6, 100))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("gspot_verified.scenes.certified.run_steps.clock.monotonic", lambda: next(monotonic))
        assert integrated_run(SCENE, bits=(64, 160), journal=kept, progress=said.append) == run
    assert said
    assert all(text.startswith("160 bits: slip at t = ") for text in said[:3])
    assert said[-1].endswith(f"{bits.count(160)} steps, {bits.count(160) - 1} of them from the journal")
    assert kept.read_bytes() == b"".join(lines)
