"""Parts of a measurement, each kept in a file as it is finished: a run that was interrupted goes on after them."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from gspot_verified.cost.measurement.file import part_of
from gspot_verified.cost.measurement.measurement import Part
from gspot_verified.work.journal_file import JournalFile


class KeptParts:
    """The parts in a file: of one size, on one machine, by one state of the sources and of the programs beside them.

    :raises ValueError: the file belongs to another run, or a part in it is damaged.
    :raises OSError: the file cannot be opened.
    """

    def __init__(self, path: Path, question: dict[str, Any]) -> None:
        self._journal = JournalFile(path, question)
        self._parts: dict[str, Part] = {}
        for number, line in enumerate(self._journal.lines, 2):
            try:
                part = part_of(json.loads(line))
            except ValueError as error:
                raise ValueError(f"{path}: line {number}: {error}; remove it and those after it") from None
            self._parts[part.key] = part

    def find(self, key: str) -> Part | None:
        """The part, if it was finished before."""
        return self._parts.get(key)

    def keep(self, part: Part) -> None:
        """Add a part; it is in the file when this returns."""
        self._journal.add(asdict(part))
        self._parts[part.key] = part

    def remove(self) -> None:
        """Remove the file: the whole measurement is written."""
        self._journal.path.unlink(missing_ok=True)
        self._journal.close()
