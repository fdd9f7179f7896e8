"""What a part of the chapter asks, before anything is measured."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.measurement.contest import Call, Effort, TimedRoute, compete
from gspot_verified.cost.measurement.measurement import Limit, Part, Share
from gspot_verified.cost.measurement.time_shares import time_shares


@dataclass(frozen=True, slots=True)
class Blueprint:
    """One part: its texts, its contestants, the call whose time is taken apart, and the limit.

    ``profiled``: words and call, or None; ``limit``: None where none is stated. Both are made when they are asked for.
    """

    key: str
    title: str
    question: str
    axis: str
    symbol: str
    contestants: Callable[[], tuple[TimedRoute, ...]]
    profiled: Callable[[bool], tuple[str, Call]] | None = None
    limit: Callable[[bool], Limit] | None = None
    remarks: tuple[str, ...] = ()
    targets: tuple[tuple[str, float], ...] = ()

    def measured(self, effort: Effort) -> Part:
        """Measure everything of this part."""
        routes = compete(self.key, self.contestants(), effort)
        shares_of, shares = "", tuple[Share, ...]()
        if self.profiled is not None:
            shares_of, call = self.profiled(effort.full)
            shares = time_shares(call)
        limit = self.limit(effort.full) if self.limit is not None else None
        words = (self.key, self.title, self.question, self.axis, self.symbol)
        return Part(*words, routes, shares_of, shares, limit, self.remarks, self.targets)


def best_time(call: Call, repeats: int = 3, fresh: bool = True) -> float:
    """The least processor time of some calls; ``fresh``: with empty caches."""
    found = []
    for _ in range(repeats):
        if fresh:
            forget()
        start = time.process_time()
        call()
        found.append(time.process_time() - start)
    return max(min(found), 1e-9)
