"""The work of a sweep over states: blocks of cells, each divided until its parts have one fate, and kept in a journal.

A journal holds choices, which boxes were divided; every fate is proved again along them, and a digest says whether all
is what it was.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from flint import fmpq

from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.fates.fate_piece import OPEN, FatePiece, StartBox
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.prepared import Prepared, prepared
from gspot_verified.mechanisms.fates.starts import Starts
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_work import whole_text
from gspot_verified.numbers.balls import working_bits
from gspot_verified.work.journal_file import JournalFile

BITS = 53  # working precision: any is correct, the sets are wide
_VERSION = 1  # of the journal's form, which its first line names


@dataclass(frozen=True, slots=True)
class FateQuestion:
    """What is swept: the mechanism, with a place at its G-spot; the components of the state that do not vary, as texts;
    the surface's velocity."""

    mechanism: Mechanism
    given: tuple[tuple[str, str], ...]
    grid: Grid
    surface: fmpq

    def header(self) -> dict[str, Any]:
        """What a journal's first line says."""
        return {
            "kind": f"fates {_VERSION}",
            "mechanism": hashlib.sha256(whole_text(self.mechanism).encode()).hexdigest(),
            "from": [list(pair) for pair in self.given],
            "over": [str(axis) for axis in self.grid.axes],
            "surface_velocity": str(self.surface),
        }

    @property
    def sides(self) -> tuple[fmpq, ...]:
        """Those of a cell."""
        return tuple((axis.upper - axis.lower) / axis.cells for axis in self.grid.axes)

    def check(self) -> None:
        """Says what is wrong with the state or the mechanism, before any work.

        :raises MechanismError: the flow is not planar, or the state is none.
        """
        with working_bits(BITS):
            shifted = shift(self.mechanism)
            Starts(shifted, dict(self.given), [axis.name for axis in self.grid.axes])
            PlanarFlow(shifted)

    def prepared(self) -> Prepared:
        """Compiled once in each process."""
        return _prepared(self.mechanism, self.given, self.grid.axes, self.surface)


@lru_cache(maxsize=4)
def _prepared(
    mechanism: Mechanism, given: tuple[tuple[str, str], ...], axes: tuple[Axis, ...], surface: fmpq
) -> Prepared:
    with working_bits(BITS):
        shifted = shift(mechanism)
        starts = Starts(shifted, dict(given), [axis.name for axis in axes])
        return prepared(shifted, starts, axes, surface)


class FateAnswer(NamedTuple):
    """What a block of cells gave: it pickles. ``choices`` is JSON: of each box in turn whether it was divided."""

    pieces: list[FatePiece]
    digest: str
    choices: str


def examine(question: FateQuestion, boxes: Sequence[StartBox], known: str = "") -> FateAnswer:
    """The pieces of some boxes, each divided until it has one fate or is a cell or less. ``known``: which boxes were
    divided before, 1 or 0 in turn; those are not asked for their fate."""
    here, met, recalled = question.prepared(), list[str](), iter(known)

    def parts(box: StartBox) -> Iterator[FatePiece]:
        skipped = next(recalled, "0") == "1" and not box.small
        found = None if skipped else here.fate(box.lower, box.upper)
        divided = found is None or (found.fate in OPEN and not box.small)
        met.append("1" if divided else "0")
        if found is not None and not divided:
            yield FatePiece(box.lower, box.upper, found.fate, found.why)
            return
        for half in box.halves(question.sides):
            yield from parts(half)

    with working_bits(BITS):
        pieces = [piece for box in boxes for piece in parts(box)]
    return FateAnswer(pieces, digest(pieces), json.dumps("".join(met)))


def proved_again(question: FateQuestion, boxes: Sequence[StartBox], line: str) -> FateAnswer:
    """The examination along a journal's line; without it where other pieces come out than those of its digest."""
    _, expected, known = read_line(line)
    examined = examine(question, boxes, known)
    return examined if examined.digest == expected else examine(question, boxes)


def digest(pieces: Sequence[FatePiece]) -> str:
    """A hash of all that the pieces say."""
    text = json.dumps([piece.to_json() for piece in pieces], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def open_journal(path: str | Path | None, question: FateQuestion) -> AbstractContextManager[JournalFile | None]:
    """The journal in the file, to be closed by ``with``; None where there is no file.

    :raises ValueError: the file belongs to another question or other sources, or another run uses it.
    """
    return nullcontext() if path is None else JournalFile(path, question.header())


def read_line(line: str) -> tuple[int, str, str]:
    """The number of the portion, the digest and the choices."""
    number, expected, known = json.loads(line)
    if type(number) is not int or not isinstance(known, str) or set(known) - {"0", "1"}:
        raise ValueError("a portion has a number, a digest, and 0 or 1 for each box")
    return number, str(expected), known
