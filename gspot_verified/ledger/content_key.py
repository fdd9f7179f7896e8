"""What the result of a check can depend on, as one hash: code, data, proofs, Python, every installed distribution.

The key is strict: a change of a comment makes another key. Two runs with one key ran the same bytes of this package and
of ``proofs/``, under the same interpreter, beside distributions of the same versions, lists of contents, sizes and
times of change.
"""

from __future__ import annotations

import hashlib
import json
import os
import platform
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from importlib import metadata
from pathlib import Path
from typing import Any

PACKAGE = Path(__file__).resolve().parents[1]
PROOFS = PACKAGE.parent / "proofs"
CHECKER = Path(sys.prefix) / "share" / "gspot_verified" / "check.py"
"""Where an installation puts the checker; the source tree has it in ``proofs/``."""
SOURCES = (PACKAGE, PROOFS, CHECKER)
_IMPORTED = time.time()


def content_key(sources: Sequence[Path] = SOURCES) -> str:
    """The hash of everything that a result depends on.

    >>> len(content_key()), content_key() == content_key()
    (64, True)
    """
    return hashlib.sha256(_canonical(ingredients(sources)).encode()).hexdigest()


def ingredients(sources: Sequence[Path] = SOURCES) -> dict[str, Any]:
    """What the key is made of, by name."""
    import flint

    return {
        "sources": {str(path): hashlib.sha256(path.read_bytes()).hexdigest() for path in source_files(sources)},
        "distributions": distributions(),
        "FLINT": flint.__FLINT_VERSION__,
        "python": [sys.version, sys.executable, *map(str, sys.flags)],
        "machine": [platform.platform(), platform.machine(), sys.byteorder],
    }


@lru_cache(maxsize=1)
def distributions() -> list[list[Any]]:
    """Every installed distribution, as it was when this process first asked."""
    return sorted(_distribution(found) for found in metadata.distributions())


def source_files(sources: Iterable[Path] = SOURCES) -> Iterator[Path]:
    """Every file of the folders, but for what Python compiled; and the files themselves."""
    for place in sources:
        if place.is_file():
            yield place
        for folder, names, files in os.walk(place):
            names[:] = [name for name in names if name != "__pycache__"]
            yield from (Path(folder) / name for name in files if not name.endswith(".pyc"))


def newest_change(sources: Sequence[Path] = SOURCES) -> float:
    """When a file of the sources was last changed, or put in its place; a copy with an old date does not hide it."""
    return max((path.stat().st_ctime for path in source_files(sources)), default=0.0)


def process_start() -> float:
    """When this process began, in seconds since 1970; where the system does not tell, when this module was imported."""
    try:
        fields = Path("/proc/self/stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
        age = time.clock_gettime(time.CLOCK_BOOTTIME) - int(fields[19]) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError, IndexError, AttributeError):
        return _IMPORTED
    return min(time.time() - age, _IMPORTED)


def _distribution(found: metadata.Distribution) -> list[Any]:
    """Name, version, the list of its files with their hashes, and of each the size and the time of its last change."""
    record = found.read_text("RECORD") or found.read_text("METADATA") or ""
    files = [found.locate_file(file) for file in found.files or () if file.suffix != ".pyc"]
    stamps = _canonical([_stamp(os.fspath(str(file))) for file in files])
    return [found.metadata["Name"] or "", found.version, *(_hash(text) for text in (record, stamps))]


def _stamp(file: str) -> list[int]:
    try:
        found = os.stat(file)
    except OSError:
        return []
    return [found.st_size, found.st_mtime_ns]


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _canonical(value: Any) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"))
