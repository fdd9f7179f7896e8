"""The typer application and what all commands share: results go to stdout, progress to stderr."""

from __future__ import annotations

import json
import re
import threading
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand

from gspot_verified.cli.command_groups import WIDEST, CommandGroups
from gspot_verified.cli.progress_line import at_terminal

QUIET_SECONDS = 10.0  # between two signs of life on stderr
_running: ContextVar[str] = ContextVar("_running", default="")
_VERSIONS = {
    "approach": 3,
    "classify": 3,
    "cost": 2,
    "events": 3,
    "iwc": 2,
    "report": 3,
    "scenes": 2,
    "side": 2,
    "simulate": 3,
    "simulators": 2,
    "theta": 2,
    "verdict": 2,
    "verify": 3,
}
"""Of the schemas that have changed: a change of what is printed raises it."""
_NUMBER = re.compile(r"-(\.?[0-9].*|inf(inity)?|nan|[ij])", re.IGNORECASE)
"""What is read as a number and no option; -inf is then refused as a number, with what is allowed."""

_COUNT = re.compile(r"\b([0-9]+) of ([0-9]+) [a-z]")
_TIME = re.compile(r"\bt = (\S+) of (\S+) after (one|[0-9]+) step")
"""How far a run is, and how many steps it has made; what is left may need shorter ones, so the time left is rough."""


def _print_version(wanted: bool) -> None:
    if wanted:
        from gspot_verified import __version__

        typer.echo(f"gspot-verified {__version__}")
        raise typer.Exit


def _print_schema(command: str | None) -> None:
    if command is not None:
        from gspot_verified.cli.schema import schema_of

        _echo_json(schema_of(command, schema_name(command)))
        raise typer.Exit


app = typer.Typer(
    cls=CommandGroups,
    context_settings={"max_content_width": WIDEST},
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
    schema: Annotated[  # noqa: ARG001  its callback acts
        str | None,
        typer.Option(
            metavar="COMMAND",
            help="Print the schema of a command's --json and leave.",
            is_eager=True,
            callback=_print_schema,
        ),
    ] = None,
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


def schema_name(command: str) -> str:
    """The name of the schema of the command's ``--json``, with its version; ``--schema`` prints it."""
    return f"gspot-verified/{command}/{_VERSIONS.get(command, 1)}"


def print_json(data: dict[str, Any], command: str | None = None) -> None:
    """Data on stdout, with the name of the schema that it satisfies: the running command's own."""
    _echo_json({**data, "schema": schema_name(command or _running.get())})


def show(result: Any, as_json: bool, text: str | None = None) -> None:
    """A result on stdout: as JSON, or as its own text where no other is given."""
    if as_json:
        print_json(result.to_json())
    else:
        typer.echo(str(result) if text is None else text)


def print_json_with_rows(data: dict[str, Any], key: str, rows: Iterable[str]) -> None:
    """The same with a list at the end, some of whose entries are in each of the texts: :func:`rows_text` makes them."""
    whole = {**data, "schema": schema_name(_running.get())}
    typer.echo(json.dumps(whole, ensure_ascii=False, indent=2, sort_keys=True).removesuffix("\n}"), nl=False)
    typer.echo(f',\n  "{key}": [', nl=False)
    for number, text in enumerate(rows):
        typer.echo(f"{',' if number else ''}\n{text}", nl=False)
    typer.echo("\n  ]\n}")


def _echo_json(data: dict[str, Any]) -> None:
    typer.echo(json.dumps(data, ensure_ascii=False, indent=2, sort_keys=True))


def refuse(why: str, options: Mapping[str, object]) -> None:
    """Leave no option aside in silence.

    :raises ValueError: some of them were given; the message names them.

    >>> refuse("for ranges", {"--journal": None, "--budget": 0})
    Traceback (most recent call last):
    ...
    ValueError: --budget: for ranges
    """
    given = [name for name, value in options.items() if not (value is None or value is False or value == [])]
    if given:
        raise ValueError(f"{', '.join(given)}: {why}")


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
            line = at_terminal()
            if line is None or not line.refresh():
                progress(f"at work for {time.monotonic() - start:.0f} s")

    thread = threading.Thread(target=say, daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


def progress(step: str) -> None:
    """A step of long work, on stderr; at a terminal one that says "3 of 40 cells" is counted, and so is one that says
    "t = 0.1 of 0.5 after 7 steps"."""
    line, numbers, times = at_terminal(), _COUNT.search(step), _TIME.search(step)
    if line is not None and numbers is not None and int(numbers[2]) > 0:
        line.count(step, int(numbers[1]), int(numbers[1]) / int(numbers[2]))
        return
    if line is not None and times is not None and float(times[2]) > 0:
        line.count(step, 1 if times[3] == "one" else int(times[3]), min(float(times[1]) / float(times[2]), 1.0))
        return
    if line is not None:
        line.end()
    typer.echo(f"... {step}", err=True)


def counted(step: str, done: int, share: float, said: bool) -> None:
    """A step of counted work: at a terminal in a line with percentage, rate and time left; elsewhere, if it is one of
    those to be ``said``, as any other step."""
    line = at_terminal()
    if line is not None:
        line.count(step, done, share)
    elif said:
        progress(step)


Workers = Annotated[int, typer.Option(help="Processes that share the work; the result is the same for any number.")]
Scheduler = Annotated[str | None, typer.Option(help="Address of a Dask scheduler, in place of processes here.")]
JournalFile = Annotated[Path | None, typer.Option("--journal", help="Keep finished work here; go on from it.")]
TableOutput = Annotated[
    Path | None, typer.Option("--output", help="With --table: the file for its answers, CSV or FILE.parquet.")
]
