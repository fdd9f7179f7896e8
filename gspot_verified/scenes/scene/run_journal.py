"""A journal of the pieces of one run, so that a run that was interrupted goes on, to the same result."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.work.journal_file import JournalFile


class RunJournal:
    """``pieces``: those that are kept. ``notes``: why no more could be written, if that happened.

    :raises ValueError: the file belongs to another run, or is no journal.
    """

    def __init__(self, path: str | Path, asked: dict[str, Any]) -> None:
        self.path = Path(path)
        self.notes: list[str] = []
        self._file = JournalFile(path, asked, self.notes.append)
        try:
            self.pieces = [json.loads(line) for line in self._file.lines]
        except (ValueError, RecursionError) as error:
            raise ValueError(f"{path}: a line of the journal cannot be read: {error}") from None

    def add(self, piece: dict[str, Any]) -> None:
        """Keep one piece; where the disk is full what is there stays, and no more is written."""
        self._file.add(piece)


def question(scene: Scene, asked: dict[str, Any]) -> dict[str, Any]:
    """What tells one run from another: the equations of all phases, the start, and how they are solved."""
    systems = {}
    for phase in scene.phases():
        system = scene.system(phase)
        systems[phase] = [system.states, str(system.right_hand_side), str(system.events), str(system.read_out)]
    return {
        "run": scene.name,
        "systems": systems,
        "start": {name: str(value) for name, value in scene.scaled_initial().items()},
        "until": str(scene.until),
        "stop_at_force": str(scene.stop_at_force),
        **asked,
    }
