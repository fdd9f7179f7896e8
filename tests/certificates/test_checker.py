"""Tests of what proofs/certificate.md states."""

from __future__ import annotations

import importlib.util
import os
import py_compile
import re
import shutil
from pathlib import Path

import pytest
from must_reject.mutate import GOOD, text_of

from gspot_verified.certificates import checker
from gspot_verified.certificates.checker import CheckResult, check, checker_path
from gspot_verified.certificates.text import certificate_text, write_certificate
from gspot_verified.signs.cover.sign import sign


@pytest.fixture
def good(tmp_path: Path) -> Path:
    result = sign("-inf..inf", "0..1")
    path = tmp_path / "-good.cert"
    write_certificate(path, result.statement, result.columns)
    return path


def test_a_good_certificate(good: Path) -> None:
    found = check(good)
    assert found.verified
    assert found.text.startswith("VERIFIED ")
    assert found.to_json() == {"verified": True, "text": found.text}


def test_one_changed_byte(good: Path) -> None:
    data = good.read_bytes()
    for place in (5, len(data) // 2, len(data) - 3):
        good.write_bytes(data[:place] + bytes([data[place] ^ 1]) + data[place + 1 :])
        found = check(good)
        assert not found.verified
        assert found.text.startswith("REJECTED ")


@pytest.mark.parametrize("drop", [0, 1, -1])
def test_pieces_that_are_missing(good: Path, drop: int) -> None:
    from dataclasses import replace

    result = sign("-inf..inf", "0..1")
    column, *others = result.columns
    pieces = [piece for piece in column.pieces if piece is not column.pieces[drop]]
    good.write_text(certificate_text(result.statement, [replace(column, pieces=tuple(pieces)), *others]))
    assert not check(good).verified


def test_another_statement(good: Path) -> None:
    from dataclasses import replace

    result = sign("-inf..inf", "0..1")
    good.write_text(certificate_text(replace(result.statement, sign=1), result.columns))
    assert not check(good).verified


def test_no_file(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="there is no file"):
        check(tmp_path / "nothing")
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", tmp_path):
        with pytest.raises(ValueError, match="is not a regular file"):
            check(path)


def test_limits_and_workers(good: Path) -> None:
    assert check(good, workers=2, limits=["work=20", "tau=2"]).verified
    found = check(good, limits=["tau=1"])
    assert not found.verified
    assert "the limit tau=1 (raise it on purpose: --limit tau=NUMBER)" in found.text
    with pytest.raises(
        ValueError, match=r"^--limit needs a positive integer, as NAME=NUMBER, not 'a: b'; the limits are"
    ):
        check(good, limits=["a: b"])
    with pytest.raises(ValueError, match="the limits are bytes, line"):
        check(good, limits=["time=1"])
    with pytest.raises(ValueError, match="--workers needs a positive integer"):
        check(good, workers=0)


def test_a_name_that_looks_like_an_option(good: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(good.parent)
    good.rename("--limit")
    assert check(Path("--limit")).verified


@pytest.mark.parametrize(
    ("script", "verified"),
    [
        ("print('VERIFIED it')", True),
        ("import sys; print('REJECTED it', file=sys.stderr); sys.exit(1)", False),
        ("raise RuntimeError", None),  # also code 1
        ("print('verified')", None),
        ("import sys; print('VERIFIED it'); sys.exit(3)", None),
        ("import sys; print('VERIFIED it'); sys.exit(1)", None),
        ("import sys; print('REJECTED it', file=sys.stderr)", None),
        ("import sys; print('REJECTED it', file=sys.stderr); sys.exit(2)", None),
        ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", None),
        ("import gspot_verified", None),
        ("", None),
    ],
)
def test_only_its_line_and_code_count(
    good: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, verified: bool | None
) -> None:
    path = tmp_path / "checker.py"
    path.write_text(script)
    monkeypatch.setattr(checker, "checker_path", lambda: path)
    if verified is None:
        with pytest.raises(ValueError, match="the checker stopped with code"):
            check(good)
    else:
        assert check(good) == CheckResult(verified, f"{'VERIFIED' if verified else 'REJECTED'} it")


USAGE_LINE = "import sys; print('usage: checker CERTIFICATE: a wrong option', file=sys.stderr); sys.exit({})"


@pytest.mark.parametrize(
    ("script", "message"),
    [
        (USAGE_LINE.format(64), "a wrong option"),
        (USAGE_LINE.format(1), "the checker stopped with code 1: usage: checker CERTIFICATE: a wrong option"),
        ("import sys; print('odd: it', file=sys.stderr); sys.exit(64)", "the checker stopped with code 64: odd: it"),
    ],
)
def test_a_usage_error_is_its_line_and_its_code(
    good: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, message: str
) -> None:
    path = tmp_path / "checker.py"
    path.write_text(script)
    monkeypatch.setattr(checker, "checker_path", lambda: path)
    with pytest.raises(ValueError, match=re.escape(message)) as raised:
        check(good)
    assert str(raised.value) == message


def test_one_process_unless_more_are_asked_for(good: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "checker.py"
    path.write_text("import sys; print('VERIFIED', *sys.argv[1:-1])")
    monkeypatch.setattr(checker, "checker_path", lambda: path)
    assert check(good).text == "VERIFIED --workers=1"
    assert check(good, 3, ["tau=2"]).text == "VERIFIED --workers=3 --limit=tau=2"


def test_where_the_checker_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert checker_path().name == "checker"
    monkeypatch.setattr(checker, "_ROOT", tmp_path)
    monkeypatch.setattr(checker.sys, "prefix", str(tmp_path))
    with pytest.raises(ValueError, match="was not found"):
        checker_path()
    installed = tmp_path / "share" / "gspot_verified" / "checker"
    installed.mkdir(parents=True)
    with pytest.raises(ValueError, match="was not found"):
        checker_path()
    (installed / "__main__.py").write_text("")
    assert checker_path() == installed


@pytest.mark.parametrize(("workers", "part"), [(1, "__main__"), (1, "pieces"), (2, "theta")])
def test_a_compiled_file_beside_the_checker_is_not_believed(
    workers: int, part: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor is one written: what runs is the text."""
    folder, other = tmp_path / "checker", tmp_path / "other.py"
    shutil.copytree(checker_path(), folder, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(checker, "checker_path", lambda: folder)
    other.write_text("raise SystemExit('believed')\n", encoding="utf-8")
    place = Path(importlib.util.cache_from_source(str(folder / f"{part}.py")))
    mode = py_compile.PycInvalidationMode.UNCHECKED_HASH
    py_compile.compile(str(other), cfile=str(place), doraise=True, invalidation_mode=mode)
    certificate = tmp_path / "iwc.cert"
    certificate.write_bytes(text_of(GOOD["iwc"]))
    assert check(certificate, workers).verified
    assert list(place.parent.iterdir()) == [place]
