"""What a benchmark gives: rows with targets, curves for the picture, remarks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gspot_verified.cost.times.curves import Curve
from gspot_verified.cost.times.rows import Row, table


@dataclass(frozen=True, slots=True)
class Benchmark:
    """What was measured. ``str`` is the table under its heading."""

    head: str
    rows: tuple[Row, ...]
    curves: tuple[Curve, ...]
    remarks: tuple[str, ...]
    seconds: float

    def summary(self) -> str:
        """One line: how many targets are met and missed."""
        met = sum(row.met is True for row in self.rows)
        return f"{met} of {len(self.rows)} met, {len(self.rows) - met} missed"

    def __str__(self) -> str:
        return "\n\n".join([self.head, table(self.rows), "\n".join([*self.remarks, self.summary()])])

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``; all times in seconds."""
        return {
            "rows": [row.to_json() for row in self.rows],
            "curves": [item.to_json() for item in self.curves],
            "remarks": list(self.remarks),
            "seconds": self.seconds,
            "summary": self.summary(),
        }
