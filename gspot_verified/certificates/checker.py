"""Running the independent checker ``proofs/checker`` in a process of its own.

The checker shares nothing with this package: it is started as a program, in isolated mode, without site packages.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

_ROOT = Path(__file__).resolve().parents[2]
_REJECTED = 1  # the exit code with which the checker rejects
_USAGE = 64  # the exit code of a wrong command line


@dataclass(frozen=True, slots=True)
class CheckResult(NoTruthValue, Written):
    """What the checker said. ``verified`` is True only if it printed its line and left with code 0."""

    ask: ClassVar[str] = ".verified is True only if the checker verified the certificate"

    verified: bool
    text: str


def checker_path() -> Path:
    """The folder of the checker, which Python runs as it is: in the source tree, or where an installation put it.

    :raises ValueError: it is in neither place.
    """
    places = (_ROOT / "proofs" / "checker", Path(sys.prefix) / "share" / "gspot_verified" / "checker")
    for place in places:
        if (place / "__main__.py").is_file():
            return place
    raise ValueError(
        "the checker proofs/checker was not found; run it from the source tree: python proofs/checker FILE"
    )


def check(file: Path, workers: int = 1, limits: Sequence[str] = ()) -> CheckResult:
    """Check one certificate. ``limits``: texts ``NAME=NUMBER`` for limits of the checker that are raised on purpose.

    :raises ValueError: there is no such file, an option is not one of the checker's, or the checker could not run.

    >>> check(checker_path().with_name("iwc_0_1.cert")).text
    'VERIFIED dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)'
    """
    if not file.exists():
        raise ValueError(f"there is no file {file}")
    if not file.is_file():
        raise ValueError(f"{file} is not a regular file")
    options = [f"--workers={workers}", *(f"--limit={limit}" for limit in limits)]
    # An absolute path is never taken for an option.
    # What runs is the text of the checker: compiled files are neither read nor written.
    python = [sys.executable, "-I", "-S", "-B", "-X", "utf8", "-X", f"pycache_prefix={os.devnull}"]
    command = [*python, str(checker_path()), *options, str(file.absolute())]
    run = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)
    if run.returncode == 0 and run.stdout.startswith("VERIFIED "):
        return CheckResult(True, run.stdout.strip())
    # Python leaves with 1 after a traceback, too.
    if run.returncode == _REJECTED and run.stderr.startswith("REJECTED "):
        return CheckResult(False, run.stderr.strip())
    if run.returncode == _USAGE and run.stderr.startswith("usage: "):
        raise ValueError(run.stderr.strip().partition("CERTIFICATE: ")[2])
    raise ValueError(f"the checker stopped with code {run.returncode}: {run.stderr.strip()[-500:]}")
