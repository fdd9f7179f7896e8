"""Command ``approach``."""

from __future__ import annotations

from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app
from gspot_verified.cli.approach_output import show_approach
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.commands.mechanism_commands import MechanismName, Settings
from gspot_verified.cli.load import load_with_settings

_STATE = 'The state, "phi=phi_ref + 1/10,phi_dot=-9/10": all components, or all but the two that y = v = 0 determine.'


@app.command(epilog=example('approach oscillator --from "phi=phi_ref+1/10,phi_dot=-9/10"'))
def approach(
    name: MechanismName,
    state: Annotated[str, typer.Option("--from", help=_STATE)],
    surface: Annotated[
        str | None, typer.Option("--surface-velocity", help="Tangential velocity of the surface; 0 if u > 0.")
    ] = None,
    settings: Settings = None,
    spot: Annotated[
        int | None,
        typer.Option("--spot", help="What --from leaves out is as at this G-spot, by its number in `classify --all`."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Where slip from a state leads: a G-spot, lift-off or stick. At a G-spot: C1 in balls, and lift-off or impact.

    Exit code 0 when that is proved (and C1 has a certain sign), 2 when something is undecided.
    """
    show_approach(load_with_settings(name, settings), state, surface, as_json, spot)
