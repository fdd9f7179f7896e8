"""What a part of the chapter asks, before anything is measured.

Its profile says where the time goes: the parts of one call, by the module in which it is spent.
"""

from __future__ import annotations

import cProfile
import pstats
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.measurement.contest import Call, Effort, TimedRoute, compete
from gspot_verified.cost.measurement.measurement import Limit, Part, Share

_PACKAGE = Path(__file__).resolve().parents[2]
_SHOWN = 5  # the largest shares of a profile
_LEAST = 0.02  # smaller shares are noise


def time_shares(call: Callable[[], object], clock: Callable[[], float] = time.perf_counter) -> tuple[Share, ...]:
    """The largest parts of the time of ``call``, with empty caches; a function of C counts for the module calling it.

    Nothing where no time passed on ``clock``.
    The profiler lengthens Python more than it lengthens FLINT: short calls are only roughly right.
    """
    forget()
    profile = cProfile.Profile(clock)
    profile.runcall(call)
    seconds: Counter[str] = Counter()
    table: dict[Any, Any] = pstats.Stats(profile).stats  # type: ignore[attr-defined]
    for (file, _, _), (_, _, own, _, callers) in table.items():
        if file != "~":
            seconds[_module(file)] += own
            continue
        for (caller, _, _), entry in callers.items():
            seconds[_module(caller)] += entry[2]
    total = sum(seconds.values())
    if total <= 0:
        return ()
    large = [Share(name, own / total) for name, own in seconds.most_common(_SHOWN) if own >= _LEAST * total]
    return (*large, Share("all the rest", max(0.0, 1 - sum(share.part for share in large))))


def _module(file: str) -> str:
    path = Path(file)
    if path.is_relative_to(_PACKAGE):
        return ".".join(path.relative_to(_PACKAGE).with_suffix("").parts)
    parts = path.parts
    if "site-packages" in parts:
        return parts[parts.index("site-packages") + 1].removesuffix(".py")
    return "Python"


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
    times = []
    for _ in range(repeats):
        if fresh:
            forget()
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return max(min(times), 1e-9)
