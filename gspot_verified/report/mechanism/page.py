"""The page on one mechanism: one HTML file that loads nothing from elsewhere, and the files beside it."""

from __future__ import annotations

import base64
import json
import re
from pathlib import Path

from gspot_verified.report.mechanism.report import MechanismReport
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.site import rendered, style
from gspot_verified.report.write import make_folder, replace_file

PAGE, DATA = "mechanism.html", "mechanism.json"
WRITTEN = re.compile(r"(mechanism\.(toml|html|json)|scene\.toml|g-spot-[0-9]+.*)")
"""The names of the files of a report."""
SCHEMA = "gspot-verified/mechanism-report/1"


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
