"""The lines of the benchmark: what was asked, what it took, the target, by how much it was met or missed; curves."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from flint import fmpq

from gspot_verified.cost.times.baseline import flint_theta, mpmath_theta
from gspot_verified.cost.times.measure import Contestant, clear_caches, measure
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.theta import theta


@dataclass(frozen=True, slots=True)
class Benchmark(Written):
    """What was measured. ``str`` is the table under its heading."""

    written: ClassVar[str] = "rows curves remarks seconds summary"

    head: str
    rows: tuple[Row, ...]
    curves: tuple[TimeCurve, ...]
    remarks: tuple[str, ...]
    seconds: float

    def summary(self) -> str:
        """One line: how many targets are met and missed."""
        met = sum(row.met is True for row in self.rows)
        return f"{met} of {len(self.rows)} met, {len(self.rows) - met} missed"

    def __str__(self) -> str:
        return "\n\n".join([self.head, table(self.rows), "\n".join([*self.remarks, self.summary()])])


_TAU = fmpq(7, 3)  # where the curves of time over digits are measured
_DIGITS = (10, 30, 100, 300, 1_000, 3_000, 10_000, 30_000, 100_000)  # the last two in full only
_MPMATH_DIGITS = 1_000  # beyond them mpmath takes too long


@dataclass(frozen=True, slots=True)
class TimeCurve(Written):
    """Seconds at some numbers of digits, or at another number."""

    name: str
    points: tuple[tuple[float, float], ...]


def curves(full: bool) -> tuple[TimeCurve, ...]:
    """First calls at tau = 7/3, up to 10^4 digits (10^5 when ``full``).

    A curve ends after the point that takes longer than 1 second (10 when ``full``), mpmath's at 10^3 digits: its next
    point would take minutes, for Bernoulli numbers.
    """
    half, third = fmpq(1, 2), fmpq(7, 3)
    calls: dict[str, Callable[[int], object]] = {
        "this package, β = 1/2": lambda digits: theta(_TAU, half, 0, digits),
        "this package, β = 7/3": lambda digits: theta(_TAU, third, 0, digits),
        "three FLINT 1F2, β = 1/2": lambda digits: flint_theta(_TAU, half, 0, digits),
        "mpmath hyp1f2, β = 1/2": lambda digits: mpmath_theta(_TAU, half, 0, digits),
    }
    digits, patience = (_DIGITS, 10.0) if full else (_DIGITS[:-2], 1.0)
    last = {"mpmath hyp1f2, β = 1/2": _MPMATH_DIGITS}
    return tuple(
        TimeCurve(name, curve(call, tuple(count for count in digits if count <= last.get(name, count)), patience))
        for name, call in calls.items()
    )


def curve(call: Callable[[int], object], digits: tuple[int, ...], patience: float) -> tuple[tuple[int, float], ...]:
    """The points of one curve, with empty caches before every call, up to the first above ``patience`` seconds."""
    points: list[tuple[int, float]] = []
    for count in digits:
        contestant = Contestant(partial(call, count), clear_caches, 7)
        points.append((count, measure({"it": contestant}, 0.5)["it"].median))
        if points[-1][1] > patience:
            break
    return tuple(points)


_UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"))
_HEADER = ("asked", "cold", "warm", "baseline", "mpmath", "figure", "target", "outcome")


@dataclass(frozen=True, slots=True)
class Target:
    """A bound on a figure: seconds ("s") or a ratio ("x"); ``words`` says what the figure is."""

    words: str
    limit: float
    unit: str = "x"
    at_most: bool = True

    def __str__(self) -> str:
        return f"{self.words} {'<=' if self.at_most else '>='} {figure_text(self.limit, self.unit)}"

    def met(self, figure: float | None) -> bool | None:
        """Whether the figure is within the bound; ``None`` without a figure."""
        if figure is None:
            return None
        return figure <= self.limit if self.at_most else figure >= self.limit

    def outcome(self, figure: float | None) -> str:
        """``met``, ``missed by 1.3 x`` (how many times too large, or too small), or ``not measured``.

        >>> Target("cold", 0.005, "s").outcome(0.01), Target("speed", 8, at_most=False).outcome(16.0)
        ('missed by 2.00 x', 'met')
        """
        if figure is None:
            return "not measured"
        if self.met(figure):
            return "met"
        excess = figure / self.limit if self.at_most else self.limit / figure
        return f"missed by {excess:.2f} x"


@dataclass(frozen=True, slots=True)
class Row(NoTruthValue, Written):
    """One measurement. Times are medians in seconds, ``None`` where there is none; ``note`` says why.

    ``cold``: the package's caches are empty before each call. ``warm``: the same call again. ``figure`` is what the
    target speaks of.
    """

    ask: ClassVar[str] = ".met is True, False or None (no figure)"
    written: ClassVar[str] = "case asked target figure cold warm baseline mpmath note met outcome"

    case: str
    asked: str
    target: Target
    figure: float | None
    cold: float | None = None
    warm: float | None = None
    baseline: float | None = None
    mpmath: float | None = None
    note: str = ""

    @property
    def met(self) -> bool | None:
        """Whether the target is met; ``None`` when there is no figure."""
        return self.target.met(self.figure)

    @property
    def outcome(self) -> str:
        """``met``, ``missed by ...`` or ``not measured``."""
        return self.target.outcome(self.figure)

    @property
    def badness(self) -> float:
        """How near to a miss: above 1 is missed; a row without a figure counts as missed."""
        if self.figure is None:
            return float("inf")
        return self.figure / self.target.limit if self.target.at_most else self.target.limit / self.figure

    def cells(self) -> tuple[str, ...]:
        """The texts of the table, in the order of its columns."""
        times = (seconds_text(value) for value in (self.cold, self.warm, self.baseline, self.mpmath))
        return (self.asked, *times, figure_text(self.figure, self.target.unit), str(self.target), self.outcome)


def seconds_text(seconds: float | None) -> str:
    """A time in three digits with its unit.

    >>> seconds_text(0.000123456), seconds_text(None)
    ('123 µs', '-')
    """
    if seconds is None:
        return "-"
    scale, unit = next((pair for pair in _UNITS if seconds >= pair[0]), _UNITS[-1])
    return f"{seconds / scale:.3g} {unit}" if seconds < 1000 else f"{seconds:.0f} s"


def figure_text(figure: float | None, unit: str) -> str:
    """A time, or a ratio such as ``1.5 x``."""
    return seconds_text(figure) if unit == "s" or figure is None else f"{figure:.3g} x"


def table(rows: Iterable[Row]) -> str:
    """The rows as aligned text, one block per case, notes under their row."""
    rows = list(rows)
    lines = [_HEADER, *(row.cells() for row in rows)]
    widths = [max(len(line[column]) for line in lines) for column in range(len(_HEADER))]
    text, case = [_aligned(_HEADER, widths)], ""
    for row in rows:
        if row.case != case:
            case = row.case
            text += ["", case]
        text.append(_aligned(row.cells(), widths))
        if row.note:
            text.append(f"      {row.note}")
    return "\n".join(text)


def _aligned(cells: tuple[str, ...], widths: list[int]) -> str:
    parts = [cells[0].ljust(widths[0])]
    parts += [cell.rjust(width) for cell, width in zip(cells[1:6], widths[1:6], strict=True)]
    parts += [cell.ljust(width) for cell, width in zip(cells[6:], widths[6:], strict=True)]
    return ("  " + "  ".join(parts)).rstrip()


def grouped(rows: Iterable[Row]) -> list[Row]:
    """The rows of a case that has many: of those with one target, the nearest to a miss, and every row that missed."""
    by_group: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        by_group.setdefault((row.case, str(row.target)), []).append(row)
    kept = []
    for group in by_group.values():
        worst = max(group, key=lambda row: row.badness)
        kept += group if len(group) <= 6 else [row for row in group if row is worst or not row.met]
    return kept
