"""Writing the report: ``report.json``, pages, ``figures/``, ``certificates/``; and the pages again from the JSON.

A LaTeX document becomes a PDF without a shell and without a network.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gspot_verified.cost.measurement.file import load, recorded, written
from gspot_verified.cost.measurement.measurement import Measurement
from gspot_verified.paper.checks.entry import Entry
from gspot_verified.report.certificates import CheckedCertificate, certificate_checks
from gspot_verified.report.data import read_report, report_data
from gspot_verified.report.figures.figures import drawings
from gspot_verified.report.hard_cases import hard_cases, measurements
from gspot_verified.report.parts.cost_page import cost_figures
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.site import pages, style
from gspot_verified.report.supplement import ERRATA_PAGES, supplement
from gspot_verified.work.executors import InProcessExecutor, as_they_end

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


def write_report(
    entries: Sequence[Entry],
    directory: Path,
    progress: Callable[[str], None] | None = None,
    pool: Executor | None = None,
) -> Path:
    """Draw the figures, check the certificates and write the report; returns the path of its ``index.html``.

    The commands are ``verify`` and ``report``; the second word is the subpackage here.

    Everything is computed before the first file is touched, and each file is replaced in one step, the start last.

    :param directory: made if it does not exist; the folder it is in must exist.
    :param progress: called with a short line after each part that is computed, and before each step of writing.
    :param pool: where figures, certificates and hard cases are computed.
    :raises ValueError: two entries have one identifier.
    :raises RuntimeError: a part could not be computed; the message has its name.
    :raises OSError: a file or folder cannot be written; that its own folder is missing is seen before the work.

    >>> write_report([], Path("nowhere") / "report")
    Traceback (most recent call last):
    ...
    FileNotFoundError: there is no folder nowhere
    """
    _check_parent(directory)
    say = progress or (lambda _: None)
    drawn, certificates, hard = computed(say, pool or InProcessExecutor())
    report = report_data(entries, drawn, certificates, hard)
    measurement = recorded()
    made = pages(report, measurement)
    for folder in (directory, directory / "figures", directory / "certificates"):
        make_folder(folder)
    say("writing figures and certificates")
    for picture in drawn:
        replace_file(directory / "figures" / f"{picture.name}.png", picture.png)
        replace_file(directory / "figures" / f"{picture.name}.svg", picture.svg.encode())
    for certificate in certificates:
        replace_file(directory / "certificates" / certificate.name, certificate.content)
    say("writing report.json")
    replace_file(directory / "report.json", _canonical(report))
    say("writing the pages")
    _write_measurement(measurement, directory)
    return _write_pages(made, directory)


def computed(
    say: Callable[[str], None], pool: Executor
) -> tuple[tuple[Picture, ...], list[CheckedCertificate], dict[str, Any]]:
    """Figures, certificates and hard cases: parts that do not depend on each other, the longest kind first."""
    certificates, figures, families = certificate_checks(), drawings(), measurements()
    calls: dict[str, Callable[[], Any]] = {**dict(reversed(certificates.items())), **figures, **families}
    results: dict[str, Any] = {}
    for name, result in as_they_end(pool, calls):
        results[name] = result
        say(f"{name}: done, {len(results)} of {len(calls)} parts of the report")
    drawn = tuple(results[name] for name in figures)
    return drawn, [results[name] for name in certificates], hard_cases(results[name] for name in families)


def render_report(path: Path, directory: Path, cost: Path | None = None) -> Path:
    """Write the pages into ``directory`` from a ``report.json``; returns the start. Nothing is computed again.

    Every page says that it shows a file. Figures and certificates that lie beside it are copied. Proof pages and code
    are shown where the versions that the report was made with are here.

    :param cost: what ``gspot-verified cost --output`` wrote, for the page on cost; None: the ``cost.json`` beside the
        file, or else the measurement that comes with the package.
    :raises ValueError: the file is not JSON, has another schema, or is malformed; the message names the file.
    :raises OSError: the file cannot be read.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as place:
    ...     Path(place, "report.json").touch()
    ...     render_report(Path(place, "report.json"), Path(place, "pages"))
    Traceback (most recent call last):
    ...
    ValueError: ...json: Expecting value: line 1 column 1 (char 0)
    """
    beside = path.parent / "cost.json"
    measurement = load(cost or beside) if cost is not None or beside.is_file() else recorded()
    report = read_report(path)
    made = pages(report, measurement)
    make_folder(directory)
    files = [f"figures/{figure['name']}.svg" for figure in report["figures"]]
    files += [f"certificates/{certificate['name']}" for certificate in report["certificates"]]
    for name in files:
        source, target = path.parent / name, directory / name
        if not source.resolve().is_relative_to(path.parent.resolve()):
            continue  # a link to some other file
        if source.is_file() and not (target.exists() and target.samefile(source)):
            make_folder(target.parent)
            replace_file(target, source.read_bytes())
    _write_measurement(measurement, directory)
    return _write_pages(made, directory)


@dataclass(frozen=True, slots=True)
class Supplement:
    """The files of a supplement, and what is to be said of LaTeX: empty where it made both documents."""

    files: tuple[Path, ...]
    warnings: tuple[str, ...]


def write_supplement(path: Path, directory: Path) -> Supplement:
    """Write ``errata.tex`` and ``theorems.tex`` from a ``report.json``, and their PDFs where LaTeX is here.

    :raises ValueError: the file is no report.
    :raises OSError: a file cannot be read or written.
    """
    made = supplement(read_report(path))
    make_folder(directory)
    files, warnings = [], []
    for name, text in made.items():
        files.append(replace_file(directory / name, text.encode("ascii")))
        document = pdf_of(text)
        if document.content:
            files.append(replace_file(directory / name.replace(".tex", ".pdf"), document.content))
        else:
            warnings.append(f"{name}: {document.said}")
        if name == "errata.tex" and document.pages > ERRATA_PAGES:
            warnings.append(f"{name}: {document.pages} pages, more than {ERRATA_PAGES}")
    return Supplement(tuple(files), tuple(warnings))


def _write_measurement(measurement: Measurement, directory: Path) -> None:
    replace_file(directory / "cost.json", written(measurement).encode())
    make_folder(directory / "figures")
    for name, svg in cost_figures(measurement).items():
        replace_file(directory / "figures" / f"{name}.svg", svg.encode())


def _write_pages(made: dict[str, str], directory: Path) -> Path:
    replace_file(directory / "style.css", style().encode())
    for name, content in made.items():
        if name != "index.html":
            replace_file(directory / name, content.encode())
    return replace_file(directory / "index.html", made["index.html"].encode())


def _canonical(report: dict[str, Any]) -> bytes:
    return (json.dumps(report, indent=1, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n").encode()


def make_folder(directory: Path) -> None:
    """The folder, if only its last part is missing; a slip in the path makes no tree of folders."""
    _check_parent(directory)
    directory.mkdir(exist_ok=True)


def _check_parent(directory: Path) -> None:
    if not directory.parent.is_dir():
        raise FileNotFoundError(f"there is no folder {directory.parent}")


def replace_file(path: Path, content: bytes) -> Path:
    """Write the whole file beside its place, then put it there in one step; a good file is never left half-written."""
    draft = path.with_name(f".{path.name}.{secrets.token_hex(6)}.tmp")
    try:
        with draft.open("xb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)
    return path
