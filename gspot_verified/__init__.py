"""Verified numerics for the Painlevé paradox: Θ(τ, β) and its signs, the paper claim by claim, your own mechanism.

The public names stand in ``__init__.pyi``, with their types. A name is loaded when it is first used, so that the import
is quick.
"""

import ast
from importlib import import_module
from pathlib import Path
from typing import Any

__version__ = "0.2.0"

__homes__ = {
    alias.name: str(line.module)
    for line in ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")).body
    if isinstance(line, ast.ImportFrom)
    for alias in line.names
}
"""The public names and the modules that define them."""

__all__ = [*__homes__]


def __getattr__(name: str) -> Any:
    if name not in __homes__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(__homes__[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__homes__})
