"""A statement over ranges is refuted by a point of the ranges at which it certainly fails. Both are checked here, in
the one place of this folder that says "refuted".
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.numbers.evidence import at_most, equal, every, less
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Verdict
from gspot_verified.work.ranges import Range

Point = tuple[fmpq, ...]
Failure = tuple[str, Evidence | None]
"""What contradicts a statement at a point, in words, and the comparison that shows it."""


@dataclass(frozen=True, slots=True)
class Refutation(NoTruthValue):
    """A verdict "refuted" and the point that it rests on, one number for each range that was asked about."""

    verdict: Verdict
    point: Point


def refutation(
    statement: str, asked: Mapping[str, Range], candidates: Iterable[Point], failure: Callable[..., Failure | None]
) -> Refutation | None:
    """Refute the statement by the first candidate that serves; None when none does.

    ``asked``: the ranges over which the statement is made, by the names of the variables. A candidate serves when it
    lies in them (open and closed ends count) and ``failure``, called with its numbers, says what certainly contradicts
    the statement there, and by which comparison. It answers None where nothing is certain, and is not asked outside
    the ranges.

    :raises ValueError: a candidate has not one number for each range.

    >>> from gspot_verified.numbers.evidence import less
    >>> asked, half = {"x": Range.parse("[0..1)", "x")}, fmpq(1, 2)
    >>> refuted = refutation("x < 1/2", asked, [(fmpq(1),), (fmpq(3, 4),)], lambda x: ("x > 1/2", less(half, x)))
    >>> refuted.point, refuted.verdict.witness
    ((3/4,), 'x > 1/2 at x = 3/4')
    """
    for point in candidates:
        places = list(zip(asked.items(), point, strict=True))
        within = [_inside(values, number) for (_, values), number in places]
        if any(part is None for part in within):
            continue
        failed = failure(*point)
        shown = None if failed is None else every([*within, failed[1]])
        if failed is not None and shown is not None:
            where = ", ".join(f"{name} = {number}" for (name, _), number in places)
            return Refutation(Verdict.refuted(statement, f"{failed[0]} at {where}", shown), point)
    return None


def _inside(asked: Range, number: fmpq) -> Evidence | None:
    """That the number belongs to the range: its ends, open or closed, compared exactly."""
    shown = [equal(number, number)]
    if asked.lower is not None:
        shown.append((at_most if asked.lower_closed else less)(asked.lower, number))
    if asked.upper is not None:
        shown.append((at_most if asked.upper_closed else less)(number, asked.upper))
    return every(shown)
