"""``classify --table`` and ``approach --table``: a line of the answers' file for each row of values, as they come."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import typer

from gspot_verified.cli.app import progress
from gspot_verified.cli.output import Outputs
from gspot_verified.numbers.counted import counted

if TYPE_CHECKING:
    from gspot_verified.mechanisms.input.mechanism import Mechanism
    from gspot_verified.mechanisms.table.row_text import AnsweredRow

_SAID = 1_024  # rows between two plain lines of progress

Answers = Callable[["Mechanism", Executor], "Iterator[AnsweredRow]"]
"""What is asked of the table's rows."""


@dataclass(frozen=True)
class TableRun:
    """A mechanism as the command line names it, the table's file, the answers' file, and where the work is done."""

    name: str
    settings: list[str] | None
    table: Path
    output: Path | None
    workers: int
    scheduler: str | None


def write_classified_table(run: TableRun, journal: Path | None) -> NoReturn:
    """The Case and the side of each row's G-spot.

    :raises ValueError: no output is named, or it cannot be written.
    """
    from gspot_verified.mechanisms.table.classify_table import classify_table

    def answers(mechanism: Mechanism, pool: Executor) -> Iterator[AnsweredRow]:
        return classify_table(mechanism, run.table, executor=pool, journal=journal, progress=_show)

    _write(run, journal, False, answers)


def write_approach_table(
    run: TableRun, state: str | None, surface: str | None, digits: int | None, rows: str | None
) -> NoReturn:
    """Where slip from each row's state leads; ``rows``: "A:B", a part of the table.

    :raises ValueError: no output is named, or it cannot be written, or there is no such part.
    """
    from gspot_verified.cli.load import components
    from gspot_verified.mechanisms.table.approach_table import approach_table

    given = {} if state is None else components(state)
    only = None if rows is None else _part(rows)

    def answers(mechanism: Mechanism, pool: Executor) -> Iterator[AnsweredRow]:
        return approach_table(
            mechanism,
            run.table,
            given,
            surface_velocity=surface,
            digits=digits,
            only=only,
            executor=pool,
            progress=_show_each,
        )

    _write(run, None, True, answers)


def _write(run: TableRun, journal: Path | None, with_state: bool, answers: Answers) -> NoReturn:
    """Write the table of answers, print how many there are of each, and end the command."""
    from gspot_verified.cli.load import given_values, load_with_settings
    from gspot_verified.mechanisms.table.parameter_rows import parameter_rows
    from gspot_verified.work.answers_file import require_writer, write_answers
    from gspot_verified.work.executors import executor

    table, output = run.table, run.output
    if output is None:
        raise ValueError("--table needs --output, the file for its answers")
    outputs = Outputs()
    outputs.reads(run.name)
    if table.exists() and output.exists() and table.samefile(output):
        raise ValueError(f"--output and --table name the same file {output}")
    outputs.reads(table)
    outputs.file("--output", output)
    require_writer("--output", output)
    outputs.file("--journal", journal)
    mechanism = load_with_settings(run.name, run.settings)
    columns = parameter_rows(mechanism, table, with_state)
    twice = next((word for word in columns.parameters if word in given_values(run.settings)), None)
    if twice is not None:
        raise ValueError(f"--set {twice}: the table has a column {twice}")
    counts: dict[str, int] = {}
    with executor(run.workers, run.scheduler) as pool, outputs.journal(journal):
        write_answers(output, _lines(answers(mechanism, pool), counts), columns.names)
    total = sum(counts.values())
    typer.echo(f"{mechanism.name}: {counted(total, 'row')}")
    for what, count in sorted(counts.items()):
        typer.echo(f"  {counted(count, 'row')}: {what}")
    outputs.leave(0 if total == sum(count for what, count in counts.items() if what.startswith("settled")) else 2)


def _part(text: str) -> tuple[int, int | None]:
    first, colon, last = text.partition(":")
    words = [word for word in (first, last) if word]
    if not (colon and words and all(word.isascii() and word.isdigit() and len(word) < 19 for word in words)):
        raise ValueError(f"--rows: expected A:B, A: or :B, numbers of rows from 1 on, got {text!r}")
    return int(first or 1), int(last) if last else None


def _lines(rows: Iterable[AnsweredRow], counts: dict[str, int]) -> Iterator[str]:
    """The names of the columns and the rows, as lines of CSV, counted by what they say."""
    for row in rows:
        if not counts:
            yield row.csv_head()
        yield row.to_csv()
        counts[row.summary] = counts.get(row.summary, 0) + 1


def _show(done: int) -> None:
    if done % _SAID == 0:
        progress(f"{done} rows done")


def _show_each(done: int) -> None:
    progress(f"{counted(done, 'row')} done")
