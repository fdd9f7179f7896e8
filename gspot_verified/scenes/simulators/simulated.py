"""A simulated motion as a table, and what happens in it."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import ContactFloats

LEAVES, IMPULSE, STOPS, NOTHING = "leaves the surface", "leaves after an impulse", "slip stops", "no event"
_SLOW = 0.01  # of the slip velocity at the start: below it slip has stopped
_BRAKED = 0.5  # of the same: who leaves with less has met an impulse
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
MAX_ROWS = 2_000_000  # of a file: a limit of input


@dataclass(frozen=True)
class Simulated:
    """Times, states in the order of the mechanism, and the contact force where the simulator says it."""

    times: Sequence[float]
    states: Sequence[Sequence[float]]
    forces: Sequence[float] | None = None


@dataclass(frozen=True)
class Happened:
    """What comes first, at the time of the row in which it is seen, and with which slip velocity against the surface.

    ``since``: up to this time nothing came.
    """

    what: str
    time: float | None
    slip: float | None
    since: float


def what_happens(
    motion: Simulated, functions: ContactFloats, surface_velocity: float = 0.0, *, lasting: float
) -> Happened:
    """Contact is lost where the force is 0 (if there is none: where y > 0) for a time ``lasting`` and longer, else that
    is a rebound of the step; slip stops where it is below a hundredth of what it was, or has turned since the row
    before."""
    contacts = [functions.contact(state) for state in motion.states]
    slips = [contact.u - surface_velocity for contact in contacts]
    free = [c.y > 0 for c in contacts] if motion.forces is None else [force <= 0 for force in motion.forces]
    left = _lost(motion.times, free, lasting)
    stopped = next((i for i, slip in enumerate(slips) if slip * slips[0] < _SLOW * slips[0] ** 2), None)
    if left is not None and (stopped is None or left < stopped):
        what = LEAVES if abs(slips[left]) > _BRAKED * abs(slips[0]) else IMPULSE
        return Happened(what, motion.times[left], slips[left], motion.times[left - 1])
    if stopped is not None:
        return Happened(STOPS, motion.times[stopped], slips[stopped], motion.times[max(stopped - 1, 0)])
    ended = len(free) - 1
    while ended > 0 and free[ended]:  # perhaps a flight that the end of the table cuts
        ended -= 1
    return Happened(NOTHING, None, None, motion.times[ended])


def _lost(times: Sequence[float], free: Sequence[bool], lasting: float) -> int | None:
    """The first row from which on the contact is free for that long; the first instant is the start in contact."""
    begin: int | None = None
    for i, alone in enumerate(free[1:], 1):
        begin = (i if begin is None else begin) if alone else None
        if begin is not None and times[i] - times[begin] >= lasting:
            return begin
    return None


def read_motion(path: str | Path, functions: ContactFloats) -> Simulated:
    """A table of comma-separated values: a column t, one for each component of the state, and, if known, force.

    :raises SceneError: the file cannot be read, a column is missing or there twice, a value is no finite number, times
        do not grow.
    """
    try:
        with open(path, newline="", encoding="utf-8") as lines:
            reader = csv.DictReader(lines)
            rows, columns = list(reader), list(reader.fieldnames or ())
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise SceneError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if not 2 <= len(rows) <= MAX_ROWS:
        raise SceneError(f"{path}: expected 2 to {MAX_ROWS} rows below a line of names, got {len(rows)}")
    twice = [name for name in ("t", *functions.names, "force") if columns.count(name) > 1]
    if twice:
        raise SceneError(f"{path}: column {', '.join(twice)} is there twice")
    missing = [name for name in ("t", *functions.names) if name not in rows[0]]
    if missing:
        raise SceneError(f"{path}: no column {', '.join(missing)}; needed: t, {', '.join(functions.names)}")
    table = {name: _column(path, rows, name) for name in ("t", *functions.names)}
    times = table["t"]
    if any(later <= earlier for earlier, later in pairwise(times)):
        raise SceneError(f"{path}: the times of column t must grow from row to row")
    states = list(zip(*(table[name] for name in functions.names), strict=True))
    return Simulated(times, states, _column(path, rows, "force") if "force" in rows[0] else None)


def _column(path: str | Path, rows: Sequence[dict[str, str]], name: str) -> list[float]:
    wrong = [(line, row[name]) for line, row in enumerate(rows, 2) if not is_finite_number(row[name] or "")]
    if wrong:
        raise SceneError(f"{path}, line {wrong[0][0]}: {name} is no finite number: {str(wrong[0][1])[:40]!r}")
    return [float(row[name]) for row in rows]


def is_finite_number(text: str) -> bool:
    """Whether the text is a decimal number, with an exponent or not.

    >>> is_finite_number("-1.5e-3"), is_finite_number("nan"), is_finite_number("")
    (True, False, False)
    """
    return _NUMBER.fullmatch(text.strip()) is not None and math.isfinite(float(text))
