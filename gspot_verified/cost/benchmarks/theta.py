"""The benchmark behind ``gspot-verified cost theta``: every case with its target, met or missed by how much."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.cost.peers.external import PROGRAMS, ExternalTime, ask
from gspot_verified.cost.times import cases
from gspot_verified.cost.times.cases import HALF, SEVEN_THIRDS, SPEED, asked, first_attempt_note, general_beta_fresh
from gspot_verified.cost.times.measure import ChildRun, machine_load, run_child
from gspot_verified.cost.times.rows import Row, Target, TimeCurve, curves, grouped, seconds_text, table
from gspot_verified.numbers.written import Written

BASELINE_LIMIT = 900.0  # seconds; what takes longer is stopped, and the row says so
MPMATH_LIMIT = 120.0  # seconds
_OURS_LIMIT = 600.0  # seconds

Progress = Callable[[str], None]


def _child(who: str, tau: fmpq, digits: int, limit: float) -> ChildRun:
    return run_child({"who": who, "tau": str(tau), "beta": "1/2", "digits": digits}, limit)


def against_baseline(progress: Progress) -> Iterator[Row]:
    """10^5 digits against the baseline, one run each."""
    for tau in (SEVEN_THIRDS, -SEVEN_THIRDS):
        words = asked(tau, HALF, 100_000)
        progress(f"{words}: ours, then the baseline (minutes)")
        ours, other = _child("ours", tau, 100_000, _OURS_LIMIT), _child("baseline", tau, 100_000, BASELINE_LIMIT)
        speed = other.seconds / ours.seconds if ours.seconds and other.seconds else None
        first = first_attempt_note(other.first_attempt, ours.seconds) if other.first_attempt and ours.seconds else ""
        said = [ours.note, other.note, first, _processor(ours, other)]
        note = "; ".join(["one run each in a fresh process, nothing warmed", *filter(None, said)])
        target = Target("baseline / cold", SPEED[100_000], at_most=False)
        yield Row("many digits", words, target, speed, ours.seconds, baseline=other.seconds, note=note)


def _processor(ours: ChildRun, other: ChildRun) -> str:
    if not ours.processor or not other.processor:
        return ""
    mine, theirs = seconds_text(ours.processor), seconds_text(other.processor)
    return f"processor time {mine} and {theirs}: {other.processor / ours.processor:.3g} x"


def mpmath_at_many_digits(progress: Progress) -> str:
    """What mpmath does with 10^4 digits, in words."""
    progress(f"mpmath at 10^4 digits (at most {MPMATH_LIMIT:g} s)")
    run = _child("mpmath", SEVEN_THIRDS, 10_000, MPMATH_LIMIT)
    return f"mpmath, τ=7/3 β=1/2 10000 digits: {run.note or f'{run.seconds:.1f} s'}"


def general_beta_rows(progress: Progress) -> Iterator[Row]:
    """beta = 7/3 and 7/5 against 1/2 at 10^5 digits."""
    progress("general β at 10^5 digits")
    yield from general_beta_fresh(100_000, _OURS_LIMIT)


def growth(progress: Progress) -> Row:
    """From 10^5 to 10^6 digits: how much longer, and the peak memory."""
    progress("10^6 digits")
    small = _child("ours", SEVEN_THIRDS, 100_000, _OURS_LIMIT)
    large = _child("ours", SEVEN_THIRDS, 1_000_000, _OURS_LIMIT)
    ratio = large.seconds / small.seconds if small.seconds and large.seconds else None
    note = f"peak memory: {_megabytes(small)} at 10^5, {_megabytes(large)} at 10^6 digits"
    note = "; ".join([note, *filter(None, [small.note, large.note])])
    target = Target("time at 10^6 / at 10^5 digits", 20.0)
    return Row("growth", asked(SEVEN_THIRDS, HALF, 1_000_000), target, ratio, large.seconds, note=note)


def _megabytes(run: ChildRun) -> str:
    return "unknown" if run.peak_bytes is None else f"{run.peak_bytes / 1e6:.0f} MB"


_EXTERNAL_DIGITS = (15, 50, 1_000, 10_000)  # 100,000 with --large only
_HEAD = (
    "Times are medians. cold: the package's caches are empty (FLINT's constants are not); warm: the same call again;\n"
    "baseline: t01-t03 and three FLINT 1F2, precision doubled until the accuracy is met; mpmath: hyp1f2, no bound."
)


@dataclass(frozen=True, slots=True)
class CostReport(Written):
    """What the benchmark measured, where, and under which load. ``str`` is a table of the rows that matter."""

    written: ClassVar[str] = "rows external curves remarks full seconds summary"

    rows: tuple[Row, ...]
    external: tuple[ExternalTime, ...]
    curves: tuple[TimeCurve, ...]
    remarks: tuple[str, ...]
    full: bool
    seconds: float

    @property
    def missed(self) -> tuple[Row, ...]:
        """The rows whose target is missed. A row without a figure is neither met nor missed."""
        return tuple(row for row in self.rows if row.met is False)

    def summary(self) -> str:
        """One line: how many targets are met, missed, not measured."""
        met = sum(row.met is True for row in self.rows)
        open_rows = sum(row.met is None for row in self.rows)
        return f"{met} of {len(self.rows)} met, {len(self.missed)} missed, {open_rows} not measured"

    def table(self, all_rows: bool = True) -> str:
        """The table with every row, or (``all_rows=False``) with the worst and the missed rows of the large groups."""
        return table(self.rows if all_rows else grouped(self.rows))

    def __str__(self) -> str:
        parts = [_HEAD, self.table(all_rows=False)]
        if len(grouped(self.rows)) < len(self.rows):
            parts.append("Of a large group only the row nearest to a miss and the missed ones are shown (--json: all).")
        if self.external:
            parts.append("Other programs (first call, repeated call)\n" + "\n".join(map(_external_line, self.external)))
        return "\n\n".join([*parts, "\n".join([*self.remarks, self.summary()])])


def _external_line(item: ExternalTime) -> str:
    words = f"  {item.program:16}  τ={item.tau} β={item.beta} {item.digits} digits: "
    if item.first is None:
        return words + item.note
    right = "" if item.right is None or item.right >= item.digits else f", only {item.right} digits right"
    return f"{words}{seconds_text(item.first)}, {seconds_text(item.again)}{right}"


def run(full: bool = False, progress: Progress = lambda _: None) -> CostReport:
    """Run the benchmark: about a minute; with ``full`` also 10^5 and 10^6 digits, a quarter of an hour or more.

    ``progress`` is called with a line of text before each step. A slow machine raises nothing: a missed target is a row
    of the report.
    """
    start = time.perf_counter()
    before = machine_load()
    rows: list[Row] = []
    for words, step in _STEPS:
        progress(words)
        rows += step()
    remarks = [f"Python {platform.python_version()}, {platform.machine()}"]
    if full:
        rows += [*against_baseline(progress), *general_beta_rows(progress), growth(progress)]
        remarks.append(mpmath_at_many_digits(progress))
    progress("other programs")
    external = tuple(_external(full))
    progress("time against digits")
    drawn = curves(full)
    remarks.append(f"before: {before}; after: {machine_load()}")
    return CostReport(tuple(rows), external, drawn, tuple(remarks), full, time.perf_counter() - start)


_STEPS: tuple[tuple[str, Callable[[], Iterator[Row]]], ...] = (
    ("few digits", cases.few_digits),
    ("far τ", cases.far_tau),
    ("many digits", cases.many_digits),
    ("general β", cases.general_beta),
    ("array and import", cases.array_and_import),
)


def run_peers(progress: Progress = lambda _: None) -> CostReport:
    """Every cell beside its peers, interleaved: ratios of the shortest times; then the limits. A few minutes."""
    from gspot_verified.cost.peers import peers
    from gspot_verified.cost.times import limits

    start, before = time.perf_counter(), machine_load()
    rows: list[Row] = []
    steps: tuple[tuple[str, Callable[[], Iterator[Row]]], ...] = (
        ("one value", peers.one_value),
        ("first calls", peers.first_calls),
        ("far τ", peers.far_values),
        ("many values", peers.many_values),
        ("limits: products", limits.many_digits),
        ("limits: memory", limits.memory_traffic),
    )
    for words, step in steps:
        progress(words)
        rows += step()
    progress("other programs")
    external = tuple(_external(False))
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        "The times of these rows are the shortest ones; baseline: FLINT (1F2 and 1/Γ), DOP853 or the limit.",
        f"before: {before}; after: {machine_load()}",
    )
    return CostReport(tuple(rows), external, (), remarks, False, time.perf_counter() - start)


def _external(full: bool) -> Iterator[ExternalTime]:
    for program in PROGRAMS:
        for digits in (*_EXTERNAL_DIGITS, *((100_000,) if full else ())):
            for tau in (cases.SEVEN_THIRDS, -cases.SEVEN_THIRDS)[: 1 if digits > 10_000 else 2]:
                answer = ask(program, tau, cases.HALF, digits, 300.0 if full else 20.0)
                yield answer
                if answer.first is None:
                    break
            if answer.first is None:
                break
        if answer.first is not None:
            yield ask(program, fmpq(10**6), cases.HALF, 50, 20.0)
