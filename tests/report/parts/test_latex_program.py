"""LaTeX as a program: absent, failing, too slow, and, where it is, a document without a shell."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from gspot_verified.report.parts import latex_program
from gspot_verified.report.parts.latex_program import PROGRAM, pdf_of

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

    monkeypatch.setattr(latex_program.shutil, "which", lambda name: f"/bin/{name}")
    monkeypatch.setattr(latex_program.subprocess, "run", run)
    found = pdf_of(SMALL % "x")
    assert (found.content, found.said.startswith("pdflatex: ")) == (b"", True)
    assert "-no-shell-escape" in asked["command"]
    assert asked["timeout"] == latex_program.SECONDS
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
