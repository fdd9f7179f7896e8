"""Words of the command line as values, without a library that takes longer to load than most commands run.

Typer 0.29 coerces every value by pydantic. Here a plain word (a text, an integer in decimal digits, a path that typer
would take as it is) is taken as typer takes it; all others are left to typer, with its messages.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, get_args, get_origin

_INTEGER = re.compile(r"-?[0-9]{1,15}")


def take_plain_values(command: Any) -> None:
    """Let the parameters of the command, and of those in it, take plain words where typer would ask pydantic."""
    for each in getattr(command, "commands", {}).values():
        take_plain_values(each)
    command.get_params = partial(_taking_plain_values, command.get_params)


def _taking_plain_values(parameters: Callable[[Any], list[Any]], context: Any) -> list[Any]:
    """All parameters, that of ``--help`` too, which is made when it is asked for."""
    found = parameters(context)
    for each in found:
        if "get_runtime_param" not in vars(each) and hasattr(each, "get_runtime_param"):
            each.get_runtime_param = partial(_PlainFirst, each.type_descriptor.annotation, each.get_runtime_param)
    return found


class _PlainFirst:
    def __init__(self, annotation: Any, otherwise: Callable[[], Any]) -> None:
        self._annotation, self._otherwise = annotation, otherwise

    def coerce(self, value: Any, param: Any, ctx: Any) -> Any:
        if value is None:
            return () if param.multiple or param.nargs == -1 else None
        try:
            return plain_value(value, self._annotation)
        except ValueError:
            return self._otherwise().coerce(value, param=param, ctx=ctx)


def plain_value(value: Any, annotation: Any) -> Any:
    """The value of a word, or of a sequence of words.

    :raises ValueError: it is not plain: whoever knows all its forms has to be asked.

    >>> plain_value("-7", int), plain_value(("a", "b"), list[str])
    (-7, ['a', 'b'])
    """
    if get_origin(annotation) is list and isinstance(value, list | tuple):
        return [plain_value(each, get_args(annotation)[0]) for each in value]
    if type(value) is annotation and annotation is not Path:
        return value
    if annotation is int and isinstance(value, str) and _INTEGER.fullmatch(value):
        return int(value)
    if annotation is Path and (os.access(value, os.R_OK) or not os.path.lexists(value)):
        return Path(value)
    raise ValueError(f"{value!r:.60} is not plain")
