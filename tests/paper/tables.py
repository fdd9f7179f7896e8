"""The tables of wrong formulas in ``teeth``: one for each module of the ledger that is a part of the paper."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType

TABLES = sorted(path.stem for path in Path(__file__).with_name("teeth").glob("*.py"))


def table(name: str) -> ModuleType:
    """The table of one module: its ``TEETH`` and the ``ENTRIES`` that they bite."""
    return importlib.import_module(f"paper.teeth.{name}")
