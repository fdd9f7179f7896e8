"""The work of a sweep in portions: each goes to an executor by itself, and the tubes that it met are kept in a journal.

A journal holds choices: every piece is proved again along them, and a digest says whether it is what it was.
Portions depend on the question alone, so the pieces are the same for every executor and after every kill.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, fields
from functools import lru_cache, partial
from itertools import zip_longest
from pathlib import Path
from typing import Any

from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep.sweep_cell import Cell, Examination
from gspot_verified.mechanisms.sweep.sweep_findings import equations
from gspot_verified.mechanisms.sweep.sweep_grid import Grid
from gspot_verified.mechanisms.sweep.sweep_piece import SweepPiece
from gspot_verified.mechanisms.sweep.sweep_trace import Choice, read_choice
from gspot_verified.mechanisms.zeros.tube import Equations
from gspot_verified.work.executors import InProcessExecutor
from gspot_verified.work.journal_file import JournalFile

_PORTION = 32  # cells of one task, and of one line of the journal
_VERSION = 2  # of the journal's form, which its first line names

Pieces = list[list[SweepPiece]]
"""The pieces of each cell of a portion."""
Choices = list[list[Choice]]
"""The tubes that each cell of a portion met."""


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
        whole = hashlib.sha256(_whole(self.mechanism).encode()).hexdigest()
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


def _whole(mechanism: Mechanism) -> str:
    """All that the mechanism is, as text, without its drawing; its own ``repr`` is short."""
    own = [each.name for each in fields(mechanism) if each.compare]
    return f"Mechanism({', '.join(f'{name}={getattr(mechanism, name)!r}' for name in own)})"


@lru_cache(maxsize=4)
def _equations(mechanism: Mechanism, parameters: tuple[str, ...], fixed: tuple[str, ...]) -> Equations:
    return equations(parametric_system(mechanism, parameters, fixed))


def portions(cells: Sequence[Cell]) -> list[list[Cell]]:
    """The cells in runs of a fixed length."""
    return [list(cells[i : i + _PORTION]) for i in range(0, len(cells), _PORTION)]


def examine(question: Question, cells: Sequence[Cell], known: Choices | None = None) -> tuple[Pieces, Choices]:
    """The pieces of some cells, and their tubes as choices, of which ``known`` ones are tried first; it pickles, and so
    do its arguments and its answer."""
    examination = Examination(question.equations(), question.digits)
    pieces, choices = [], []
    for cell, tubes in zip_longest(cells, (known or [])[: len(cells)], fillvalue=None):
        assert cell is not None
        pieces.append(examination.pieces(cell, tubes or ()))
        choices.append(examination.kept_tubes.met)
    return pieces, choices


def proved_again(question: Question, cells: Sequence[Cell], known: Choices, expected: str) -> tuple[Pieces, Choices]:
    """The examination along known tubes; without them where other pieces come out than those of the digest."""
    examined = examine(question, cells, known)
    return examined if digest(examined[0]) == expected else examine(question, cells)


def digest(pieces: Pieces) -> str:
    """A hash of all that the pieces say."""
    text = json.dumps([[piece.to_json() for piece in cell] for cell in pieces], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def results(
    question: Question, work: Sequence[Sequence[Cell]], executor: Executor, journal: JournalFile | None, first: int = 0
) -> Iterator[Pieces]:
    """The answers of the portions, in order; those that the journal holds are proved again along its choices.

    ``first``: the number of the first portion, where others have come before.

    :raises ValueError: a line of the journal cannot be read.
    """
    known = {} if journal is None else _recalled(journal)
    answers: list[Callable[[], tuple[Pieces, Choices]]] = []
    for number, cells in enumerate(work, first):
        task = partial(examine, question, list(cells))
        if number in known:
            expected, tubes = known[number]
            task = partial(proved_again, question, list(cells), tubes, expected)
        # Not before its turn in this process: what is recorded is then all that was done, also after a kill.
        answers.append(task if isinstance(executor, InProcessExecutor) else executor.submit(task).result)
    for number, answer in enumerate(answers, first):
        pieces, choices = answer()
        if journal is not None and (number not in known or known[number][0] != digest(pieces)):
            journal.add([number, digest(pieces), choices])
        yield pieces


def open_journal(
    path: str | Path | None, question: Question, start: Sequence[Any], spot: Mapping[str, str]
) -> AbstractContextManager[JournalFile | None]:
    """The journal in the file, to be closed by ``with``; None where there is no file.

    :raises ValueError: the file belongs to another question or other sources, or another run uses it.
    """
    return nullcontext() if path is None else JournalFile(path, question.header(start, spot))


def _recalled(journal: JournalFile) -> dict[int, tuple[str, Choices]]:
    """Of each portion the digest and the choices."""
    recalled: dict[int, tuple[str, Choices]] = {}
    for line in journal.lines:
        try:
            number, expected, data = json.loads(line)
            if type(number) is not int:
                raise ValueError("a portion has a number")
            recalled[number] = str(expected), [[read_choice(tube) for tube in cell] for cell in data]
        except (ValueError, TypeError, KeyError, IndexError, RecursionError) as error:
            raise ValueError(f"{journal.path}: a line of the journal cannot be read: {error}") from None
    return recalled
