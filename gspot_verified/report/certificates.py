"""The certificates of ``proofs/`` and what the independent checker says of them."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import ClassVar

from gspot_verified.certificates.checker import check
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.report.parts.proof_page import PROOFS


@dataclass(frozen=True, slots=True)
class CheckedCertificate(NoTruthValue, Written):
    """``said``: the checker's line, with the statement that it verified or the reason why it did not."""

    ask: ClassVar[str] = ".verified is True only if the checker verified the certificate"
    written: ClassVar[str] = "name sha256 verified said"

    name: str
    sha256: str
    verified: bool
    said: str
    content: bytes


def checked_certificates(
    folder: Path = PROOFS, progress: Callable[[str], None] | None = None
) -> list[CheckedCertificate]:
    """Every certificate of a folder, checked now by ``proofs/checker`` in a process of its own.

    :raises ValueError: the checker is not there, or it could not run.
    :raises OSError: a file cannot be read.
    """
    certificates = []
    for path in _certificates(folder):
        if progress is not None:
            progress(f"checking {path.name}")
        certificates.append(checked(path))
    return certificates


def certificate_checks(folder: Path = PROOFS) -> dict[str, Callable[[], CheckedCertificate]]:
    """What checks each certificate of a folder, by its name."""
    return {path.name: partial(checked, path) for path in _certificates(folder)}


def checked(path: Path) -> CheckedCertificate:
    """One certificate, checked now: the bytes that were read, whatever stands in the file when the checker begins.

    :raises ValueError: the checker is not there, or it could not run.
    :raises OSError: the file cannot be read.
    """
    content = path.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, "read.cert")
        copy.write_bytes(content)
        result = check(copy)
    said = result.text.splitlines()[-1]
    return CheckedCertificate(path.name, hashlib.sha256(content).hexdigest(), result.verified, said, content)


def _certificates(folder: Path) -> list[Path]:
    """The regular files: to read a pipe or a device would never end."""
    return sorted(path for path in folder.glob("*.cert") if path.is_file())
