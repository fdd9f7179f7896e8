"""A journal of examinations, one line each, so that long work goes on after a kill.

The first line says for which question the journal is. A line that a kill cut short is dropped on the next start.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.balls import exact
from gspot_verified.signs.pieces import Column, Kind, Piece

Answer = Column | tuple[fmpq, fmpq] | None


class Journal:
    """Examinations of one question, kept in a file.

    :raises ValueError: the file belongs to another question, or is no journal.
    """

    def __init__(self, path: Path, question: dict[str, Any]) -> None:
        self._path = path
        self._known: dict[tuple[str, str], Answer] = {}
        header = json.dumps({"journal": question}, sort_keys=True)
        data = path.read_bytes() if path.exists() else b""
        # A kill may leave a line without its line feed: what follows the last line feed is dropped.
        whole = data[: data.rfind(b"\n") + 1]
        lines = whole.decode(errors="replace").split("\n")[:-1]
        if lines[0] != header if lines else not header.encode().startswith(data):
            raise ValueError(f"{path} is not a journal of this question; choose another file or remove it")
        for line in lines[1:]:
            lower, upper, answer = _read(line, path)
            self._known[lower, upper] = answer
        with path.open("r+b" if data else "wb") as file:
            file.truncate(len(whole))
            if not lines:
                file.write(f"{header}\n".encode())

    def knows(self, lower: fmpq | None, upper: fmpq) -> bool:
        """Whether the range was examined before."""
        return (str(lower), str(upper)) in self._known

    def recall(self, lower: fmpq | None, upper: fmpq) -> Answer:
        """What was found for a range that is known."""
        return self._known[str(lower), str(upper)]

    def add(self, lower: fmpq | None, upper: fmpq, answer: Answer) -> None:
        """Keep one examination; it is in the file when this returns."""
        if self.knows(lower, upper):
            return
        self._known[str(lower), str(upper)] = answer
        with self._path.open("a", encoding="utf-8") as file:
            file.write(json.dumps([str(lower), str(upper), _to_json(answer)]) + "\n")


def _to_json(answer: Answer) -> Any:
    if isinstance(answer, Column):
        ends = [None if answer.lower is None else str(answer.lower), str(answer.upper)]
        return {"column": ends, "pieces": [_piece_to_json(piece) for piece in answer.pieces]}
    return None if answer is None else {"witness": [str(value) for value in answer]}


def _piece_to_json(piece: Piece) -> list[Any]:
    ends = [None if end is None else str(end) for end in (piece.lower, piece.upper)]
    return [piece.kind.value, *ends, piece.mark]


def _read(line: str, path: Path) -> tuple[str, str, Answer]:
    try:
        lower, upper, data = json.loads(line)
        answer: Answer = None
        if data is not None and "witness" in data:
            first, second = data["witness"]
            answer = (_rational(first), _rational(second))
        elif data is not None:
            pieces = tuple(
                Piece(Kind(kind), None if a is None else _rational(a), None if b is None else _rational(b), int(mark))
                for kind, a, b, mark in data["pieces"]
            )
            left, right = data["column"]
            answer = Column(None if left is None else _rational(left), _rational(right), pieces)
            if (str(answer.lower), str(answer.upper)) != (lower, upper):
                raise ValueError("the column is not over the range that was examined")
        if not (isinstance(lower, str) and isinstance(upper, str)):
            raise ValueError("the ends of a range must be texts")
    except (ValueError, TypeError, KeyError) as error:
        raise ValueError(f"{path}: a line of the journal cannot be read: {error}") from None
    return lower, upper, answer


def _rational(text: str) -> fmpq:
    value = exact(text, "journal")
    assert isinstance(value, fmpq)
    return value
