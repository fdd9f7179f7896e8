from __future__ import annotations

from pathlib import Path

import pytest
from flint import fmpq
from killed import killed_after

from gspot_verified.certificates.text import certificate_text
from gspot_verified.signs.cover.journal import Answer, Journal
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.signs.cover.sign import sign
from gspot_verified.signs.zeros import zeros
from gspot_verified.signs.zeros.zeros import zeros_on_range

QUESTION = {"kind": "zeros", "beta": "(1, 5)"}

VICTIM = """
from pathlib import Path
from gspot_verified.signs.zeros.zeros import zeros_on_range
zeros_on_range("1..5", journal=Path({path!r}))
"""


def test_resume_after_a_kill(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "journal"
    kept = 20
    killed_after(kept, VICTIM.format(path=str(path)), path)

    whole = zeros_on_range("1..5")
    calls = []
    honest = zeros.zero_column

    def counted(lower: fmpq, upper: fmpq, along: Column | None = None) -> Column | None:
        if along is None:
            calls.append((lower, upper))
        return honest(lower, upper, along)

    monkeypatch.setattr(zeros, "zero_column", counted)
    resumed = zeros_on_range("1..5", journal=path)
    assert len(calls) == whole.examined - kept
    assert whole.statement is not None
    assert resumed.statement is not None
    assert certificate_text(resumed.statement, resumed.columns) == certificate_text(whole.statement, whole.columns)
    calls.clear()
    assert zeros_on_range("1..5", journal=path) == whole
    assert calls == []


ANSWERS: list[tuple[fmpq | None, fmpq, Answer]] = [
    (fmpq(1), fmpq(2), None),
    (fmpq(1), fmpq(3, 2), (fmpq(-1, 3), fmpq(5, 4))),
    (
        fmpq(3, 2),
        fmpq(2),
        Column(
            fmpq(3, 2), fmpq(2), (ColumnPiece(Kind.LEFT, None, fmpq(-2)), ColumnPiece(Kind.RIGHT, fmpq(-2), None, 1))
        ),
    ),
    (None, fmpq(0), Column(None, fmpq(0), (ColumnPiece(Kind.LAPLACE, None, None),))),
]


def filled(path: Path) -> None:
    with Journal(path, QUESTION) as journal:
        for lower, upper, answer in ANSWERS:
            journal.add(lower, upper, answer)


def test_answers_come_back(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    filled(path)
    journal = Journal(path, QUESTION)
    for lower, upper, answer in ANSWERS:
        assert journal.knows(lower, upper)
        assert journal.recall(lower, upper) == answer
    assert not journal.knows(fmpq(1), fmpq(9))


def test_every_cut_of_the_file_is_a_journal(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    filled(path)
    data = path.read_bytes()
    for length in range(0, len(data) + 1, 7):
        path.write_bytes(data[:length])
        Journal(path, QUESTION)
        assert path.read_bytes() == data[: max(data.rfind(b"\n", 0, length), data.find(b"\n")) + 1]
        filled(path)
        assert path.read_bytes() == data


@pytest.mark.parametrize(
    "content", [b"my notes", b"my notes\n", b"\xff\xfe\n", b'{"journal": {"kind": "sign"}}\n', b"\n", b"{\n"]
)
def test_a_foreign_file_is_refused_and_kept(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "journal"
    path.write_bytes(content)
    with pytest.raises(ValueError, match="is not a journal of this question"):
        Journal(path, QUESTION)
    assert path.read_bytes() == content


def test_a_journal_of_another_question_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    zeros_on_range("2..5/2", journal=path)
    for call in (
        lambda: zeros_on_range("2..3", journal=path),
        lambda: zeros_on_range("[2..5/2]", journal=path),
        lambda: sign("-inf..0", "1..2", journal=path),
    ):
        with pytest.raises(ValueError, match="another file"):
            call()
    by_theorem = tmp_path / "other"
    sign("-inf..inf", "0..1", by_theorem=True, journal=by_theorem)
    with pytest.raises(ValueError, match="another file"):
        sign("-inf..inf", "0..1", journal=by_theorem)


@pytest.mark.parametrize(
    "line",
    [
        "nonsense", "null", "[]", "5", '["1","2"]', '["1","2",5]', '["1","2",{}]', '[["1"],"2",null]', '[1,2,null]',
        '["1",2,null]',
        '["1","2",{"witness":["1"]}]', '["1","2",{"witness":["nan","2"]}]', '["1","2",{"column":["1","2"]}]',
        '["1","2",{"column":["1","2"],"pieces":[["spell",null,null,0]]}]',
        '["1","2",{"column":["1","3"],"pieces":[["laplace",null,null,0]]}]',
        '["1","2",{"column":["1","2"],"pieces":[["laplace",null,null,Infinity]]}]',
        '["1","2",{"column":["1","2"],"pieces":[]}]',
        '["1","2",{"column":[null,"2"],"pieces":[["laplace",null,null,0]]}]', "",
    ],
)  # fmt: skip
def test_a_line_that_cannot_be_read(tmp_path: Path, line: str) -> None:
    path = tmp_path / "journal"
    filled(path)
    with path.open("a") as file:
        file.write(line + "\n")
    with pytest.raises(ValueError, match="a line of the journal cannot be read"):
        Journal(path, QUESTION)


def test_an_answer_that_is_known_is_not_written_again(tmp_path: Path) -> None:
    path = tmp_path / "journal"
    filled(path)
    before = path.read_bytes()
    filled(path)
    assert path.read_bytes() == before


def test_a_folder_that_does_not_exist(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="nowhere"):
        zeros_on_range("2..5/2", journal=tmp_path / "nowhere" / "journal")
