"""The work of a sweep in portions: each goes to an executor by itself and is kept in a journal when it is done.

Portions depend on the question alone, so the pieces are the same for every executor and after every kill.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from gspot_verified.mechanisms.mechanism import Mechanism
from gspot_verified.mechanisms.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep_cell import Cell, Examination
from gspot_verified.mechanisms.sweep_findings import equations
from gspot_verified.mechanisms.sweep_grid import Grid
from gspot_verified.mechanisms.sweep_piece import SweepPiece
from gspot_verified.mechanisms.tube import Equations
from gspot_verified.signs.executors import InProcessExecutor
from gspot_verified.signs.journal_file import JournalFile

_PORTION = 32
_VERSION = 1

Pieces = list[list[SweepPiece]]
"""The pieces of each cell of a portion."""


@dataclass(frozen=True, slots=True)
class Question:
    """What is swept, and how."""

    mechanism: Mechanism
    grid: Grid
    fixed: tuple[str, ...]
    digits: int

    @property
    def parameters(self) -> tuple[str, ...]:
        """The parameters that vary."""
        return tuple(axis.name for axis in self.grid.axes)

    def header(self, start: Sequence[Any], spot: Mapping[str, str]) -> dict[str, Any]:
        """What a journal's first line says: the mechanism by its hash, the spot at the start."""
        whole = hashlib.sha256(repr(self.mechanism).encode()).hexdigest()
        return {
            "kind": f"sweep {_VERSION}",
            "mechanism": whole,
            "over": [str(axis) for axis in self.grid.axes],
            "fixed": list(self.fixed),
            "start": [str(value) for value in start],
            "spot": dict(spot),
            "digits": self.digits,
        }

    def equations(self) -> Equations:
        """The conditions and quantities, compiled once in each process."""
        return _equations(self.mechanism, self.parameters, self.fixed)


@lru_cache(maxsize=4)
def _equations(mechanism: Mechanism, parameters: tuple[str, ...], fixed: tuple[str, ...]) -> Equations:
    return equations(parametric_system(mechanism, parameters, fixed))


def portions(cells: Sequence[Cell]) -> list[list[Cell]]:
    """The cells in runs of a fixed length."""
    return [list(cells[i : i + _PORTION]) for i in range(0, len(cells), _PORTION)]


def examine(question: Question, cells: Sequence[Cell]) -> Pieces:
    """The pieces of some cells; it pickles, and so do its arguments and its answer."""
    examination = Examination(question.equations(), question.digits)
    return [examination.pieces(cell) for cell in cells]


def results(
    question: Question, work: Sequence[Sequence[Cell]], executor: Executor, journal: JournalFile | None
) -> Iterator[Pieces]:
    """The answers of the portions, in order; those that the journal holds are not computed again.

    :raises ValueError: a line of the journal cannot be read.
    """
    known = {} if journal is None else _recalled(journal)
    answers: list[Callable[[], Pieces]] = []
    for number, cells in enumerate(work):
        if number in known:
            answers.append(partial(known.__getitem__, number))
        elif isinstance(executor, InProcessExecutor):
            # Not before its turn: what is recorded is then all that was done, also after a kill.
            answers.append(partial(examine, question, cells))
        else:
            answers.append(executor.submit(examine, question, list(cells)).result)
    for number, answer in enumerate(answers):
        pieces = answer()
        if journal is not None and number not in known:
            journal.add([number, [[piece.to_json() for piece in cell] for cell in pieces]])
        yield pieces


def open_journal(
    path: Path | None, question: Question, start: Sequence[Any], spot: Mapping[str, str]
) -> JournalFile | None:
    """The journal in the file, or None.

    :raises ValueError: the file belongs to another question.
    """
    return None if path is None else JournalFile(path, question.header(start, spot))


def _recalled(journal: JournalFile) -> dict[int, Pieces]:
    found: dict[int, Pieces] = {}
    for line in journal.lines:
        try:
            number, data = json.loads(line)
            found[int(number)] = [[SweepPiece.from_json(piece) for piece in cell] for cell in data]
        except (ValueError, TypeError, KeyError, IndexError) as error:
            raise ValueError(f"{journal.path}: a line of the journal cannot be read: {error}") from None
    return found
