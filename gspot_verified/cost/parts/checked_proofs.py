"""The parts on what checks the proofs: the independent checker of certificates, and Coq where it is installed."""

from __future__ import annotations

import atexit
import re
import shutil
import subprocess
import sys
import tempfile
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from gspot_verified.certificates.checker import CheckResult, checker_path
from gspot_verified.certificates.checker import check as run_checker
from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, clock
from gspot_verified.cost.measurement.measurement import CERTIFIED, Limit
from gspot_verified.cost.parts.zero_parts import atlas_text

_ENDS, _MORE_ENDS = (2, 3, 4), (5, 7)  # atlases for beta in (1, end); more in full
_SOURCES = Path(__file__).resolve().parents[3] / "proofs" / "coq"
_FEW_FILES = 3  # of proofs/coq; the rest in full
_LIMIT_CALLS = 3  # of which the fastest counts
_LIBRARY = "GSpot"
_FOLDERS: dict[str, Path] = {}
_TEXTS: dict[int, str] = {}


def _words(end: int) -> str:
    return f"β in (1, {end})"


def _checking(end: int) -> Call:
    if end not in _TEXTS:
        _TEXTS[end] = atlas_text(end) or ""
    folder = _folder("certificates")
    file = folder / f"zeros_1_{end}.cert"
    file.write_text(_TEXTS[end], encoding="utf-8")
    return partial(run_checker, file)


def _verified(end: int, result: CheckResult) -> float | None:
    return float(end) if result.verified else None


def _folder(name: str) -> Path:
    """A folder that is removed when the process ends."""
    if name not in _FOLDERS:
        _FOLDERS[name] = Path(tempfile.mkdtemp(prefix=f"gspot-{name}-"))
        atexit.register(shutil.rmtree, _FOLDERS[name], ignore_errors=True)
    return _FOLDERS[name]


def _checker_missing() -> str:
    try:
        checker_path()
    except ValueError:
        return "proofs/checker is not here"
    return ""


def _checker_contestants() -> tuple[TimedRoute, ...]:
    return (
        TimedRoute(
            "producing", CERTIFIED, _ENDS, lambda end: partial(atlas_text, end), _MORE_ENDS, words=_words,
            exponent=3.0, theory="as in the atlas",
        ),
        TimedRoute(
            "checking", CERTIFIED, _ENDS, _checking, _MORE_ENDS, words=_words, place=_verified,
            missing=_checker_missing(), exponent=3.0, theory="the same pieces, in Python’s integers",
        ),
    )  # fmt: skip


def _checker_limit(_: bool) -> Limit:
    end = _ENDS[-1]
    check = _checking(end)
    numbers = re.findall(r"-?\d+", _TEXTS[end])

    def reading() -> None:
        subprocess.run([sys.executable, "-I", "-S", "-c", "pass"], check=True)
        for number in numbers:
            int(number)

    def least(call: Call) -> float:
        times = []
        for _ in range(_LIMIT_CALLS):
            start = clock()
            call()
            times.append(clock() - start)
        return min(times)

    words = f"starting Python and reading the {len(numbers)} integers of the certificate"
    return Limit(_words(end), words, least(reading), least(check))


CHECKER = Blueprint(
    key="checker",
    title="The independent checker",
    question="The certificate of all zeros for β in (1, k): producing it, and checking it with proofs/checker, "
    "start included.",
    axis="k",
    symbol="k",
    contestants=_checker_contestants,
    profiled=None,
    limit=_checker_limit,
    remarks=(
        "The checker computes with Python’s own integers. It shares nothing with the producer, not even FLINT. That "
        "is what its time buys.",
    ),
)


def coq_sources() -> list[str]:
    """The files of the formal proofs in the order in which they build on each other; none where they are not here."""
    project = _SOURCES / "_CoqProject"
    if not project.is_file():
        return []
    return re.findall(r"^(\w+\.v)$", project.read_text(encoding="utf-8"), re.MULTILINE)


@lru_cache(maxsize=1)
def coq_missing() -> str:
    """Why Coq cannot be asked; empty when it can."""
    if not coq_sources():
        return "proofs/coq is not here"
    if shutil.which("coqc") is None:
        return "Coq is not installed on this machine"
    folder = _folder("coq")
    (folder / "probe.v").write_text("From Coquelicot Require Import Coquelicot.\n", encoding="utf-8")
    done = subprocess.run(["coqc", "probe.v"], cwd=folder, capture_output=True, check=False)
    return "Coquelicot is not installed on this machine" if done.returncode else ""


def _compiling(name: str) -> Call:
    folder = _folder("coq")
    for source in coq_sources()[: coq_sources().index(name) + 1]:
        if not (folder / source).exists():
            shutil.copyfile(_SOURCES / source, folder / source)
        if source != name and not (folder / source).with_suffix(".vo").exists():
            _compile(folder, source)
    return partial(_compile, folder, name)


def _compile(folder: Path, name: str) -> bool | None:
    done = subprocess.run(["coqc", "-R", ".", _LIBRARY, name], cwd=folder, capture_output=True, check=False)
    return True if done.returncode == 0 else None


def _lines(name: str, _: Any) -> float:
    return float(len((_SOURCES / name).read_text(encoding="utf-8").splitlines()))


def _coq_contestants() -> tuple[TimedRoute, ...]:
    names = tuple(coq_sources())
    return (
        TimedRoute(
            "coqc", CERTIFIED, names[:_FEW_FILES], _compiling, names[_FEW_FILES:], place=_lines,
            has_memory=False, missing=coq_missing(), exponent=1.0,
            theory="a proof script is read once; single tactics decide",
        ),
    )  # fmt: skip


FORMAL = Blueprint(
    "formal",
    "The formal proofs",
    "Each file of proofs/coq compiled by Coq, what it builds on being there.",
    "lines L of the file",
    "L",
    _coq_contestants,
)
