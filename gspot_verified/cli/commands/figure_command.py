"""The command ``figure``: pictures by their names."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gspot_verified.cli.app import app, progress
from gspot_verified.cli.approach_output import components
from gspot_verified.cli.load import load_with_settings
from gspot_verified.cli.output import PICTURES, Outputs

if TYPE_CHECKING:
    from gspot_verified.report.pictures.canvas import Picture


@app.command(epilog="Example: gspot-verified figure force force.png")
def figure(
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
    epsilon: Annotated[str, typer.Option("--eps", help="contact-force: ε.")] = "1/1000",
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
    from gspot_verified.report.plot import plot

    if name == "phase-plane":
        state = None if start is None else components(start)
        return plot(load_with_settings(mechanism, settings), state=state)
    if name == "contact-force":
        from gspot_verified.compliant.contact.iwc import compliant_iwc

        return plot(compliant_iwc(beta), epsilon=epsilon)
    if name == "b-hat":
        return plot(name, beta=beta)
    return _FIGURES[name]()


def _theta() -> Picture:
    from gspot_verified.report.figures.figures import theta_picture

    return theta_picture()


def _force() -> Picture:
    from gspot_verified.report.figures.force_figure import force_picture

    return force_picture()


def _side_map() -> Picture:
    from flint import fmpq

    from gspot_verified.compliant.side.side_map import side_map
    from gspot_verified.report.figures.side_map import side_map_picture

    betas = [fmpq(2 * n + 1, 8) for n in range(1, 40)]
    parts = (fmpq(1), fmpq(3, 2), fmpq(2), fmpq(3), fmpq(9, 2), fmpq(7))  # of a power of ten
    epsilons = [fmpq(10) ** -(k // 6) / parts[k % 6] for k in range(25)]
    return side_map_picture(side_map(betas, epsilons, lambda done, number: progress(f"{done} of {number} values of β")))


def _threshold() -> Picture:
    from gspot_verified.report.figures.threshold_figure import threshold_picture, threshold_points

    return threshold_picture(threshold_points())


_FIGURES: dict[str, Callable[[], Picture]] = {
    "theta": _theta,
    "force": _force,
    "side-map": _side_map,
    "threshold": _threshold,
}
NAMES = ("theta", "b-hat", "contact-force", "phase-plane", "force", "side-map", "threshold")
