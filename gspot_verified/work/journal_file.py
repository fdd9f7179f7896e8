"""A file of lines that long work appends to and reads again after a kill. Its first line says for which question, and
by which sources. One run at a time holds it.

A line that a kill cut short is dropped on the next start. Nothing here is proved: who reads a line checks what it says.
Where the file cannot be written (a full disk) it is left as it is, and the work goes on without it.

The sources are known by a hash of the package's code and of the version of FLINT below it: what other code left in a
file is not its own.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
import warnings
import weakref
from array import array
from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path
from types import TracebackType
from typing import Any, Self, overload

import flint

_PACKAGE = Path(__file__).resolve().parents[1]


@lru_cache(maxsize=1)
def source_key() -> str:
    """The hash, of the files as they are when this process first asks.

    >>> len(source_key())
    64
    """
    digest = hashlib.sha256(f"{flint.__FLINT_VERSION__}\0".encode())
    for path in sorted(_PACKAGE.rglob("*.py")):
        digest.update(f"{path.relative_to(_PACKAGE).as_posix()}\0".encode() + path.read_bytes())
    return digest.hexdigest()


class JournalWarning(UserWarning):
    """A journal could not be written: the result stands, but a killed run would not go on after what is in the file."""


def _warn(text: str) -> None:
    warnings.warn(JournalWarning(text), stacklevel=2)


class LinesInFile(Sequence[str]):
    """Lines of a file, each read when it is asked for: in memory is where they end."""

    def __init__(self, descriptor: int, start: int) -> None:
        self._descriptor = descriptor
        self._ends = array("q", [start])

    def __len__(self) -> int:
        return len(self._ends) - 1

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> list[str]: ...
    def __getitem__(self, index: int | slice) -> str | list[str]:
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        number = range(len(self))[index]
        start, end = self._ends[number], self._ends[number + 1]
        return os.pread(self._descriptor, end - start, start).decode(errors="replace").removesuffix("\n")

    @property
    def end(self) -> int:
        """Where the last line ends in the file."""
        return self._ends[-1]

    def append(self, length: int) -> None:
        """One line more, of so many bytes with its line feed."""
        self._ends.append(self.end + length)

    def cut(self, count: int) -> None:
        """The first lines only."""
        del self._ends[count + 1 :]


class JournalFile:
    """The lines that are there (``lines``, each JSON), and a way to add one.

    The system's lock on the file ends with :meth:`close`, with this object, or with the process, even a killed one.

    :param tell: is told once, in words that name the file, when it can be written no more; else a
        :class:`JournalWarning` says it.
    :raises ValueError: the file belongs to another question or to other sources, is no journal, or another run uses it.
    :raises OSError: it cannot be opened, or its file system has no locks.
    """

    def __init__(self, path: str | Path, question: dict[str, Any], tell: Callable[[str], object] = _warn) -> None:
        self.path = path = Path(path)
        self._tell = tell
        self._dropped = False
        self._descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_NONBLOCK, 0o666)
        self._close = weakref.finalize(self, os.close, self._descriptor)
        try:
            self._begin({"journal": question, "sources": source_key()})
        except BaseException:
            self.close()
            raise

    def _begin(self, asked: dict[str, Any]) -> None:
        if not stat.S_ISREG(os.fstat(self._descriptor).st_mode):
            raise ValueError(f"{self.path} is not a journal of this question: it is not a file")
        _lock(self._descriptor, self.path)
        self._header = f"{json.dumps(asked, sort_keys=True)}\n".encode()
        with open(self._descriptor, "rb", closefd=False) as file:
            first = file.readline(2 * len(self._header))  # no more of a file that is something else
            if first != self._header and not (self._header.startswith(first) and not file.read(1)):
                other = _differences(first, asked)
                raise ValueError(
                    f"{self.path} is not a journal of this question{other}; choose another file or remove it"
                )
            self.lines = LinesInFile(self._descriptor, len(self._header))
            # A kill may leave a line without its line feed: what follows the last line feed is dropped.
            for line in file if first == self._header else ():
                if line.endswith(b"\n"):
                    self.lines.append(len(line))
        if first == self._header:
            os.ftruncate(self._descriptor, self.lines.end)
        else:
            os.ftruncate(self._descriptor, 0)
            self._write(self._header)

    def add(self, data: Any) -> bool:
        """Keep one line: whether it is in the file when this returns."""
        return self.add_text(json.dumps(data))

    def add_text(self, text: str) -> bool:
        """The same for JSON that was made elsewhere, in one line."""
        line = f"{text}\n".encode()
        if not self._write(line):
            return False
        self.lines.append(len(line))
        return True

    def cut(self, count: int) -> None:
        """Drop all lines but the first ones."""
        self.lines.cut(count)
        os.ftruncate(self._descriptor, self.lines.end)

    def close(self) -> None:
        """Let another run have the file."""
        try:
            self._close()
        except OSError as error:  # a file system may write late, and say so here
            self._drop(error)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    def _write(self, data: bytes) -> bool:
        try:
            while data and not self._dropped:
                data = data[os.write(self._descriptor, data) :]
        except OSError as error:
            self._drop(error)
        return not self._dropped

    def _drop(self, error: OSError) -> None:
        self._dropped = True
        self._tell(f"the journal {self.path} could not be written: {error}; the run went on without it")


def _lock(descriptor: int, path: Path) -> None:
    import fcntl

    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise ValueError(f"{path}: another run uses this journal; wait for its end or choose another file") from None


def _differences(header: bytes, asked: dict[str, Any]) -> str:
    """In which parts the question of another journal differs, in words; nothing where the file is no journal."""
    try:
        other = json.loads(header)
        known = json.loads(json.dumps(asked))
        parts = sorted(key for key in {*other["journal"], *known["journal"]}
                       if other["journal"].get(key) != known["journal"].get(key))  # fmt: skip
        if other.get("sources") != known["sources"]:
            parts.append("the sources of this package")
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return ""
    return f" (it differs in: {', '.join(parts)[:200]})"
