"""The checker as a program: its words, what breaks it, its workers.

Page: proofs/check.md.
"""

from __future__ import annotations

import ast
import importlib.machinery
import importlib.util
import io
import multiprocessing
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from must_reject import mutate
from must_reject.mutate import GOOD, text_of
from samples.checker_models import (
    STATEMENTS,
)

check = mutate.checker()

FAILURES = [
    IndexError, KeyError, RecursionError, ZeroDivisionError, OverflowError, MemoryError, AssertionError, RuntimeError,
    AttributeError, TypeError, UnicodeError, OSError, NotImplementedError,
]  # fmt: skip


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch) -> Callable[[type[Exception] | None], bytes]:
    """A certificate that is read with pieces that break whoever looks at them."""
    read = check.pieces.read_certificate

    def with_pieces(failure: type[Exception] | None) -> bytes:
        def broken_certificate(data: bytes, limits: check.limits.Limits) -> tuple[int, Any, list[check.pieces.Column]]:
            version, statement, columns = read(data, limits)
            pieces = mutate.BreakingPieces(failure)
            return version, statement, [column._replace(pieces=pieces) for column in columns]

        monkeypatch.setattr(check.main, "read_certificate", broken_certificate)
        return text_of(GOOD["right"])

    return with_pieces


@pytest.mark.parametrize(
    ("failure", "workers"), [*((failure, "1") for failure in FAILURES), (IndexError, "2"), (MemoryError, "2")]
)
def test_whatever_breaks_is_no_proof(
    failure: type[Exception],
    workers: str,
    broken: Callable[[type[Exception] | None], bytes],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One line that says so, and not the status of a certificate that is verified."""
    good = tmp_path / "good"
    good.write_bytes(broken(failure))
    assert check.main.main([str(good), "--workers", workers]) == 1
    written = capsys.readouterr()
    assert (written.out, written.err) == ("", f"REJECTED the check failed with {failure.__name__}\n")


def test_a_worker_that_is_killed_is_no_proof(broken: Callable[[type[Exception] | None], bytes]) -> None:
    with pytest.raises(check.limits.Rejected, match="the check failed with BrokenProcessPool"):
        check.main.check_text(broken(None), workers=2)


@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
def test_workers_begin_afresh_whatever_the_start_method_is(method: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """They know nothing of what was changed here, on each system and version of Python."""

    def breaks(*_: object) -> None:
        raise AssertionError

    monkeypatch.setattr(check.theta.Theta, "value", breaks)
    before = multiprocessing.get_start_method(allow_none=True)
    multiprocessing.set_start_method(method, force=True)
    try:
        assert check.main.check_text(text_of(GOOD["right"]), workers=2) == STATEMENTS["right"]
    finally:
        multiprocessing.set_start_method(before, force=True)


def test_a_file_too_large_for_the_memory_is_no_proof(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["right"]))

    def breaks(*_: object) -> bytes:
        raise MemoryError

    monkeypatch.setattr(check.main, "read_file", breaks)
    assert check.main.main([str(good)]) == 64
    assert capsys.readouterr().err.startswith("usage")


def run(*arguments: str, encoding: str = "utf-8") -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", "-S", str(mutate.CHECKER), *arguments]
    environment = {"PYTHONIOENCODING": encoding} if encoding else {}
    options = [] if encoding else ["-X", "utf8"]
    command[1:1] = options
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False, env=environment)


def test_the_program_takes_the_words_after_its_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["integer"]))
    monkeypatch.setattr(sys, "argv", ["checker", str(good)])
    loader = importlib.machinery.SourceFileLoader("__main__", str(mutate.CHECKER / "__main__.py"))
    spec = importlib.util.spec_from_loader("__main__", loader)
    assert spec is not None
    with pytest.raises(SystemExit) as ended:
        loader.exec_module(importlib.util.module_from_spec(spec))
    assert (ended.value.code, capsys.readouterr().out) == (0, f"VERIFIED {STATEMENTS['integer']}\n")


def test_command_line(tmp_path: Path) -> None:
    good, bad = tmp_path / "good", tmp_path / "bad"
    good.write_bytes(text_of(GOOD["iwc by theorem"]))
    bad.write_bytes(text_of(GOOD["iwc by theorem"])[:-1])
    result = run(str(good))
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.splitlines()[0].startswith("VERIFIED d")
    columns = tmp_path / "columns"
    columns.write_bytes(text_of(GOOD["iwc"]))
    result = run(str(columns), "--workers", "2")
    assert (result.returncode, result.stdout, result.stderr) == (0, f"VERIFIED {STATEMENTS['iwc']}\n", "")
    result = run(str(bad))
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr == "REJECTED the last line is not sha256 and a hash\n"
    for arguments in [(), (str(tmp_path / "none"),), (str(tmp_path),), (str(good), str(good))]:
        result = run(*arguments)
        assert (result.returncode, result.stdout) == (64, "")
        assert result.stderr.startswith("usage")


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        (["--limit", "work"], "--limit needs a positive integer"),
        (["--limit", "work=0"], "--limit needs a positive integer"),
        (["--limit=work=-1"], "--limit needs a positive integer"),
        (["--limit", "speed=3"], "the limits are bytes, line,"),
        (["--limit", "3"], "the limits are bytes, line,"),
        (["--workers", "0"], "--workers needs a positive integer"),
        (["--workers", "work=2"], "the limits are bytes, line,"),
        (["--workers"], "--workers needs a positive integer"),
        (["--limit", "work"], "as NAME=NUMBER, not 'work'; the limits are bytes, line,"),
        (["--workers", "two"], "--workers needs a positive integer, not 'two'"),
        (["--help"], "the exit status is 0 for VERIFIED alone, 1 for REJECTED, else 64; the limits are bytes, line,"),
        (["--speed"], "there is no option --speed (a file of this name is ./--speed)"),
    ],
)
def test_options_that_are_none(
    options: list[str], reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["iwc by theorem"]))
    assert check.main.main([str(good), *options]) == 64
    written = capsys.readouterr()
    assert written.out == ""
    assert written.err.startswith("usage: python checker")
    assert reason in written.err


def test_options(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A limit that is met is named with the option that raises it; workers do not change the answer."""
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["right"]))
    assert check.main.main([str(good), "--limit", "tau=3"]) == 1
    assert "the limit tau=3 (raise it on purpose: --limit tau=NUMBER)" in capsys.readouterr().err
    lines = set()
    for workers in ("1", "2"):
        assert check.main.main(["--limit=tau=4", "--workers", workers, "--limit", "beta=2", str(good)]) == 0
        lines.add(capsys.readouterr().out)
    assert lines == {f"VERIFIED {STATEMENTS['right']}\n"}


def test_one_process_unless_more_are_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    good, asked = tmp_path / "good", []
    good.write_bytes(text_of(GOOD["right"]))
    monkeypatch.setattr(check.main, "check_text", lambda _data, _limits, workers: asked.append(workers) or "it")
    assert [check.main.main([str(good), *words]) for words in ([], ["--workers=3"])] == [0, 0]
    assert asked == [1, 3]


def test_only_a_regular_file_of_bounded_length_is_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pipe, long = tmp_path / "pipe", tmp_path / "long"
    os.mkfifo(pipe)
    for name in (pipe, tmp_path, "/dev/zero"):
        assert check.main.main([str(name)]) == 64
        assert capsys.readouterr().err.startswith("usage")
    with long.open("wb") as file:
        file.truncate(10**12)  # with no block on the disk
    assert check.main.main([str(long)]) == 1
    assert "the limit bytes=20000000" in capsys.readouterr().err


def test_workers_find_the_same_fault() -> None:
    lines = mutate.copy.deepcopy(GOOD["iwc"])
    lines[1]["pieces"][1][3] = lines[2]["pieces"][1][3] = -1
    found = set()
    for workers in (1, 2):
        with pytest.raises(check.limits.Rejected) as caught:
            check.main.check_text(text_of(lines), workers=workers)
        found.add(str(caught.value))
    assert len(found) == 1
    assert "of the column from β = 0: the sign is 1, not -1" in found.pop()


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_output_in_any_encoding(encoding: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file, raw = tmp_path / "good", io.BytesIO()
    file.write_bytes(text_of(GOOD["zero"]))
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, encoding=encoding))
    assert check.main.main([str(file)]) == 0
    sys.stdout.flush()
    assert raw.getvalue().startswith(b"VERIFIED d")
    assert raw.getvalue().count(b"\n") == 1


def sources() -> dict[str, ast.Module]:
    """The files of the checker in the order in which they are read, as trees."""
    names = [*mutate.PARTS, "__main__"]
    assert {path.stem for path in mutate.CHECKER.glob("*.py")} == set(names)
    return {name: ast.parse((mutate.CHECKER / f"{name}.py").read_text(encoding="utf-8")) for name in names}


def test_size_and_imports() -> None:
    """At most 600 lines a file; the standard library, and the files before it, only."""
    before: set[str] = set()
    for name, tree in sources().items():
        assert len((mutate.CHECKER / f"{name}.py").read_text(encoding="utf-8").splitlines()) <= 600
        names = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
        names |= {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        assert {one.split(".")[0] for one in names} <= sys.stdlib_module_names | before
        assert not any(isinstance(node, ast.Assert) for node in ast.walk(tree))
        before.add(name)
    assert not before & sys.stdlib_module_names - {"__main__"}, "a file would take the place of one of Python's"


def test_work_is_paid_in_the_arithmetic_alone() -> None:
    """Each call that takes from the budget stands in an operation on integers or on models, none in a formula."""
    paying = set()
    for tree in sources().values():
        for function in (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)):
            calls = [node.func for node in ast.walk(function) if isinstance(node, ast.Call)]
            if any(isinstance(call, ast.Attribute) and call.attr == "spend" for call in calls):
                paying.add(function.name)
    of_theta = {"product", "dot", "combined", "weighted", "rounded_powers"}
    assert paying == of_theta | {
        "interval", "reciprocal", "sine_cosine", "term", "on", "inverse", "length", "apply_up",
        "multiple", "convolution", "put_in", "paid", "common_denominator",
    }  # fmt: skip


def test_the_page_names_functions_that_are_there() -> None:
    """Before its section on Coq: functions, files, limits, kinds of pieces, parts of a value."""
    text = (mutate.CHECKER.parent / "check.md").read_text(encoding="utf-8").partition("## 7.")[0]
    named = set(re.findall(r"`([a-z]\w*)(?:\.py)?`", re.sub(r"(?s)Formal proof.*?\n\n", "", text)))
    trees = sources()
    kinds = ast.FunctionDef | ast.ClassDef
    known = {node.name for tree in trees.values() for node in ast.walk(tree) if isinstance(node, kinds)}
    known |= {*trees, *check.limits.Limits._fields, *check.pieces.POINTS, *check.theta.Value._fields}
    assert named - known == set()
    assert {"combined", "weighted", "recurrence", "settle", "compared"} <= named
