"""What a sweep over parameters costs, for ``gspot-verified cost mechanism``."""

from __future__ import annotations

import random
import time
from collections.abc import Callable

from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.times.rows import Row, Target
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.table.approach_table import approach_table
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.numbers.counted import counted

CASES = (
    ("oscillator", {"beta": "1/2..9/2:50", "kappa": "-1..1:20"}, 1_000),
    ("genot_brogliato_rod", {"mu": "1.2..2:1000"}, 1_000),
    ("frictional_impact_oscillator_all_parameters", {"c_psi": "1/4..1/2:1000"}, 1_000),
)
LONG_CASES = (("oscillator", {"beta": "1/2..9/2:200", "kappa": "-1..1:50"}, 10_000),)
_SECONDS_PER_CELL = 30 / 10_000  # the target: half a minute for the largest case


TABLE_ROWS = 1_000  # of the table that is measured
_SECONDS_PER_ROW = 0.01  # the target
APPROACH_ROWS = 4  # of the table of states that is measured
_SECONDS_PER_PATH = 0.5  # the target


def table_row() -> Row:
    """A table of rods of random mass, length, gravity and friction, classified: processor time in one process."""
    dice = random.Random(1)
    words = ("m", "L", "g")
    table = [
        {"mu": f"{dice.randrange(1400, 3000)}/1000", **{word: f"{dice.randrange(300, 2000)}/1000" for word in words}}
        for _ in range(TABLE_ROWS)
    ]
    forget()
    start = time.process_time()
    rows = list(classify_table(shipped_mechanism("genot_brogliato_rod"), table))
    figure = time.process_time() - start
    return Row(
        "table",
        f"{TABLE_ROWS} rods, mu, m, L, g = random",
        Target("processor time", TABLE_ROWS * _SECONDS_PER_ROW, "s"),
        figure,
        cold=figure,
        note=f"{sum(row.outcome == 'settled' for row in rows)} settled",
    )


def approach_row() -> Row:
    """A table of states of the rod, slip followed for each: processor time in one process."""
    table = [{"theta": f"theta_ref - 1/{k}", "theta_dot": "1/2"} for k in range(20, 20 + APPROACH_ROWS)]
    forget()
    start = time.process_time()
    rows = list(approach_table(shipped_mechanism("rod"), table, {"X": 0, "X_dot": 2}))
    figure = time.process_time() - start
    return Row(
        "table",
        f"{APPROACH_ROWS} states of a rod, theta = theta_ref - 1/20, ...",
        Target("processor time", APPROACH_ROWS * _SECONDS_PER_PATH, "s"),
        figure,
        cold=figure,
        note=f"{sum(row.outcome == 'settled' for row in rows)} settled",
    )


def sweep_rows(full: bool = False, progress: Callable[[str], None] = lambda _: None) -> list[Row]:
    """One row for each case: processor time of the whole sweep in one process, everything derived anew."""
    rows = []
    for name, over, cells in (*CASES, *(LONG_CASES if full else ())):
        text = ", ".join(f"{parameter} = {ends}" for parameter, ends in over.items())
        progress(f"sweep of {name} over {text}")
        forget()
        start = time.process_time()
        result = sweep(shipped_mechanism(name), over)
        figure = time.process_time() - start
        rows.append(
            Row(
                "sweep",
                f"{result.name}, {text}",
                Target("processor time", cells * _SECONDS_PER_CELL, "s"),
                figure,
                cold=figure,
                note=f"{len(result.pieces)} pieces, {result.verdict.outcome.value}",
            )
        )
    progress(f"a table of {TABLE_ROWS} rods")
    progress(f"a table of {counted(APPROACH_ROWS, 'state')}")
    return [*rows, table_row(), approach_row()]
