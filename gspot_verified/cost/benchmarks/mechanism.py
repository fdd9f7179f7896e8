"""The benchmark behind ``gspot-verified cost mechanism``: to all G-spots of a mechanism, and along slip to one.

The mechanisms are planar legs and chains of slender rods, of any size.
"""

from __future__ import annotations

import platform
import random
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any

from gspot_verified.certificates.checker import checker_path
from gspot_verified.cost.benchmarks.force import forget
from gspot_verified.cost.benchmarks.mechanism_states import state_rows
from gspot_verified.cost.times.measure import Contestant, child_environment, machine_load, measure
from gspot_verified.cost.times.rows import Benchmark, Row, Target, TimeCurve
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.critical_friction import critical_friction
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.table.approach_table import approach_table
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.numbers.counted import counted


def leg(links: int, height: str = "2", mu: str = "1", **options: Any) -> Mechanism:
    """Slender rods of length 1 and mass 1, hinged in a row; the first hangs from a hip at the given height.

    The angles count from the vertical; the contact point is the end of the last rod.

    >>> leg(3).state
    ('a1', 'a2', 'a3', 'a1_dot', 'a2_dot', 'a3_dot')
    """
    return _rods(f"leg of {links} links", links, [], height, mu, options)


def chain(links: int, mu: str = "2", **options: Any) -> Mechanism:
    """The same rods with a first end that moves freely in the plane: two coordinates more.

    >>> len(chain(5).state)
    14
    """
    return _rods(f"chain of {links} links", links, ["X", "Y"], "0", mu, options)


def _rods(name: str, links: int, base: list[str], height: str, mu: str, options: dict[str, Any]) -> Mechanism:
    angles = [f"a{i + 1}" for i in range(links)]
    weights = [Fraction(1, 2) + links - 1 - i for i in range(links)]
    rows, forces = [], []
    for own, slope, sign, gravity in (("cos", "sin", "", ""), ("sin", "cos", "-", f" - {links}"))[: len(base)]:
        diagonal = [str(links) if word == ("X" if own == "cos" else "Y") else "0" for word in base]
        moments = list(zip(weights, angles, strict=True))
        rows.append(diagonal + [f"{weight}*{own}({angle})" for weight, angle in moments])
        forces.append(
            " + ".join(f"{sign}{weight}*{slope}({angle})*{angle}_dot^2" for weight, angle in moments) + gravity
        )
    for i, angle in enumerate(angles):
        row = [f"{weights[i]}*{own}({angle})" for own in ("cos", "sin")[: len(base)]]
        bends = f"-{weights[i]}*sin({angle})"
        for j, other in enumerate(angles):
            coupling = _coupling(links, i, j)
            row.append(f"{coupling}*cos({angle} - {other})" if i != j else str(coupling))
            bends += f" - {coupling}*sin({angle} - {other})*{other}_dot^2" if i != j else ""
        rows.append(row)
        forces.append(bends)
    x = " + ".join([*base[:1], *(f"sin({angle})" for angle in angles)])
    y = " - ".join([base[1] if base else height, *(f"cos({angle})" for angle in angles)])
    return lagrangian(name, [*base, *angles], rows, forces, x, y, mu, **options)


def _coupling(links: int, i: int, j: int) -> Fraction:
    """The coefficient of cos(a_i - a_j) in the mass matrix."""
    after = links - 1 - max(i, j)
    return (Fraction(1, 3) if i == j else Fraction(1, 2)) + after


Progress = Callable[[str], None]

_HEAD = (
    "Times are medians in one thread. All G-spots: read, derive, search every angle and every velocity, prove each "
    "alone in its box,\nand that there are no others. Command line: a process of its own, processor time."
)
_LEG = {"a1": "-1", "a1_dot": "-2"}
COMMANDS = (
    ("--version", 0.25),
    ("theta 7/3 1/2", 0.25),
    ("check force_5_2.cert", 0.5),
    ("simulate fig-varsim1", 1.0),
    ("classify rod", 0.5),
    ("classify oscillator", 0.5),
    ("classify rod --all", 0.5),
)
"""Commands, which leave with the code 0, and the targets of their processor time; the certificate is a shipped one."""


def run(full: bool = False, progress: Progress = lambda _: None) -> Benchmark:
    """Run the benchmark: some seconds; with ``full`` longer legs and chains, and more repeats."""
    start, before = time.perf_counter(), machine_load()
    repeats = 9 if full else 3
    rows = []
    for family in (_searches, _critical, _chains, _commands):
        rows += family(full, repeats, progress)
    rows += state_rows(full, progress)
    rows += sweep_rows(full, progress)
    points = tuple((links, _time(partial(leg, links), repeats)) for links in (2, 3, 4))
    remarks = (
        f"Python {platform.python_version()}, {platform.machine()}",
        f"before: {before}; after: {machine_load()}",
    )
    return Benchmark(_HEAD, tuple(rows), (TimeCurve("reading a leg", points),), remarks, time.perf_counter() - start)


def _time(call: Callable[[], object], repeats: int) -> float:
    return measure({"it": Contestant(call, None, repeats)}, 4.0)["it"].median


def _row(case: str, asked: str, limit: float, call: Callable[[], object], repeats: int) -> Row:
    figure = _time(call, repeats)
    return Row(case, asked, Target("time", limit, "s"), figure, warm=figure)


def _all(make: Callable[[], Mechanism]) -> object:
    return find_g_spots(make())


def _friction(make: Callable[[], Mechanism]) -> object:
    return critical_friction(make())


def _classified(links: int, place: dict[str, str]) -> object:
    return classify_all(chain(links, fixed=list(place), place=place))


def _searches(full: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("all G-spots")
    cases: list[tuple[str, float, Callable[[], Mechanism]]] = [
        ("classical rod, mu = 7/5: four", 2.0, lambda: shipped_mechanism("genot_brogliato_rod", mu="7/5")),
        ("classical rod, mu = 13/10: none", 2.0, lambda: shipped_mechanism("genot_brogliato_rod", mu="13/10")),
        ("classical rod, mu = 4/3: the fold", 2.0, lambda: shipped_mechanism("genot_brogliato_rod", mu="4/3")),
        ("oscillator", 5.0, lambda: shipped_mechanism("oscillator")),
        ("two-link leg", 5.0, lambda: leg(2, "3/2")),
        ("three-link leg, hip angle and rate fixed", 60.0, lambda: leg(3, fixed=list(_LEG), place=_LEG)),
        ("three-link leg: a patch of a surface", 60.0, lambda: leg(3)),
    ]
    if full:
        place = {**_LEG, "a2": "-1/2", "a2_dot": "0"}
        cases.append(("four-link leg, two angles fixed", 60.0, lambda: leg(4, "3", fixed=list(place), place=place)))
    return [_row("all G-spots", words, limit, partial(_all, make), repeats) for words, limit, make in cases]


def _critical(_: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("critical friction")
    cases: list[tuple[str, Callable[[], Mechanism]]] = [
        ("classical rod", lambda: shipped_mechanism("genot_brogliato_rod")),
        ("two-link leg", lambda: leg(2, "3/2")),
    ]
    return [_row("critical friction", words, 2.0, partial(_friction, make), repeats) for words, make in cases]


def _chains(full: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("chains")
    rows = []
    for links in (3, 5, *((6,) if full else ())):
        angles = [f"a{i}" for i in range(1, links)]
        place = {"X": "0", "X_dot": "0"}
        for i, angle in enumerate(angles):
            place |= {angle: f"{i}/20", f"{angle}_dot": "0"}
        rows.append(
            _row(
                "chains",
                f"{links} links: all G-spots classified, the last angle and its rate free",
                60.0,
                partial(_classified, links, place),
                repeats,
            )
        )
    return rows


def _commands(_: bool, repeats: int, progress: Progress) -> list[Row]:
    progress("the command line")
    rows = []
    for words, limit in COMMANDS:
        arguments = [str(checker_path().with_name(word)) if word.endswith(".cert") else word for word in words.split()]
        figure = sorted(_processor_seconds(arguments) for _ in range(repeats))[repeats // 2]
        rows.append(
            Row("command line", f"gspot-verified {words}", Target("processor", limit, "s"), figure, cold=figure)
        )
    return rows


def _processor_seconds(arguments: list[str]) -> float:
    """Processor time of a process of its own, user and system."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [sys.executable, "-m", "gspot_verified", *arguments], capture_output=True, env=child_environment(), check=True
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


CASES = (
    ("oscillator", {"beta": "1/2..9/2:50", "kappa": "-1..1:20"}, 1_000),
    ("genot_brogliato_rod", {"mu": "1.2..2:1000"}, 1_000),
    ("frictional_impact_oscillator_all_parameters", {"c_psi": "1/4..1/2:1000"}, 1_000),
)
LONG_CASES = (("oscillator", {"beta": "1/2..9/2:200", "kappa": "-1..1:50"}, 10_000),)
_SECONDS_PER_CELL = 30 / 10_000  # the target: half a minute for the largest case


TABLE_ROWS = 1_000  # of the table that is measured
_SECONDS_PER_ROW = 0.01  # the target
APPROACH_ROWS = 12  # of each table in which slip is followed
_FOLLOWED: tuple[tuple[str, Callable[[int], dict[str, str]], dict[str, str]], ...] = (
    (
        "states of a rod, theta = theta_ref - 1/20, ...",
        lambda k: {"theta": f"theta_ref - 1/{20 + k}", "theta_dot": "1/2"},
        {"X": "0", "X_dot": "2"},
    ),
    (
        "rods, mu = 3/2, 151/100, ...",
        lambda k: {"mu": f"{150 + k}/100"},
        {"X": "0", "X_dot": "2", "theta": "theta_ref - 1/20", "theta_dot": "1/2"},
    ),
)


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


def approach_rows() -> list[Row]:
    """Tables of rods in which slip is followed: processor time in one process, cold with what is derived once."""
    rows = []
    for text, row_of, state in _FOLLOWED:
        table = [row_of(k) for k in range(APPROACH_ROWS)]
        forget()
        times = []
        for _ in range(2):
            start = time.process_time()
            found = list(approach_table(shipped_mechanism("rod"), table, state))
            times.append(time.process_time() - start)
        target = Target("processor time", APPROACH_ROWS * _SECONDS_PER_ROW, "s")
        note = f"{sum(row.outcome == 'settled' for row in found)} settled"
        rows.append(Row("table", f"{APPROACH_ROWS} {text}", target, times[1], cold=times[0], warm=times[1], note=note))
    return rows


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
    progress(f"tables of {counted(APPROACH_ROWS, 'row')} in which slip is followed")
    return [*rows, table_row(), *approach_rows()]
