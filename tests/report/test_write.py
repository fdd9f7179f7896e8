"""What is written where, and what happens when something is wrong."""

from __future__ import annotations

import html
import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

from gspot_verified.report import data, write
from gspot_verified.report.write import PROGRAM, pdf_of


@pytest.fixture(scope="module")
def written(entries, pictures, certificates, hard, tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(write, "computed", lambda *_: (pictures, certificates, hard))
        directory = tmp_path_factory.mktemp("out") / "report"
        said = []
        assert write.write_report(entries, directory, said.append) == directory / "index.html"
        assert said[-2:] == ["writing report.json", "writing the pages"]
        return directory


@pytest.fixture
def drawn(monkeypatch, pictures, certificates, hard):
    monkeypatch.setattr(write, "computed", lambda *_: (pictures, certificates, hard))


def test_files(written, pictures, certificates):
    found = {str(path.relative_to(written)) for path in written.rglob("*") if path.is_file()}
    assert {"index.html", "report.json", "style.css", "statements.html", "section-4.html", "appendix-a.html"} <= found
    assert {f"figures/{p.name}.{kind}" for p in pictures for kind in ("png", "svg")} <= found
    for certificate in certificates:
        assert (written / "certificates" / certificate.name).read_bytes() == certificate.content
    assert not [name for name in found if name.endswith(".tmp")]


def test_what_a_page_links_to_lies_beside_it(written):
    for page in written.glob("*.html"):
        text = page.read_text(encoding="utf-8")
        links = {html.unescape(link).partition("#")[0] for link in re.findall(r'(?:href|src)="([^"]*)"', text)} - {""}
        assert [link for link in links if not (written / unquote(link)).is_file()] == [], page.name


@pytest.mark.usefixtures("drawn")
def test_json_is_sorted_and_the_same_twice(written, entries, tmp_path):
    write.write_report(entries, tmp_path)
    text = (written / "report.json").read_text(encoding="utf-8")
    assert (tmp_path / "report.json").read_text(encoding="utf-8") == text
    assert json.dumps(json.loads(text), indent=1, sort_keys=True, ensure_ascii=False) + "\n" == text


def test_json_round_trip_writes_the_same_pages(written, tmp_path):
    path = write.render_report(written / "report.json", tmp_path / "again")
    assert path == tmp_path / "again" / "index.html"
    again = {p.relative_to(path.parent): p.read_bytes() for p in path.parent.rglob("*") if p.is_file()}
    first = {p.relative_to(written): p.read_bytes() for p in written.rglob("*") if p.is_file()}
    assert {name: first[name] for name in again} == again
    assert {str(name) for name in set(first) - set(again)} == {
        "report.json", *(str(name) for name in first if name.suffix == ".png")
    }  # fmt: skip


def test_a_link_out_of_the_folder_is_not_followed(written, tmp_path):
    import shutil

    shutil.copytree(written, tmp_path / "given")
    (tmp_path / "secret").write_text("secret")
    drawn = next((tmp_path / "given" / "figures").glob("*.svg")).name
    (tmp_path / "given" / "figures" / drawn).unlink()
    (tmp_path / "given" / "figures" / drawn).symlink_to(tmp_path / "secret")
    write.render_report(tmp_path / "given" / "report.json", tmp_path / "again")
    assert not (tmp_path / "again" / "figures" / drawn).exists()
    others = {p.name for p in (written / "figures").glob("*.svg")} - {drawn}
    assert others <= {p.name for p in (tmp_path / "again" / "figures").iterdir()}


def test_pages_can_be_written_again_in_place(written, tmp_path):
    import shutil

    shutil.copytree(written, tmp_path / "copy")
    (tmp_path / "copy" / "index.html").unlink()
    write.render_report(tmp_path / "copy" / "report.json", tmp_path / "copy")
    assert (tmp_path / "copy" / "index.html").read_bytes() == (written / "index.html").read_bytes()


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "report.json: Expecting value"),
        (b"{", "report.json: "),
        (b"[]", "report.json: report: expected an object, got list"),
        (b'{"schema": 7}', "reads schema 8, the file has schema 7"),
        (b"\xff\xfe", "report.json: not UTF-8 text"),
        (b'{"schema": 8}', "expected a list under 'entries'"),
        (b"[" * 200_000, "report.json: nested too deeply"),
    ],
)
def test_a_bad_file_is_rejected_and_the_page_is_kept(tmp_path, content, message):
    (tmp_path / "report.json").write_bytes(content)
    (tmp_path / "index.html").write_text("good")
    with pytest.raises(ValueError, match=message):
        write.render_report(tmp_path / "report.json", tmp_path)
    assert (tmp_path / "index.html").read_text() == "good"


def test_a_file_that_is_too_large_is_rejected_before_it_is_read(tmp_path, monkeypatch):
    monkeypatch.setattr(data, "_MAX_FILE_BYTES", 3)
    (tmp_path / "report.json").write_text("[[[[")
    with pytest.raises(ValueError, match="larger than 3 bytes"):
        write.render_report(tmp_path / "report.json", tmp_path)


def test_a_failed_write_keeps_the_good_file_and_leaves_no_draft(tmp_path, monkeypatch):
    (tmp_path / "index.html").write_text("good")

    def fail(_):
        raise OSError("disk full")

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(OSError, match="disk full"):
        write.replace_file(tmp_path / "index.html", b"partial")
    assert [path.name for path in tmp_path.iterdir()] == ["index.html"]
    assert (tmp_path / "index.html").read_text() == "good"


def test_a_file_is_replaced_and_not_written_over(tmp_path):
    (tmp_path / "index.html").write_text("good")
    os.link(tmp_path / "index.html", tmp_path / "held")
    write.replace_file(tmp_path / "index.html", b"new")
    assert (tmp_path / "index.html").read_text() == "new"
    assert (tmp_path / "held").read_text() == "good"


@pytest.mark.usefixtures("drawn")
def test_duplicate_entries_touch_no_file(entries, tmp_path):
    with pytest.raises(ValueError, match="occurs 2 times"):
        write.write_report([entries[0]] * 2, tmp_path)
    assert list(tmp_path.iterdir()) == []


needs_latex = pytest.mark.skipif(shutil.which(PROGRAM) is None, reason=f"there is no {PROGRAM} here")
SMALL = "\\documentclass{article}\\pagestyle{empty}\\begin{document}%s\\end{document}\n"


def answers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    """A program of the name in a folder of its own on the path."""
    program = tmp_path / PROGRAM
    program.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")


def test_without_latex_it_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    found = pdf_of(SMALL % "x")
    assert (found.content, found.pages) == (b"", 0)
    assert found.said == "there is no pdflatex on this machine: the .tex files are written, and no PDF"


def test_a_failure_is_said_with_the_complaint(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    answers(tmp_path, monkeypatch, "echo 'This is it'; echo '! Undefined control sequence.'; exit 1")
    found = pdf_of(SMALL % "x")
    assert (found.content, found.said) == (b"", "pdflatex failed: ! Undefined control sequence.")


def test_a_document_that_was_not_made_is_a_failure(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    answers(tmp_path, monkeypatch, "exit 0")
    assert pdf_of(SMALL % "x").said == "pdflatex failed: it made no document"


def test_the_document_and_its_pages(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    answers(tmp_path, monkeypatch, "printf made > text.pdf; echo 'Output written on text.pdf (3 pages, 99 bytes).'")
    found = pdf_of(SMALL % "x")
    assert (found.content, found.pages) == (b"made", 3)


def test_the_program_has_no_shell_no_date_and_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: dict[str, Any] = {}

    def run(command: list[str], **options: Any) -> None:
        asked.update(options, command=command)
        raise subprocess.TimeoutExpired(command, options["timeout"])

    monkeypatch.setattr(write.shutil, "which", lambda name: f"/bin/{name}")
    monkeypatch.setattr(write.subprocess, "run", run)
    found = pdf_of(SMALL % "x")
    assert (found.content, found.said.startswith("pdflatex: ")) == (b"", True)
    assert "-no-shell-escape" in asked["command"]
    assert asked["timeout"] == write.SECONDS
    assert (asked["env"]["openin_any"], asked["env"]["openout_any"]) == ("p", "p")
    assert asked["env"]["SOURCE_DATE_EPOCH"] == "0"
    assert asked["env"]["HOME"] == asked["cwd"]


@needs_latex
def test_latex_makes_the_same_document_twice() -> None:
    first, again = pdf_of(SMALL % "$x^2$"), pdf_of(SMALL % "$x^2$")
    assert first.content.startswith(b"%PDF")
    assert (first.pages, first.content) == (1, again.content)


@needs_latex
@pytest.mark.parametrize("body", [r"\input{/etc/passwd}", r"\undefined", r"\openout5=/tmp/x \write5{x}\closeout5"])
def test_latex_refuses(body: str) -> None:
    assert pdf_of(SMALL % body).content == b""
