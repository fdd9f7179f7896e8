"""The numbers that are drawn of a run: lines phase by phase, boxes that hold the trajectory, the places of events."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.scene.run import RunEvent, SceneRun
from gspot_verified.scenes.scene.samples import RADIUS, Boxes, Samples

if TYPE_CHECKING:
    from numpy import ndarray

    Column = ndarray[Any, Any]

_TURN = 1e-9  # of the largest |p|: by so much it may grow from row to row and count as falling
_ULPS = 4 * 2.0**-52  # of the time: two floats nearer than this are the same time

Box = tuple[float, float, float, float]
"""Where it begins and ends on the horizontal axis, its lower and its upper bound."""


@dataclass(frozen=True)
class Place:
    """An event on the horizontal axis, and on the curves: between a row and the next one, at a share of the way; None:
    nothing is sampled there."""

    name: str
    at: float
    between: tuple[int, float] | None

    def value(self, column: Column) -> float | None:
        """The value of a curve there."""
        return None if self.between is None else _along(column, *self.between)


def _along(column: Column, row: int, share: float) -> float:
    first = float(column[row])
    return first if share == 0 else first + share * (float(column[row + 1]) - first)


def falls(samples: Samples) -> bool:
    """Whether p falls all along, so that it can stand for time."""
    import numpy as np

    p = samples.columns["p"]
    return bool(np.all(np.diff(p) <= _TURN * np.abs(p).max(initial=0.0)))


def phase_rows(samples: Samples) -> list[tuple[int, int]]:
    """The rows of each phase, first and last; a line through them crosses no event that changes the phase.

    >>> phase_rows(Samples({}, ("slip", "slip", "flight")))
    [(0, 1), (2, 2)]
    """
    names, found, first = samples.phases, list[tuple[int, int]](), 0
    for k in range(1, len(names) + 1):
        if k == len(names) or names[k] != names[first]:
            found.append((first, k - 1))
            first = k
    return found


def places(run: SceneRun, over: str) -> list[Place]:
    """Where each event of the run is drawn over "t" or "p"; one at whose time nothing is sampled has a place over t
    alone, and none over p."""
    found = []
    for event in run.events:
        between = None if run.samples is None else sampled_at(event, run.samples)
        if between is not None and run.samples is not None:
            found.append(Place(event.name, _along(run.samples.columns[over], *between), between))
        elif over == "t":
            found.append(Place(event.name, approximate((event.lower + event.upper) / 2), None))
    return found


def sampled_at(event: RunEvent, samples: Samples) -> tuple[int, float] | None:
    """The first row whose time may be that of the event, as its enclosure and the bracket meet. Between the rows of one
    phase the event has a place only where a box holds the line that joins them."""
    times = samples.columns["t"].tolist()
    radii = samples.columns.get(f"t{RADIUS}")
    lower, upper = approximate(event.lower), approximate(event.upper)
    room = _ULPS * abs(upper)
    for row, time in enumerate(times):
        radius = room + (0.0 if radii is None else float(radii[row]))
        if lower - radius <= time <= upper + radius:
            return row, 0.0
    for row in range(len(times) - 1 if samples.boxes is not None else 0):
        if samples.phases[row] == samples.phases[row + 1] and times[row] < lower <= upper < times[row + 1]:
            return row, (lower / 2 + upper / 2 - times[row]) / (times[row + 1] - times[row])
    return None


def boxes_over(boxes: Boxes, over: str, name: str, scale: float, tall: float, wide: float) -> list[list[Box]]:
    """The boxes of one column, in stretches without a gap; neighbours are put into one box as long as it is not taller
    or wider than is asked for. Values are divided by ``scale``."""
    begins, ends = (boxes.upper, boxes.lower) if over == "p" else (boxes.lower, boxes.upper)
    rows = zip(
        begins[over].tolist(), ends[over].tolist(), boxes.lower[name].tolist(), boxes.upper[name].tolist(), strict=True
    )
    stretches: list[list[Box]] = [[]]
    for begin, end, low, high in rows:
        box = (begin, end, *_divided(low, high, scale))
        if not all(map(math.isfinite, box)):
            stretches.append([])
            continue
        stretch = stretches[-1]
        joined = _joined(stretch[-1], box) if stretch else None
        if joined is not None and joined[3] - joined[2] <= tall and abs(joined[1] - joined[0]) <= wide:
            stretch[-1] = joined
        else:
            stretch.append(box)
    return [stretch for stretch in stretches if stretch]


def _divided(low: float, high: float, scale: float) -> tuple[float, float]:
    """Rounded outwards."""
    if scale == 1:
        return low, high
    return math.nextafter(low / scale, -math.inf), math.nextafter(high / scale, math.inf)


def _joined(first: Box, second: Box) -> Box:
    forward = first[1] >= first[0]
    end = max(first[1], second[1]) if forward else min(first[1], second[1])
    return first[0], end, min(first[2], second[2]), max(first[3], second[3])


def outline(stretch: Sequence[Box]) -> list[tuple[float, float]]:
    """The corners of one stretch of boxes: along the upper sides and back along the lower ones."""
    above = [(x, box[3]) for box in stretch for x in box[:2]]
    below = [(x, box[2]) for box in reversed(stretch) for x in (box[1], box[0])]
    return above + below
