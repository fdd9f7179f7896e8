"""A journal of examinations, one line each, so that long work goes on after a kill.

What it recalls is a choice and no proof: which ranges to cut, and along which pieces to prove a column again.
"""

from __future__ import annotations

import json
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from flint import fmpq

from gspot_verified.numbers.balls import exact
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.work.journal_file import JournalFile

Answer = Column | tuple[fmpq, fmpq] | None


class Journal:
    """Examinations of one question, kept in a file; of several of one range the last one.

    :raises ValueError: the file belongs to another question or other sources, is no journal, or another run uses it.
    """

    def __init__(self, path: str | Path, question: dict[str, Any]) -> None:
        self._known: dict[tuple[str, str], Answer] = {}
        self._file = JournalFile(path, question)
        try:
            for line in self._file.lines:
                lower, upper, answer = _read(line, path)
                self._known[lower, upper] = answer
        except ValueError:
            self._file.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._file.close()

    def knows(self, lower: fmpq | None, upper: fmpq) -> bool:
        """Whether the range was examined before."""
        return (str(lower), str(upper)) in self._known

    def recall(self, lower: fmpq | None, upper: fmpq) -> Answer:
        """What the file says was found for a range that is known. Whoever could write the file could write this."""
        return self._known[str(lower), str(upper)]

    def add(self, lower: fmpq | None, upper: fmpq, answer: Answer) -> None:
        """Keep one examination; it is in the file when this returns."""
        if self.knows(lower, upper) and self.recall(lower, upper) == answer:
            return
        self._known[str(lower), str(upper)] = answer
        self._file.add([str(lower), str(upper), _to_json(answer)])


def opened(path: str | Path | None, question: dict[str, Any]) -> AbstractContextManager[Journal | None]:
    """The journal in the file, to be closed by ``with``; None where there is no file."""
    return nullcontext() if path is None else Journal(path, question)


def _to_json(answer: Answer) -> Any:
    if isinstance(answer, Column):
        ends = [None if answer.lower is None else str(answer.lower), str(answer.upper)]
        return {"column": ends, "pieces": [_piece_to_json(piece) for piece in answer.pieces]}
    return None if answer is None else {"witness": [str(value) for value in answer]}


def _piece_to_json(piece: ColumnPiece) -> list[Any]:
    ends = [None if end is None else str(end) for end in (piece.lower, piece.upper)]
    return [piece.kind.value, *ends, piece.mark]


def _read(line: str, path: str | Path) -> tuple[str, str, Answer]:
    try:
        lower, upper, data = json.loads(line)
        answer: Answer = None
        if data is not None and "witness" in data:
            first, second = data["witness"]
            answer = (_rational(first), _rational(second))
        elif data is not None:
            pieces = tuple(
                ColumnPiece(
                    Kind(kind), None if a is None else _rational(a), None if b is None else _rational(b), int(mark)
                )
                for kind, a, b, mark in data["pieces"]
            )
            left, right = data["column"]
            answer = Column(None if left is None else _rational(left), _rational(right), pieces)
            if not pieces:
                raise ValueError("a column has pieces")
            if (str(answer.lower), str(answer.upper)) != (lower, upper):
                raise ValueError("the column is not over the range that was examined")
        if not (isinstance(lower, str) and isinstance(upper, str)):
            raise ValueError("the ends of a range must be texts")
    except (ValueError, TypeError, KeyError, OverflowError, RecursionError) as error:
        raise ValueError(f"{path}: a line of the journal cannot be read: {error}") from None
    return lower, upper, answer


def _rational(text: str) -> fmpq:
    value = exact(text, "journal")
    assert isinstance(value, fmpq)
    return value
