"""What following slip from a state to its G-spot costs, for ``gspot-verified cost mechanism``."""

from __future__ import annotations

import time
from collections.abc import Callable

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.times.rows import Row, Target
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.shipped import shipped_mechanism

CASES = (
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}),
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-1/2"}),
    ("extended", {"x": "0", "u": "3", "p": "1/4", "b": "-1/2"}),
    ("rod", {"X": "0", "X_dot": "2", "theta": "theta_ref - 1/20", "theta_dot": "1/2"}),
)
_SECONDS = 3.0


def approach_rows(progress: Callable[[str], None] = lambda _: None) -> list[Row]:
    """One row for each start: processor time of everything, from the mechanism to the side."""
    rows = []
    for name, state in CASES:
        text = ", ".join(f"{word} = {value}" for word, value in state.items())
        progress(f"approach of {name} from {text}")
        forget()
        start = time.process_time()
        result = approach(shipped_mechanism(name), state)
        figure = time.process_time() - start
        rows.append(
            Row(
                "approach",
                f"{result.name}, {text}",
                Target("processor time", _SECONDS, "s"),
                figure,
                cold=figure,
                note=f"{result.end}, {result.side}, {result.bits} bits",
            )
        )
    return rows
