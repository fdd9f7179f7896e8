"""A statement over ranges is refuted by a point of the ranges at which it certainly fails. Both are checked here, in
the one place of this folder that says "refuted".
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.signs.ranges import Range
from gspot_verified.verdict import ASK_VERDICT, NoTruthValue, Verdict

Point = tuple[fmpq, ...]


@dataclass(frozen=True, slots=True)
class Refutation(NoTruthValue):
    """A verdict "refuted" and the point that it rests on, one number for each range that was asked about."""

    ask: ClassVar[str] = ASK_VERDICT

    verdict: Verdict
    point: Point


def refutation(
    statement: str, asked: Mapping[str, Range], candidates: Iterable[Point], failure: Callable[..., str | None]
) -> Refutation | None:
    """Refute the statement by the first candidate that serves; None when none does.

    ``asked``: the ranges over which the statement is made, by the names of the variables. A candidate serves when it
    lies in them (open and closed ends count) and ``failure``, called with its numbers, says what certainly contradicts
    the statement there. ``failure`` answers None where nothing is certain, and is not asked outside the ranges.

    :raises ValueError: a candidate has not one number for each range.

    >>> asked = {"x": Range.parse("[0..1)", "x")}
    >>> found = refutation("x < 1/2", asked, [(fmpq(1),), (fmpq(3, 4),)], lambda x: "x > 1/2" if 2 * x > 1 else None)
    >>> found.point, found.verdict.witness
    ((3/4,), 'x > 1/2 at x = 3/4')
    """
    for point in candidates:
        places = list(zip(asked.items(), point, strict=True))
        if not all(values.contains(number) for (_, values), number in places):
            continue
        finding = failure(*point)
        if finding is not None:
            where = ", ".join(f"{name} = {number}" for (name, _), number in places)
            return Refutation(Verdict.refuted(statement, f"{finding} at {where}"), point)
    return None
