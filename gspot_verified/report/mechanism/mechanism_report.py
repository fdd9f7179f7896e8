"""The report on the user's own mechanism: one HTML file that loads nothing from elsewhere, and the files beside it."""

from __future__ import annotations

import base64
import json
import os
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from gspot_verified.mechanisms.input.mechanism import MechanismError, exact_rational
from gspot_verified.mechanisms.load import mechanism_text
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.report.mechanism.report import MechanismReport, report_on
from gspot_verified.report.mechanism.runs import State, check_state, report_scene
from gspot_verified.report.mechanism.subject import Source
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.site import rendered, style
from gspot_verified.report.write import make_folder, replace_file
from gspot_verified.scenes.scene.file import files_read

PAGE, DATA = "mechanism.html", "mechanism.json"
WRITTEN = re.compile(r"(mechanism\.(toml|html|json)|scene\.toml|g-spot-[0-9]+.*)")
"""The names of the files of a report."""
SCHEMA = "gspot-verified/mechanism-report/2"


def mechanism_page(report: MechanismReport) -> str:
    """The page, with its style and its pictures inside."""
    return rendered("mechanism", report=report, style=style(), drawn=_address, data_file=DATA)


def write_pages(report: MechanismReport, directory: Path) -> Path:
    """Write the page, ``mechanism.json``, the mechanism files and the certificates; returns the path of the page.

    Each file is replaced in one step, the page last.

    :raises OSError: a file or folder cannot be written.
    """
    page = mechanism_page(report)
    make_folder(directory)
    for name, content in report.files:
        replace_file(directory / name, content)
    for certificate in report.certificates:
        replace_file(directory / certificate.name, certificate.content)
    data = json.dumps({**report.to_json(), "schema": SCHEMA}, indent=1, sort_keys=True, ensure_ascii=False)
    replace_file(directory / DATA, f"{data}\n".encode())
    return replace_file(directory / PAGE, page.encode())


def _address(picture: Picture) -> str:
    """The picture itself as the address of an image."""
    return "data:image/svg+xml;base64," + base64.b64encode(picture.svg.encode()).decode()


FILE = "mechanism.toml"
"""The name of the copy of the mechanism's file beside the page."""


def mechanism_report(
    name_or_path: str | Path,
    directory: str | Path | None = None,
    *,
    settings: Mapping[str, ExactInput | None] | None = None,
    states: Sequence[State] = (),
    scene: str | None = None,
    budget: int | None = None,
    progress: Callable[[str], None] = lambda _: None,
) -> MechanismReport:
    """All that the library states about a mechanism: its G-spots, cases and sides, the expansion, certified runs.

    With ``directory`` it is written as one page, ``mechanism.html``, for the appendix of a paper, beside its data
    (``mechanism.json``), the mechanism's file and the certificates. Nothing in it depends on the day or the machine,
    but for the versions that it names. A part that is not stated says why.

    :param name_or_path: as for :func:`load`.
    :param directory: made if it does not exist; the folder it is in must exist. None: nothing is written.
    :param settings: values of parameters.
    :param states: starts of slip, as for :func:`approach`; none: two are chosen next to each G-spot in a Case.
    :param scene: a scene of this mechanism, a file or a name as for :func:`load_scene`, for a certified run.
    :param budget: how many boxes the search for all G-spots looks at; 100 000 if left out.
    :param progress: is told what is done.
    :raises MechanismError: no such mechanism, a part of it is wrong, or a parameter has no value.
    :raises StateError: a state names no component, or too few. (From one with p <= 0 nothing is stated.)
    :raises SceneError: no such scene, or it is that of another mechanism.
    :raises OSError: the folder cannot be written, or a file that is read there would be replaced; checked before the
        work.

    >>> report = mechanism_report("falling-rod-lower-friction", settings={"mu": "13/10"})
    >>> report.exit_code, report.search.text.partition(" (refuted")[0]
    (1, 'falling rod, lower friction, mu = 13/10 has no G-spot in the region')
    """
    if directory is not None:
        _check_folder(Path(directory))
        check_not_replaced(Path(directory), name_or_path, scene)
    text, origin = mechanism_text(name_or_path)
    missing = [key for key, value in (settings or {}).items() if value is None]
    if missing:
        raise MechanismError(f"{origin}: the report needs a number for {missing[0]}, a symbol has no G-spot")
    chosen = {key: str(exact_rational(value, key)) for key, value in (settings or {}).items() if value is not None}
    source = Source(FILE, text, chosen)
    try:
        _ = source.mechanism
    except MechanismError as error:
        raise MechanismError(f"{origin}: {error}") from None
    for state in states:
        check_state(source.mechanism, state)
    shown = None if scene is None else report_scene(scene, source)
    report = report_on(source, states, shown, budget, progress)
    if directory is not None:
        write_pages(report, Path(directory))
    return report


def check_not_replaced(directory: Path, name_or_path: str | Path, scene: str | None) -> None:
    """Passes where no file of the report takes the place of the mechanism's file, or of the scene's files.

    :raises FileExistsError: one does.
    """
    for read in (Path(name_or_path), *([] if scene is None else files_read(scene))):
        if os.path.isfile(read) and read.resolve().parent == directory.resolve() and WRITTEN.fullmatch(read.name):
            raise FileExistsError(f"{read} is read, and the report would take its place; choose another folder")


def _check_folder(directory: Path) -> None:
    place = directory if directory.is_dir() else directory.parent
    if directory.exists() and not directory.is_dir():
        raise NotADirectoryError(f"{directory} is a file, not a folder")
    if not place.is_dir():
        raise FileNotFoundError(f"there is no folder {place}")
    if not os.access(place, os.W_OK | os.X_OK):
        raise PermissionError(f"the folder {place} cannot be written")
