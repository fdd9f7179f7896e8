"""LaTeX as a program: a document as PDF, without a shell and without a network."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

PROGRAM = "pdflatex"
SECONDS = 120
"""A document of a few pages takes one or two."""


@dataclass(frozen=True, slots=True)
class Pdf:
    """A document of LaTeX: ``content`` is empty where it was not made, and ``said`` is the reason; else its pages."""

    content: bytes
    said: str
    pages: int = 0


def pdf_of(text: str) -> Pdf:
    """The document that LaTeX makes of a text, the same bytes for the same text and the same LaTeX.

    LaTeX runs in a folder of its own, starts no program (``-no-shell-escape``), and opens no other folder's files but
    those that belong to it.
    """
    program = shutil.which(PROGRAM)
    if program is None:
        return Pdf(b"", f"there is no {PROGRAM} on this machine: the .tex files are written, and no PDF")
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "text.tex").write_text(text, encoding="ascii")
        command = [program, "-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "text.tex"]
        try:
            run = subprocess.run(
                command, cwd=folder, env=_environment(folder), capture_output=True, timeout=SECONDS, check=False
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            return Pdf(b"", f"{PROGRAM}: {error}")
        log = run.stdout.decode("utf-8", "replace")
        made = Path(folder, "text.pdf")
        if run.returncode or not made.is_file():
            return Pdf(b"", f"{PROGRAM} failed: {_complaint(log)}")
        return Pdf(made.read_bytes(), log, _pages(log))


def _environment(folder: str) -> dict[str, str]:
    """Where programs are, a home that is empty, no date, and no reading or writing elsewhere."""
    kept = {name: os.environ[name] for name in ("PATH", "SYSTEMROOT") if name in os.environ}
    limits = {"openin_any": "p", "openout_any": "p", "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}
    return kept | limits | {"HOME": folder, "TEXMFVAR": folder}


def _complaint(log: str) -> str:
    return next((line for line in log.splitlines() if line.startswith("!")), "it made no document")


def _pages(log: str) -> int:
    found = re.search(r"Output written on text\.pdf \((\d+) pages?", log.replace("\n", ""))
    return int(found[1]) if found else 0
