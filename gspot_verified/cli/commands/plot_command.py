"""The command ``plot``: pictures by their names."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gspot_verified.cli.app import app, progress
from gspot_verified.cli.approach_output import components
from gspot_verified.cli.load import load_with_settings
from gspot_verified.cli.output import PICTURES, Outputs

if TYPE_CHECKING:
    from gspot_verified.report.pictures.canvas import Picture


@app.command(epilog="Example: gspot-verified plot force force.png")
def plot(
    name: Annotated[
        str, typer.Argument(help='"theta", "b-hat", "contact-force", "phase-plane", "force", "side-map", "threshold".')
    ],
    output: Annotated[Path, typer.Argument(help="The file: PNG, PDF or SVG by its suffix.")],
    mechanism: Annotated[str, typer.Option(help="phase-plane: a TOML file or a name.")] = "oscillator",
    settings: Annotated[list[str] | None, typer.Option("--set", help='phase-plane: a parameter, "mu=2".')] = None,
    start: Annotated[
        str | None, typer.Option("--from", help='phase-plane: a state of one\'s own, "phi=1/10,phi_dot=-9/10".')
    ] = None,
    beta: Annotated[str, typer.Option(help="b-hat, contact-force: β.")] = "7/3",
    epsilon: Annotated[str, typer.Option("--epsilon", "--eps", help="contact-force: ε.")] = "1/1000",
) -> None:
    """Draw a figure; its caption, which says what is certified, goes to stdout.

    theta: Θ for five β. b-hat: b-hat of the compliant model against Θ. contact-force: λ_N(τ) at leading order.
    phase-plane: (p, b) of a mechanism next to its G-spot.
    force: the slow force at several ε above leading order. side-map: the exact side rule over β and ε for the paper's
    data (about a minute). threshold: the exact ε0 over β beside the one at leading order (some minutes).
    """
    if name not in NAMES:
        raise ValueError(f"name: expected one of {', '.join(NAMES)}, got {name!r}")
    outputs = Outputs()
    outputs.file("output", output, PICTURES)
    drawn = _drawn(name, mechanism, settings, start, beta, epsilon)
    typer.echo(f"{drawn.title}\n{drawn.caption}")
    outputs.write("output", output, lambda: drawn.save(output))
    outputs.leave(0)


def _drawn(
    name: str, mechanism: str, settings: list[str] | None, start: str | None, beta: str, epsilon: str
) -> Picture:
    from gspot_verified.report.plot import plot as picture_of

    if name == "phase-plane":
        state = None if start is None else components(start)
        return picture_of(load_with_settings(mechanism, settings), state=state)
    if name == "contact-force":
        from gspot_verified.mechanisms.iwc import iwc

        return picture_of(iwc(beta), epsilon=epsilon)
    if name == "b-hat":
        return picture_of(name, beta=beta)
    if name == "side-map":
        return picture_of(name, progress=progress)
    return picture_of(name)


NAMES = ("theta", "b-hat", "contact-force", "phase-plane", "force", "side-map", "threshold")
