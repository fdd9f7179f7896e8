"""What questions about states of a mechanism cost, for ``gspot-verified cost mechanism``.

Where slip leads, the side for small epsilon, the fates over a range of starts.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TypeVar

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.times.rows import Row, Target
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.mechanism_side import mechanism_side
from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.shipped import shipped_mechanism

_Result = TypeVar("_Result")

CASES = (
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}),
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-1/2"}),
    ("extended", {"x": "0", "u": "3", "p": "1/4", "b": "-1/2"}),
    ("rod", {"X": "0", "X_dot": "2", "theta": "theta_ref - 1/20", "theta_dot": "1/2"}),
)
_SECONDS, _VERDICT_SECONDS = 3.0, 10.0  # the targets for one path, and with the side for small epsilon

FATES: tuple[tuple[str, dict[str, str], dict[str, str], int], ...] = (
    ("model", {"x": "0", "u": "3", "p": "1/2"}, {"b": "-5/2..-1/2:64"}, 64),
)
LONG_FATES: tuple[tuple[str, dict[str, str], dict[str, str], int], ...] = (
    ("rod_with_wrist", {"X": "0", "X_dot": "5"}, {"theta": "0.72..0.84:20", "theta_dot": "2.8..3.5:20"}, 400),
)
_SECONDS_PER_CELL = 120 / 10_000  # the target: two minutes for the largest map


def state_rows(full: bool = False, progress: Callable[[str], None] = lambda _: None) -> list[Row]:
    """Rows for each start and each range of starts: processor time of everything, from the mechanism to the answer."""
    rows = []
    for name, state in CASES:
        text = _text(state)
        progress(f"approach of {name} from {text}")
        figure, result = _timed(approach, name, state)
        note = f"{result.end}, {result.side}, {result.bits} bits"
        rows.append(_row("approach", f"{result.name}, {text}", _SECONDS, figure, note))
        progress(f"verdict of {name} from {text}")
        figure, side = _timed(mechanism_side, name, state)
        note = f"{side.side}, {side.verdict.outcome.value}"
        rows.append(_row("verdict", f"{result.name}, {text}", _VERDICT_SECONDS, figure, note))
    for name, state, over, cells in (*FATES, *(LONG_FATES if full else ())):
        text = f"{_text(state)}, {_text(over)}"
        progress(f"fates of {name} from {text}")
        figure, found = _timed(fates, name, state, over)
        note = f"{len(found.pieces)} pieces, {found.verdict.outcome.value}"
        rows.append(_row("fates", f"{found.name}, {text}", cells * _SECONDS_PER_CELL, figure, note))
    return rows


def _timed(call: Callable[..., _Result], name: str, *questions: dict[str, str]) -> tuple[float, _Result]:
    forget()
    start = time.process_time()
    result = call(shipped_mechanism(name), *questions)
    return time.process_time() - start, result


def _row(case: str, asked: str, limit: float, figure: float, note: str) -> Row:
    return Row(case, asked, Target("processor time", limit, "s"), figure, cold=figure, note=note)


def _text(values: dict[str, str]) -> str:
    return ", ".join(f"{word} = {value}" for word, value in values.items())
