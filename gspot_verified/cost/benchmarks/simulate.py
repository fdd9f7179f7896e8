"""The benchmark behind ``gspot-verified cost simulate``: certified runs of scenes beside runs with floats."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from gspot_verified.cost.peers.lift_off_runs import (
    CERTIFIED_BITS,
    HEYOKA_TOLERANCES,
    LIMITS,
    bracket_decimals,
    certified_bracket,
    float_time,
    heyoka_call,
    heyoka_missing,
    right_decimals,
    scene_of,
)
from gspot_verified.cost.times.measure import machine_load
from gspot_verified.cost.times.rows import Benchmark, Row, Target, TimeCurve, seconds_text
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import OPEN
from gspot_verified.scenes.scene.scene import Scene

Progress = Callable[[str], None]

QUICK, FULL = 2, 4  # how many epsilons: 1e-3, 1e-4, 1e-5, 1e-6
_DRAWN: dict[bool, dict[str, tuple[int, ...]]] = {
    False: {"model": (0, 1), "extended": (0, 1), "oscillator": (0,)},
    True: dict.fromkeys(LIMITS, (0, 1, 2)),
}
_BITS = 192  # working precision of the timed runs
_TOLERANCE = 1e-10  # of the float runs beside them
_TOLERANCES = (1e-4, 1e-7, 1e-10)  # of Radau in the curves
_HEAD = (
    "Processor time of one run, until after the first lift-off. cold: the equations are compiled; warm: the same call\n"
    "again; baseline: scipy, Radau, relative tolerance 1e-10. Certified by the integrator at 192 bits, with the width\n"
    "of the bracket of lift-off."
)


def run(full: bool = False, progress: Progress = lambda _: None) -> Benchmark:
    """Run the benchmark: about a minute; with ``full`` epsilon = 1e-6, too. A missed target is a row."""
    start, before = time.perf_counter(), machine_load()
    rows = []
    load_scene("fig-varsim1", until="0.1")  # libraries are loaded before anything is timed
    certified_bracket(scene_of("model", 0), _BITS)
    for name in LIMITS:
        count = FULL if full else QUICK
        for k in range(count):
            progress(f"{name}, epsilon = 1e-{k + 3}")
            rows.append(_row(name, k))
    curves: list[TimeCurve] = []
    for name in LIMITS:
        for k in _DRAWN[full][name]:
            progress(f"accuracy against time: {name}, epsilon = 1e-{k + 3}")
            curves += _accuracy(name, k)
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        f"before: {before}; after: {machine_load()}",
        f"heyoka: {heyoka_missing() or 'Taylor’s method in doubles, no bound; equations compiled before its time'}",
    )
    return Benchmark(_HEAD, tuple(rows), tuple(curves), remarks, time.perf_counter() - start)


def _timed(call: Callable[[], Any]) -> tuple[Any, float]:
    start = time.process_time()
    answer = call()
    return answer, time.process_time() - start


def _row(name: str, k: int) -> Row:
    scene = scene_of(name, k)
    certified, cold = _timed(lambda: integrated_run(scene, bits=(_BITS,)))
    _, warm = _timed(lambda: integrated_run(scene, bits=(_BITS,)))
    time_of_floats, baseline = _timed(lambda: float_time(scene, "Radau", _TOLERANCE))
    notes = [] if time_of_floats is not None else ["scipy reports no lift-off"]
    if not heyoka_missing():
        call = heyoka_call(scene, _TOLERANCE)
        seconds = min(_timed(call)[1] for _ in range(3))
        notes.append(f"heyoka, tolerance {_TOLERANCE:g}: {seconds_text(seconds)}")
    asked = f"ε = 1e-{k + 3}: {certified.fate}"
    if certified.events:
        width = certified.events[0].upper - certified.events[0].lower
        asked += f", bracket {approximate(width):.0e}"
    figure = None if certified.fate == OPEN else cold
    times = {"cold": cold, "warm": warm, "baseline": baseline}
    return Row(name, asked, Target("time", LIMITS[name][k], "s"), figure, note="; ".join(notes), **times)


def _accuracy(name: str, k: int) -> list[TimeCurve]:
    """Right decimals of the time of lift-off against seconds: certified by bits, floats by tolerance; the target."""
    scene: Scene = scene_of(name, k)
    words = f"{name}, ε = 1e-{k + 3}"
    certified = [
        (bracket_decimals(bracket), seconds)
        for bits in CERTIFIED_BITS
        for bracket, seconds in [_timed(lambda bits=bits: certified_bracket(scene, bits))]  # type: ignore[misc]
        if bracket is not None
    ]
    radau = [partial(float_time, scene, "Radau", tolerance) for tolerance in _TOLERANCES]
    heyoka = [] if heyoka_missing() else [heyoka_call(scene, tolerance) for tolerance in HEYOKA_TOLERANCES]
    for call in heyoka:
        call()  # its first call takes longer
    solvers: dict[str, Sequence[Callable[[], Any]]] = {"scipy Radau": radau, "heyoka": heyoka}
    curves = [TimeCurve(f"certified: {words}", tuple(certified))]
    for solver, calls in solvers.items():
        points = []
        for call in calls:
            at, seconds = _timed(call)
            decimals = None if at is None else right_decimals(name, k, at)
            if decimals is not None:
                points.append((decimals, seconds))
        if points:
            curves.append(TimeCurve(f"{solver}: {words}", tuple(sorted(points))))
    if certified:
        ends = (1.0, max(decimals for decimals, _ in certified))
        curves.append(TimeCurve(f"aim: {words}", tuple((decimals, LIMITS[name][k]) for decimals in ends)))
    return curves
