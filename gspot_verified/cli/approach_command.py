"""Command ``approach``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json
from gspot_verified.cli.load import load_with_settings
from gspot_verified.cli.mechanism_commands import MechanismName, Settings

if TYPE_CHECKING:
    from gspot_verified.mechanisms.mechanism import Mechanism

_STATE = 'The state, "phi=phi_ref + 1/10,phi_dot=-9/10": all components, or all but the two that y = v = 0 determine.'


@app.command(epilog='Example: gspot-verified approach oscillator --from "phi=phi_ref + 1/10,phi_dot=-9/10"')
def approach(
    name: MechanismName,
    state: Annotated[str, typer.Option("--from", help=_STATE)],
    surface: Annotated[
        str | None, typer.Option("--surface-velocity", help="Tangential velocity of the surface; 0 if u > 0.")
    ] = None,
    settings: Settings = None,
    as_json: JsonFlag = False,
) -> None:
    """Where slip from a state leads: a G-spot (with C1 in balls, and lift-off or impact), lift-off or stick before.

    Exit code 0 when that is proved (and C1 has a certain sign), 2 when something is undecided.
    """
    show_approach(load_with_settings(name, settings), state, surface, as_json)


def show_approach(mechanism: Mechanism, state: str, surface: str | None, as_json: bool) -> NoReturn:
    """Print the result for one state, and leave with its exit code."""
    from gspot_verified.mechanisms.approach import approach as approach_spot

    result = approach_spot(mechanism, components(state), surface_velocity=surface)
    if as_json:
        print_json(result.to_json(), "approach")
    else:
        typer.echo(str(result))
    raise typer.Exit(result.exit_code)


def components(text: str) -> dict[str, str]:
    """The components of a state given as "name=value,name=value".

    :raises ValueError: a part is no "name=value", or a name is given twice.

    >>> components("p=1/2, b=-1")
    {'p': '1/2', 'b': '-1'}
    """
    found: dict[str, str] = {}
    for part in text.split(","):
        word, equals, value = part.partition("=")
        if not equals or not word.strip() or not value.strip():
            raise ValueError(f'--from: expected "name=value,name=value", got {part.strip()[:60]!r}')
        if word.strip() in found:
            raise ValueError(f"--from: {word.strip()[:60]} is given twice")
        found[word.strip()] = value.strip()
    return found
