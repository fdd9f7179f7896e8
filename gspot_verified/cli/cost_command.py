"""Command ``cost``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress


@app.command(epilog="Example: gspot-verified cost theta --picture cost.png")
def cost(
    subject: Annotated[str, typer.Argument(help='What to measure: "theta".')],
    full: Annotated[bool, typer.Option("--full", help="Also 10^5 and 10^6 digits: about 20 minutes.")] = False,
    picture: Annotated[Path | None, typer.Option(help="Write time against digits as a PNG file.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """Measure what accuracy costs in time, against FLINT's 1F2, mpmath, and PARI and ore_algebra where installed.

    About half a minute. The exit code is 0 whatever the times are: a benchmark decides nothing.
    """
    if subject != "theta":
        raise ValueError(f'cost: expected "theta", got {subject!r}')
    from gspot_verified.cost.picture import save_picture
    from gspot_verified.cost.theta import run as measure_theta

    result = measure_theta(full, progress)
    if picture is not None:
        save_picture(result.curves, picture)
    if as_json:
        print_json(result.to_json())
    else:
        typer.echo(str(result))
