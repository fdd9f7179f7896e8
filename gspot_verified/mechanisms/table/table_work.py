"""The rows of a table in portions: through an executor, with a journal where there is one, answers as they come."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import nullcontext
from dataclasses import dataclass
from functools import partial
from itertools import islice
from typing import Any, Generic, Protocol, TypeVar

from gspot_verified.mechanisms.table.parameter_rows import ParameterRow
from gspot_verified.work.executors import InProcessExecutor, in_order
from gspot_verified.work.journal_file import JournalFile
from gspot_verified.work.kept_portions import kept_results

_Row = TypeVar("_Row", covariant=True)


class PortionAnswer(Protocol[_Row]):
    """What a portion of rows gave: it pickles."""

    @property
    def rows(self) -> Sequence[_Row]:
        """The answers, one for each row."""

    @property
    def digest(self) -> str:
        """A hash of all that they say, for a journal."""

    @property
    def choices(self) -> str:
        """What a journal keeps of the way to them, as JSON in one line."""


@dataclass(frozen=True)
class Kept(Generic[_Row]):
    """A journal, and how its lines are read and proved again: arguments of :func:`kept_results`."""

    journal: JournalFile
    again: Callable[[list[ParameterRow], str], PortionAnswer[_Row]]
    read: Callable[[str], tuple[int, str, Any]]


def answered_rows(
    rows: Iterator[ParameterRow],
    size: int,
    first: Callable[[list[ParameterRow]], PortionAnswer[_Row]],
    executor: Executor | None,
    progress: Callable[[int], None] | None,
    kept: Kept[_Row] | None = None,
) -> Iterator[_Row]:
    """The answers to all rows, ``size`` of them in each task. The journal is closed at the end. ``progress`` is told
    how many rows are done."""
    portions, pool = iter(lambda: list(islice(rows, size)), []), executor or InProcessExecutor()
    done = 0
    with nullcontext() if kept is None else kept.journal:
        if kept is None:
            answers = in_order(pool, (partial(first, portion) for portion in portions))
        else:
            answers = kept_results(portions, pool, kept.journal, first, kept.again, kept.read)
        for answer in answers:
            done += len(answer.rows)
            if progress is not None:
                progress(done)
            yield from answer.rows
