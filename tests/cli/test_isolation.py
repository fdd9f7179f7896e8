"""``verify`` runs where nothing outside of its key acts: no PYTHONPATH, sitecustomize, usercustomize, own folder."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from gspot_verified.cli import isolation
from gspot_verified.paper import content_key as keys

ROOT = Path(__file__).resolve().parents[2]
WORDS = ("verify", "S-gamma-intervals", "--alone", "--json")

POISON = """
import pathlib, sys
from dataclasses import replace
try:
    from gspot_verified.paper.checks.entry import conclude
    from gspot_verified.paper.verify import PARTS
except ImportError:  # a Python without the libraries
    pass
else:
    [part] = [part for part in PARTS.values() if "S-gamma-intervals" in part]
    honest = part["S-gamma-intervals"]
    def lie():
        entry = honest()
        checks = tuple(replace(check, agrees=True) for check in entry.checks)
        return replace(entry, checks=checks, verdict=conclude(entry.statement, checks))
    part["S-gamma-intervals"] = lie
    pathlib.Path(__file__).with_name("acted").write_text(str(sys.flags.isolated))
"""


def verified(folder: Path, *path: Path) -> tuple[int, str, bool]:
    """Exit code, outcome, and whether it came from the cache."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    environment["PYTHONPATH"] = os.pathsep.join(map(str, (*path, ROOT)))
    command = [sys.executable, "-m", "gspot_verified", *WORDS, "--cache", str(folder)]
    done = subprocess.run(
        command, capture_output=True, text=True, env=environment, cwd=folder, timeout=300, check=False
    )
    [entry] = json.loads(done.stdout)["entries"]
    return done.returncode, entry["verdict"]["outcome"], entry["from_cache"]


def test_a_sitecustomize_changes_no_result_and_poisons_no_later_run(tmp_path: Path) -> None:
    evil, cache = tmp_path / "evil", tmp_path / "cache"
    evil.mkdir()
    cache.mkdir()
    for name in ("sitecustomize.py", "usercustomize.py"):
        (evil / name).write_text(POISON)
    (cache / "flint.py").write_text("raise SystemExit(77)")  # the current folder
    assert verified(cache, evil) == (1, "refuted", False)
    assert (evil / "acted").read_text() == "0"  # before the isolated start, and not in it
    assert verified(cache) == (1, "refuted", True)


def test_the_key_of_an_isolated_run_is_its_own() -> None:
    code = "from gspot_verified.paper.content_key import ingredients; import json; print(json.dumps(ingredients(())))"
    start = isolation.command([])
    isolated = [*start[:3], start[3].replace("from gspot_verified.__main__ import run\nrun()", code), *start[4:]]
    outputs = [
        subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT).stdout
        for command in (isolated, [sys.executable, "-c", code])
    ]
    first, second = map(json.loads, outputs)
    assert first["python"] != second["python"]
    assert first["distributions"] == second["distributions"]


def test_what_acts_at_the_start_is_in_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def state() -> list[list[str]]:
        keys.startup.cache_clear()
        return keys.startup()

    monkeypatch.syspath_prepend(str(tmp_path))
    before = state()
    (tmp_path / "some.pth").write_text("import os")
    first = state()
    (tmp_path / "some.pth").write_text("import sys")
    assert len({json.dumps(found) for found in (before, first, state())}) == 3
    keys.startup.cache_clear()


@pytest.mark.parametrize(
    ("words", "started"),
    [(["verify"], True), (["--x", "verify", "--full"], True), (["theta", "verify"], False), ([], False)],
)
def test_which_commands_are_started_again(words: list[str], started: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[list[str]] = []
    monkeypatch.setenv("PYTHONPATH", "/nowhere")

    def execve(program: str, command: list[str], environment: dict[str, str]) -> None:
        assert program == sys.executable
        assert not [name for name in environment if name.startswith("PYTHON")]
        calls.append(command)

    monkeypatch.setattr(os, "execve", execve)
    isolation.isolate(words)
    assert calls == ([isolation.command(words)] if started else [])
    monkeypatch.setattr(isolation, "is_isolated", lambda: True)
    isolation.isolate(words)
    assert len(calls) == started
