"""The sign atlas: the certified sign of dTheta/dtau over the (tau, beta) plane, and the curves on which it is zero."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.numbers.balls import approximate
from gspot_verified.report.figures.atlas_data import Area, Colour, areas, entries, folds, has_open_tail, zero_curves
from gspot_verified.report.pictures.canvas import BLUE, INK, ORANGE, PAPER, PURPLE, Picture, canvas, picture, styled
from gspot_verified.signs.cover.pieces import Column, number_of_zeros
from gspot_verified.signs.zeros.zeros import ZerosResult

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LOOKS: dict[Colour, dict[str, Any]] = {
    Colour.NEGATIVE: {"facecolor": BLUE, "alpha": 0.42},
    Colour.POSITIVE: {"facecolor": ORANGE, "alpha": 0.50},
    Colour.ONE_ZERO: {"facecolor": INK, "alpha": 0.16},
    Colour.TWO_ZEROS: {"facecolor": PURPLE, "edgecolor": PURPLE, "linewidth": 1.5, "alpha": 0.8},
}
_WORDS = {
    Colour.NEGATIVE: "dΘ/dτ < 0",
    Colour.POSITIVE: "dΘ/dτ > 0",
    Colour.ONE_ZERO: "one zero at each β",
    Colour.TWO_ZEROS: "two zeros at each β",
}
_LEAST_REACH = fmpq(2)  # in tau: an atlas without tubes shows this much
_HEIGHT = 6.9  # inches of the axes; the caption and the legend come on top
_LINE = 128  # characters of the caption in a line


def save_atlas(result: ZerosResult, path: Path) -> Path:
    """Draw the atlas of a range of beta as PNG, PDF or SVG; a file that is there is replaced.

    :raises ValueError: no column is settled, or the range of beta is one value.
    """
    return atlas_picture(result, with_texts=True).save(path)


def atlas_picture(result: ZerosResult, with_texts: bool = False) -> Picture:
    """The atlas as a figure of the report; ``with_texts`` puts title and caption into the image itself.

    :raises ValueError: no column is settled, or the range of beta is one value.
    """
    if result.beta.is_point:
        raise ValueError("beta: a picture needs a range, not one value")
    if not result.columns:
        raise ValueError("there is no settled range of beta to draw")
    return styled(lambda: _draw(result, with_texts))()


def _draw(result: ZerosResult, with_texts: bool) -> Picture:
    title, caption = f"The sign of dΘ/dτ for β in {result.beta}", _caption(result)
    lines = textwrap.wrap(caption, _LINE) if with_texts else []
    below, above = 0.55 + 0.15 * len(lines), 0.55 + 0.35 * with_texts
    height = _HEIGHT + below + above
    figure = canvas(height)
    # The legend is as wide as the axes: their place is given, not found.
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.07, below / height, 0.84, _HEIGHT / height))
    left, right = _window(result.columns)
    shown = [area for column in result.columns for area in areas(column)]
    _fill(axes, shown, left, right)
    has_curves = _curves(axes, result.columns, right)
    _marks(axes, result, left, right)
    _legend(axes, result, {area.colour for area in shown}, has_curves)
    if with_texts:
        figure.text(0.015, 1 - 0.12 / height, title, fontsize=13, va="top")
        figure.text(0.015, 0.1 / height, "\n".join(lines), fontsize=8)
    return picture(
        figure,
        "atlas",
        title,
        caption,
        "The plane of τ and β in two colours: negative on the left, on the right stripes that alternate with β. "
        "Curves of zeros come in from the right at each integer β and wander to the left.",
    )


def _window(columns: Sequence[Column]) -> tuple[fmpq, fmpq]:
    """The range of tau that is shown: all tubes, and a little of both tails."""
    ends = [
        end for column in columns for piece in column.pieces for end in (piece.lower, piece.upper) if end is not None
    ]
    left = min([-_LEAST_REACH, *ends]).floor() - 1
    right = max([_LEAST_REACH, *ends]).ceil()
    return fmpq(left), fmpq(right)


def _fill(axes: Axes, shown: Sequence[Area], left: fmpq, right: fmpq) -> None:
    from matplotlib.collections import PolyCollection

    for colour, look in _LOOKS.items():
        boxes = [_corners(area, left, right) for area in shown if area.colour is colour and area.lower is not None]
        # Neighbours share an edge: without smoothing no line shows between them.
        axes.add_collection(PolyCollection(boxes, **({"linewidth": 0} | look), antialiased=False))


def _corners(area: Area, left: fmpq, right: fmpq) -> list[tuple[float, float]]:
    assert area.lower is not None
    start = approximate(left if area.left is None else area.left)
    end = approximate(right if area.right is None else area.right)
    lower, upper = approximate(area.lower), approximate(area.upper)
    return [(start, lower), (end, lower), (end, upper), (start, upper)]


def _curves(axes: Axes, columns: Sequence[Column], right: fmpq) -> bool:
    """Whether there was a curve to draw."""
    curves = [curve for column in columns for curve in zero_curves(column, right + 2)]
    for curve in curves:
        axes.plot(*zip(*curve, strict=True), color=INK, linewidth=1.5, solid_capstyle="round", zorder=4)
    return bool(curves)


def _marks(axes: Axes, result: ZerosResult, left: fmpq, right: fmpq) -> None:
    assert result.beta.lower is not None
    assert result.beta.upper is not None
    lower, upper = approximate(result.beta.lower), approximate(result.beta.upper)
    edge = approximate(right)
    for beta in range(math.ceil(lower), math.floor(upper) + 1):
        axes.axhline(beta, color=INK, linewidth=0.7, linestyle=(0, (1, 2.2)), zorder=3)
    incoming = [approximate(beta) for beta in entries(result.columns)]
    axes.plot([edge] * len(incoming), incoming, "<", color=INK, markersize=6, clip_on=False, zorder=6)
    meeting = [approximate(beta) for beta in folds(result.columns)]
    axes.plot([0] * len(meeting), meeting, "o", color=INK, markerfacecolor=PAPER, markersize=5, zorder=6)
    counts: dict[int, tuple[float, float, int]] = {}
    for column in result.columns:
        number = number_of_zeros(column)
        if column.lower is not None and number is not None and column.lower < column.upper:
            m, first, last = int(column.lower.floor()), approximate(column.lower), approximate(column.upper)
            counts[m] = (min(first, counts[m][0]) if m in counts else first, last, number)
    for first, last, number in counts.values():
        axes.annotate(
            f"{number} zero{'s' if number != 1 else ''}",
            (1, (first + last) / 2),
            xycoords=("axes fraction", "data"),
            xytext=(9, 0),
            textcoords="offset points",
            va="center",
        )
    axes.set_ylabel("β", rotation=0, labelpad=6)
    axes.set(xlabel="τ", xlim=(approximate(left), edge), ylim=(lower, upper))
    axes.grid(False)
    if upper - lower <= 40:
        axes.set_yticks(range(math.ceil(lower), math.floor(upper) + 1))


def _legend(axes: Axes, result: ZerosResult, present: set[Colour], has_curves: bool) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    handles: list[Any] = [Patch(label=_WORDS[colour], **_LOOKS[colour]) for colour in _LOOKS if colour in present]
    if result.unfinished or has_open_tail(result.columns):
        handles.append(Patch(facecolor=PAPER, edgecolor=INK, linewidth=0.6, label="sign not settled"))
    marks: dict[str, Any] = {"marker": "o", "linestyle": "none", "color": INK}
    if has_curves:
        handles.append(Line2D([], [], color=INK, linewidth=1.5, label="zero of dΘ/dτ"))
    if folds(result.columns):
        handles.append(Line2D([], [], markerfacecolor=PAPER, markersize=5, label="two zeros meet", **marks))
    if entries(result.columns):
        handles.append(Line2D([], [], **{**marks, "marker": "<"}, label="one comes from +∞"))
    axes.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(-0.03, 1.0),
        ncols=4,
        fontsize=9,
        frameon=False,
        handlelength=1.4,
        columnspacing=1.8,
        borderaxespad=0.3,
    )


def _caption(result: ZerosResult) -> str:
    pieces = sum(len(column.pieces) for column in result.columns)
    parts = [
        f"Certified: the colours, at every point of an area, by {pieces} pieces in {len(result.columns)} ranges of β; "
        "no colour rests on samples."
    ]
    if result.statement is not None:
        parts.append(
            f"Also certified: the number of zeros on the right, on the whole τ-axis, for every β in {result.beta} that "
            "is not an integer, and that each is simple."
        )
    if has_open_tail(result.columns):
        parts.append("A white strip, continued to τ → +∞, holds exactly one zero at each β that is not an integer.")
    if result.unfinished:
        parts.append(f"White from edge to edge: not settled (ranges of β: {len(result.unfinished)}).")
    parts.append("Curves join points that are certified to lie within 1/2000 of a zero; between them they are drawn.")
    return " ".join(parts)
