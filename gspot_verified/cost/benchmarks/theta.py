"""The benchmark behind ``gspot-verified cost theta``: every case with its target, met or missed by how much."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.cost.benchmarks import heavy
from gspot_verified.cost.peers.external import PROGRAMS, ExternalTime, ask
from gspot_verified.cost.times import cases
from gspot_verified.cost.times.curves import TimeCurve, curves
from gspot_verified.cost.times.measure import machine_load
from gspot_verified.cost.times.rows import Row, grouped, seconds_text, table
from gspot_verified.numbers.written import Written

Progress = Callable[[str], None]

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
        rows += [*heavy.against_baseline(progress), *heavy.general_beta_rows(progress), heavy.growth(progress)]
        remarks.append(heavy.mpmath_at_many_digits(progress))
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
