"""A source of which Python would run an older compiled form is found, and no other."""

from __future__ import annotations

import importlib.util
import os
import py_compile
import subprocess
import sys
from pathlib import Path

import pytest

from gspot_verified.paper.cache import Cache
from gspot_verified.paper.stale_bytecode import stale_bytecode

MODES = py_compile.PycInvalidationMode
TIMESTAMP, UNCHECKED = MODES.TIMESTAMP, MODES.UNCHECKED_HASH


def compiled(folder: Path, mode: MODES = TIMESTAMP) -> Path:
    source = folder / "toy.py"
    source.write_text("answer = 1\n")
    py_compile.compile(str(source), invalidation_mode=mode)
    return source


def changed(source: Path, text: str = "answer = 2\n") -> None:
    """Within the second of the first text, or with its date."""
    at = source.stat()
    source.write_text(text)
    os.utime(source, ns=(at.st_atime_ns, at.st_mtime_ns))


def imported(source: Path) -> int:
    """What Python runs."""
    command = [sys.executable, "-B", "-c", "import toy; print(toy.answer)"]
    run = subprocess.run(command, cwd=source.parent, capture_output=True, text=True, check=True)
    return int(run.stdout)


@pytest.mark.parametrize("mode", [TIMESTAMP, UNCHECKED], ids=lambda mode: mode.name)
def test_an_older_form_is_found(tmp_path: Path, mode: MODES) -> None:
    source = compiled(tmp_path, mode)
    assert stale_bytecode([source]) is None
    changed(source)
    assert imported(source) == 1  # the hazard itself
    assert stale_bytecode([tmp_path / "other.py", source]) == source


def test_what_python_compiles_again_is_not_stale(tmp_path: Path) -> None:
    for mode, text in ((TIMESTAMP, "answer = 22\n"), (MODES.CHECKED_HASH, "answer = 2\n")):
        source = compiled(tmp_path, mode)
        changed(source, text)
        assert imported(source) in (2, 22)
        assert stale_bytecode([source]) is None
    source = compiled(tmp_path)
    place = Path(importlib.util.cache_from_source(str(source)))
    changed(source)
    place.write_bytes(b"\0\0\0\0" + place.read_bytes()[4:])  # of another Python
    assert stale_bytecode([source]) is None
    place.unlink()
    assert stale_bytecode([source]) is None


def test_a_compiled_file_that_cannot_be_read_is_not_taken_for_the_source(tmp_path: Path) -> None:
    source = compiled(tmp_path)
    place = Path(importlib.util.cache_from_source(str(source)))
    place.write_bytes(place.read_bytes()[:16])
    assert stale_bytecode([source]) == source


def test_the_cache_stays_closed_beside_an_older_form(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.paper.cache.newest_change", lambda _: 0.0)
    source = compiled(tmp_path)
    assert Cache(tmp_path / "cache", sources=[source]).closed == ""
    changed(source)
    assert "older form of toy.py" in Cache(tmp_path / "cache", sources=[source]).closed


def test_the_package_is_run_as_it_is() -> None:
    package = Path(__file__).resolve().parents[2] / "gspot_verified"
    assert stale_bytecode(package.rglob("*.py")) is None
