"""The typer application and what all commands share: results go to stdout, progress to stderr."""

from __future__ import annotations

import json
import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from importlib import resources
from typing import Annotated, Any

import typer
from typer.core import TyperCommand

QUIET_SECONDS = 10.0
_running: ContextVar[str] = ContextVar("_running", default="")
_NUMBER = re.compile(r"-\.?[0-9].*")


def _print_version(wanted: bool) -> None:
    if wanted:
        from gspot_verified import __version__

        typer.echo(f"gspot-verified {__version__}")
        raise typer.Exit


app = typer.Typer(
    no_args_is_help=True,
    rich_markup_mode=None,
    help="Certified values and signs of Θ(τ, β), and the paper claim by claim. "
    "Exit codes: 0 proved, 1 refuted, 2 undecided, 64 usage, 70 internal error, 74 a file could not be written.",
)


@app.callback()
def _options(
    context: typer.Context,
    version: Annotated[  # noqa: ARG001  its callback acts
        bool, typer.Option("--version", help="Print the version and leave.", is_eager=True, callback=_print_version)
    ] = False,
) -> None:
    _running.set(context.invoked_subcommand or "")


JsonFlag = Annotated[bool, typer.Option("--json", help="Print JSON.")]


class NumberArguments(TyperCommand):
    """A command whose arguments may be negative numbers, with options before or after them, with or without ``--``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Move the numbers behind one ``--``; an option's value stays with its option."""
        takes_value = {name for p in self.params if getattr(p, "is_flag", None) is False for name in p.opts}
        options, numbers = [], []
        waiting = iter(args)
        for word in waiting:
            if word in takes_value:
                options += [word, *[value for value in [next(waiting, None)] if value is not None]]
            elif word.startswith("-") and word != "--" and not _NUMBER.fullmatch(word):
                options.append(word)
            elif word != "--":
                numbers.append(word)
        return super().parse_args(ctx, [*options, "--", *numbers])


def schema_of(command: str) -> dict[str, Any]:
    """The schema (JSON Schema, draft 2020-12) of the command's ``--json``."""
    text = resources.files("gspot_verified.cli").joinpath("schemas", f"{command}.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text)
    return found


def print_json(data: dict[str, Any], schema: str | None = None) -> None:
    """Data on stdout, with the name of the schema in ``cli/schemas`` that it satisfies: the running command's own."""
    name = schema_of(schema or _running.get())["$id"]
    typer.echo(json.dumps({**data, "schema": name}, ensure_ascii=False, indent=2, sort_keys=True))


def warn(text: str) -> None:
    """What the reader of a result must know, on stderr."""
    typer.echo(f"warning: {text}", err=True)


@contextmanager
def signs_of_life(seconds: float = QUIET_SECONDS) -> Iterator[None]:
    """Say on stderr, every so many seconds, that the work goes on: no command is silent for minutes."""
    done = threading.Event()
    start = time.monotonic()

    def say() -> None:
        while not done.wait(seconds):
            progress(f"at work for {time.monotonic() - start:.0f} s")

    thread = threading.Thread(target=say, daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


def progress(step: str) -> None:
    """A step of long work, on stderr."""
    typer.echo(f"... {step}", err=True)
