"""Taking times: one thread, ``time.perf_counter``, cold and warm calls, and calls in a process of their own."""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gspot_verified.numbers.written import Written

_THETA = "gspot_verified.theta_function"
_ROOT = Path(__file__).resolve().parents[3]

Call = Callable[[], object]


@dataclass(frozen=True, slots=True)
class Timing(Written):
    """Seconds: the median and the best of ``repeats`` calls."""

    median: float
    best: float
    repeats: int


def timing(seconds: list[float]) -> Timing:
    """The summary of some measured times.

    >>> timing([3.0, 1.0, 2.0])
    Timing(median=2.0, best=1.0, repeats=3)
    """
    return Timing(statistics.median(seconds), min(seconds), len(seconds))


@dataclass(frozen=True, slots=True)
class Contestant:
    """A call to be timed, what comes before each timed call (not timed), and at most how many calls."""

    call: Call
    prepare: Call | None = None
    repeats: int = 15


def measure(contestants: dict[str, Contestant], seconds: float = 1.0) -> dict[str, Timing]:
    """Time the contestants in turn, so that a disturbance of the machine meets all of them.

    Each is called once at least, and not again once its calls have taken ``seconds``.
    """
    spent: dict[str, list[float]] = {name: [] for name in contestants}
    for turn in range(max(contestant.repeats for contestant in contestants.values())):
        for name, contestant in contestants.items():
            if turn == 0 or (turn < contestant.repeats and sum(spent[name]) < seconds):
                spent[name].append(_seconds(contestant))
    return {name: timing(times) for name, times in spent.items()}


def _seconds(contestant: Contestant) -> float:
    if contestant.prepare is not None:
        contestant.prepare()
    start = time.perf_counter()
    contestant.call()
    return time.perf_counter() - start


def clear_caches() -> int:
    """Empty every ``lru_cache`` in the loaded modules of ``gspot_verified.theta_function``; returns how many there are.

    FLINT's own caches (pi, log 2, Bernoulli numbers) stay: no user can empty them, and the alternatives use them too.
    """
    caches = {
        id(member): member
        for name, module in list(sys.modules.items())
        if name == _THETA or name.startswith(_THETA + ".")
        for member in list(vars(module).values())
        if callable(getattr(member, "cache_clear", None))
    }
    for cache in caches.values():
        cache.cache_clear()
    return len(caches)


@dataclass(frozen=True, slots=True)
class ChildRun:
    """A call in a process of its own: seconds of the call, peak memory of the process, ``None`` where there is none.

    ``note`` says why there is no time or no answer; ``first_attempt`` is the baseline's first precision alone;
    ``processor`` is processor time, which other work on the machine does not lengthen.
    """

    seconds: float | None
    peak_bytes: int | None
    note: str = ""
    first_attempt: float | None = None
    processor: float | None = None


def run_child(request: dict[str, Any], time_limit: float) -> ChildRun:
    """Do ``request`` (see :mod:`cost.times.child`) in a fresh process, killed after ``time_limit`` seconds."""
    command = [sys.executable, "-m", "gspot_verified.cost.times.child", json.dumps(request)]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=time_limit, env=child_environment(), check=False
        )
    except subprocess.TimeoutExpired:
        return ChildRun(None, None, f"no answer within {time_limit:g} s")
    if done.returncode != 0:
        last = (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
        return ChildRun(None, None, f"failed: {last[:120]}")
    data = json.loads(done.stdout)
    if not data["answered"]:
        return ChildRun(None, data["peak_bytes"], f"no answer ({data['seconds']:.3g} s spent)")
    return ChildRun(data["seconds"], data["peak_bytes"], "", data["first_attempt"], data["processor"])


def child_environment() -> dict[str, str]:
    """The environment of a child process: this package importable, one thread for numpy."""
    path = os.pathsep.join(part for part in (str(_ROOT), os.environ.get("PYTHONPATH", "")) if part)
    return {**os.environ, "PYTHONPATH": path, "OMP_NUM_THREADS": "1"}


def import_seconds(repeats: int = 5) -> Timing:
    """The time of ``import gspot_verified`` in fresh processes."""
    script = "import time; s = time.perf_counter(); import gspot_verified; print(time.perf_counter() - s)"
    seconds = [
        float(
            subprocess.run(
                [sys.executable, "-c", script], capture_output=True, text=True, env=child_environment(), check=True
            ).stdout
        )
        for _ in range(repeats)
    ]
    return timing(seconds)


def machine_load() -> str:
    """Load averages and cores, where the system tells them: other work makes every time longer."""
    cores = os.cpu_count() or 1
    try:
        averages = ", ".join(f"{value:.2f}" for value in os.getloadavg())
    except (AttributeError, OSError):
        return f"{cores} core(s)"
    return f"load {averages} on {cores} core(s)"
