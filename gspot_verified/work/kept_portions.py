"""Portions of long work through an executor, each kept in a journal as choices along which it is done again.

A line of the journal is ``[number, digest, choices]``: what a portion gave is made again from the choices.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from functools import partial
from typing import Any, Protocol, TypeVar

from gspot_verified.work.executors import in_order
from gspot_verified.work.journal_file import JournalFile


class Answer(Protocol):
    """What a portion gave: it pickles."""

    @property
    def digest(self) -> str:
        """A hash of all that it says."""

    @property
    def choices(self) -> str:
        """What a journal keeps of the way to it, as JSON in one line."""


_Answer = TypeVar("_Answer", bound=Answer)
_Portion = TypeVar("_Portion")


def kept_results(
    work: Iterable[_Portion],
    executor: Executor,
    journal: JournalFile | None,
    first: Callable[[_Portion], _Answer],
    again: Callable[[_Portion, str], _Answer],
    read: Callable[[str], tuple[int, str, Any]],
    start: int = 0,
) -> Iterator[_Answer]:
    """The answers of the portions, in order: ``first`` of those that are new, ``again`` with its line of those that
    the journal holds. ``read``: the number, the digest and the choices of a line. ``start``: the number of the first
    portion, where others have come before.

    :raises ValueError: a line of the journal cannot be read.
    """
    known = {} if journal is None else recalled(journal, read)

    def task(number: int, portion: _Portion) -> Callable[[], _Answer]:
        if journal is not None and number in known:
            return partial(again, portion, journal.lines[known[number][0]])
        return partial(first, portion)

    tasks = (task(number, portion) for number, portion in enumerate(work, start))
    for number, answer in enumerate(in_order(executor, tasks), start):
        if journal is not None and (number not in known or known[number][1] != answer.digest):
            journal.add_text(f'[{number}, "{answer.digest}", {answer.choices}]')
        yield answer


def recalled(journal: JournalFile, read: Callable[[str], tuple[int, str, Any]]) -> dict[int, tuple[int, str]]:
    """Of each portion its last line, by number, and the digest there.

    :raises ValueError: a line cannot be read.
    """
    found: dict[int, tuple[int, str]] = {}
    for k, line in enumerate(journal.lines):
        try:
            number, expected, _ = read(line)
        except (ValueError, TypeError, KeyError, IndexError, RecursionError) as error:
            raise ValueError(f"{journal.path}: a line of the journal cannot be read: {error}") from None
        found[number] = k, expected
    return found
