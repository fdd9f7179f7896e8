"""Writing the report: ``report.json``, ``index.html``, ``figures/*.png``; and the page again from the JSON."""

from __future__ import annotations

import base64
import json
import os
import secrets
from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from gspot_verified.ledger.entry import Entry, Rung
from gspot_verified.report.data import checked, report_data
from gspot_verified.report.figures import pictures
from gspot_verified.verdict import Outcome, Reason

if TYPE_CHECKING:
    from jinja2 import Template

_MAX_FILE_BYTES = 200_000_000
_ANSWERS = {True: "agrees", False: "fails", None: "could not tell"}
_COUNTEREXAMPLE = "single points: one certain counterexample is enough"
_COUNTEREXAMPLE_SHORT = "a counterexample at points"  # points carry no other verdict


def write_report(entries: Sequence[Entry], directory: Path, progress: Callable[[str], None] | None = None) -> Path:
    """Draw the figures and write the report; returns the path of its ``index.html``.

    Everything is computed before the first file is touched, and each file is replaced in one step, the page last.

    :param directory: made if it does not exist; the folder it is in must exist.
    :param progress: called with a short line before each step.
    :raises ValueError: two entries have one identifier.
    :raises OSError: a file or folder cannot be written.
    """
    say = progress or (lambda _: None)
    drawn = pictures(say)
    report = report_data(entries, drawn)
    page = render_html(report)
    _make(directory)
    _make(directory / "figures")
    for picture in drawn:
        say(f"writing figures/{picture.name}.png")
        _replace(directory / "figures" / f"{picture.name}.png", picture.png)
    say("writing report.json")
    _replace(directory / "report.json", _canonical(report))
    say("writing index.html")
    return _replace(directory / "index.html", page.encode())


def render_from_json(path: Path, directory: Path) -> Path:
    """Write ``index.html`` into ``directory`` from a ``report.json``; returns its path. Nothing is computed again.

    :raises ValueError: the file is not JSON, has another schema, or is malformed; the message names the file.
    :raises OSError: the file cannot be read.
    """
    if path.stat().st_size > _MAX_FILE_BYTES:
        raise ValueError(f"{path}: larger than {_MAX_FILE_BYTES} bytes, so it is not a report")
    try:
        page = render_html(json.loads(path.read_text(encoding="utf-8")))
    except UnicodeDecodeError:
        raise ValueError(f"{path}: not UTF-8 text") from None
    except RecursionError:
        raise ValueError(f"{path}: nested too deeply, so it is not a report") from None
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    _make(directory)
    return _replace(directory / "index.html", page.encode())


def render_html(report: dict[str, Any]) -> str:
    """The page, from the data of ``report.json`` alone.

    Texts are escaped; figures become images, in which a browser runs no script and loads nothing.

    :raises ValueError: the data is not a report of this schema.
    """
    report = checked(report)
    entries = [_shown(entry) for entry in report["entries"]]
    return _template().render(
        counts=report["counts"],
        rungs=[
            (rung, *(report["rungs"][outcome][rung.name.lower()] for outcome in ("proved", "refuted"))) for rung in Rung
        ],
        page_alone=report["page_alone"],
        versions=report["versions"],
        entries=entries,
        sections=_by_section(entries),
        refuted=[entry for entry in entries if entry["outcome"] == Outcome.REFUTED.value],
        undecided=[entry for entry in entries if entry["outcome"] == Outcome.UNDECIDED.value],
        figures=[{**picture, "source": _data_address(picture["svg"])} for picture in report["figures"]],
    )


def _shown(entry: dict[str, Any]) -> dict[str, Any]:
    """An entry with the words that the page shows for its codes."""
    verdict = entry["verdict"]
    reason = verdict["reason"]
    rests_on = [Rung[rung.upper()] for rung in entry["rests_on"]]
    checks = [{**check, "rung": _rung_words(check), "answer": _ANSWERS[check["agrees"]]} for check in entry["checks"]]
    return {
        **entry,
        "anchor": "entry-" + quote(entry["identifier"], safe=""),
        "outcome": verdict["outcome"],
        "witness": verdict["witness"],
        "detail": verdict["detail"],
        "reason": Reason[reason.upper()].value.capitalize() + "." if reason else None,
        "remaining": [" × ".join(box) for box in verdict["remaining"]],
        "checks": checks,
        "rests_on": [_COUNTEREXAMPLE_SHORT if rung is Rung.POINTS else rung.short for rung in rests_on],
        "page_alone": rests_on == [Rung.PAGE],
    }


def _rung_words(check: dict[str, Any]) -> str:
    rung = Rung[check["rung"].upper()]
    return _COUNTEREXAMPLE if rung is Rung.POINTS and check["agrees"] is False else rung.value


def _by_section(entries: Sequence[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """The entries under their sections, in order of first appearance."""
    sections: dict[str, list[dict[str, Any]]] = {}
    for entry in entries:
        sections.setdefault(entry["section"], []).append(entry)
    return sections


def _data_address(svg: str) -> str:
    return "data:image/svg+xml;base64," + base64.b64encode(svg.encode()).decode()


@lru_cache(maxsize=1)
def _template() -> Template:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("gspot_verified", "report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    return environment.get_template("report.html.j2")


def _canonical(report: dict[str, Any]) -> bytes:
    return (json.dumps(report, indent=1, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _make(directory: Path) -> None:
    """The folder, if only its last part is missing; a slip in the path makes no tree of folders."""
    if not directory.parent.is_dir():
        raise FileNotFoundError(f"there is no folder {directory.parent}")
    directory.mkdir(exist_ok=True)


def _replace(path: Path, content: bytes) -> Path:
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
