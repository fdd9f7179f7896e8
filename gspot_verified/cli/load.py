"""A mechanism and a state as the command line names them, and what ``approach`` and ``classify --from`` print."""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

import typer

from gspot_verified.cli.app import print_json

if TYPE_CHECKING:
    from gspot_verified.mechanisms.input.mechanism import Mechanism
from typing import TYPE_CHECKING

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


def load_with_settings(name: str, settings: list[str] | None) -> Mechanism:
    """The mechanism with the values of ``--set name=value``; "symbolic" keeps a parameter a symbol.

    :raises ValueError: a setting is no ``name=value``, or is given twice; see also :func:`mechanisms.load.load`.
    """
    from gspot_verified.mechanisms.load import load

    return load(name, **given_values(settings))


def given_values(settings: list[str] | None) -> dict[str, str | None]:
    """The values of ``--set name=value``; None for "symbolic".

    :raises ValueError: a setting is no ``name=value``, or is given twice.
    """
    values: dict[str, str | None] = {}
    for setting in settings or []:
        key, equals, value = setting.partition("=")
        if not equals or not key.strip():
            raise ValueError(f'--set: expected "name=value", got {setting[:60]!r}')
        if key.strip() in values:
            raise ValueError(f"--set: {key.strip()[:60]} is given twice")
        values[key.strip()] = None if value.strip() == "symbolic" else value.strip()
    return values
