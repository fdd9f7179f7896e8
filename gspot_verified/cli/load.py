"""A mechanism as the command line names it: a file or a name, and ``--set`` for its parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gspot_verified.mechanisms.input.mechanism import Mechanism


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
