"""``classify --table``: a line of CSV for each row of parameter values, as they come."""

from __future__ import annotations

from pathlib import Path
from typing import NoReturn

import typer

from gspot_verified.cli.app import progress
from gspot_verified.cli.output import Outputs
from gspot_verified.numbers.counted import counted

_SAID = 1_024  # rows between two plain lines of progress


def write_classified_table(
    name: str,
    settings: list[str] | None,
    table: Path,
    output: Path | None,
    workers: int,
    scheduler: str | None,
    journal: Path | None,
) -> NoReturn:
    """Write the table of answers, print how many there are of each, and end the command.

    :raises ValueError: no output is named, or it cannot be written.
    """
    from gspot_verified.cli.load import given_values, load_with_settings
    from gspot_verified.mechanisms.table.classify_table import classify_table
    from gspot_verified.mechanisms.table.parameter_rows import parameter_rows
    from gspot_verified.work.draft import draft
    from gspot_verified.work.executors import executor

    if output is None:
        raise ValueError("--table needs --output, the file for its answers")
    outputs = Outputs()
    outputs.reads(name)
    if table.exists() and output.exists() and table.samefile(output):
        raise ValueError(f"--output and --table name the same file {output}")
    outputs.reads(table)
    outputs.file("--output", output)
    outputs.file("--journal", journal)
    mechanism = load_with_settings(name, settings)
    twice = next((word for word in parameter_rows(mechanism, table).parameters if word in given_values(settings)), None)
    if twice is not None:
        raise ValueError(f"--set {twice}: the table has a column {twice}")
    counts: dict[str, int] = {}
    with executor(workers, scheduler) as pool, outputs.journal(journal):
        rows = classify_table(mechanism, table, executor=pool, journal=journal, progress=_show)
        with draft(output) as unfinished, unfinished.open("w", encoding="utf-8", newline="") as file:
            for row in rows:
                file.write(row.to_csv() if counts else row.csv_head() + row.to_csv())
                what = row.outcome if row.case is None else f"{row.outcome}, {_case(row.case)}"
                counts[what] = counts.get(what, 0) + 1
    total = sum(counts.values())
    typer.echo(f"{mechanism.name}: {counted(total, 'row')}")
    for what, count in sorted(counts.items()):
        typer.echo(f"  {counted(count, 'row')}: {what}")
    outputs.leave(0 if total == sum(count for what, count in counts.items() if what.startswith("settled")) else 2)


def _case(case: str) -> str:
    return "no Case" if case == "none" else f"Case {case}"


def _show(done: int) -> None:
    if done % _SAID == 0:
        progress(f"{done} rows done")
