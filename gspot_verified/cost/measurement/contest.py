"""Taking the times of a part: every route at every argument, in turn, in processor time; memory in a fresh process."""

from __future__ import annotations

import cProfile
import json
import pstats
import resource
import statistics
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.measurement.measurement import Limit, Part, Point, Route, Share
from gspot_verified.cost.times.measure import child_environment

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


Call = Callable[[], object]
_MEMORY_LIMIT = 600.0  # seconds for the process in which memory is measured
_MOST_REPEATS = 15  # of one call, however short


def argument_itself(argument: Any, _: object) -> float:
    """The place of a route that reaches what it is asked for."""
    return float(argument)


@dataclass(frozen=True, slots=True)
class TimedRoute:
    """A route to be timed: ``call(argument)`` gives the call, made before the time is taken.

    ``arguments`` grow; those in ``more`` are for the full size. ``place``: what the result reached, None where it is no
    answer. ``seconds``: the time that the result itself tells (another program's own). ``missing``: why it cannot run.
    """

    name: str
    kind: str
    arguments: tuple[Any, ...]
    call: Callable[[Any], Call]
    more: tuple[Any, ...] = ()
    place: Callable[[Any, Any], float | None] = argument_itself
    words: Callable[[Any], str] = str
    exponent: float | None = None
    theory: str = ""
    panel: str = ""
    seconds: Callable[[Any], float] | None = None
    missing: str = ""
    has_memory: bool = True

    @property
    def own_name(self) -> tuple[str, str]:
        """What tells it from the others of its part."""
        return self.panel, self.name

    @property
    def all_arguments(self) -> tuple[Any, ...]:
        """Those of the full size."""
        return (*self.arguments, *self.more)


@dataclass(frozen=True, slots=True)
class Effort:
    """How much is measured: ``patience`` ends a route's larger arguments, ``seconds`` the repeats of one call."""

    full: bool
    patience: float
    seconds: float


QUICK = Effort(False, 1.0, 0.2)
FULL = Effort(True, 60.0, 1.5)


@dataclass(slots=True)
class _Record:
    contestant: TimedRoute
    argument: Any
    place: float
    seconds: list[float] = field(default_factory=list)


def clock() -> float:
    """Processor time of this process and of the processes that it has waited for."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def compete(key: str, contestants: tuple[TimedRoute, ...], effort: Effort) -> tuple[Route, ...]:
    """The routes with their points: first every route up to its patience, then all again, in turn.

    So a disturbance of the machine meets all of them. The package's caches are empty before each call.
    """
    for contestant in {contestant.name: contestant for contestant in reversed(contestants)}.values():
        if not contestant.missing:
            contestant.call(contestant.arguments[0])()  # libraries are loaded before anything is timed
    records: dict[tuple[str, str], list[_Record]] = {}
    notes: dict[tuple[str, str], str] = {}
    for contestant in contestants:
        name = contestant.own_name
        records[name], notes[name] = _first_calls(contestant, effort)
    for _ in range(_MOST_REPEATS - 1):
        waiting = [r for of_one in records.values() for r in of_one if sum(r.seconds) < effort.seconds]
        for record in waiting:
            record.seconds.append(_timed(record.contestant, record.argument)[0])
    return tuple(
        Route(
            c.name,
            c.kind,
            tuple(_point(key, r, r is records[c.own_name][-1]) for r in records[c.own_name]),
            c.exponent,
            c.theory,
            notes[c.own_name],
            c.panel,
        )
        for c in contestants
    )


def _first_calls(contestant: TimedRoute, effort: Effort) -> tuple[list[_Record], str]:
    if contestant.missing:
        return [], contestant.missing
    records: list[_Record] = []
    without: list[str] = []
    for argument in contestant.all_arguments if effort.full else contestant.arguments:
        seconds, result = _timed(contestant, argument)
        place = None if result is None else contestant.place(argument, result)
        if place is None:
            without.append(contestant.words(argument))
        else:
            records.append(_Record(contestant, argument, place, [seconds]))
        if seconds > effort.patience:
            break
    return records, f"no answer: {', '.join(without)}" if without else ""


def _timed(contestant: TimedRoute, argument: Any) -> tuple[float, Any]:
    call = contestant.call(argument)
    forget()
    start = clock()
    result = call()
    seconds = clock() - start
    if contestant.seconds is not None and result is not None:
        return contestant.seconds(result), result
    return seconds, result


def _point(key: str, record: _Record, with_memory: bool) -> Point:
    contestant = record.contestant
    memory = None
    if key and with_memory and contestant.has_memory and contestant.seconds is None:
        memory = memory_alone(key, contestant.own_name, contestant.all_arguments.index(record.argument))
    return Point(
        record.place,
        contestant.words(record.argument),
        statistics.median(record.seconds),
        min(record.seconds),
        len(record.seconds),
        memory,
    )


def memory_alone(key: str, name: tuple[str, str], position: int) -> int | None:
    """By how many bytes a fresh process grows during the call (:mod:`gspot_verified.cost.alone`)."""
    request = json.dumps({"part": key, "panel": name[0], "route": name[1], "position": position})
    command = [sys.executable, "-m", "gspot_verified.cost.alone", request]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=_MEMORY_LIMIT, env=child_environment(), check=True
        )
    except (subprocess.SubprocessError, OSError):
        return None
    grown: int = json.loads(done.stdout)["grown"]
    return grown
