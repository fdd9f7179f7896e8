"""The picture of time against digits, or against another number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gspot_verified.cost.curves import Curve
from gspot_verified.report.canvas import COLOURS, STYLES, Picture, canvas, picture, styled

_MARKS = "os^Dv"


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
LINKS = Labels("links", "seconds", "The cost of reading a mechanism: legs of rods")
RUNS = Labels("correct digits of the time of lift-off", "seconds", "What a certificate costs: fig. varsim1, ε = 1e-3")
ORDERS = Labels("order of δ", "seconds, one core", "The cost of exact expansions: Theorem 1")


def cost_picture(curves: Sequence[Curve], labels: Labels = DIGITS) -> Picture:
    """The times on logarithmic scales.

    :raises ValueError: no curve has a point.
    """
    if not any(curve.points for curve in curves):
        raise ValueError("curves: there is no point to draw")
    return styled(lambda: _draw(curves, labels))()


def save_picture(curves: Sequence[Curve], path: Path, labels: Labels = DIGITS) -> Path:
    """Write the picture as PNG, PDF or SVG and return its path.

    :raises ValueError: no curve has a point, or another suffix.
    """
    return cost_picture(curves, labels).save(path)


def _draw(curves: Sequence[Curve], labels: Labels) -> Picture:
    figure = canvas(4.6)
    axes = figure.add_subplot()
    for index, curve in enumerate(curves):
        look: dict[str, Any] = {
            "color": COLOURS[index % len(COLOURS)],
            "linestyle": STYLES[index % len(STYLES)],
            "marker": _MARKS[index % len(_MARKS)],
            "markersize": 4,
        }
        digits, seconds = zip(*curve.points, strict=True) if curve.points else ((), ())
        axes.loglog(digits, seconds, label=curve.name, **look)
    axes.set(xlabel=labels.horizontal, ylabel=labels.vertical, title=labels.title)
    axes.legend()
    caption = "Times that were measured on one machine; nothing here is certified."
    return picture(figure, "cost", labels.title, caption, "Curves of time that rise to the right.")
