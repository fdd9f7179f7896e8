"""What a word of the command line becomes: the same with typer's adapters and without them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import pytest
import typer

from gspot_verified.cli.app import app
from gspot_verified.cli.main import load_commands
from gspot_verified.cli.parameters import read_when_needed


def answer(words: list[str], *, light: bool) -> Any:
    """What the command was given, or the message of its error."""
    application = typer.Typer()
    seen: list[Any] = []

    @application.command()
    def command(
        number: Annotated[int, typer.Option()] = 15,
        limited: Annotated[int, typer.Option(min=1, max=9)] = 3,
        text: Annotated[str | None, typer.Option()] = None,
        place: Annotated[Path | None, typer.Option()] = None,
        there: Annotated[Path | None, typer.Option(exists=True)] = None,
        several: Annotated[list[str] | None, typer.Option()] = None,
        flag: Annotated[bool, typer.Option("--flag")] = False,
    ) -> None:
        seen.append((number, limited, text, place, there, several, flag))

    made = typer.main.get_command(application)
    if light:
        made = read_when_needed(made)
    try:
        made(args=words, prog_name="command", standalone_mode=False)
    except Exception as error:
        return type(error).__name__, str(error)
    return seen


@pytest.mark.parametrize(
    "words",
    [
        "", "--number 20", "--number -7", "--number 007", "--number 1_000", "--number 5.0", "--number x",
        "--number 5.5", f"--number {'9' * 25}", "--limited 9", "--limited 10", "--text 12", "--text=", "--flag",
        "--several a --several b", "--place .", "--place nowhere/at/all", f"--place {__file__}",
        "--there nowhere/at/all", f"--there {__file__}",
        "--unknown", "--number",
    ],
)  # fmt: skip
def test_words_mean_the_same(words: str) -> None:
    assert answer(words.split(), light=True) == answer(words.split(), light=False)


def test_a_path_that_cannot_be_read(tmp_path: Path) -> None:
    closed = tmp_path / "closed"
    closed.write_text("")
    closed.chmod(0)
    words = ["--place", str(closed)]
    assert answer(words, light=True) == answer(words, light=False)


def test_epsilon_is_one_option_everywhere() -> None:
    """``--epsilon``, and ``--eps`` as its short form."""
    load_commands()
    options = {
        (name, parameter.name): parameter.opts
        for name, command in typer.main.get_group(app).commands.items()
        for parameter in command.params
        if {"--eps", "--epsilon"} & {*parameter.opts}
    }
    assert {name for name, _ in options} >= {"iwc", "side", "zeros", "force", "events", "simulate", "plot"}
    assert set(map(tuple, options.values())) == {("--epsilon", "--eps")}
    assert {parameter for _, parameter in options} == {"epsilon"}
