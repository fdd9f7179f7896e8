"""Options of commands whose work may be shared and go on after a kill."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

Workers = Annotated[int, typer.Option(help="Processes that share the work; the result is the same for any number.")]
Scheduler = Annotated[str | None, typer.Option(help="Address of a Dask scheduler, in place of processes here.")]
JournalFile = Annotated[Path | None, typer.Option("--journal", help="Keep finished work here; go on from it.")]
TableOutput = Annotated[Path | None, typer.Option("--output", help="With --table: the CSV file for its answers.")]
