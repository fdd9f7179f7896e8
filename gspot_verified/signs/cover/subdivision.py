"""Subdivision of a range of beta as an iterator: the whole tree is kept, work goes through an executor.

The tree is the same for every executor: ranges are examined level by level in the order of beta, a range that is not
settled is cut in two, and the examination of a range depends on that range alone.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import partial

from flint import fmpq

from gspot_verified.signs.cover.cuts import middle
from gspot_verified.signs.cover.journal import Journal
from gspot_verified.signs.cover.pieces import Column
from gspot_verified.work.executors import InProcessExecutor

Examine = Callable[..., "Column | tuple[fmpq, fmpq] | None"]
"""Takes the ends of a range, and perhaps a column along which to try first; gives a column, or a witness (tau, beta),
or nothing. It must pickle."""


class State(enum.Enum):
    """What is known of one range."""

    OPEN = "open"
    SETTLED = "settled"
    SPLIT = "split"
    REFUTED = "refuted"
    STUCK = "stuck"


@dataclass(frozen=True, slots=True)
class Node:
    """One range of beta in the tree. ``parent`` is its index, None at the top; ``lower`` is None for minus infinity."""

    lower: fmpq | None
    upper: fmpq
    parent: int | None
    depth: int
    state: State = State.OPEN
    column: Column | None = None
    witness: tuple[fmpq, fmpq] | None = None


@dataclass(frozen=True, slots=True)
class Progress:
    """What the iterator gives after each examination."""

    node: Node
    examined: int
    finished: int
    waiting: int


@dataclass
class Subdivision:
    """Cut ranges of beta in two until ``examine`` settles each one, within ``budget`` examinations.

    ``nodes`` is the whole tree; ``finished`` and ``unfinished`` are read off it at any time. A ``journal`` keeps each
    examination in a file: a new subdivision with the same journal goes on where a killed one stopped. Only choices are
    taken from it: where it says that a range was not settled the range is cut, a column is proved again along its
    pieces, and everything else is examined anew. ``cut`` chooses a point inside a range.
    """

    cells: list[tuple[fmpq | None, fmpq]]
    budget: int
    max_depth: int = 40
    journal: Journal | None = None
    cut: Callable[[fmpq, fmpq], fmpq] = middle
    nodes: list[Node] = field(default_factory=list)
    examined: int = 0

    def __post_init__(self) -> None:
        if type(self.budget) is not int or self.budget < 0:
            raise ValueError("the budget must be a nonnegative int")
        self.nodes = [Node(lower, upper, None, 0) for lower, upper in self.cells]

    @property
    def finished(self) -> list[Column]:
        """The columns that are settled, in the order of beta."""
        columns = [node.column for node in self.nodes if node.column is not None]
        return sorted(columns, key=lambda column: (column.lower is not None, column.lower or 0))

    @property
    def unfinished(self) -> list[tuple[fmpq | None, fmpq]]:
        """The ranges of beta that are open or stuck."""
        left = [(node.lower, node.upper) for node in self.nodes if node.state in (State.OPEN, State.STUCK)]
        return sorted(left, key=lambda ends: (ends[0] is not None, ends[0] or 0))

    @property
    def witness(self) -> tuple[fmpq, fmpq] | None:
        """The first point (in the order of the tree) at which the statement fails."""
        return next((node.witness for node in self.nodes if node.witness is not None), None)

    def steps(self, examine: Examine, executor: Executor) -> Iterator[Progress]:
        """Examine open ranges until none is left, a witness is met, or the budget ends."""
        while self.witness is None and self.examined < self.budget:
            batch = [i for i, node in enumerate(self.nodes) if node.state is State.OPEN]
            batch = batch[: self.budget - self.examined]
            if not batch:
                return
            answers = [self._answer(examine, executor, self.nodes[i]) for i in batch]
            for i, answer in zip(batch, answers, strict=True):
                self._record(i, answer())
                yield self._progress(i)

    def _answer(
        self, examine: Examine, executor: Executor, node: Node
    ) -> Callable[[], Column | tuple[fmpq, fmpq] | None]:
        work = partial(examine, node.lower, node.upper)
        if self.journal is not None and self.journal.knows(node.lower, node.upper):
            known = self.journal.recall(node.lower, node.upper)
            if known is None and not self._is_last(node):
                return lambda: None
            if isinstance(known, Column):
                work = partial(proved_again, examine, known)
        if isinstance(executor, InProcessExecutor):
            # Not before its turn: what is recorded is then all that was done, also after a kill.
            return work
        return executor.submit(work).result

    def _is_last(self, node: Node) -> bool:
        """Whether the range is not cut, so that it stays undecided where it is not settled."""
        return node.depth >= self.max_depth or node.lower is None or node.lower == node.upper

    def _record(self, index: int, answer: Column | tuple[fmpq, fmpq] | None) -> None:
        node = self.nodes[index]
        self.examined += 1
        if self.journal is not None:
            self.journal.add(node.lower, node.upper, answer)
        if isinstance(answer, Column):
            self.nodes[index] = replace(node, state=State.SETTLED, column=answer)
        elif answer is not None:
            self.nodes[index] = replace(node, state=State.REFUTED, witness=answer)
        elif node.lower is None or self._is_last(node):
            self.nodes[index] = replace(node, state=State.STUCK)
        else:
            self.nodes[index] = replace(node, state=State.SPLIT)
            point = self.cut(node.lower, node.upper)
            for lower, upper in ((node.lower, point), (point, node.upper)):
                self.nodes.append(Node(lower, upper, index, node.depth + 1))

    def _progress(self, index: int) -> Progress:
        states = [node.state for node in self.nodes]
        return Progress(self.nodes[index], self.examined, states.count(State.SETTLED), states.count(State.OPEN))


def proved_again(examine: Examine, known: Column) -> Column | tuple[fmpq, fmpq] | None:
    """The range's examination along the pieces of a column; without them where that column does not come out."""
    again = examine(known.lower, known.upper, known)
    return again if again == known else examine(known.lower, known.upper)
