"""A hash of the package's code and of the version of FLINT below it: what other code left in a file is not its own."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path

import flint

_PACKAGE = Path(__file__).resolve().parents[1]


@lru_cache(maxsize=1)
def source_key() -> str:
    """The hash, of the files as they are when this process first asks.

    >>> len(source_key())
    64
    """
    found = hashlib.sha256(f"{flint.__FLINT_VERSION__}\0".encode())
    for path in sorted(_PACKAGE.rglob("*.py")):
        found.update(f"{path.relative_to(_PACKAGE).as_posix()}\0".encode() + path.read_bytes())
    return found.hexdigest()
