"""The benchmark behind ``gspot-verified cost simulate``: certified runs of scenes beside runs with floats."""

from __future__ import annotations

import importlib.util
import math
import platform
import time
from collections.abc import Callable

from flint import fmpq

from gspot_verified.balls import approximate
from gspot_verified.cost.benchmark import Benchmark
from gspot_verified.cost.curves import Curve
from gspot_verified.cost.measure import machine_load
from gspot_verified.cost.rows import Row, Target
from gspot_verified.scenes.certified_integration import integrated_run
from gspot_verified.scenes.file import load_scene
from gspot_verified.scenes.float_run import float_run
from gspot_verified.scenes.run import OPEN, SceneRun
from gspot_verified.scenes.scene import Scene, SceneError

Progress = Callable[[str], None]

LIMITS = {
    "model": (0.15, 1.0, 6.0, 50.0),
    "extended": (0.15, 1.0, 6.0, 60.0),
    "oscillator": (0.5, 4.0, 20.0, 150.0),
}
"""Seconds of processor time for epsilon = 1e-3, 1e-4, 1e-5, 1e-6, until after the first lift-off."""
_UNTIL = {
    "model": ("0.56", "0.515", "0.505", "0.502"),
    "extended": ("0.45", "0.4", "0.39", "0.385"),
    "oscillator": ("0.105", "0.117", "0.114", "0.113"),
}
"""Just after the first lift-off."""
QUICK, FULL = 2, 4
_QUICK_OSCILLATOR = 2
_BASELINES = 2
_BITS = 192
_CERTIFIED_BITS = (144, 160, 192, 256, 384)
_TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
_HEAD = (
    "Processor time of one run, until after the first lift-off. cold: the equations are compiled; warm: the same call\n"
    "again; baseline: scipy, Radau, relative tolerance 1e-10 (to epsilon = 1e-4).\n"
    "Certified by the integrator at 192 bits, with the width of the bracket of lift-off."
)


def run(full: bool = False, progress: Progress = lambda _: None) -> Benchmark:
    """Run the benchmark: about half a minute; with ``full`` epsilon = 1e-6, too. A missed target is a row."""
    start, before = time.perf_counter(), machine_load()
    rows = []
    load_scene("fig-varsim1", until="0.1")  # libraries are loaded before anything is timed
    integrated_run(_scene("model", 0), bits=(_BITS,))
    for name in LIMITS:
        count = FULL if full else (_QUICK_OSCILLATOR if name == "oscillator" else QUICK)
        for k in range(count):
            progress(f"{name}, epsilon = 1e-{k + 3}")
            rows.append(_row(name, k))
    progress("accuracy against time")
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        f"before: {before}; after: {machine_load()}",
        f"heyoka: {'installed, not measured here' if importlib.util.find_spec('heyoka') else 'not installed'}",
    )
    return Benchmark(_HEAD, tuple(rows), _accuracy(), remarks, time.perf_counter() - start)


def _scene(name: str, k: int) -> Scene:
    epsilon, until = fmpq(1, 10 ** (k + 3)), _UNTIL[name][k]
    if name == "model":
        return load_scene("fig-varsim1", eps=epsilon, until=until)
    if name == "extended":
        return load_scene("fig-varsim2", eps=epsilon, until=until, chi=1)
    return load_scene("oscillator", eps=epsilon, until=until)


def _timed(call: Callable[[], SceneRun]) -> tuple[SceneRun, float]:
    start = time.process_time()
    found = call()
    return found, time.process_time() - start


def _row(name: str, k: int) -> Row:
    scene = _scene(name, k)
    found, cold = _timed(lambda: integrated_run(scene, bits=(_BITS,)))
    _, warm = _timed(lambda: integrated_run(scene, bits=(_BITS,)))
    baseline: float | None = None
    note = ""
    if k < _BASELINES:
        try:
            _, baseline = _timed(lambda: float_run(scene))
        except SceneError as error:
            note = str(error)
    asked = f"ε = 1e-{k + 3}: {found.fate}"
    if found.events:
        width = found.events[0].upper - found.events[0].lower
        asked += f", bracket {approximate(width):.0e}"
    figure = None if found.fate == OPEN else cold
    return Row(
        name, asked, Target("time", LIMITS[name][k], "s"), figure, cold=cold, warm=warm, baseline=baseline, note=note
    )


def _accuracy() -> tuple[Curve, ...]:
    """Correct digits of the time of lift-off against seconds: certified by bits, floats by tolerance."""
    scene = _scene("model", 0)
    known = integrated_run(scene, bits=(512,)).events[0]
    certified, floats = [], []
    for bits in _CERTIFIED_BITS:
        found, seconds = _timed(lambda bits=bits: integrated_run(scene, bits=(bits,)))  # type: ignore[misc]
        if found.events:
            certified.append((_digits(found.events[0].upper - found.events[0].lower), seconds))
    for tolerance in _TOLERANCES:
        found, seconds = _timed(lambda tolerance=tolerance: float_run(scene, "Radau", tolerance))  # type: ignore[misc]
        if found.events:
            floats.append((_digits(abs(found.events[0].lower - known.lower)), seconds))
    return Curve("certified", tuple(certified)), Curve("scipy Radau, error unknown to it", tuple(sorted(floats)))


def _digits(error: fmpq) -> int:
    """How many decimals after the point are right."""
    return max(1, math.floor(-math.log10(approximate(error)))) if error > 0 else 1
