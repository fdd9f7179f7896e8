"""The file under a journal: whole lines stay, a line that a kill cut short goes, a question has a file of its own."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from full_disk import full_after

from gspot_verified.work import journal_file
from gspot_verified.work.journal_file import JournalFile, JournalWarning

QUESTION = {"kind": "test", "over": ["0", "1"]}


def kept(path: Path) -> list[str]:
    with JournalFile(path, QUESTION) as journal:
        return [*journal.lines]


def test_what_is_added_is_there_again(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    first = JournalFile(path, QUESTION)
    assert [*first.lines] == []
    first.add([1, {"a": "1/3"}])
    with pytest.raises(ValueError, match="another run uses this journal"):
        JournalFile(path, QUESTION)
    first.close()
    assert [json.loads(line) for line in kept(path)] == [[1, {"a": "1/3"}]]


@pytest.mark.parametrize("cut", range(1, 12))
def test_a_line_that_was_cut_short_is_dropped_and_written_again(tmp_path: Path, cut: int) -> None:
    path = tmp_path / "journal"
    journal = JournalFile(path, QUESTION)
    journal.add([1, "first"])
    whole = path.read_bytes()
    journal.add([2, "other"])
    journal.close()
    path.write_bytes(path.read_bytes()[:-cut])
    again = JournalFile(path, QUESTION)
    assert path.read_bytes() == whole
    again.add([3, "third"])
    again.close()
    assert [json.loads(line) for line in kept(path)] == [[1, "first"], [3, "third"]]


def test_a_header_that_was_cut_short_is_completed(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    JournalFile(path, QUESTION)
    header = path.read_bytes()
    path.write_bytes(header[:-5])
    assert len(JournalFile(path, QUESTION).lines) == 0
    assert path.read_bytes() == header


@pytest.mark.parametrize("content", [b"something else\n", b'{"journal": {"kind": "other"}}\n', b"x", b"\xff\xfe\n"])
def test_other_files_are_left_alone(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "journal"
    path.write_bytes(content)
    with pytest.raises(ValueError, match="not a journal of this question"):
        JournalFile(path, QUESTION)
    assert path.read_bytes() == content


def test_lines_are_cut_off_the_end(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    with JournalFile(path, QUESTION) as journal:
        for number in range(4):
            journal.add([number, "ä"])
        journal.cut(2)
        journal.add([9])
    with JournalFile(path, QUESTION) as journal:
        assert [json.loads(line) for line in journal.lines] == [[0, "ä"], [1, "ä"], [9]]


def test_a_line_is_read_from_the_file_when_it_is_asked_for(tmp_path: Path) -> None:
    """By its number, from the end, in slices; what is added and cut counts at once."""
    with JournalFile(tmp_path / "journal", QUESTION) as journal:
        for number in range(3):
            journal.add_text(f"[{number}]")
        assert (journal.lines[0], journal.lines[-1], journal.lines[1:]) == ("[0]", "[2]", ["[1]", "[2]"])
        journal.cut(1)
        assert [*journal.lines] == ["[0]"]
        with pytest.raises(IndexError):
            journal.lines[1]


def test_a_refused_file_is_not_held(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    JournalFile(path, QUESTION).close()
    with pytest.raises(ValueError, match=r"\(it differs in: kind\); choose another") as refused:
        JournalFile(path, {**QUESTION, "kind": "other"})
    JournalFile(path, QUESTION).close()
    assert refused.value.__traceback__ is not None  # which holds the frames of the refused one


def test_a_journal_of_other_sources_is_refused_and_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "journal"
    JournalFile(path, QUESTION).close()
    with monkeypatch.context() as patch:
        patch.setattr(journal_file, "source_key", lambda: "another version")
        for question, parts in ((QUESTION, ""), ({**QUESTION, "kind": "other"}, "kind, ")):
            with pytest.raises(ValueError, match=rf"\(it differs in: {parts}the sources of this package\); choose"):
                JournalFile(path, question)
    JournalFile(path, QUESTION).close()


def test_a_pipe_is_no_journal(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    os.mkfifo(path)
    with pytest.raises(ValueError, match="it is not a file"):
        JournalFile(path, QUESTION)


@pytest.mark.parametrize(("mask", "mode"), [(0o000, 0o666), (0o022, 0o644)])
def test_no_journal_can_be_executed(tmp_path: Path, mask: int, mode: int) -> None:
    before = os.umask(mask)
    try:
        JournalFile(tmp_path / "journal", QUESTION).close()
    finally:
        os.umask(before)
    assert (tmp_path / "journal").stat().st_mode & 0o777 == mode


def test_on_a_full_disk_the_work_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What was written stays, half a line goes with the next run; it is said once, and no second line is tried."""
    path = tmp_path / "journal"
    with JournalFile(str(path), QUESTION) as journal:
        assert journal.add([1])
        whole = path.read_bytes()
        failed = full_after(len(whole) + 3, path, monkeypatch)
        with pytest.warns(JournalWarning, match="No space left") as said:
            added = [journal.add(line) for line in ([2, "long"], [3])]
        assert [*journal.lines] == ["[1]"]
    assert added == [False, False]
    assert [str(one.message) for one in said] == [
        f"the journal {path} could not be written: [Errno 28] No space left on device; the run went on without it"
    ]
    assert len(failed) == 1
    assert path.read_bytes() == whole + b"[2,"
    monkeypatch.undo()
    with JournalFile(path, QUESTION) as again:
        assert [*again.lines] == ["[1]"]
        assert again.add([2])
    assert path.read_bytes() == whole + b"[2]\n"


def test_a_disk_that_is_full_from_the_start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, told = tmp_path / "journal", list[str]()
    full_after(0, path, monkeypatch)
    with JournalFile(path, QUESTION, told.append) as journal:
        assert not journal.add([1])
    assert len(told) == 1
    assert str(path) in told[0]
    assert (len(journal.lines), path.read_bytes()) == (0, b"")


def test_a_file_system_that_fails_at_the_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    told = list[str]()
    journal = JournalFile(tmp_path / "journal", QUESTION, told.append)
    close = os.close

    def late(descriptor: int) -> None:
        close(descriptor)
        raise OSError(122, "Disk quota exceeded")

    monkeypatch.setattr(journal, "_close", lambda: late(journal._descriptor))
    journal.close()
    assert [("Disk quota exceeded" in text) for text in told] == [True]
    monkeypatch.undo()
    journal._close.detach()
