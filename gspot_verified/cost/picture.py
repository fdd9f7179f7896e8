"""The picture of time against digits, or against another number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from gspot_verified.cost.curves import Curve

# Dark enough on white, and told apart by line and mark as well as by colour.
_LOOKS = (("#0072B2", "-", "o"), ("#009E73", "--", "s"), ("#D55E00", "-.", "^"), ("#555555", ":", "D"))


@dataclass(frozen=True, slots=True)
class Labels:
    """The texts of a picture of curves."""

    horizontal: str
    vertical: str
    title: str


DIGITS = Labels("digits asked for", "seconds, first call", "The cost of accuracy: Θ(7/3, β)")
RANGES = Labels(
    "size of the range of β, or m",
    "seconds of processor time",
    "The cost of certified zeros of dΘ/dτ over a range of β",
)
SMALLNESS = Labels("k, ε = 10^-k", "seconds per value", "The cost of a small ε: the slow solution")
ORDERS = Labels("order of δ", "seconds, one core", "The cost of exact expansions: Theorem 1")


def save_picture(curves: Sequence[Curve], path: Path, labels: Labels = DIGITS) -> Path:
    """Write the log-log picture as PNG and return its path; a file that is there is replaced when the new one is ready.

    :raises ValueError: no curve has a point.
    """
    if not any(curve.points for curve in curves):
        raise ValueError("curves: there is no point to draw")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7, 4.5), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for index, curve in enumerate(curves):
        colour, line, mark = _LOOKS[index % len(_LOOKS)]
        digits, seconds = zip(*curve.points, strict=True) if curve.points else ((), ())
        axes.loglog(digits, seconds, color=colour, linestyle=line, marker=mark, markersize=4, label=curve.name)
    axes.set(xlabel=labels.horizontal, ylabel=labels.vertical, title=labels.title)
    axes.grid(True, which="major", linewidth=0.4)
    axes.legend()
    unfinished = path.with_name(path.name + ".part")
    try:
        figure.savefig(unfinished, format="png", dpi=150)
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
    return path
