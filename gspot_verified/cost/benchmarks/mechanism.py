"""The benchmark behind ``gspot-verified cost mechanism``: from a mechanism to all of its G-spots."""

from __future__ import annotations

import platform
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial

from gspot_verified.cost.benchmarks.mechanism_approach import approach_rows
from gspot_verified.cost.benchmarks.mechanism_models import chain, leg
from gspot_verified.cost.benchmarks.mechanism_sweep import sweep_rows
from gspot_verified.cost.times.benchmark import Benchmark
from gspot_verified.cost.times.curves import TimeCurve
from gspot_verified.cost.times.measure import Contestant, child_environment, machine_load, measure
from gspot_verified.cost.times.rows import Row, Target
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.critical_friction import critical_friction

Progress = Callable[[str], None]

_HEAD = (
    "Times are medians in one thread. All G-spots: read, derive, search every angle and every velocity, prove each "
    "alone in its box,\nand that there are no others. Command line: a process of its own, processor time."
)
_LEG = {"a1": "-1", "a1_dot": "-2"}


def run(full: bool = False, progress: Progress = lambda _: None) -> Benchmark:
    """Run the benchmark: some seconds; with ``full`` longer legs and chains, and more repeats."""
    start, before = time.perf_counter(), machine_load()
    repeats = 9 if full else 3
    rows = []
    for family in (_searches, _critical, _chains, _commands):
        rows += family(full, repeats, progress)
    rows += approach_rows(progress)
    rows += sweep_rows(full, progress)
    points = tuple((links, _time(partial(leg, links), repeats)) for links in (2, 3, 4))
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        f"before: {before}; after: {machine_load()}",
    )
    return Benchmark(_HEAD, tuple(rows), (TimeCurve("reading a leg", points),), remarks, time.perf_counter() - start)


def _time(call: Callable[[], object], repeats: int) -> float:
    return measure({"it": Contestant(call, None, repeats)}, 4.0)["it"].median


def _row(case: str, asked: str, limit: float, call: Callable[[], object], repeats: int) -> Row:
    figure = _time(call, repeats)
    return Row(case, asked, Target("time", limit, "s"), figure, warm=figure)


def _all(make: Callable[[], Mechanism]) -> object:
    return find_g_spots(make())


def _friction(make: Callable[[], Mechanism]) -> object:
    return critical_friction(make())


def _classified(links: int, place: dict[str, str]) -> object:
    return classify_all(chain(links, fixed=list(place), place=place))


def _searches(full: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("all G-spots")
    cases: list[tuple[str, float, Callable[[], Mechanism]]] = [
        ("classical rod, mu = 7/5: four", 2.0, lambda: shipped_mechanism("genot_brogliato_rod", mu="7/5")),
        ("classical rod, mu = 13/10: none", 2.0, lambda: shipped_mechanism("genot_brogliato_rod", mu="13/10")),
        ("classical rod, mu = 4/3: the fold", 2.0, lambda: shipped_mechanism("genot_brogliato_rod", mu="4/3")),
        ("oscillator", 5.0, lambda: shipped_mechanism("oscillator")),
        ("two-link leg", 5.0, lambda: leg(2, "3/2")),
        ("three-link leg, hip angle and rate fixed", 60.0, lambda: leg(3, fixed=list(_LEG), place=_LEG)),
        ("three-link leg: a patch of a surface", 60.0, lambda: leg(3)),
    ]
    if full:
        place = {**_LEG, "a2": "-1/2", "a2_dot": "0"}
        cases.append(("four-link leg, two angles fixed", 60.0, lambda: leg(4, "3", fixed=list(place), place=place)))
    return [_row("all G-spots", words, limit, partial(_all, make), repeats) for words, limit, make in cases]


def _critical(_: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("critical friction")
    cases: list[tuple[str, Callable[[], Mechanism]]] = [
        ("classical rod", lambda: shipped_mechanism("genot_brogliato_rod")),
        ("two-link leg", lambda: leg(2, "3/2")),
    ]
    return [_row("critical friction", words, 2.0, partial(_friction, make), repeats) for words, make in cases]


def _chains(full: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("chains")
    rows = []
    for links in (3, 5, *((6,) if full else ())):
        angles = [f"a{i}" for i in range(1, links)]
        place = {"X": "0", "X_dot": "0"}
        for i, angle in enumerate(angles):
            place |= {angle: f"{i}/20", f"{angle}_dot": "0"}
        rows.append(
            _row(
                "chains",
                f"{links} links: all G-spots classified, the last angle and its rate free",
                60.0,
                partial(_classified, links, place),
                repeats,
            )
        )
    return rows


def _commands(_: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("the command line")
    cases = (("--version", 0.25), ("classify rod", 0.5), ("classify oscillator", 0.5), ("classify rod --all", 0.5))
    rows = []
    for words, limit in cases:
        figure = sorted(_processor_seconds(words.split()) for _ in range(repeats))[repeats // 2]
        rows.append(
            Row("command line", f"gspot-verified {words}", Target("processor", limit, "s"), figure, cold=figure)
        )
    return rows


def _processor_seconds(arguments: list[str]) -> float:
    """Processor time of a process of its own, user and system."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [sys.executable, "-m", "gspot_verified", *arguments], capture_output=True, env=child_environment(), check=True
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
