"""Where the time goes: the parts of one call, by the module in which it is spent."""

from __future__ import annotations

import cProfile
import pstats
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.measurement.measurement import Share

_PACKAGE = Path(__file__).resolve().parents[2]
_SHOWN = 5
_LEAST = 0.02


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
