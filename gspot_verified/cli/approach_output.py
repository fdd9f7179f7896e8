"""What ``approach`` and ``classify --from`` print."""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

import typer

from gspot_verified.cli.app import print_json

if TYPE_CHECKING:
    from gspot_verified.mechanisms.input.mechanism import Mechanism


def show_approach(
    mechanism: Mechanism, state: str, surface: str | None, as_json: bool, spot: int | None = None
) -> NoReturn:
    """Print the result for one state, and leave with its exit code."""
    from gspot_verified.mechanisms.approach.approach import approach as approach_spot

    result = approach_spot(mechanism, components(state), surface_velocity=surface, spot=spot)
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
    values: dict[str, str] = {}
    for part in text.split(","):
        word, equals, value = part.partition("=")
        if not equals or not word.strip() or not value.strip():
            raise ValueError(f'--from: expected "name=value,name=value", got {part.strip()[:60]!r}')
        if word.strip() in values:
            raise ValueError(f"--from: {word.strip()[:60]} is given twice")
        values[word.strip()] = value.strip()
    return values
