"""Boxes of initial states, in cells of a grid or parts of one, and their fates."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar, TypeVar

from flint import fmpq

from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.sweep.sweep_grid import Grid
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

OPEN = (Fate.UNDECIDED, Fate.SPOT)
_BLOCK = 16  # cells on a side of what is examined at once: any number is correct


@dataclass(frozen=True, slots=True)
class StartBox:
    """A box of values of the components that vary, of so many cells along each; 1: a cell or a part of one."""

    lower: tuple[fmpq, ...]
    upper: tuple[fmpq, ...]
    cells: tuple[int, ...]

    @property
    def small(self) -> bool:
        """Whether it is one cell, or a part of one."""
        return all(count == 1 for count in self.cells)

    def halves(self, sides: tuple[fmpq, ...]) -> tuple[StartBox, StartBox]:
        """Both parts, cut across the longest side as counted in ``sides``, those of a cell; between cells where there
        are several."""
        lengths = [(high - low) / side for low, high, side in zip(self.lower, self.upper, sides, strict=True)]
        k = max(range(len(lengths)), key=lengths.__getitem__)
        count, first = self.cells[k], max(self.cells[k] // 2, 1)
        cut = self.lower[k] + (self.upper[k] - self.lower[k]) * (fmpq(first, count) if count > 1 else fmpq(1, 2))
        return (
            StartBox(self.lower, _with(self.upper, k, cut), _with(self.cells, k, first)),
            StartBox(_with(self.lower, k, cut), self.upper, _with(self.cells, k, max(count - first, 1))),
        )


_Value = TypeVar("_Value")


def _with(values: tuple[_Value, ...], k: int, value: _Value) -> tuple[_Value, ...]:
    return (*values[:k], value, *values[k + 1 :])


@dataclass(frozen=True, slots=True)
class FatePiece(NoTruthValue, Written):
    """A box of initial states all of which have the fate; ``why``: what kept one that is open from being settled."""

    ask: ClassVar[str] = ".fate is what is certain of every state in it"
    written: ClassVar[str] = "lower upper fate why"

    lower: tuple[fmpq, ...]
    upper: tuple[fmpq, ...]
    fate: Fate
    why: str = ""

    def holds(self, place: tuple[fmpq, ...]) -> bool:
        """Whether the values lie in the (closed) box."""
        return all(low <= value <= high for low, value, high in zip(self.lower, place, self.upper, strict=True))


def blocks(grid: Grid) -> list[StartBox]:
    """The grid in blocks of cells, in order."""
    boxes = [StartBox((), (), ())]
    for axis in grid.axes:
        cuts = [*range(0, axis.cells, _BLOCK), axis.cells]
        boxes = [
            StartBox((*box.lower, axis.cut(i)), (*box.upper, axis.cut(j)), (*box.cells, j - i))
            for box in boxes
            for i, j in pairwise(cuts)
        ]
    return boxes
