"""The certificates of a report, checked again by the independent checker, whoever wrote the report."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.report.certificates import checked_certificates
from gspot_verified.report.data import read_report


@dataclass(frozen=True, slots=True)
class CheckedAgain(NoTruthValue, Written):
    """``same``: the file has the hash that the report names, and the checker verified it with the same line."""

    ask: ClassVar[str] = ".same is True only if the checker verified the file that the report names"

    name: str
    same: bool
    said: str


def check_report(folder: Path, progress: Callable[[str], None] | None = None) -> list[CheckedAgain]:
    """Every certificate that the report in ``folder`` names, and every other one that lies in its folder.

    :raises ValueError: there is no report.json, it is malformed, or it names no certificate.

    >>> check_report(Path("nowhere"))
    Traceback (most recent call last):
    ...
    ValueError: --check: there is no file nowhere/report.json
    """
    path = folder / "report.json"
    if not path.is_file():
        raise ValueError(f"--check: there is no file {path}")
    report = read_report(path)
    if not report["certificates"]:
        raise ValueError(f"{path}: it names no certificate")
    here = {certificate.name: certificate for certificate in checked_certificates(folder / "certificates", progress)}
    results = []
    for named in report["certificates"]:
        certificate = here.pop(named["name"], None)
        if certificate is None:
            results.append(CheckedAgain(named["name"], False, "the file is missing"))
        elif certificate.sha256 != named["sha256"]:
            results.append(
                CheckedAgain(certificate.name, False, f"another file than the report names; now: {certificate.said}")
            )
        else:
            results.append(
                CheckedAgain(
                    certificate.name, certificate.verified and certificate.said == named["said"], certificate.said
                )
            )
    return results + [
        CheckedAgain(other.name, False, f"the report does not name it; {other.said}") for other in here.values()
    ]
