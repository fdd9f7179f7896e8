"""What is kept is given back under the same key alone, whole, and never by itself a proof."""

from __future__ import annotations

import importlib.util
import json
import os
import py_compile
import signal
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper import cache as cache_module
from gspot_verified.paper import verify
from gspot_verified.paper.cache import Cache, default_folder, stale_bytecode
from gspot_verified.paper.checks.entry import Check, Entry, Rung, Section, conclude
from gspot_verified.paper.verify import verify_claims, verify_paper


def entry(identifier: str, *answers: bool | None, names: str = "") -> Entry:
    checks = [Check(Rung.EXACT, f"check {n} {names}", agrees, "it") for n, agrees in enumerate(answers)]
    return Section("Section").settled(identifier, "line 1", "x", "statement", *checks, corrected="c", note="n")


PROVED, REFUTED, OPEN = entry("a", True, True), entry("b", False, False), entry("c", True)


def kept_files(folder: Path) -> list[Path]:
    return sorted(folder.glob("*/*.json"))


@pytest.mark.parametrize("made", [PROVED, REFUTED], ids=lambda made: made.verdict.outcome.value)
def test_what_is_kept_comes_back(tmp_path: Path, made: Entry) -> None:
    cache = Cache(tmp_path / "deep" / "folder", sources=())
    assert cache.recall(made.identifier) is None
    cache.keep(made)
    assert cache.recall(made.identifier) == replace(made, from_cache=True)
    assert Cache(tmp_path / "deep" / "folder", sources=()).recall(made.identifier) is not None
    assert cache.recall("other") is None
    assert Cache(tmp_path / "deep" / "folder", read=False, sources=()).recall(made.identifier) is None


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="a system without named pipes")
def test_a_pipe_in_the_place_of_a_result_is_none(tmp_path: Path) -> None:
    """To read it would wait for a writer, for ever."""
    cache = Cache(tmp_path, sources=())
    cache.keep(PROVED)
    (place,) = kept_files(tmp_path)
    place.unlink()
    os.mkfifo(place)
    assert cache.recall(PROVED.identifier) is None


def test_an_undecided_entry_is_not_kept(tmp_path: Path) -> None:
    cache = Cache(tmp_path, sources=())
    cache.keep(OPEN)
    assert OPEN.verdict.outcome is Outcome.UNDECIDED
    assert not kept_files(tmp_path)


def test_another_key_knows_nothing(tmp_path: Path) -> None:
    first = Cache(tmp_path, sources=())
    first.keep(PROVED)
    other = Cache(tmp_path, sources=())
    other.key = "0" * 64
    other._place = tmp_path / other.key
    assert other.recall("a") is None
    # Nor does a file that was carried from one key's folder into the other's.
    other._place.mkdir()
    [file] = kept_files(tmp_path)
    (other._place / file.name).write_bytes(file.read_bytes())
    assert other.recall("a") is None


def change(data: dict[str, Any], path: list[Any], value: Any) -> None:
    for key in path[:-1]:
        data = data[key]
    data[path[-1]] = value


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (["entry", "statement"], "another"),
        (["entry", "checks", 0, "finding"], "another"),
        (["entry", "verdict", "outcome"], "refuted"),
        (["entry", "checks", 0, "rung"], "heard of"),
        (["format"], "another"),
        (["key"], "another"),
        (["sha256"], "another"),
    ],
)
def test_a_changed_file_is_not_read(tmp_path: Path, path: list[Any], value: Any) -> None:
    cache = Cache(tmp_path, sources=())
    cache.keep(PROVED)
    [file] = kept_files(tmp_path)
    data = json.loads(file.read_text())
    change(data, path, value)
    file.write_text(json.dumps(data))
    assert cache.recall("a") is None


@pytest.mark.parametrize("text", ["", "{", "[]", "null", '{"entry": {}}', "[" * 100_000], ids=lambda text: text[:9])
def test_a_file_that_is_none_is_not_read(tmp_path: Path, text: str) -> None:
    cache = Cache(tmp_path, sources=())
    cache.keep(PROVED)
    [file] = kept_files(tmp_path)
    file.write_text(text)
    assert cache.recall("a") is None
    cache.keep(PROVED)
    assert cache.recall("a") is not None


def test_the_file_of_another_entry_is_not_read(tmp_path: Path) -> None:
    cache = Cache(tmp_path, sources=())
    cache.keep(PROVED)
    cache.keep(REFUTED)
    cache._file("b").replace(cache._file("a"))
    assert cache.recall("a") is None


def test_all_of_a_result_is_on_the_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    synced = []
    monkeypatch.setattr("os.fsync", lambda descriptor: synced.append(os.fstat(descriptor).st_size))
    Cache(tmp_path, sources=()).keep(PROVED)
    [kept] = kept_files(tmp_path)
    assert synced == [kept.stat().st_size]


def test_the_verdict_is_drawn_from_the_checks_again(tmp_path: Path) -> None:
    """A file that says "proved" over checks that do not, with a right hash, is not read."""
    cache = Cache(tmp_path, sources=())
    cache.keep(replace(OPEN, verdict=conclude("statement", PROVED.checks)))
    assert len(kept_files(tmp_path)) == 1
    assert cache.recall("c") is None


def test_sources_that_changed_meanwhile_close_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source = tmp_path / "source.py"
    source.write_text("newer than this process")
    cache = Cache(tmp_path / "cache", sources=[source])
    assert "changed" in cache.closed
    cache.keep(PROVED)
    assert cache.recall("a") is None
    assert not (tmp_path / "cache").exists()
    # Also between the first and the second result, where the clock was set back in between.
    later = Cache(tmp_path / "cache", sources=[tmp_path / "none.py"])
    assert later.closed == ""
    later.keep(PROVED)
    (tmp_path / "none.py").write_text("x")
    with monkeypatch.context() as patch:
        patch.setattr(cache_module, "newest_change", lambda _: 0.0)
        later.keep(REFUTED)
    assert "changed" in later.closed
    assert later.recall("a") is None
    assert len(kept_files(tmp_path / "cache")) == 1


def test_a_folder_that_cannot_be_written_loses_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    cache = Cache(tmp_path / "file", sources=())
    cache.keep(PROVED)
    assert "cannot be kept" in cache.closed
    assert cache.recall("a") is None


def test_a_clone_keeps_its_results_in_itself() -> None:
    assert default_folder() == Path(verify.__file__).resolve().parents[2] / "build" / "ledger"


def test_without_a_clone_results_lie_in_the_user_s_caches(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache_module, "PACKAGE", tmp_path / "site-packages" / "gspot_verified")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "caches"))
    assert default_folder() == tmp_path / "caches" / "gspot-verified" / "ledger"
    for unset in (lambda: monkeypatch.setenv("XDG_CACHE_HOME", ""), lambda: monkeypatch.delenv("XDG_CACHE_HOME")):
        unset()
        assert default_folder() == Path.home() / ".cache" / "gspot-verified" / "ledger"


def test_a_change_in_the_moment_of_the_start_closes_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache_module, "process_start", lambda: 5.0)
    for change, said in ((4.5, False), (5.0, True), (5.5, True)):
        monkeypatch.setattr(cache_module, "newest_change", lambda _, change=change: change)
        assert bool(Cache(tmp_path, sources=()).closed) is said


def test_a_draft_that_cannot_be_put_in_its_place_is_removed_and_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cache = Cache(tmp_path, sources=())

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr("os.fsync", full)
        cache.keep(PROVED)
    assert "cannot be kept: [Errno 28]" in cache.closed
    cache.keep(REFUTED)  # it stays closed
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []
    # Whatever stopped it is passed on, also where the draft is gone already.
    draft = Path(tempfile.mkdtemp(dir=tmp_path)) / "result.json"

    def gone(_: int) -> None:
        for path in draft.parent.iterdir():
            path.unlink()
        raise KeyboardInterrupt

    monkeypatch.setattr("os.fsync", gone)
    with pytest.raises(KeyboardInterrupt):
        cache_module._write(draft, "text")


@pytest.fixture
def ledger(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A ledger of three entries, where a names b and b names c; the list says what was run."""
    run: list[str] = []

    def builder(identifier: str, names: str) -> Any:
        def build() -> Entry:
            run.append(identifier)
            return entry(identifier, True, True, names=names)

        return build

    parts = {
        "one": {"a1": builder("a1", "as in b1"), "b1": builder("b1", "as in c1")},
        "two": {"c1": builder("c1", "")},
    }
    monkeypatch.setattr(verify, "PARTS", parts)
    return run


def test_a_second_run_runs_nothing(ledger: list[str], tmp_path: Path) -> None:
    first = verify_paper(cache=Cache(tmp_path, sources=()))
    assert ledger == ["a1", "b1", "c1"]
    assert not any(found.from_cache for found in first)
    second = verify_paper(cache=Cache(tmp_path, sources=()))
    assert ledger == ["a1", "b1", "c1"]
    assert all(found.from_cache for found in second)
    assert [replace(found, from_cache=False) for found in second] == first
    verify_paper(cache=Cache(tmp_path, read=False, sources=()))
    assert ledger == ["a1", "b1", "c1"] * 2


def test_named_entries_and_those_that_their_checks_name(ledger: list[str]) -> None:
    named, further = verify_claims(["b1"])
    assert [found.identifier for found in named] == ["b1"]
    assert [found.identifier for found in further] == ["c1"]
    named, further = verify_claims(["c1", "a1", "c1"])
    assert [found.identifier for found in named] == ["c1", "a1"]
    assert [found.identifier for found in further] == ["b1"]
    ledger.clear()
    assert verify_claims(["a1"], alone=True)[1] == []
    assert ledger == ["a1"]


def test_an_unknown_name_is_told_its_neighbours(ledger: list[str]) -> None:
    with pytest.raises(ValueError, match=r"no entry of the ledger is named 'a2'; nearest: a1"):
        verify_claims(["b1", "a2"])
    with pytest.raises(ValueError, match=r"named 'zzzz'$"):
        verify_claims(["zzzz"])
    assert ledger == []


_KILLED = """
import sys, time
from pathlib import Path
from gspot_verified.paper import verify
from gspot_verified.paper.cache import Cache
from gspot_verified.paper.checks.entry import Check, Rung, Section

def build(name):
    def made():
        if name == "second" and sys.argv[2] == "wait":
            print("waiting", flush=True)
            time.sleep(600)
        checks = [Check(Rung.EXACT, f"check {n}", True) for n in range(2)]
        return Section("Section").settled(name, "line 1", "x", "statement", *checks)
    return made

verify.PARTS = {"part": {name: build(name) for name in ("first", "second")}}
found = verify.verify_paper(cache=Cache(Path(sys.argv[1]), sources=()))
print([(entry.identifier, entry.from_cache, entry.verdict.outcome.value) for entry in found])
"""


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="no SIGKILL on this system")
def test_a_run_that_was_killed_goes_on(tmp_path: Path) -> None:
    command = [sys.executable, "-c", _KILLED, str(tmp_path)]
    with subprocess.Popen([*command, "wait"], stdout=subprocess.PIPE, text=True) as killed:
        assert killed.stdout is not None
        assert killed.stdout.readline() == "waiting\n"
        killed.kill()
    again = subprocess.run([*command, "go"], capture_output=True, text=True, check=True)
    assert again.stdout.strip() == "[('first', True, 'proved'), ('second', False, 'proved')]"


def test_a_real_entry_is_the_same_from_the_cache(tmp_path: Path) -> None:
    cache = Cache(tmp_path, sources=())
    named, further = verify_claims(["S-iwc"], cache=cache, alone=True)
    again, _ = verify_claims(["S-iwc"], cache=cache, alone=True)
    assert further == []
    assert [replace(found, from_cache=False) for found in again] == named
    assert again[0].from_cache


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
