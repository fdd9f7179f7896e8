"""What a benchmark gives: rows with targets, curves for the picture, remarks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from gspot_verified.cost.times.curves import TimeCurve
from gspot_verified.cost.times.rows import Row, table
from gspot_verified.numbers.written import Written


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
