"""What is said of ranges of β while they are examined, cut and settled."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from gspot_verified.cli.app import counted
from gspot_verified.numbers.counted import counted as number_of

if TYPE_CHECKING:
    from gspot_verified.signs.cover.subdivision import Progress


class RangesProgress:
    """Told each step of a subdivision, or of several one after the other. ``where`` follows the number of ranges."""

    def __init__(self, where: str = "", tubes: bool = False) -> None:
        self._where, self._tubes = where, tubes
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
        text = f"{ranges} examined{self._where}, {step.finished} settled, {step.waiting} waiting"
        counted(text + tubes, step.examined, self._settled / self._cells, said)

    def _add(self, step: Progress) -> None:
        """The settled share: a range that was cut d times counts 2^-d of the cell that it comes from."""
        from gspot_verified.signs.cover.subdivision import State

        if step.examined == 1:  # the cells: those that wait and this one, which two halves replace if it was cut
            cut = step.node.state is State.SPLIT
            self._settled, self._cells = 0.0, step.waiting - 1 if cut else step.waiting + 1
        if step.node.state is State.SETTLED:
            self._settled += 0.5**step.node.depth
