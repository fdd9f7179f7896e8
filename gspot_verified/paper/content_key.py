"""What the result of a check can depend on, as one hash: code, data, proofs, Python, every installed distribution.

The key is strict: a change of a comment makes another key. Two runs with one key ran the same bytes of this package and
of ``proofs/``, under the same interpreter, which began with the same files, beside distributions of the same versions,
lists of contents, sizes and times of change, with the modules that compute taken from the same places.
"""

from __future__ import annotations

import hashlib
import importlib.util
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
CHECKER = Path(sys.prefix) / "share" / "gspot_verified" / "checker"
"""Where an installation puts the checker; the source tree has it in ``proofs/``."""
SOURCES = (PACKAGE, PROOFS, CHECKER)
MODULES = ("hypothesis", "mpmath", "numpy", "scipy", "sympy")
"""What results are computed with, beside FLINT. Python may find one where no distribution put it."""
LIBRARY_PATHS = ("LD_LIBRARY_PATH", "LD_PRELOAD", "DYLD_LIBRARY_PATH", "DYLD_INSERT_LIBRARIES")
"""Variables of the environment that may bring another FLINT."""
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
        "modules": {name: list(module_files(name)) for name in (flint.__name__, *MODULES)},
        "libraries": [os.environ.get(name, "") for name in LIBRARY_PATHS],
        "FLINT": flint.__FLINT_VERSION__,
        "startup": startup(),
        "python": [sys.version, sys.executable, *map(str, sys.flags)],
        "machine": [platform.platform(), platform.machine(), sys.byteorder],
    }


@lru_cache(maxsize=1)
def startup() -> list[list[str]]:
    """What acts on Python before any program: the hashes of ``.pth`` files, ``sitecustomize`` and ``usercustomize``.

    ``verify`` runs without the last two (``cli/main.py``); other programs may have them.
    """
    paths = [file for folder in sys.path for file in sorted(Path(folder).glob("*.pth"))]
    for name in ("sitecustomize", "usercustomize"):
        place = getattr(sys.modules.get(name), "__file__", None)
        paths += [Path(place)] if place else []
    return [[str(path), hashlib.sha256(path.read_bytes()).hexdigest()] for path in paths]


@lru_cache(maxsize=1)
def distributions() -> list[list[Any]]:
    """Every installed distribution, as it was when this process first asked."""
    return sorted(_distribution(found) for found in metadata.distributions())


@lru_cache(maxsize=len(MODULES) + 1)
def module_files(name: str) -> tuple[str, str]:
    """Where Python finds a module, and the hash of the sizes and times of change of its files; empty: nowhere."""
    found = importlib.util.find_spec(name)
    if found is None:
        return "", ""
    places = [Path(place) for place in found.submodule_search_locations or (found.origin or "",)]
    files = sorted(map(str, source_files(places)))
    return found.origin or "", _hash(_canonical([(file, _stamp(file)) for file in files]))


def source_files(sources: Iterable[Path] = SOURCES) -> Iterator[Path]:
    """Every file of the folders, also behind links, but for what Python compiled; and the files themselves."""
    for place in sources:
        if place.is_file():
            yield place
        for folder, names, files in os.walk(place, followlinks=True):
            names[:] = [name for name in names if name != "__pycache__"]
            yield from (Path(folder) / name for name in files if not name.endswith(".pyc"))


def newest_change(sources: Sequence[Path] = SOURCES) -> float:
    """When a file of the sources was last changed, or put in its place; a copy with an old date does not hide it."""
    return max((path.stat().st_ctime for path in source_files(sources)), default=0.0)


def source_state(sources: Sequence[Path] = SOURCES) -> str:
    """A hash that another file in its place, a change, a new file and a removed one alter, whatever the clock says."""
    found = ((str(path), path.stat()) for path in source_files(sources))
    stamps = [(name, at.st_dev, at.st_ino, at.st_size, at.st_mtime_ns, at.st_ctime_ns) for name, at in found]
    return _hash(_canonical(sorted(stamps)))


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
