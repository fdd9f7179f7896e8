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
            other = _differences(lines[0], question) if lines else ""
            raise ValueError(f"{path} is not a journal of this question{other}; choose another file or remove it")
        self._header = header
        self.lines = lines[1:]
        with path.open("r+b" if data else "wb") as file:
            file.truncate(len(whole))
            if not lines:
                file.write(f"{header}\n".encode())

    def add(self, data: Any) -> None:
        """Keep one line; it is in the file when this returns."""
        with self.path.open("a", encoding="utf-8") as file:
            line = json.dumps(data)
            file.write(f"{line}\n")
        self.lines.append(line)

    def cut(self, count: int) -> None:
        """Drop all lines but the first ones."""
        del self.lines[count:]
        with self.path.open("r+b") as file:
            file.truncate(sum(len(line.encode()) + 1 for line in (self._header, *self.lines)))


def _differences(header: str, question: dict[str, Any]) -> str:
    """In which parts the question of another journal differs, in words; nothing where the file is no journal."""
    try:
        other = json.loads(header)["journal"]
        known = json.loads(json.dumps(question))
        parts = sorted(key for key in {*other, *known} if other.get(key) != known.get(key))
    except (ValueError, TypeError, KeyError, AttributeError):
        return ""
    return f" (it differs in: {', '.join(parts)[:200]})"
