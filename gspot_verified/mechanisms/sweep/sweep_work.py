"""The work of a sweep in portions: each goes to an executor by itself, and the tubes that it met are kept in a journal.

A journal holds choices: every piece is proved again along them, and a digest says whether it is what it was.
Portions depend on the question alone, so the pieces are the same for every executor and after every kill. What can be
done where a portion is examined is done there: its journal's line, and which of its pieces are linked.
"""

from __future__ import annotations

import hashlib
import json
from array import array
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, fields
from functools import lru_cache, partial
from itertools import zip_longest
from pathlib import Path
from typing import Any, NamedTuple

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep.sweep_cell import BITS, Cell, Examination
from gspot_verified.mechanisms.sweep.sweep_findings import equations
from gspot_verified.mechanisms.sweep.sweep_grid import Grid, GridCells
from gspot_verified.mechanisms.sweep.sweep_links import groups_in_a_row
from gspot_verified.mechanisms.sweep.sweep_piece import SweepPiece
from gspot_verified.mechanisms.sweep.sweep_pieces import Block, packed
from gspot_verified.mechanisms.sweep.sweep_trace import Choice, read_choice
from gspot_verified.mechanisms.zeros.tube import Equations
from gspot_verified.numbers.balls import working_bits
from gspot_verified.work.journal_file import JournalFile
from gspot_verified.work.kept_portions import kept_results

_PORTION = 32  # cells of one task, and of one line of the journal
_MANY, _LONGEST = 4_096, 8  # of so many cells it has twice as many, and so on, up to eight times as many
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
        whole = hashlib.sha256(whole_text(self.mechanism).encode()).hexdigest()
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
        return compiled(self.mechanism, self.parameters, self.fixed)

    def conditions(self) -> BoxProgram:
        """The conditions alone, in the same way."""
        return conditions(self.mechanism, self.parameters, self.fixed)


def whole_text(mechanism: Mechanism) -> str:
    """All that the mechanism is, as text, without its drawing; its own ``repr`` is short."""
    own = [each.name for each in fields(mechanism) if each.compare]
    return f"Mechanism({', '.join(f'{name}={getattr(mechanism, name)!r}' for name in own)})"


@lru_cache(maxsize=4)
def compiled(mechanism: Mechanism, parameters: tuple[str, ...], fixed: tuple[str, ...]) -> Equations:
    """The conditions and quantities as functions of the state and these parameters, compiled once in each process."""
    return equations(parametric_system(mechanism, parameters, fixed))


@lru_cache(maxsize=4)
def conditions(mechanism: Mechanism, parameters: tuple[str, ...], fixed: tuple[str, ...]) -> BoxProgram:
    """The conditions alone, for searches that prove nothing."""
    system = parametric_system(mechanism, parameters, fixed)
    return BoxProgram(system.conditions, system.dimension + len(parameters))


def portions(cells: Sequence[Cell]) -> Iterator[Sequence[Cell]]:
    """The cells in runs of a fixed length, longer ones where there are many cells."""
    size = _PORTION * min(max(len(cells) // _MANY, 1), _LONGEST)
    return (cells[i : i + size] for i in range(0, len(cells), size))


class Answer(NamedTuple):
    """What a portion of cells gave: it pickles."""

    block: Block
    groups: array[int]
    """For each piece, one after the other, a number from 0: those with the same one hold the same spot, continued."""
    digest: str = ""
    choices: str = ""
    """The tubes, as JSON."""


def examine(question: Question, cells: Sequence[Cell], known: Choices | None = None, kept: bool = True) -> Answer:
    """The pieces of some cells, and their tubes as choices, of which ``known`` ones are tried first; it pickles, and so
    do its arguments and its answer. ``kept``: with what a journal keeps."""
    examination = Examination(question.equations(), question.digits, question.mechanism.regularisation.c > 0)
    pieces, choices, boxes = [], [], []
    made = cells.located(question.conditions()) if isinstance(cells, GridCells) else cells
    for cell, tubes in zip_longest(made, (known or [])[: len(cells)], fillvalue=None):
        assert cell is not None
        pieces.append(examination.pieces(cell, tubes or ()))
        choices.append(examination.kept_tubes.met)
        boxes.append((cell.lower, cell.upper))
    with working_bits(BITS):
        groups = groups_in_a_row(question.equations(), pieces)
    block = packed(pieces, boxes if isinstance(cells, GridCells) else ())
    return Answer(block, groups, digest(pieces), json.dumps(choices)) if kept else Answer(block, groups)


def proved_again(question: Question, cells: Sequence[Cell], line: str) -> Answer:
    """The examination along the tubes of a journal's line; without them where other pieces come out than those of its
    digest."""
    _, expected, known = read_line(line)
    examined = examine(question, cells, known)
    return examined if examined.digest == expected else examine(question, cells)


def digest(pieces: Pieces) -> str:
    """A hash of all that the pieces say."""
    text = json.dumps([[piece.to_json() for piece in cell] for cell in pieces], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def results(
    question: Question, work: Iterable[Sequence[Cell]], executor: Executor, journal: JournalFile | None, first: int = 0
) -> Iterator[Answer]:
    """The answers of the portions, in order; those that the journal holds are proved again along its choices.

    ``first``: the number of the first portion, where others have come before.

    :raises ValueError: a line of the journal cannot be read.
    """
    first_time, again = partial(examine, question, kept=journal is not None), partial(proved_again, question)
    yield from kept_results(work, executor, journal, first_time, again, read_line, first)


def open_journal(
    path: str | Path | None, question: Question, start: Sequence[Any], spot: Mapping[str, str]
) -> AbstractContextManager[JournalFile | None]:
    """The journal in the file, to be closed by ``with``; None where there is no file.

    :raises ValueError: the file belongs to another question or other sources, or another run uses it.
    """
    return nullcontext() if path is None else JournalFile(path, question.header(start, spot))


def read_line(line: str) -> tuple[int, str, Choices]:
    """The number of the portion, the digest and the choices."""
    number, expected, data = json.loads(line)
    if type(number) is not int:
        raise ValueError("a portion has a number")
    return number, str(expected), [[read_choice(tube) for tube in cell] for cell in data]
