"""Command ``hard-cases``."""

from __future__ import annotations

import shutil
from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, progress, show
from gspot_verified.cli.command_groups import example


@app.command(epilog=example("hard-cases side canard"))
def hard_cases(
    families: Annotated[
        list[str] | None,
        typer.Argument(help="Names of families, such as canard or near-zero; all if none.", metavar="NAME"),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Hard cases of every part, beside double precision. From easy to hard: about ten seconds.

    For each: the condition number, the bits that the usual formula loses, what it says in double precision, what is
    certified, and how work and time grow. The exit code is 0 whatever the rows say; undecided ones are counted.
    """
    from gspot_verified.hard_cases.catalogue import WIDTH, measure_hard_cases

    catalogue = measure_hard_cases(families or (), progress)
    show(catalogue, as_json, catalogue.table(min(shutil.get_terminal_size((WIDTH, 0)).columns, WIDTH)))
