"""The run behind ``gspot-verified cost``: every part of the chapter, in its order, and what it was measured on."""

from __future__ import annotations

import datetime
import importlib.metadata
import os
import platform
import re
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import flint

from gspot_verified.cost.measurement.contest import FULL, QUICK, Blueprint, TimedRoute
from gspot_verified.cost.measurement.file import SCHEMA, KeptParts
from gspot_verified.cost.measurement.measurement import FILES, Measurement, Part, files_key
from gspot_verified.cost.parts import scene_runs
from gspot_verified.cost.parts.cheap_answers import answers
from gspot_verified.cost.parts.checked_proofs import CHECKER, FORMAL
from gspot_verified.cost.parts.expansion_orders import EXPANSIONS
from gspot_verified.cost.parts.sign_ranges import SIGNS
from gspot_verified.cost.parts.slow_solution_digits import FINITE_EPSILON
from gspot_verified.cost.parts.theta_digits import THETA
from gspot_verified.cost.parts.theta_routes import ROUTES
from gspot_verified.cost.parts.zero_parts import ATLAS, BRACKETS
from gspot_verified.cost.times.measure import machine_load
from gspot_verified.numbers.counted import done_of


def blueprints(full: bool) -> tuple[Blueprint, ...]:
    """The parts, for the small or the full size."""
    scenes = scene_runs.blueprint(full)
    return (THETA, ROUTES, SIGNS, ATLAS, BRACKETS, EXPANSIONS, FINITE_EPSILON, scenes, CHECKER, FORMAL)


def contestants_of(key: str) -> tuple[TimedRoute, ...]:
    """The contestants of one part, with those of the full size.

    :raises ValueError: there is no such part.
    """
    matches = [blueprint for blueprint in blueprints(True) if blueprint.key == key]
    if not matches:
        raise ValueError(f"part: expected one of {', '.join(b.key for b in blueprints(True))}, got {key!r}")
    return matches[0].contestants()


Progress = Callable[[str], None]
_PACKAGES = ("gspot-verified", "python-flint", "mpmath", "numpy", "scipy", "sympy", "heyoka")
_PROGRAMS = {"PARI/GP": ("gp", "--version-short"), "Sage": ("sage", "--version"), "Coq": ("coqc", "--version")}


def measure_cost(full: bool = False, progress: Progress = lambda _: None, kept: KeptParts | None = None) -> Measurement:
    """Measure all parts: two to three minutes of processor time; with ``full`` more than half an hour.

    The command is ``cost``; that word is the subpackage here.

    ``progress`` is called with a line of text before each part. Parts in ``kept`` are not measured again; new ones are
    put there.
    """
    start, before = time.perf_counter(), machine_load()
    parts: list[Part] = []
    planned = blueprints(full)
    for blueprint in planned:
        part = None if kept is None else kept.find(blueprint.key)
        if part is None:
            progress(f"{blueprint.title}; {done_of(len(parts), len(planned), 'part')} measured")
            part = blueprint.measured(FULL if full else QUICK)
            if kept is not None:
                kept.keep(part)
        parts.append(part)
    progress("the same questions asked cheaply")
    cheap = answers()
    date = datetime.datetime.now(datetime.UTC).date().isoformat()
    load = f"before: {before}; after: {machine_load()}"
    seconds = time.perf_counter() - start
    return Measurement(
        parts=tuple(parts),
        answers=cheap,
        date=date,
        machine=machine(),
        versions=tuple(sorted(versions().items())),
        load=load,
        full=full,
        seconds=seconds,
    )


def question(full: bool) -> dict[str, object]:
    """What parts that were measured at different times must have in common, beside the sources."""
    return {"cost": SCHEMA, "full": full, "machine": machine(), "versions": versions()}


def machine() -> str:
    """Processor, its cores and the memory, where the system tells them; no name of a host."""
    words = [_processor() or platform.machine(), f"{os.cpu_count() or 1} cores"]
    try:
        total = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
        words.append(f"{total / 2**30:.0f} GiB of memory")
    except (AttributeError, ValueError, OSError):
        pass
    return ", ".join([*words, platform.system()])


def _processor() -> str:
    file = Path("/proc/cpuinfo")
    if file.is_file():
        match = re.search(r"^model name\s*:\s*(.+)$", file.read_text(encoding="utf-8", errors="replace"), re.MULTILINE)
        if match:
            return match[1].strip()
    return platform.processor()


def versions() -> dict[str, str]:
    """What was measured, by name; a program that is not there is not named."""
    by_name = {"Python": platform.python_version(), "FLINT": flint.__FLINT_VERSION__, FILES: files_key()}
    for name in _PACKAGES:
        try:
            by_name[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    for name, (program, option) in _PROGRAMS.items():
        if shutil.which(program) is None:
            continue
        done = subprocess.run([program, option], capture_output=True, text=True, check=False)
        match = re.search(r"\d+(\.\d+)+", done.stdout)
        if match:
            by_name[name] = match[0]
    return by_name
