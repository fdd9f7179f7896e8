"""Entry points of ``gspot-verified``.

Exit codes: 0 proved (or done), 1 refuted, 2 undecided, 64 wrong usage, 70 an internal error, 74 the result stands but
a file (or stdout) could not be written, 130 interrupted. A reader that closes the pipe ends the program by SIGPIPE.
"""

from __future__ import annotations

import errno
import io
import os
import signal
import sys
from collections.abc import Callable, Sequence
from importlib import import_module

import typer

from gspot_verified.cli.app import app, signs_of_life
from gspot_verified.cli.command_groups import GROUPS
from gspot_verified.cli.isolation import isolate
from gspot_verified.cli.output import NOT_WRITTEN
from gspot_verified.cli.plain_values import take_plain_values
from gspot_verified.cli.progress_line import line_at_terminal
from gspot_verified.work.interrupt import INTERRUPTED, was_interrupted

USAGE = 64  # as in sysexits.h: a command line that cannot be run
INTERNAL = 70  # as in sysexits.h: a fault of the program
CLOSED_PIPE = 141
"""128 + SIGPIPE: what a shell shows for a program that a closed pipe ended."""

_CANNOT_WRITE = {errno.ENOSPC, errno.EIO, errno.EDQUOT, errno.EFBIG, errno.EROFS}

COMMANDS = {name: module for members in GROUPS.values() for name, module in members.items()}
"""The commands in the order of the help, and their modules."""


def load_commands(arguments: Sequence[str] = ()) -> None:
    """Import the module of the command that the arguments ask for, or all modules."""
    command = next(iter(arguments), "")  # before it there are only options of the application, such as --help
    for module in dict.fromkeys([COMMANDS[command]] if command in COMMANDS else COMMANDS.values()):
        import_module(f"gspot_verified.cli.commands.{module}")
    app.registered_commands.sort(key=lambda info: [*COMMANDS].index(name_of(info.callback)))


def name_of(command: Callable[..., None] | None) -> str:
    """The word on the command line for a command's function: ``hard-cases`` for ``hard_cases``."""
    return getattr(command, "__name__", "").replace("_", "-")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code; bad input is a message on stderr and 64."""
    words = sys.argv[1:] if arguments is None else list(arguments)
    try:
        with line_at_terminal(), signs_of_life():
            load_commands(words)
            command = typer.main.get_command(app)
            take_plain_values(command)
            code = command(prog_name="gspot-verified", args=words, standalone_mode=False)
        if code == INTERRUPTED:  # some releases of typer end with this code, others raise
            raise KeyboardInterrupt
    except (ValueError, OSError) as error:
        typer.echo(f"error: {error}", err=True)
        full = isinstance(error, OSError) and error.errno in _CANNOT_WRITE
        return NOT_WRITTEN if full else USAGE
    except SystemExit as leaving:
        # click leaves with 1 where the reader of stdout is gone; 1 would read as "refuted".
        if isinstance(leaving.__context__, OSError):
            return CLOSED_PIPE
        raise
    except (typer.Abort, KeyboardInterrupt):
        typer.echo("interrupted", err=True)
        return INTERRUPTED
    except Exception as error:
        if was_interrupted():
            typer.echo("interrupted", err=True)
            return INTERRUPTED
        # A usage error. Its class has moved between releases of typer; what they share is show().
        if hasattr(error, "show"):
            error.show()
            return USAGE
        from gspot_verified.work.executors import WorkerEndedError

        # Never 1, which would read as "refuted".
        if isinstance(error, WorkerEndedError):
            typer.echo(f"error: {error}; with fewer workers, and with a journal, the same command goes on", err=True)
            return INTERNAL
        typer.echo(f"internal error, please report it: {type(error).__name__}: {error}", err=True)
        return INTERNAL
    return int(code) if isinstance(code, int) else 0


def run() -> None:
    """The program ``gspot-verified``, once it is loaded (``gspot_verified/__main__.py``)."""
    isolate(sys.argv[1:])
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # Greek letters on a stream that has none
    code = main()
    if code == CLOSED_PIPE and hasattr(signal, "SIGPIPE"):
        # As `cat` or `grep` end: by the signal itself, without a word.
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGPIPE)
    sys.exit(code)
