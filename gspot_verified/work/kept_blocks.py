"""Many blocks of bytes in little memory: beyond some of it they stand in a file without a name."""

from __future__ import annotations

import os
import tempfile
import weakref
from array import array
from collections.abc import Sequence
from typing import IO, overload

_IN_MEMORY = 2**22  # bytes, before they are moved


class KeptBlocks(Sequence[bytes]):
    """Blocks, each read when it is asked for: in memory is where they end, and the last ones.

    Where no file can be written (a full disk) they stay in memory.

    >>> blocks = KeptBlocks()
    >>> blocks.append(b"one")
    >>> blocks.append(b"")
    >>> list(blocks)
    [b'one', b'']
    """

    def __init__(self) -> None:
        self._file: IO[bytes] | None = None
        self._ends = array("q", [0])
        self._here: list[bytes] = []
        self._moves = True

    def __len__(self) -> int:
        return len(self._ends) - 1

    @overload
    def __getitem__(self, index: int) -> bytes: ...
    @overload
    def __getitem__(self, index: slice) -> list[bytes]: ...
    def __getitem__(self, index: int | slice) -> bytes | list[bytes]:
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        number = range(len(self))[index]
        moved = len(self) - len(self._here)
        if number >= moved:
            return self._here[number - moved]
        assert self._file is not None
        start, end = self._ends[number], self._ends[number + 1]
        data = os.pread(self._file.fileno(), end - start, start)
        if len(data) != end - start:
            raise OSError(f"a temporary file was cut short: {len(data)} bytes of {end - start} are left of a block")
        return data

    def append(self, data: bytes) -> None:
        """One block more."""
        self._here.append(data)
        self._ends.append(self._ends[-1] + len(data))
        if self._moves and self._ends[-1] - self._ends[len(self) - len(self._here)] >= _IN_MEMORY:
            self._move()

    def _move(self) -> None:
        """All blocks to the file; where one cannot be written, what is in memory stays there from now on."""
        try:
            if self._file is None:
                self._file = tempfile.TemporaryFile(buffering=0)  # noqa: SIM115  closed with this object
                weakref.finalize(self, self._file.close)
            place, data = self._ends[len(self) - len(self._here)], b"".join(self._here)
            while data:
                written = os.pwrite(self._file.fileno(), data, place)
                place, data = place + written, data[written:]
        except OSError:
            self._moves = False
        else:
            self._here.clear()
