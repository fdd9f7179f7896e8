"""A journal of the steps of a certified run: what was chosen for each, so that an interrupted run goes on.

Nothing that was proved is kept: each step is proved again on the way, in about half of the time that finding it took
(nine tenths where steps are easily found). So a journal that somebody changed cannot make an answer wrong. A digest at
each line tells a damaged one.
"""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path
from typing import Any

from gspot_verified.work.journal_file import JournalFile

FORMAT = 1  # of the lines; another one is not read
_DIGEST_LENGTH = 16  # hexadecimal digits, 64 bits: against damage, not against intent


class StepJournal:
    """The lines of one certified run, in order: ``lines``. ``notes``: why no more could be written, if that happened.

    :raises ValueError: the file belongs to another run, is no journal, or a line is damaged.
    :raises OSError: the file cannot be opened.
    """

    def __init__(self, path: str | Path, asked: dict[str, Any]) -> None:
        self.notes: list[str] = []
        self._file = JournalFile(path, asked, self.notes.append)
        self._last = ""
        self.lines = [self._read(number, line) for number, line in enumerate(self._file.lines, 2)]

    def _read(self, number: int, line: str) -> dict[str, Any]:
        try:
            digest, data = json.loads(line)
            whole = digest == self._digest(data)
        except (ValueError, TypeError, RecursionError):
            whole = False
        if not whole or not isinstance(data, dict):
            raise ValueError(
                f"{self._file.path}: line {number} of the journal is damaged; remove it and those after it, or the file"
            )
        self._last = digest
        return data

    def _digest(self, data: Any) -> str:
        """Of a line and, through the digest of the one before, of all lines before it."""
        return sha256(f"{self._last}{json.dumps(data, sort_keys=True)}".encode()).hexdigest()[:_DIGEST_LENGTH]

    def add(self, data: dict[str, Any]) -> None:
        """Keep one line; where the disk is full what is there stays, and no more is written."""
        digest = self._digest(data)
        if self._file.add([digest, data]):
            self._last = digest
            self.lines.append(data)

    def cut(self, count: int) -> None:
        """Drop all lines but the first ones."""
        self._file.cut(count)
        self._last = "" if count == 0 else json.loads(self._file.lines[-1])[0]
        del self.lines[count:]
