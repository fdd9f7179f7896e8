"""The examples of a page: Python sessions, commands with what they print, and files that a reader writes."""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from gspot_verified.cli import main

FENCE = re.compile(r"^(?P<fence>`{3,})(?P<kind>[^\n]*)\n(?P<body>.*?)^(?P=fence)[ \t]*$", re.MULTILINE | re.DOTALL)
OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
PROMPT = "$ "
PREPARATIONS = ("pip install ", "pip wheel ", "python -m venv ", ". .venv/bin/activate")
"""Of an environment: the tests have theirs."""


@dataclass(frozen=True)
class Block:
    """One fenced block: its language, its options, its lines."""

    kind: str
    options: dict[str, str]
    body: str
    line: int


def blocks(text: str) -> Iterator[Block]:
    """All fenced blocks of a page."""
    for match in FENCE.finditer(text):
        kind, body = match["kind"].strip().removeprefix("{code-block}").strip(), match["body"]
        options = (
            dict(re.findall(r"^:(\w+):[ \t]*(.*)$", body, re.MULTILINE)) if "{code-block}" in match["kind"] else {}
        )
        if options:
            body = re.sub(r"\A(:\w+:.*\n)+\n?", "", body)
        yield Block(kind, options, body, text[: match.start()].count("\n") + 1)


def run_page(page: Path, folder: Path) -> int:
    """Run every example of the page in ``folder``, in order; returns how many there were.

    :raises AssertionError: one prints or returns something else.
    """
    names: dict[str, object] = {}
    examples = 0
    for block in blocks(page.read_text(encoding="utf-8")):
        where = f"{page.name}:{block.line}"
        if block.kind in ("toml", "python") and "caption" in block.options:
            write_file(folder / block.options["caption"], block)
        elif block.kind in ("pycon", "python") and ">>>" in block.body:
            examples += run_session(block.body, names, where)
        elif block.kind == "console" and PROMPT in block.body:
            examples += run_commands(block.body, where, folder)
    return examples


def write_file(place: Path, block: Block) -> None:
    """The file of the block; a block that begins with a table replaces that table of the file that is there."""
    header = block.body.split("\n", 1)[0]
    if not header.startswith("["):
        place.write_text(block.body, encoding="utf-8")
        return
    text = place.read_text(encoding="utf-8")
    table = re.compile(rf"^{re.escape(header)}\n.*?(?=^\[|\Z)", re.MULTILINE | re.DOTALL)
    assert len(table.findall(text)) == 1, f"{place.name}: {header} is not there once"
    place.write_text(table.sub(lambda _: block.body + "\n", text), encoding="utf-8")


def run_session(body: str, names: dict[str, object], where: str) -> int:
    """A Python session; names live on to the next block of the page."""
    test = doctest.DocTestParser().get_doctest(body, names, where, where, 0)
    runner = doctest.DocTestRunner(optionflags=OPTIONS)
    report = io.StringIO()
    runner.run(test, out=report.write, clear_globs=False)
    names.update(test.globs)
    assert runner.failures == 0, report.getvalue()
    return len(test.examples)


def run_commands(body: str, where: str, folder: Path) -> int:
    """Commands after ``$``, each with what it prints; ``[exit code N]`` where it is not 0."""
    parts = re.split(r"^\$ ", body, flags=re.MULTILINE)[1:]
    for part in parts:
        command, _, expected = part.partition("\n")
        words = shlex.split(command)
        if words[0] not in ("gspot-verified", "pytest"):
            assert command.startswith(PREPARATIONS), f"{where}: {command}: only gspot-verified and pytest are run"
            continue
        found, code = run_command(words[1:]) if words[0] == "gspot-verified" else run_pytest(words[1:], folder)
        stated = re.search(r"^\[exit code (\d+)\]\n?\Z", expected, re.MULTILINE)
        assert code == (int(stated[1]) if stated else 0), f"{where}: {command} ended with {code}: {found}"
        wanted = expected[: stated.start()] if stated else expected
        assert matches(wanted, found), f"{where}: {command}\nprinted:\n{found}\nexpected:\n{wanted}"
    return len(parts)


def run_command(arguments: list[str]) -> tuple[str, int]:
    """What the command prints on both streams (progress left out), and its exit code."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        code = main(arguments)
    lines = [line for line in printed.getvalue().splitlines() if not line.startswith("... ")]
    return "\n".join(lines) + "\n", code


def run_pytest(arguments: list[str], folder: Path) -> tuple[str, int]:
    """What pytest prints about the files of the reader, and its exit code; settings of these tests do not reach it."""
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *arguments]
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    run = subprocess.run(command, cwd=folder, env=inherited, capture_output=True, text=True, check=False)
    return run.stdout + run.stderr, run.returncode


def matches(wanted: str, found: str) -> bool:
    """Whether they agree, ``...`` standing for anything; a page that shows no output claims none."""
    return not wanted.strip() or doctest.OutputChecker().check_output(wanted, found, OPTIONS)
