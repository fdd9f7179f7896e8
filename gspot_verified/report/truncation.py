"""The picture of the truncation error of an expansion: how many orders help at which delta."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from flint import arb, fmpq

from gspot_verified.balls import float_bounds, working_bits
from gspot_verified.expansion.trajectory import Trajectory, expand_system

_EXTRA = 8
_BITS = 256
_STEPS = 24
_SMALLEST, _LARGEST = fmpq(1, 100), fmpq(1)
_MOST_CURVES = 6
_AT = fmpq(1)
_COLOURS = ("#0072B2", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#555555")


def truncation_curves(trajectory: Trajectory) -> dict[int, list[tuple[float, float]]]:
    """For some orders M: points (delta, |b truncated at M - b truncated eight orders later|) at s = 1.

    The difference shows the first omitted terms. It is no bound on the error: that is ``residual_bounds``.

    :raises TypeError: the numbers of the system are symbols.
    """
    if not isinstance(trajectory.system.ring.number(0), fmpq | arb):
        raise TypeError("a picture needs numbers: put values in the place of the symbols")
    longer = expand_system(trajectory.system, trajectory.order + _EXTRA)
    with working_bits(_BITS):
        values = [arb(term(_AT)) for term in longer.b]
    step = max(1, trajectory.order // _MOST_CURVES)
    orders = sorted({trajectory.order, *range(step, trajectory.order, step)})[-_MOST_CURVES:]
    return {order: _points(values, order) for order in orders}


def _points(values: list[Any], order: int) -> list[tuple[float, float]]:
    found = []
    with working_bits(_BITS):
        ratio = (arb(_SMALLEST / _LARGEST)) ** (arb(1) / _STEPS)
        delta = arb(_LARGEST)
        for _ in range(_STEPS + 1):
            total = arb(0)
            for k in range(min(order + _EXTRA, len(values)) - 1, order - 1, -1):
                total = total * delta + values[k]
            size = float_bounds(abs(total * delta**order))[1]
            if size > 0:
                found.append((float(delta.mid()), size))
            delta = delta * ratio
    return found


def save_truncation(trajectory: Trajectory, path: Path) -> Path:
    """Write the log-log picture as PNG and return its path; a file is replaced when the new one is ready."""
    curves = truncation_curves(trajectory)
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7, 4.5), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for colour, (order, points) in zip(_COLOURS, curves.items(), strict=False):
        if points:
            deltas, sizes = zip(*points, strict=True)
            axes.loglog(deltas, sizes, color=colour, label=f"M = {order}")
    axes.set(
        xlabel="δ = ε^(1/3)",
        ylabel=f"|b truncated at M − at M + {_EXTRA}|, s = 1",
        title=f"Truncation of the expansion: {trajectory.system.name}",
    )
    axes.grid(True, which="major", linewidth=0.4)
    axes.legend()
    unfinished = path.with_name(path.name + ".part")
    try:
        figure.savefig(unfinished, format="png", dpi=150)
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
    return path
