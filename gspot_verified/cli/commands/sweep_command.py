"""Command ``sweep``."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gspot_verified.cli.app import JournalFile, JsonFlag, Scheduler, Workers, app, counted, print_json_with_rows
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.commands.approach_command import Surface
from gspot_verified.cli.commands.mechanism_commands import MechanismName
from gspot_verified.cli.load import components
from gspot_verified.cli.output import PICTURES, Outputs
from gspot_verified.numbers.counted import done_of
from gspot_verified.work.answers_file import require_writer, write_answers

if TYPE_CHECKING:
    from gspot_verified.mechanisms.fates.fates_result import Fates
    from gspot_verified.mechanisms.input.mechanism import Mechanism
    from gspot_verified.mechanisms.sweep.sweep_result import Sweep

_SAID = 32  # cells and pieces between two plain lines of progress


@app.command(epilog=example("sweep oscillator --over beta=1/2..4:40"))
def sweep(
    name: MechanismName,
    over: Annotated[
        list[str],
        typer.Option(
            "--over",
            help='A parameter and its range, "mu=1.4..2:200" for 200 cells; given twice: a map. '
            "With --from: a component of the state.",
        ),
    ],
    state: Annotated[
        str | None,
        typer.Option("--from", help='Where slip ends that starts at "X=0,X_dot=5,theta=4/5" and the range of --over.'),
    ] = None,
    surface: Surface = None,
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
    digits: Annotated[
        int | None, typer.Option(help="Decimals of the brackets in which Case or side change, 1..15; 12 if left out.")
    ] = None,
    budget: Annotated[
        int | None,
        typer.Option(
            help="How many undecided pieces may be divided again, beyond the cells; 500 if left out, 0 with --from."
        ),
    ] = None,
    csv: Annotated[
        Path | None, typer.Option("--csv", help="Write a table, one line for each piece: CSV, or FILE.parquet.")
    ] = None,
    picture: Annotated[Path | None, typer.Option(help="Draw it, as PNG, PDF or SVG by the file's suffix.")] = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    journal: JournalFile = None,
    as_json: JsonFlag = False,
) -> None:
    """A G-spot over one or two parameters: α's, β, Case, side. With --from: where slip ends, over initial states.

    All is certain for every value of the range, not only at points. With --from "NAME=VALUE,..." --over gives one or
    two components of the state, and two are left out that y = v = 0 determine: which states reach the G-spot, with
    which sign of C1, lift off, or stop to slip. Else where Case or side change is bracketed. What stays undecided in a
    cell is divided again without being asked, up to --budget pieces. Exit code 0 when all the rest is settled, 2 when
    something is undecided.
    """
    from gspot_verified.mechanisms.load import load
    from gspot_verified.work.executors import executor

    outputs = Outputs()
    outputs.reads(name)
    outputs.file("--csv", csv)
    require_writer("--csv", csv)
    outputs.file("--picture", picture, PICTURES)
    outputs.file("--journal", journal)
    ranges, first = _assignments("--over", over), _assignments("--start", start or [])
    fixed = _assignments("--set", settings or [])
    for word in (each for each in fixed if each in ranges):
        raise ValueError(f"--set {word}: it varies by --over; --start {word}=... says where the sweep begins")
    mechanism = load(name, **fixed)
    work: dict[str, Any] = {"spot": spot, "journal": journal, "progress": _progress()}
    if budget is not None:
        work["budget"] = budget
    with executor(workers, scheduler) as pool, outputs.journal(journal):
        work["executor"] = pool
        if state is None:
            swept = _of_a_spot(mechanism, ranges, first, digits, surface, work)
            result: Sweep | Fates = swept
            lines, in_parts = partial(swept.csv_lines, pool), partial(swept.in_parts, pool)
        else:
            result = _of_states(mechanism, state, ranges, first, digits, surface, work)
            lines, in_parts = partial(result.csv_lines), partial(result.in_parts)
        if csv is not None:
            outputs.write("--csv", csv, lambda: write_answers(csv, lines()))
        if as_json:
            summary, rows = in_parts()
            print_json_with_rows(summary, "pieces", rows)
    if picture is not None:
        outputs.write("--picture", picture, lambda: _draw(result, picture))
    if not as_json:
        typer.echo(str(result))
    outputs.leave(result.verdict.exit_code)


def _of_a_spot(
    mechanism: Mechanism,
    ranges: dict[str, str],
    start: dict[str, str],
    digits: int | None,
    surface: str | None,
    work: dict[str, Any],
) -> Sweep:
    from gspot_verified.mechanisms.sweep.sweep import sweep as sweep_mechanism

    if surface is not None:
        raise ValueError("--surface-velocity: is asked for with --from only")
    return sweep_mechanism(mechanism, ranges, start=start, digits=12 if digits is None else digits, **work)


def _of_states(
    mechanism: Mechanism,
    state: str,
    ranges: dict[str, str],
    start: dict[str, str],
    digits: int | None,
    surface: str | None,
    work: dict[str, Any],
) -> Fates:
    from gspot_verified.mechanisms.fates.fates import fates

    for option, asked in (("--start", bool(start)), ("--digits", digits is not None)):
        if asked:
            raise ValueError(f"{option}: says nothing with --from")
    given = components(state) if state.strip() else {}
    return fates(mechanism, given, ranges, surface_velocity=surface or 0, **work)


def _draw(result: Sweep | Fates, path: Path) -> Path:
    from gspot_verified.mechanisms.sweep.sweep_result import Sweep
    from gspot_verified.report.pictures.sweep_picture import save_fates, save_sweep

    return save_sweep(result, path) if isinstance(result, Sweep) else save_fates(result, path)


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


def _progress() -> Callable[[int, int], None]:
    """Shows the cells, and, once some are divided again, the undecided pieces among them."""
    cells: list[int] = []

    def show(done: int, of: int) -> None:
        cells.append(of)
        again = ", undecided pieces among them" if of > cells[0] else ""
        counted(f"{done_of(done, of, 'cell')}{again}", done, done / of, done == of or done % _SAID == 0)

    return show
