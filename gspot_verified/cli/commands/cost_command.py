"""Command ``cost``."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Protocol

import typer

from gspot_verified.cli.app import JsonFlag, app, progress, show
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.output import PICTURES, Outputs

if TYPE_CHECKING:
    from gspot_verified.cost.times.rows import TimeCurve

_SUBJECTS = ("all", "theta", "sign", "expand", "force", "mechanism", "simulate")
_NAMES = ", ".join(f'"{name}"' for name in _SUBJECTS[:-1]) + f' or "{_SUBJECTS[-1]}"'


class Measured(Protocol):
    """What every benchmark gives."""

    @property
    def curves(self) -> tuple[TimeCurve, ...]:
        """Curves for the picture."""
        ...

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        ...


@app.command(epilog=example("cost --output cost.json"))
def cost(
    subject: Annotated[str, typer.Argument(help=f"What to measure: {_NAMES}.")] = "all",
    full: Annotated[
        bool, typer.Option("--large/--quick", help="Larger cases too: 2 to 20 minutes; all parts: about half an hour.")
    ] = False,
    peers: Annotated[
        bool,
        typer.Option("--peers", help="theta: every cell beside what is installed (FLINT, mpmath, scipy, PARI, Sage)."),
    ] = False,
    picture: Annotated[
        Path | None, typer.Option(help="One subject: time against digits, size or order as PNG, PDF or SVG.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(help="all: write the measurement as JSON, for `report --cost`; goes on where it was interrupted."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Measure what accuracy costs in time. All parts of the report's chapter, or one subject with its targets.

    All parts take two to three minutes, one subject half a minute to a minute. The exit code is 0 whatever the times
    are: a benchmark decides nothing.
    """
    outputs = Outputs()
    outputs.file("--picture", picture, PICTURES)
    outputs.file("--output", output, (".json",))
    if subject not in _SUBJECTS:
        raise ValueError(f"cost: expected {_NAMES}, got {subject!r}")
    if peers and (subject != "theta" or full or picture is not None):
        raise ValueError("--peers: for theta, without --large and --picture")
    if subject == "all":
        if picture is not None:
            raise ValueError("--picture: for one subject; the pictures of all parts are in the report")
        _all_parts(full, output, outputs, as_json)
    if output is not None:
        raise ValueError('--output: for "all"')
    result = _peers() if peers else _measure(subject, full)
    if picture is not None:
        from gspot_verified.report.pictures.cost_picture import save_measured

        outputs.write("--picture", picture, lambda: save_measured(result.curves, picture, subject))
    show(result, as_json)
    outputs.leave(0)


def _all_parts(full: bool, output: Path | None, outputs: Outputs, as_json: bool) -> None:
    from gspot_verified.cost.measurement.file import KeptParts, save
    from gspot_verified.cost.measurement.text import measurement_text
    from gspot_verified.cost.run import measure_cost, question

    with outputs.journal(output, "--output"):
        kept = None if output is None else KeptParts(output.with_name(f"{output.name}.parts"), question(full))
        measurement = measure_cost(full, progress, kept)
    if output is not None and outputs.write("--output", output, lambda: save(measurement, output)) and kept is not None:
        kept.remove()
    show(measurement, as_json, measurement_text(measurement))
    outputs.leave(0)


def _peers() -> Measured:
    from gspot_verified.cost.benchmarks import theta

    return theta.run_peers(progress)


def _measure(subject: str, full: bool) -> Measured:
    benchmark = importlib.import_module(f"gspot_verified.cost.benchmarks.{subject}")
    result: Measured = benchmark.run(full, progress)
    return result
