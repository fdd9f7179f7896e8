"""Command ``sweep``."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, counted, print_json_with_rows
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.commands.mechanism_commands import MechanismName
from gspot_verified.cli.output import PICTURES, Outputs
from gspot_verified.cli.work_options import JournalFile, Scheduler, Workers
from gspot_verified.numbers.counted import done_of
from gspot_verified.work.draft import draft

_SAID = 32  # cells and pieces between two plain lines of progress


@app.command(epilog=example("sweep oscillator --over beta=1/2..4:40"))
def sweep(
    name: MechanismName,
    over: Annotated[
        list[str],
        typer.Option("--over", help='A parameter and its range, "mu=1.4..2:200" for 200 cells; given twice: a map.'),
    ],
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help='A parameter that does not vary, "kappa=1/10".'),
    ] = None,
    start: Annotated[
        list[str] | None, typer.Option("--start", help='Where the G-spot is proved first, such as "mu=2".')
    ] = None,
    spot: Annotated[
        int | None, typer.Option(help="Which of all G-spots there, by its number in `classify --all`.")
    ] = None,
    digits: Annotated[int, typer.Option(help="Decimals of the brackets in which Case or side change, 1..15.")] = 12,
    budget: Annotated[
        int | None,
        typer.Option(help="How many undecided pieces may be divided again, beyond the cells; 500 if left out."),
    ] = None,
    csv: Annotated[Path | None, typer.Option("--csv", help="Write a table, one line for each piece.")] = None,
    picture: Annotated[Path | None, typer.Option(help="Draw it, as PNG, PDF or SVG by the file's suffix.")] = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    journal: JournalFile = None,
    as_json: JsonFlag = False,
) -> None:
    """A G-spot over one or two parameters: α's, β, Case, side. For every value of the range, not only at points.

    Where Case or side change is bracketed. What stays undecided in a cell is divided again without being asked, up to
    --budget pieces. Exit code 0 when all the rest is settled, 2 when something is undecided.
    """
    from gspot_verified.mechanisms.load import load
    from gspot_verified.mechanisms.sweep.sweep import BUDGET
    from gspot_verified.mechanisms.sweep.sweep import sweep as sweep_mechanism
    from gspot_verified.work.executors import executor

    outputs = Outputs()
    outputs.reads(name)
    outputs.file("--csv", csv)
    outputs.file("--picture", picture, PICTURES)
    outputs.file("--journal", journal)
    ranges, first = _assignments("--over", over), _assignments("--start", start or [])
    fixed = _assignments("--set", settings or [])
    for word in (each for each in fixed if each in ranges):
        raise ValueError(f"--set {word}: it varies by --over; --start {word}=... says where the sweep begins")
    mechanism = load(name, **fixed)
    with executor(workers, scheduler) as pool, outputs.journal(journal):
        result = sweep_mechanism(
            mechanism,
            ranges,
            start=first,
            spot=spot,
            digits=digits,
            budget=BUDGET if budget is None else budget,
            executor=pool,
            journal=journal,
            progress=_show,
        )
    if csv is not None:
        outputs.write("--csv", csv, lambda: _replace(csv, result.csv_lines()))
    if picture is not None:
        from gspot_verified.report.pictures.sweep_picture import save_sweep

        outputs.write("--picture", picture, lambda: save_sweep(result, picture))
    if as_json:
        from gspot_verified.mechanisms.sweep.sweep_piece import PieceRow, piece_row
        from gspot_verified.mechanisms.sweep.sweep_result import SweepSummary
        from gspot_verified.numbers.written import form

        rows = (form(PieceRow).write(piece_row(piece)) for piece in result.pieces)
        print_json_with_rows(SweepSummary(result).to_json(), "pieces", rows)
    else:
        typer.echo(str(result))
    outputs.leave(result.verdict.exit_code)


def _assignments(option: str, texts: list[str]) -> dict[str, str]:
    values: dict[str, str] = {}
    for text in texts:
        key, equals, value = (part.strip() for part in text.partition("="))
        if not equals or not key:
            raise ValueError(f'{option}: expected "name=value", got {text[:60]!r}')
        if key in values:
            raise ValueError(f"{option}: {key[:60]} is given twice")
        values[key] = value
    return values


def _replace(path: Path, lines: Iterable[str]) -> None:
    """Write a file whole or not at all."""
    with draft(path) as unfinished, unfinished.open("w", encoding="utf-8") as file:
        file.writelines(lines)


def _show(done: int, of: int) -> None:
    said = done == of or done % _SAID == 0
    counted(f"{done_of(done, of, 'cell')}, undecided pieces among them", done, done / of, said)
