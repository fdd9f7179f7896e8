"""Compiled files that Python would run in the place of a source that has changed: the key would be of other code.

Python takes a compiled file for that of every source with the same size and the same second of change, or, where it was
made so, without a look at the source.
"""

from __future__ import annotations

import importlib.util
import marshal
from collections.abc import Iterable
from pathlib import Path

_HEADER = 16
_HASHED, _CHECKED = 1, 2
_SECONDS = 2
"""A compiled file that is so much younger than the last change of its source was made from what the source holds."""


def stale_bytecode(files: Iterable[Path]) -> Path | None:
    """The first of these sources that Python would not run as it is; None: there is none."""
    return next((file for file in files if file.suffix == ".py" and _is_stale(file)), None)


def _is_stale(source: Path) -> bool:
    compiled = Path(importlib.util.cache_from_source(str(source)))
    try:
        data, made, now = compiled.read_bytes(), compiled.stat(), source.stat()
    except OSError:
        return False
    words = [int.from_bytes(data[i : i + 4], "little") for i in range(4, _HEADER, 4)]
    flags, second, size = words
    if data[:4] != importlib.util.MAGIC_NUMBER:
        return False
    if flags & _HASHED:
        return not flags & _CHECKED and data[8:_HEADER] != importlib.util.source_hash(source.read_bytes())
    if (second, size) != (int(now.st_mtime) % 2**32, now.st_size % 2**32):
        return False
    return made.st_mtime <= now.st_ctime + _SECONDS and not _is_code_of(data[_HEADER:], source)


def _is_code_of(compiled: bytes, source: Path) -> bool:
    try:
        code = compile(source.read_bytes(), str(source), "exec", dont_inherit=True)
        return bool(marshal.loads(compiled) == code)
    except (SyntaxError, ValueError, EOFError, TypeError):
        return False
