"""The command ``plot``: pictures by their names."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gspot_verified.cli.app import app, progress, refuse
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.load import components, load_with_settings
from gspot_verified.cli.output import PICTURES, Outputs

if TYPE_CHECKING:
    from gspot_verified.report.pictures.canvas import Picture


@app.command(epilog=example("plot force force.png"))
def plot(
    name: Annotated[
        str,
        typer.Argument(
            help='"theta", "b-hat", "contact-force", "phase-plane", "mechanism", "force", "side-map", "threshold".'
        ),
    ],
    output: Annotated[Path, typer.Argument(help="The file: PNG, PDF or SVG by its suffix.")],
    mechanism: Annotated[
        str | None, typer.Option(help="phase-plane, mechanism: a TOML file or a name; oscillator if left out.")
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help='phase-plane, mechanism: a parameter, "mu=2".'),
    ] = None,
    spot: Annotated[
        int | None, typer.Option(help="phase-plane, mechanism: which G-spot, by its number in `classify --all`.")
    ] = None,
    start: Annotated[
        str | None,
        typer.Option("--from", help='phase-plane, mechanism: a state of one\'s own, "phi=1/10,phi_dot=-9/10".'),
    ] = None,
    beta: Annotated[str | None, typer.Option(help="b-hat, contact-force: β; 7/3 if left out.")] = None,
    epsilon: Annotated[
        str | None, typer.Option("--epsilon", "--eps", help="contact-force: ε; 1/1000 if left out.")
    ] = None,
) -> None:
    """Draw a figure; its caption says what is certified. The caption goes to stdout.

    theta: Θ for five β. b-hat: b-hat of the compliant model against Θ. contact-force: λ_N(τ) at leading order.
    phase-plane: (p, b) of a mechanism next to its G-spot. mechanism: its bodies at its G-spot, as its file draws them.
    force: the slow force at several ε above leading order. side-map: the exact side rule over β and ε for the paper's
    data (about a minute). threshold: the exact ε0 over β beside the one at leading order (some minutes).
    """
    if name not in OPTIONS:
        raise ValueError(f"name: expected one of {', '.join(OPTIONS)}, got {name[:60]!r}")
    given = {
        "--mechanism": mechanism, "--set": settings, "--spot": spot, "--from": start, "--beta": beta,
        "--epsilon": epsilon,
    }  # fmt: skip
    own = OPTIONS[name]
    refuse(f"the figure {name} takes {', '.join(own) or 'no option'}", {k: v for k, v in given.items() if k not in own})
    outputs = Outputs()
    outputs.file("output", output, PICTURES)
    drawn = _drawn(name, mechanism, settings, spot, start, beta, epsilon)
    typer.echo(f"{drawn.title}\n{drawn.caption}")
    outputs.write("output", output, lambda: drawn.save(output))
    outputs.leave(0)


def _drawn(
    name: str,
    mechanism: str | None,
    settings: list[str] | None,
    spot: int | None,
    start: str | None,
    beta: str | None,
    epsilon: str | None,
) -> Picture:
    from gspot_verified.report.plot import plot as picture_of

    if name in ("phase-plane", "mechanism"):
        state = None if start is None else components(start)
        moving = load_with_settings("oscillator" if mechanism is None else mechanism, settings)
        if name == "mechanism":
            return picture_of(name, mechanism=moving, state=state, spot=spot)
        return picture_of(moving, state=state, spot=spot)
    ratio = "7/3" if beta is None else beta
    if name == "contact-force":
        from gspot_verified.mechanisms.iwc import iwc

        return picture_of(iwc(ratio), epsilon="1/1000" if epsilon is None else epsilon)
    if name == "b-hat":
        return picture_of(name, beta=ratio)
    if name == "side-map":
        return picture_of(name, progress=progress)
    return picture_of(name)


OPTIONS: dict[str, tuple[str, ...]] = {
    "theta": (),
    "b-hat": ("--beta",),
    "contact-force": ("--beta", "--epsilon"),
    "phase-plane": ("--mechanism", "--set", "--spot", "--from"),
    "mechanism": ("--mechanism", "--set", "--spot", "--from"),
    "force": (),
    "side-map": (),
    "threshold": (),
}
"""The figures, and which options each of them has."""
