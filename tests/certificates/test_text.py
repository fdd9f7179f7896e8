"""Tests of what proofs/certificate.md states."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq
from must_reject import mutate, runs

from gspot_verified.certificates import text
from gspot_verified.certificates.checker import check
from gspot_verified.certificates.text import Statement, certificate_text, write_certificate
from gspot_verified.signs.cover.pieces import Column
from gspot_verified.signs.cover.sign import sign
from gspot_verified.signs.cover.statements import BracketsStatement
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.zeros import zeros_on_range


def certificates() -> list[tuple[Statement, list[Column]]]:
    found: list[tuple[Statement, list[Column]]] = []
    for arguments in (("-inf..inf", "0..1", -1), ("-inf..0", "[3..4]", -1), ("0", "3", 1), ("-inf..inf", "-inf..0", 1)):
        result = sign(*arguments)
        assert result.proved_statement is not None
        found.append((result.proved_statement, list(result.columns)))
    zeros, brackets = zeros_on_range("2..5/2"), zeros_at("5/2", 8)
    assert zeros.statement is not None
    return [*found, (zeros.statement, list(zeros.columns)), (brackets.statement, [brackets.column])]


@pytest.mark.parametrize(("statement", "columns"), certificates(), ids=lambda value: type(value).__name__)
def test_canonical_lines_and_hash(statement: Statement, columns: list[Column]) -> None:
    data = certificate_text(statement, columns)
    body, last = data[: data[:-1].rfind("\n") + 1], data.splitlines()[-1]
    assert last == f"sha256 {hashlib.sha256(body.encode()).hexdigest()}"
    assert data.endswith("\n")
    assert "\r" not in data
    lines = body.splitlines()
    assert len(lines) == 1 + len(columns)
    for line in lines:
        assert json.dumps(json.loads(line), sort_keys=True, separators=(",", ":")) == line
        assert_only_exact(json.loads(line))
    header = json.loads(lines[0])
    assert header["statement"] == json.loads(json.dumps(statement.to_json()))
    assert header["hypotheses"] == sorted(header["hypotheses"])
    assert certificate_text(statement, columns) == data


def assert_only_exact(value: Any) -> None:
    """Texts, integers, lists and objects; no float, no boolean, no null."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        for part in value:
            assert_only_exact(part)
    else:
        assert type(value) in (str, int)


def test_the_checker_asks_for_the_same_pages_of_each_version() -> None:
    run, passage, approach = runs.part("run"), mutate.checker().passage, mutate.checker().approach
    side = mutate.checker().side
    asked = dict(mutate.checker().pieces.HYPOTHESES)
    asked |= {part.VERSION: part.HYPOTHESES for part in (run, passage, approach, side)}
    assert {version: list(names) for version, names in text.HYPOTHESES.items()} == asked
    versions = (text.RUN_VERSION, text.PASSAGE_VERSION, text.APPROACH_VERSION)
    assert versions == (run.VERSION, passage.VERSION, approach.VERSION)


def test_every_page_that_is_named_exists() -> None:
    proofs = Path(__file__).resolve().parents[2] / "proofs"
    assert all((proofs / f"{name}.md").is_file() for names in text.HYPOTHESES.values() for name in names)


def test_written_bytes_are_the_text(tmp_path: Path) -> None:
    for k, (statement, columns) in enumerate(certificates()):
        path = tmp_path / f"{k}.cert"
        write_certificate(path, statement, columns)
        assert path.read_bytes() == certificate_text(statement, columns).encode()
        write_certificate(path, statement, columns)
        assert path.stat().st_mode & 0o777 == 0o644  # others may read what the private temporary file held
    assert len(list(tmp_path.iterdir())) == 6
    with pytest.raises(FileNotFoundError, match=r"there is no folder .*deep"):
        write_certificate(tmp_path / "deep" / "x.cert", statement, columns)
    assert not (tmp_path / "deep").exists()


@pytest.mark.parametrize(("statement", "columns"), certificates(), ids=lambda value: type(value).__name__)
def test_the_independent_checker_reads_what_was_written(
    tmp_path: Path, statement: Statement, columns: list[Column]
) -> None:
    """Every kind of statement, a range of β without a lower end included."""
    write_certificate(tmp_path / "x.cert", statement, columns)
    found = check(tmp_path / "x.cert")
    assert found.verified, found.text


def test_the_bytes_are_complete_when_they_are_forced_to_the_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sizes = []
    monkeypatch.setattr(os, "fsync", lambda descriptor: sizes.append(os.fstat(descriptor).st_size))
    statement, columns = certificates()[0]
    write_certificate(tmp_path / "x.cert", statement, columns)
    assert sizes == [len(certificate_text(statement, columns).encode())]


@pytest.mark.parametrize("where", ["fsync", "replace", "text"])
def test_a_good_file_survives_a_failing_write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str) -> None:
    path = tmp_path / "good.cert"
    statement, columns = certificates()[0]
    write_certificate(path, statement, columns)
    before = path.read_bytes()

    def broken(*_: Any) -> None:
        raise OSError("the disk is full")

    owner, name = {"fsync": (os, "fsync"), "replace": (Path, "replace"), "text": (text, "certificate_text")}[where]
    monkeypatch.setattr(owner, name, broken)
    with pytest.raises(OSError, match="disk is full"):
        write_certificate(path, *certificates()[4])
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_an_interrupt_leaves_nothing_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(_: int) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupt)
    with pytest.raises(KeyboardInterrupt):
        write_certificate(tmp_path / "x.cert", *certificates()[0])
    assert list(tmp_path.iterdir()) == []


def test_an_interrupt_after_the_last_step_stays_an_interrupt(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The temporary file is gone by then: to tidy up must not hide why the call ended."""
    real = Path.replace

    def replace(self: Path, target: Path) -> None:
        real(self, target)
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "replace", replace)
    statement, columns = certificates()[0]
    with pytest.raises(KeyboardInterrupt):
        write_certificate(tmp_path / "x.cert", statement, columns)
    assert [path.name for path in tmp_path.iterdir()] == ["x.cert"]
    assert (tmp_path / "x.cert").read_text() == certificate_text(statement, columns)


def test_a_folder_in_the_way(tmp_path: Path) -> None:
    with pytest.raises(OSError):  # noqa: PT011 (which one depends on the system)
        write_certificate(tmp_path, *certificates()[0])
    assert tmp_path.is_dir()


def test_numbers_beyond_the_format_are_refused(tmp_path: Path) -> None:
    narrow = fmpq(1, 10**4000)
    statement = BracketsStatement(fmpq(5, 2), ((fmpq(0), narrow),))
    with pytest.raises(ValueError, match="4000 digits"):
        write_certificate(tmp_path / "x.cert", statement, [])
    assert list(tmp_path.iterdir()) == []
    assert certificate_text(BracketsStatement(fmpq(5, 2), ((fmpq(0), 10 * narrow),)), [])
