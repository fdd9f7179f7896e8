"""The benchmark behind ``gspot-verified cost sign``: certified signs and zeros on ranges, what was asked beside it."""

from __future__ import annotations

import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from flint import fmpq

from gspot_verified.certificates.checker import checker_path
from gspot_verified.certificates.text import certificate_text
from gspot_verified.cost.peers.bisection import Bisection, Choice, bisect
from gspot_verified.cost.times.growth import FittedGrowth, around, cells, from_one, time_range
from gspot_verified.cost.times.measure import Contestant, clear_caches, machine_load, measure
from gspot_verified.cost.times.rows import Row, Target, TimeCurve, figure_text, seconds_text
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.sign import SignResult, sign

Progress = Callable[[str], None]

_BETA = (fmpq(1, 100), fmpq(99, 100))  # nearly 0..1, for bisection needs a closed range
_COMPARED = (-4, 10)  # range of tau where the bisection is run to its end or its limit
_FAR = ((-10, 10), (-50, 50))  # wide ranges of tau
_SPEED = Target("bisection / ours", 100.0, at_most=False)
_CHECKER = Target("checker / producer", 20.0)
_ATLAS_END = 13  # as far as proofs/zeros_1_13.cert
_HEAD = (
    "Wall time in seconds of one process, one core; the package's caches are empty before each call of ours.\n"
    "bisection: wide balls (τ, β) through three FLINT 1F2, halved until settled; the faster of two forms."
)


@dataclass(frozen=True, slots=True)
class Plan:
    """How much is measured: seconds for each bisection, the atlas (1, k), and the ranges for the growth."""

    bisection_seconds: float
    boxes: tuple[tuple[int, int], ...]
    ends: tuple[int, ...]
    middle: int
    half_sizes: tuple[int, ...]
    cells: tuple[int, ...]


_BOXES = ((-2, 10), (-4, 10), (-10, 10), (-50, 50))  # ranges of tau for the bisections
QUICK = Plan(5.0, _BOXES, (2, 3, 4, 5, 7), 4, (1, 2, 3), tuple(range(1, 9)))
FULL = Plan(60.0, _BOXES, (2, 3, 5, 7, 9, 11, 13), 7, (1, 2, 3, 4, 5, 6), (*range(1, 13), 16, 20, 25))


@dataclass(frozen=True, slots=True)
class SignCost(Written):
    """What the benchmark measured, where, and under which load. ``str`` is the table."""

    written: ClassVar[str] = "rows bisections growth curves remarks full seconds summary"

    rows: tuple[Row, ...]
    bisections: tuple[Bisection, ...]
    growth: tuple[FittedGrowth, ...]
    remarks: tuple[str, ...]
    full: bool
    seconds: float

    @property
    def curves(self) -> tuple[TimeCurve, ...]:
        """Time against size and against beta, and a line of linear growth, for the picture."""
        drawn = tuple(item.curve for item in self.growth if item.points)
        if not drawn:
            return ()
        x, y = drawn[0].points[0]
        last = max(point for curve in drawn for point, _ in curve.points)
        return (*drawn, TimeCurve("linear growth", ((x, y), (last, y * last / x))))

    def summary(self) -> str:
        """One line: how many targets are met, missed, not measured."""
        met, missed, left = ([row.met for row in self.rows].count(value) for value in (True, False, None))
        return f"{met} of {len(self.rows)} met, {missed} missed, {left} not measured"

    def __str__(self) -> str:
        parts = [_HEAD, _table(self.rows), "Bisection alone, β in [1/100, 99/100]"]
        parts[-1] += "".join(f"\n  {_bisection_line(item)}" for item in self.bisections)
        return "\n\n".join([*parts, *map(str, self.growth), "\n".join([*self.remarks, self.summary()])])


def _table(rows: tuple[Row, ...]) -> str:
    header = ("", "ours", "other", "measured", "asked", "outcome")
    lines, notes = [header], [""]
    for row in rows:
        notes.append(row.note)
        figure = figure_text(row.figure, row.target.unit)
        other = row.baseline if row.baseline is not None else row.warm
        lines.append((row.asked, seconds_text(row.cold), seconds_text(other), figure, str(row.target), row.outcome))
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    text = []
    for line, note in zip(lines, notes, strict=True):
        text.append("  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip())
        text += [f"    {note}"] if note else []
    return "\n".join(text)


def _bisection_line(item: Bisection) -> str:
    left, right, _, _ = item.box
    outcome = "all settled" if item.finished else f"stopped, {100 * item.settled:.3g} % of the area settled"
    return (
        f"τ in [{left}, {right}], halving {item.choice.value}: {seconds_text(item.seconds)}, "
        f"{item.evaluations} evaluations, {outcome}"
    )


def run(full: bool = False, progress: Progress = lambda _: None, plan: Plan | None = None) -> SignCost:
    """Run the benchmark: about a minute and a half; with ``full`` about a quarter of an hour.

    ``progress`` is called with a line of text before each step. A slow machine raises nothing: a missed target is a row
    of the report.
    """
    start = time.perf_counter()
    before = machine_load()
    plan = plan or (FULL if full else QUICK)
    progress("the sign on every τ and β in (0, 1)")
    impact, iwc_seconds, iwc_text = _impact()
    bisections = []
    for box in plan.boxes:
        for choice in Choice:
            progress(f"bisection on τ in [{box[0]}, {box[1]}], halving {choice.value}")
            ends = (fmpq(box[0]), fmpq(box[1]), *_BETA)
            bisections.append(bisect(ends, choice, plan.bisection_seconds))
    progress("the same ranges by this package")
    rows = [impact, _speed(bisections), *map(_far, _FAR)]
    growth, atlas_seconds, atlas_text = _growth(plan, progress)
    rows.append(_atlas(plan, growth[0]))
    progress("the checker")
    rows.append(_checked("checker, the sign for β in (0, 1)", iwc_text, iwc_seconds))
    rows.append(_checked(f"checker, the atlas (1, {plan.ends[-1]})", atlas_text, atlas_seconds))
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        f"before: {before}; after: {machine_load()}",
    )
    return SignCost(tuple(rows), tuple(bisections), growth, remarks, full, time.perf_counter() - start)


def _impact() -> tuple[Row, float, str]:
    """The sign of dTheta/dtau for every tau and every beta in (0, 1), with its certificate."""
    kept: list[str] = []

    def prove() -> None:
        result = sign("-inf..inf", "0..1")
        kept[:] = [certificate_text(result.statement, result.columns) if result.columns else ""]

    seconds = measure({"it": Contestant(prove, clear_caches, 15)})["it"].median
    target = Target("time", 0.3, "s")
    note = "by numbers, not by the Laplace integral; the text of the certificate included"
    asked = "dΘ/dτ < 0, all τ, β in (0, 1)"
    return Row("sign", asked, target, seconds if kept[0] else None, seconds, note=note), seconds, kept[0]


def _ours(box: tuple[int, int]) -> tuple[float, bool]:
    """The median time on one range of tau, and whether the sign was proved."""
    kept: list[SignResult] = []

    def prove() -> None:
        kept[:] = [sign(f"[{box[0]}..{box[1]}]", f"[{_BETA[0]}..{_BETA[1]}]")]

    seconds = measure({"it": Contestant(prove, clear_caches, 15)})["it"].median
    return seconds, bool(kept[0].columns)


def _speed(bisections: list[Bisection]) -> Row:
    """Ours against the faster form of the bisection; a lower bound where neither form came to an end."""
    seconds, proved = _ours(_COMPARED)
    asked = f"τ in [{_COMPARED[0]}, {_COMPARED[1]}], β in [1/100, 99/100]"
    ends = tuple(map(fmpq, _COMPARED))
    forms = [item for item in bisections if item.box[:2] == ends]
    if not forms or not proved:
        return Row("sign", asked, _SPEED, None, seconds, note="no proof" if forms else "bisection not run")
    other = min(forms, key=lambda item: (not item.finished, item.seconds))
    figure: float | None = other.seconds / seconds
    note = f"against halving {other.choice.value}"
    if not other.finished:
        note = "no bisection came to an end: the figure is a lower bound"
        if not _SPEED.met(figure):
            figure, note = None, f"no bisection came to an end; at least {figure:.3g} x"
    return Row("sign", asked, _SPEED, figure, seconds, baseline=other.seconds, note=note)


def _far(box: tuple[int, int]) -> Row:
    seconds, proved = _ours(box)
    asked = f"τ in [{box[0]}, {box[1]}], β in [1/100, 99/100]"
    return Row("sign", asked, Target("time", 1.0, "s"), seconds if proved else None, seconds)


def _growth(plan: Plan, progress: Progress) -> tuple[tuple[FittedGrowth, ...], float, str]:
    """The three growths; the time and the certificate of the last range (1, k), which is the atlas."""
    first, text = [], ""
    for k in plan.ends:
        progress(f"zeros for β in (1, {k})")
        measured, _, text = time_range(1, k)
        first.append(measured)
    second, third = [], []
    for size in plan.half_sizes:
        progress(f"zeros for β in ({plan.middle - size}, {plan.middle + size})")
        second.append(time_range(plan.middle - size, plan.middle + size)[0])
    for m in plan.cells:
        progress(f"zeros for β in ({m}, {m + 1})")
        third.append(time_range(m, m + 1)[0])
    return (from_one(first), around(second), cells(third)), first[-1].seconds, text


def _atlas(plan: Plan, growth: FittedGrowth) -> Row:
    measured = growth.points[-1][1]
    end = plan.ends[-1]
    counted = f"{measured.columns} columns, {measured.pieces} pieces, the text of the certificate included"
    note = counted if end == _ATLAS_END else f"{counted}; (1, {end}) only, --large does (1, {_ATLAS_END})"
    figure = measured.seconds if measured.proved else None
    return Row("zeros", f"zeros for β in (1, {end})", Target("time", 60.0, "s"), figure, measured.seconds, note=note)


def _checked(asked: str, text: str, producer: float) -> Row:
    """The independent checker on a certificate, its start included."""
    if not text:
        return Row("checker", asked, _CHECKER, None, producer, note="no certificate")
    try:
        script = checker_path()
    except ValueError:
        return Row("checker", asked, _CHECKER, None, producer, note="proofs/checker: not found")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "certificate"
        file.write_text(text, encoding="utf-8")
        command = [sys.executable, "-I", str(script), str(file)]
        limit = 30 * producer + 30
        start = time.perf_counter()
        try:
            done = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return Row("checker", asked, _CHECKER, None, producer, note=f"no answer within {limit:.0f} s")
        seconds = time.perf_counter() - start
    if done.returncode or not done.stdout.startswith("VERIFIED"):
        said = (done.stderr or done.stdout).strip()[:160]
        return Row("checker", asked, _CHECKER, None, producer, warm=seconds, note=f"not verified: {said}")
    note = f"an empty Python process alone: {seconds_text(_empty_process())}"
    return Row("checker", asked, _CHECKER, seconds / producer, producer, warm=seconds, note=note)


def _empty_process() -> float:
    def call() -> None:
        subprocess.run([sys.executable, "-I", "-c", "pass"], check=True)

    return measure({"it": Contestant(call, repeats=5)})["it"].median
