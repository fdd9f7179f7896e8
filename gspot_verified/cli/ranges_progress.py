"""What is said of ranges of β while they are examined, cut and settled."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from gspot_verified.cli.app import counted
from gspot_verified.numbers.counted import counted as number_of

if TYPE_CHECKING:
    from gspot_verified.signs.cover.subdivision import Progress


class RangesProgress:
    """Told each step of a subdivision, or of one for each of so many ``rows`` of ε, one after the other."""

    def __init__(self, tubes: bool = False, rows: int | None = None) -> None:
        self._tubes, self._rows, self._row = tubes, rows, 0
        self._cells, self._settled, self._said = 1, 0.0, 0.0

    def __call__(self, step: Progress) -> None:
        """Said at every tenth range and at the last one, with ``tubes`` whenever a second has passed; at a terminal
        always."""
        self._add(step)
        said = step.examined % 10 == 0 or step.waiting == 0
        tubes, column = "", step.node.column
        if self._tubes:
            said = said or time.monotonic() - self._said >= 1
            if column is not None:
                tubes = f"; β in [{column.lower}, {column.upper}]: {number_of(len(column.tubes()), 'tube')}"
        if said:
            self._said = time.monotonic()
        ranges = number_of(step.examined, "range of β", "ranges of β")
        where = "" if self._rows is None else f" in row {self._row} of {self._rows} of ε"
        text = f"{ranges} examined{where}, {step.finished} settled, {step.waiting} waiting"
        share = (self._row - 1 + self._settled / self._cells) / (self._rows or 1)
        counted(text + tubes, step.examined, share, said)

    def _add(self, step: Progress) -> None:
        """The settled share: a range that was cut d times counts 2^-d of the cell that it comes from."""
        from gspot_verified.signs.cover.subdivision import State

        if step.examined == 1:  # the cells: those that wait and this one, which two halves replace if it was cut
            cut = step.node.state is State.SPLIT
            self._settled, self._cells = 0.0, step.waiting - 1 if cut else step.waiting + 1
            self._row += 1
        if step.node.state is State.SETTLED:
            self._settled += 0.5**step.node.depth
