"""A file of lines that long work appends to and reads again after a kill. Its first line says for which question.

A line that a kill cut short is dropped on the next start.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any


class JournalFile:
    """The lines that are there (``lines``, each JSON), and a way to add one.

    :raises ValueError: the file belongs to another question, or is no journal.
    """

    def __init__(self, path: Path, question: dict[str, Any]) -> None:
        self.path = path
        header = json.dumps({"journal": question}, sort_keys=True)
        data = path.read_bytes() if path.exists() else b""
        # A kill may leave a line without its line feed: what follows the last line feed is dropped.
        whole = data[: data.rfind(b"\n") + 1]
        lines = whole.decode(errors="replace").split("\n")[:-1]
        if lines[0] != header if lines else not header.encode().startswith(data):
            raise ValueError(f"{path} is not a journal of this question; choose another file or remove it")
        self.lines = lines[1:]
        with path.open("r+b" if data else "wb") as file:
            file.truncate(len(whole))
            if not lines:
                file.write(f"{header}\n".encode())

    def add(self, data: Any) -> None:
        """Keep one line; it is in the file when this returns."""
        with self.path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(data) + "\n")
