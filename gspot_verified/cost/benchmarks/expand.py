"""The benchmark behind ``gspot-verified cost expand``: time and size of exact expansions against the order."""

from __future__ import annotations

import math
import platform
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.cost.peers.sympy_expansion import sympy_extended
from gspot_verified.cost.times.measure import machine_load
from gspot_verified.cost.times.rows import Row, Target, TimeCurve, figure_text, seconds_text
from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.system import System
from gspot_verified.mechanisms.shipped import shipped_system
from gspot_verified.numbers.written import Written

Progress = Callable[[str], None]

_EXTENDED = ((15, 0.1), (60, 5.0), (120, 60.0))  # (order, at most so many seconds)
_OSCILLATOR = ((15, 2.0), (40, 60.0))  # the same for the oscillator
_SYMPY_ORDER = 10  # of delta
_SYMPY_TARGET = Target("sympy / ours", 100.0, at_most=False)
_CURVE_ORDERS = {"extended": (8, 15, 30, 60, 90, 120), "oscillator": (6, 10, 15, 20, 30, 40)}  # without --large
_FULL_ORDERS = {"extended": (*_CURVE_ORDERS["extended"], 200), "oscillator": (*_CURVE_ORDERS["oscillator"], 50)}


@dataclass(frozen=True, slots=True)
class Size(Written):
    """At one even order: bits of the longest coefficient of b_n, and the natural logarithm of the largest one."""

    written: ClassVar[str] = "order bits log_of_largest=logarithm"

    order: int
    bits: int
    logarithm: float


@dataclass(frozen=True, slots=True)
class ExpandCost(Written):
    """What the benchmark measured. ``exponent``: sigma in |b_n| ~ A^n (n!)^sigma, fitted over the last orders."""

    written: ClassVar[str] = "rows curves sizes exponent remarks seconds summary"

    rows: tuple[Row, ...]
    curves: tuple[TimeCurve, ...]
    sizes: tuple[Size, ...]
    exponent: float
    remarks: tuple[str, ...]
    seconds: float

    def summary(self) -> str:
        """One line: how many targets are met, missed."""
        met, missed = ([row.met for row in self.rows].count(value) for value in (True, False))
        return f"{met} of {len(self.rows)} met, {missed} missed"

    def __str__(self) -> str:
        lines = ["Exact expansions, one core, wall time of all orders below the one named.", ""]
        for row in self.rows:
            lines.append(
                f"  {row.asked:34} {figure_text(row.figure, row.target.unit):>9}  asked {row.target}: {row.outcome}"
            )
            lines += [f"      {row.note}"] if row.note else []
        lines += ["", "Coefficients of b_n, extended system (order: bits of the longest, ln of the largest)"]
        lines.append("  " + "; ".join(f"{s.order}: {s.bits}, {s.logarithm:.0f}" for s in self.sizes))
        lines.append(f"  {growth_text(self.exponent)}")
        return "\n".join([*lines, "", *self.remarks, self.summary()])


def growth_text(exponent: float) -> str:
    """What the fitted exponent says about convergence.

    >>> growth_text(0.34)
    '|b_n| grows like A^n (n!)^0.34, so like Gevrey order 1.02 in ε = δ^3: the series looks divergent (a fit, no proof)'
    """
    outcome = "divergent" if exponent > 0.1 else "convergent"
    return (
        f"|b_n| grows like A^n (n!)^{exponent:.2f}, so like Gevrey order {3 * exponent:.2f} in ε = δ^3: "
        f"the series looks {outcome} (a fit, no proof)"
    )


def run(full: bool = False, progress: Progress = lambda _: None) -> ExpandCost:
    """Run the benchmark: about a minute, most of it for the oscillator; ``full`` adds higher orders to the curves."""
    start = time.perf_counter()
    before = machine_load()
    rows = []
    for name, targets in (("extended", _EXTENDED), ("oscillator", _OSCILLATOR)):
        for order, limit in targets:
            progress(f"{name} system, order {order}")
            seconds = _expansion(shipped_system(name), order)[0]
            rows.append(Row(name, f"{name} system, order {order}", Target("time", limit, "s"), seconds, cold=seconds))
    progress(f"sympy, order {_SYMPY_ORDER}")
    rows.append(_against_sympy())
    curves = []
    for name, orders in (_FULL_ORDERS if full else _CURVE_ORDERS).items():
        progress(f"time against order, {name} system")
        curves.append(TimeCurve(f"{name} system", _times(shipped_system(name), orders)))
    progress("size of the coefficients")
    sizes = coefficient_sizes(_expansion(shipped_system("extended"), 121)[1])
    remarks = (f"Python {platform.python_version()}, {platform.machine()}; before: {before}; after: {machine_load()}",)
    seconds = time.perf_counter() - start
    return ExpandCost(tuple(rows), tuple(curves), sizes, fitted_exponent(sizes), remarks, seconds)


def _expansion(system: System, order: int) -> tuple[float, Recursion]:
    start = time.perf_counter()
    recursion = Recursion(system)
    for _ in range(order):
        recursion.advance()
    return time.perf_counter() - start, recursion


def _times(system: System, orders: tuple[int, ...]) -> tuple[tuple[int, float], ...]:
    """Seconds from the start to each order, of one run."""
    start = time.perf_counter()
    recursion = Recursion(system)
    points = []
    for order in range(1, max(orders) + 1):
        recursion.advance()
        if order in orders:
            points.append((order, time.perf_counter() - start))
    return tuple(points)


def _against_sympy() -> Row:
    """Both after a first run, sympy's own cache empty: its import and first-use costs are not counted against it."""
    from sympy.core.cache import clear_cache

    sympy_extended(3)
    theirs, ours = [], []
    for _ in range(3):
        clear_cache()
        start = time.perf_counter()
        terms = sympy_extended(_SYMPY_ORDER)
        theirs.append(time.perf_counter() - start)
        seconds, recursion = _expansion(shipped_system("extended"), _SYMPY_ORDER)
        ours.append(seconds)
    same = all(
        [fmpq(c.numerator, c.denominator) for c in mine if c] == [c for c in term.coefficients() if c != 0]
        for mine, term in zip(terms, recursion.b, strict=True)
    )
    note = f"sympy {seconds_text(min(theirs))}, ours {seconds_text(min(ours))}; b_n {'equal' if same else 'DIFFERENT'}"
    return Row("sympy", f"extended system, order {_SYMPY_ORDER}", _SYMPY_TARGET, min(theirs) / min(ours), note=note)


def coefficient_sizes(recursion: Recursion) -> tuple[Size, ...]:
    """The sizes at every twelfth order."""
    sizes = []
    for order in range(12, len(recursion.b), 12):
        values = [value for value in recursion.b[order].coefficients() if value != 0]
        bits = max(int(value.height_bits()) for value in values)
        sizes.append(Size(order, bits, max(_logarithm(value) for value in values)))
    return tuple(sizes)


def _logarithm(value: fmpq) -> float:
    return math.log(abs(int(value.p))) - math.log(int(value.q))


def fitted_exponent(sizes: tuple[Size, ...]) -> float:
    """sigma of A^n (n!)^sigma through the last three sizes: the second difference removes A and the constant."""
    (n0, l0), (n1, l1), (n2, l2) = ((size.order, size.logarithm) for size in sizes[-3:])
    f0, f1, f2 = (math.lgamma(n + 1) for n in (n0, n1, n2))
    return ((l2 - l1) / (n2 - n1) - (l1 - l0) / (n1 - n0)) / ((f2 - f1) / (n2 - n1) - (f1 - f0) / (n1 - n0))
