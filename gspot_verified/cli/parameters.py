"""Parameters of commands that are read without a validation library where plain Python does.

Releases of typer from 0.2x on build a pydantic adapter for every parameter of a command, given or not; loading pydantic
takes as long as everything else that a short command does. Here an adapter is built for a value that needs one.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

_INTEGER = re.compile("-?[0-9]{1,18}")


class _ReadWhenNeeded:
    """What typer asks to turn the word of a parameter into its value."""

    def coerce(self, value: Any, param: Any, ctx: Any) -> Any:
        """The value itself where it has its type already, an integer in plain digits, a path; the rest is for typer."""
        wanted, asked = param.type_descriptor.annotation, param.type_descriptor.parameter_info
        if value is None:
            return () if param.multiple or param.nargs == -1 else None
        if asked.parser is None and asked.min is None and asked.max is None:
            if type(value) is wanted:
                return value
            if wanted is int and isinstance(value, str) and _INTEGER.fullmatch(value):
                return int(value)
            if wanted is Path and isinstance(value, str) and _is_allowed(value, asked):
                return Path(value)
        param._runtime_param = None
        return param.get_runtime_param().coerce(value, param=param, ctx=ctx)


def _is_allowed(path: str, asked: Any) -> bool:
    """Whether a path certainly meets what is asked of it."""
    further = asked.exists or asked.writable or asked.resolve_path or asked.allow_dash or asked.path_type is not None
    return (
        asked.file_okay and asked.dir_okay and not further and (os.access(path, os.R_OK) or not os.path.lexists(path))
    )


def read_when_needed(command: Any) -> Any:
    """The same command; its parameters and those of its subcommands build no adapter that no value needs."""
    found = command.get_params

    def parameters(context: Any) -> list[Any]:
        params: list[Any] = found(context)
        for param in params:
            # None: not built yet. Releases without pydantic have no such attribute, and nothing is to be done.
            if getattr(param, "_runtime_param", param) is None:
                param._runtime_param = _ReadWhenNeeded()
        return params

    command.get_params = parameters
    for subcommand in getattr(command, "commands", {}).values():
        read_when_needed(subcommand)
    return command
