"""Command ``cost``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Protocol

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress
from gspot_verified.cli.output import PICTURES, Outputs

if TYPE_CHECKING:
    from gspot_verified.cost.curves import Curve


class Measured(Protocol):
    """What every benchmark gives."""

    @property
    def curves(self) -> tuple[Curve, ...]:
        """Curves for the picture."""
        ...

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        ...


@app.command(epilog="Example: gspot-verified cost theta --picture cost.png")
def cost(
    subject: Annotated[
        str, typer.Argument(help='What to measure: "theta", "sign", "expand", "force", "mechanism", "simulate".')
    ],
    full: Annotated[bool, typer.Option("--full", help="Larger cases too: about 20, 10 or 2 minutes.")] = False,
    peers: Annotated[
        bool,
        typer.Option("--peers", help="theta: every cell beside what is installed (FLINT, mpmath, scipy, PARI, Sage)."),
    ] = False,
    picture: Annotated[
        Path | None, typer.Option(help="Write time against digits, size or order as PNG, PDF or SVG.")
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Measure the cost of accuracy (theta), signs, expansions, the compliant force, mechanisms and runs of scenes.

    About half a minute each. The exit code is 0 whatever the times are: a benchmark decides nothing.
    """
    from gspot_verified.report.cost_picture import DIGITS, LINKS, ORDERS, RANGES, RUNS, SMALLNESS, save_picture

    outputs = Outputs()
    outputs.file("--picture", picture, PICTURES)
    if peers and (subject != "theta" or full or picture is not None):
        raise ValueError("--peers: for theta, without --full and --picture")
    result = _peers() if peers else _measure(subject, full)
    if picture is not None:
        known = {"theta": DIGITS, "sign": RANGES, "expand": ORDERS, "force": SMALLNESS, "mechanism": LINKS}
        labels = {**known, "simulate": RUNS}[subject]
        outputs.write("--picture", picture, lambda: save_picture(result.curves, picture, labels))
    if as_json:
        print_json(result.to_json())
    else:
        typer.echo(str(result))
    outputs.leave(0)


def _peers() -> Measured:
    from gspot_verified.cost import theta

    return theta.run_peers(progress)


def _measure(subject: str, full: bool) -> Measured:
    if subject == "theta":
        from gspot_verified.cost import theta

        return theta.run(full, progress)
    if subject == "sign":
        from gspot_verified.cost import sign

        return sign.run(full, progress)
    if subject == "expand":
        from gspot_verified.cost import expand

        return expand.run(full, progress)
    if subject == "force":
        from gspot_verified.cost import force

        return force.run(full, progress)
    if subject == "mechanism":
        from gspot_verified.cost import mechanism

        return mechanism.run(full, progress)
    if subject == "simulate":
        from gspot_verified.cost import simulate

        return simulate.run(full, progress)
    names = '"theta", "sign", "expand", "force", "mechanism" or "simulate"'
    raise ValueError(f"cost: expected {names}, got {subject!r}")
