"""The help: every command once, in a group; no sentence cut at 80 columns; examples whole, to copy."""

from __future__ import annotations

import re
import shlex
from typing import Any

import pytest
import typer

from gspot_verified.cli import main
from gspot_verified.cli.app import app
from gspot_verified.cli.command_groups import GROUPS
from gspot_verified.cli.main import COMMANDS, load_commands, name_of


def help_of(capsys: pytest.CaptureFixture[str], *words: str) -> list[str]:
    assert main([*words, "--help"]) == 0
    return capsys.readouterr().out.splitlines()


@pytest.fixture
def narrow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


def table(lines: list[str]) -> dict[str, list[str]]:
    """Title and names of each group."""
    groups: dict[str, list[str]] = {}
    title = ""
    for line in lines:
        if re.fullmatch(r"\S.*:", line):
            title = line[:-1]
        elif (found := re.match(r"  ([a-z-]+)  +\S", line)) and title not in ("Options", ""):
            groups.setdefault(title, []).append(found[1])
    return groups


@pytest.mark.usefixtures("narrow")
def test_every_command_is_in_one_group(capsys: pytest.CaptureFixture[str]) -> None:
    load_commands()
    groups = table(help_of(capsys))
    assert groups == {title: list(members) for title, members in GROUPS.items()}
    listed = [name for names in groups.values() for name in names]
    assert listed == [name_of(info.callback) for info in app.registered_commands] == list(COMMANDS)
    assert len(set(listed)) == len(listed)


@pytest.mark.usefixtures("narrow")
@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_nothing_is_cut_at_80_columns(capsys: pytest.CaptureFixture[str], command: str) -> None:
    lines = help_of(capsys, *([command] if command else []))
    assert [line for line in lines if line.endswith(("...", "…")) and not line.startswith("Usage: ")] == []
    assert [line for line in lines if len(line) > 80] == []


@pytest.mark.usefixtures("narrow")
def test_a_command_has_one_line_in_the_table(capsys: pytest.CaptureFixture[str]) -> None:
    lines = help_of(capsys)
    for name in COMMANDS:
        [line] = [line for line in lines if re.match(rf"  {name} ", line)]
        assert line.endswith(".")
        assert lines[lines.index(line) + 1] == "" or lines[lines.index(line) + 1].split()[0] in COMMANDS


@pytest.mark.usefixtures("narrow")
@pytest.mark.parametrize("command", COMMANDS)
def test_the_example_is_one_line_that_is_understood(capsys: pytest.CaptureFixture[str], command: str) -> None:
    """It is parsed by the command, not run: the work of some takes minutes."""
    lines = help_of(capsys, command)
    line = lines[lines.index("  Example:") + 1]
    assert lines[-1] == line
    program, name, *words = shlex.split(line)
    assert (program, name) == ("gspot-verified", command)
    group: Any = typer.main.get_command(app)
    parsed = group.commands[command].make_context(command, words)
    assert parsed.args == []


def test_a_wide_terminal_is_used(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    for columns, least, most in (("200", 101, 110), ("100", 81, 100)):
        monkeypatch.setenv("COLUMNS", columns)
        widest = max(map(len, help_of(capsys, "simulate")))
        assert least <= widest <= most


def test_help_before_a_command_lists_all_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help", "theta"]) == 0
    groups = table(capsys.readouterr().out.splitlines())
    assert [name for names in groups.values() for name in names] == list(COMMANDS)
