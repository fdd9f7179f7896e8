"""``verify`` keeps results and reads them again, so it runs where nothing outside of its key can act on Python.

Python is started again in isolated mode (no ``PYTHONPATH``, no folder of the user, no current folder), and without
``sitecustomize`` and ``usercustomize``, wherever they lie.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

ISOLATED = ("verify",)
"""The commands that are started again."""

_ROOT = Path(__file__).resolve().parents[2]
_START = """
import sys
import site
site.execsitecustomize = site.execusercustomize = lambda: None
site.main()
root = sys.argv.pop(1)
sys.path.insert(0, root)
import gspot_verified
sys.path.remove(root)
sys.path.append(root)
from gspot_verified.__main__ import run
run()
"""


def is_isolated() -> bool:
    """Whether Python runs as :func:`command` starts it."""
    return bool(sys.flags.isolated and sys.flags.no_site)


def command(words: Sequence[str]) -> list[str]:
    """How the command line is started again.

    >>> command(["verify", "--full"])[1:3]
    ['-IS', '-c']
    """
    return [sys.executable, "-IS", "-c", _START, str(_ROOT), *words]


def isolate(words: Sequence[str]) -> None:
    """Go on in an isolated Python, where the command asks for it and this one is not; then this does not return."""
    if is_isolated() or next((word for word in words if not word.startswith("-")), "") not in ISOLATED:
        return
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    os.execve(sys.executable, command(words), clean)
