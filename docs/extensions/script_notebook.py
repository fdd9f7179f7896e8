"""A script in cells (``# %%``), run from top to bottom, as a page: text, code, what each cell printed and drew.

And as a notebook that nobody has run, for Jupyter.
"""

from __future__ import annotations

import ast
import contextlib
import io
import re
from pathlib import Path
from typing import Any

from gspot_verified.report.pictures.canvas import Picture

_CELL = re.compile(r"^# %%(?: (\[markdown\]))?[^\n]*\n", re.MULTILINE)


def cells(source: str) -> list[tuple[bool, str]]:
    """(is text, content) for each cell."""
    parts = _CELL.split(source)
    found = []
    for kind, body in zip(parts[1::2], parts[2::2], strict=True):
        if kind:
            body = "\n".join(line.removeprefix("#").removeprefix(" ") for line in body.strip().splitlines())
        found.append((bool(kind), body.strip("\n")))
    return found


def notebook(source: str) -> dict[str, Any]:
    """The cells as a Jupyter notebook without outputs: nbformat 4.5."""
    made: list[dict[str, Any]] = []
    for number, (is_text, body) in enumerate(cells(source), 1):
        cell = {"id": f"cell-{number}", "metadata": {}, "source": body}
        code = {"cell_type": "code", "execution_count": None, "outputs": []}
        made.append({**cell, **({"cell_type": "markdown"} if is_text else code)})
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": {"kernelspec": kernel}, "cells": made}


def run(source: str) -> list[tuple[bool, str, str, Picture | None]]:
    """(is text, content, what was printed, what was drawn) for each cell; the last expression of a cell is shown."""
    names: dict[str, Any] = {"__name__": "notebook"}
    found = []
    for number, (is_text, body) in enumerate(cells(source), 1):
        if is_text:
            found.append((True, body, "", None))
            continue
        tree = ast.parse(body, f"cell {number}")
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        printed, value = io.StringIO(), None
        with contextlib.redirect_stdout(printed):
            exec(compile(tree, f"cell {number}", "exec"), names)
            if isinstance(last, ast.Expr):
                value = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names)
            if value is not None and not isinstance(value, Picture):
                print(value)
        found.append((False, body, printed.getvalue(), value if isinstance(value, Picture) else None))
    return found


def notebook_page(source: str, pictures: Path, prefix: str = "") -> str:
    """The page in Markdown; pictures are written into the folder, their names behind the prefix."""
    parts = []
    for is_text, body, printed, drawn in run(source):
        if is_text:
            parts.append(body)
            continue
        parts.append(f"```python\n{body}\n```")
        if printed:
            parts.append(f"```text\n{printed.rstrip()}\n```")
        if drawn is not None:
            name = f"{prefix}{drawn.name}.svg"
            (pictures / name).write_text(drawn.svg, encoding="utf-8")
            parts.append(f"```{{figure}} static/{name}\n:alt: {drawn.alternative}\n\n{drawn.caption}\n```")
    return "\n\n".join(parts) + "\n"
