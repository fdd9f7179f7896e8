"""Results of earlier runs, each kept under the hash of everything that it can depend on.

An entry is in its file when ``keep`` returns, so a run that was killed goes on where it was. What is read again must
carry the same key and its own hash, and its verdict is drawn again from its checks. Whoever can write into the folder
can write a false result there, as into the sources: ``verify --full`` reads none. ``verify`` runs isolated
(``cli/main.py``), under a key of its own: what a changed Python finds is never read by it.
"""

from __future__ import annotations

import hashlib
import importlib.util
import json
import marshal
import os
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Check, Entry, Rung, conclude
from gspot_verified.paper.content_key import (
    PACKAGE,
    SOURCES,
    content_key,
    newest_change,
    process_start,
    source_files,
    source_state,
)

FORMAT = "gspot-verified ledger cache 1"
_CHANGED = "a source file was changed after the program had begun"
_TEXTS = ("identifier", "label", "section", "source", "statement", "corrected", "note", "code")


def default_folder() -> Path:
    """``build/ledger`` of a clone, so that a fresh clone knows nothing; else a folder of the user's caches."""
    if (PACKAGE.parent / "pyproject.toml").is_file():
        return PACKAGE.parent / "build" / "ledger"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "gspot-verified" / "ledger"


class Cache:
    """The results of one state of the sources, below ``folder``; ``read`` False makes every result be found again.

    Neither reads nor keeps anything (``closed`` says why) where a source was changed after this process began, or
    Python would run an older compiled file: what runs may then be older than what lies on the disk. Before each result
    is kept the sources must be as they were at first. It keeps nothing more once a file cannot be written.
    """

    def __init__(self, folder: Path, read: bool = True, sources: Sequence[Path] = SOURCES) -> None:
        self._sources = sources
        self._state = source_state(sources)
        self.key = content_key(sources)
        self.folder = folder
        self._read = read
        self._place = folder / self.key
        self.closed = _CHANGED if newest_change(sources) >= process_start() else _stale(sources)

    def recall(self, identifier: str) -> Entry | None:
        """The entry as it was kept; None where there is none, or its file is not whole."""
        place = self._file(identifier)
        if self.closed or not self._read or not place.is_file():  # to read a pipe or a device would never end
            return None
        try:
            entry = _entry(json.loads(place.read_text(encoding="utf-8")), self.key)
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None
        return entry if entry.identifier == identifier else None

    def keep(self, entry: Entry) -> None:
        """Keep a proved or refuted entry; it is on the disk when this returns. An undecided one is tried again."""
        if not self.closed and source_state(self._sources) != self._state:
            self.closed = _CHANGED
        if self.closed or entry.verdict.outcome is Outcome.UNDECIDED:
            return
        data = _data(entry)
        text = json.dumps({"format": FORMAT, "key": self.key, "entry": data, "sha256": _digest(data)}, sort_keys=True)
        try:
            self._place.mkdir(parents=True, exist_ok=True)
            _write(self._file(entry.identifier), text + "\n")
        except OSError as error:
            self.closed = f"results cannot be kept: {error}"

    def _file(self, identifier: str) -> Path:
        return self._place / f"{hashlib.sha256(identifier.encode()).hexdigest()[:32]}.json"


def _stale(sources: Sequence[Path]) -> str:
    found = stale_bytecode(source_files(sources))
    return "" if found is None else f"Python runs an older form of {found.name}: remove {found.parent / '__pycache__'}"


def _write(place: Path, text: str) -> None:
    """The whole file beside its place, then put there in one step: a kill leaves no half of one."""
    descriptor, draft = tempfile.mkstemp(dir=place.parent, suffix=".tmp")
    try:
        with os.fdopen(descriptor, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        Path(draft).replace(place)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise


def _data(entry: Entry) -> dict[str, Any]:
    texts = {name: getattr(entry, name) for name in _TEXTS}
    return {**texts, "checks": [check.to_json() for check in entry.checks], "verdict": entry.verdict.to_json()}


def _entry(kept: Any, key: str) -> Entry:
    """The entry of a file.

    :raises ValueError: another format or key, a changed text, or a verdict that the checks do not support.
    """
    data = kept["entry"]
    if kept["format"] != FORMAT or kept["key"] != key or kept["sha256"] != _digest(data):
        raise ValueError("not the file of this result")
    checks = tuple(
        Check(Rung[check["rung"].upper()], check["what"], check["agrees"], check["finding"]) for check in data["checks"]
    )
    verdict = conclude(data["statement"], checks)
    if verdict.to_json() != data["verdict"]:
        raise ValueError("its checks do not give its verdict")
    texts: dict[str, Any] = {name: str(data[name]) for name in _TEXTS}
    return Entry(**texts, checks=checks, verdict=verdict, from_cache=True)


def _digest(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()


_HEADER = 16
_HASHED, _CHECKED = 1, 2
_SECONDS = 2
"""A compiled file that is so much younger than the last change of its source was made from what the source holds."""


def stale_bytecode(files: Iterable[Path]) -> Path | None:
    """The first of these sources that Python would not run as it is; None: there is none.

    Python takes a compiled file for that of every source with the same size and the same second of change, or, where it
    was made so, without a look at the source: the key would be of other code.
    """
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
