"""The picture of time against digits, or against another number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gspot_verified.cost.times.rows import TimeCurve
from gspot_verified.report.pictures.canvas import COLOURS, INK, PAPER, STYLES, Picture, canvas, picture, styled

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
RUNS = Labels("right decimals of the time of lift-off", "seconds", "What a certificate costs: runs of scenes")
ORDERS = Labels("order of δ", "seconds, one core", "The cost of exact expansions: Theorem 1")
LABELS = {"theta": DIGITS, "sign": RANGES, "expand": ORDERS, "force": SMALLNESS, "mechanism": LINKS, "simulate": RUNS}
_BESIDE = ((4, 5, "right"), (-7, 1, "right"), (8, -3, "left"))
"""Above the last point, left of it, right of it: certified runs lie right of scipy's, heyoka's far below."""
_NO_BOUND, _AIM = ("scipy", "heyoka"), "aim"


def save_measured(curves: Sequence[TimeCurve], path: Path, subject: str) -> Path:
    """The picture of one subject of ``gspot-verified cost``: runs of scenes by scene, the others in one field.

    :raises ValueError: no curve has a point, or another suffix.
    """
    return runs_picture(curves).save(path) if subject == "simulate" else save_picture(curves, path, LABELS[subject])


def runs_picture(curves: Sequence[TimeCurve]) -> Picture:
    """Time against decimals, a field for each scene and epsilon; names of curves are "route: scene".

    :raises ValueError: no curve has a point.
    """
    if not any(curve.points for curve in curves):
        raise ValueError("curves: there is no point to draw")
    return styled(lambda: _draw_runs(curves))()


def _draw_runs(curves: Sequence[TimeCurve]) -> Picture:
    scenes = list(dict.fromkeys(curve.name.partition(": ")[2] for curve in curves))
    routes = list(dict.fromkeys(curve.name.partition(": ")[0] for curve in curves))
    rows = -(-len(scenes) // 2)
    figure = canvas(0.8 + 2.1 * rows)
    fields = figure.subplots(rows, min(2, len(scenes)), sharex=True, sharey=True, squeeze=False)
    for axes, scene in zip(fields.flat, scenes, strict=False):
        for curve in (curve for curve in curves if curve.name.partition(": ")[2] == scene and curve.points):
            route = curve.name.partition(": ")[0]
            index = routes.index(route)
            at, seconds = zip(*curve.points, strict=True)
            if route == _AIM:
                axes.semilogy(at, seconds, color=INK, linestyle=":", linewidth=1)
                _name(axes, f"aim {seconds[0]:g} s", (at[-1], seconds[-1]), (0, -9, "right"), INK)
                continue
            sure = not route.startswith(_NO_BOUND)
            look: dict[str, Any] = {"color": COLOURS[index % len(COLOURS)], "marker": _MARKS[index % len(_MARKS)]}
            look |= {"markersize": 4, "linestyle": "-" if sure else "--", "markerfacecolor": None if sure else PAPER}
            axes.semilogy(at, seconds, **look)
            _name(axes, route, (at[-1], seconds[-1]), _BESIDE[index % len(_BESIDE)], look["color"])
        axes.set_title(scene, loc="left")
    for axes in list(fields.flat)[len(scenes) :]:
        axes.set_axis_off()
    figure.supxlabel(RUNS.horizontal, fontsize=9.5)
    figure.supylabel("seconds of processor time", fontsize=9.5)
    caption = (
        "Times that were measured on one machine; nothing here is certified but the runs so named. Full lines: "
        "certified brackets. Broken lines: no bound; they stand at the decimals that are right, which they do not know."
    )
    return picture(figure, "cost", RUNS.title, caption, "For each scene lines of time against right decimals.")


def cost_picture(curves: Sequence[TimeCurve], labels: Labels = DIGITS) -> Picture:
    """The times on logarithmic scales.

    :raises ValueError: no curve has a point.
    """
    if not any(curve.points for curve in curves):
        raise ValueError("curves: there is no point to draw")
    return styled(lambda: _draw(curves, labels))()


def save_picture(curves: Sequence[TimeCurve], path: Path, labels: Labels = DIGITS) -> Path:
    """Write the picture as PNG, PDF or SVG and return its path.

    :raises ValueError: no curve has a point, or another suffix.
    """
    return cost_picture(curves, labels).save(path)


def _name(axes: Any, words: str, at: tuple[float, float], beside: tuple[int, int, str], colour: str) -> None:
    """``beside``: the distance from the point, and the side of the words that is there."""
    look = {"fontsize": 8, "ha": beside[2], "color": colour}
    axes.annotate(words, at, beside[:2], textcoords="offset points", **look)


def _draw(curves: Sequence[TimeCurve], labels: Labels) -> Picture:
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
