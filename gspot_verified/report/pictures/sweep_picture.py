"""A sweep drawn from its certified pieces: β over one parameter, or Case and side on a map of two."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.numbers.balls import approximate, float_bounds
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PAPER,
    PURPLE,
    VERMILION,
    canvas,
    save_figure,
    styled_figure,
)
from gspot_verified.report.pictures.typeset import typeset

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ANSWERS: dict[Any, tuple[str, str]] = {
    ("I", None, -1): (BLUE, "Case I"),
    ("II", None, -1): (GREEN, "Case II"),
    ("III", -1, 1): (ORANGE, "Case III, C₁ < 0 lifts off"),
    ("III", 1, -1): (PURPLE, "Case III, C₁ > 0 lifts off"),
    ("none", None, None): (PAPER, "no Case"),
}
_OTHERS = {
    Kind.CROSSING: (INK, "Case or side may change"),
    Kind.OPEN: (VERMILION, "undecided"),
    Kind.NO_TUBE: ("#8a8f94", "no spot was found"),
    Kind.FOLD: (VERMILION, "next to a fold"),
    Kind.BEYOND: ("#d9dcdf", "beyond a fold"),
}
_TALLEST = 12.0  # |beta| beyond which the curve is cut off


def save_sweep(result: Sweep, path: Path) -> Path:
    """Draw a sweep as a PNG, PDF or SVG file; a file that is there is replaced when the new one is ready.

    :raises ValueError: another suffix.
    """
    return styled_figure(lambda: _saved(result, path))


def _saved(result: Sweep, path: Path) -> Path:
    figure = canvas(5.2)
    axes = figure.subplots()
    (_line if len(result.axes) == 1 else _map)(result, axes)
    _legend(result, axes)
    figure.supxlabel("\n".join(textwrap.wrap(caption(result), 116)), fontsize=8, x=0.02, ha="left")
    over = ", ".join(f"{axis.name} from {axis.lower} to {axis.upper}" for axis in result.axes)
    return save_figure(figure, "sweep", f"{result.name}: Case and side of the G-spot over {over}", path)


def _line(result: Sweep, axes: Axes) -> None:
    """The enclosures of beta over the pieces, in the colours of Case and side; crossings and folds as lines."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Rectangle

    (axis,) = result.axes
    heights = [height for piece in result.pieces if (height := _beta(piece)) is not None]
    top = min(max([high for _, high in heights], default=1.0), _TALLEST)
    bottom = max(min([low for low, _ in heights], default=0.0), -_TALLEST)
    margin = 0.05 * (top - bottom) + 1e-9
    backgrounds, boxes, colours = [], [], []
    for piece in result.pieces:
        left, right = (approximate(end[0]) for end in (piece.lower, piece.upper))
        backgrounds.append(Rectangle((left, bottom - margin), right - left, top - bottom + 2 * margin))
        colours.append(_look(piece)[0])
        height = _beta(piece)
        if height is not None:
            boxes.append(Rectangle((left, height[0]), right - left, max(height[1] - height[0], 0.0)))
    axes.add_collection(PatchCollection(backgrounds, facecolors=colours, alpha=0.3, linewidths=0))
    axes.add_collection(PatchCollection(boxes, facecolors=INK, edgecolors=INK, linewidths=0.9))
    for crossing in result.crossings:
        axes.axvline(approximate((crossing.lower + crossing.upper) / 2), color=INK, linewidth=0.7, linestyle=":")
    for fold in result.folds:
        axes.axvline(approximate(sum(fold.bounds(), fmpq(0)) / 2), color=VERMILION, linewidth=1.2)
    axes.set(xlim=(approximate(axis.lower), approximate(axis.upper)), ylim=(bottom - margin, top + margin))
    axes.set(xlabel=typeset(axis.name), ylabel="β")


def _map(result: Sweep, axes: Axes) -> None:
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Rectangle

    boxes, colours = [], []
    for piece in result.pieces:
        (left, low), (right, high) = (tuple(map(approximate, end)) for end in (piece.lower, piece.upper))
        boxes.append(Rectangle((left, low), right - left, high - low))
        colours.append(_look(piece)[0])
    axes.add_collection(PatchCollection(boxes, facecolors=colours, alpha=0.6, linewidths=0, rasterized=True))
    first, second = result.axes
    axes.set(xlim=(approximate(first.lower), approximate(first.upper)), xlabel=typeset(first.name))
    axes.set(ylim=(approximate(second.lower), approximate(second.upper)), ylabel=typeset(second.name))
    axes.grid(False)


def _legend(result: Sweep, axes: Axes) -> None:
    from matplotlib.patches import Patch

    looks = {_look(piece): None for piece in result.pieces}
    handles = [Patch(facecolor=colour, alpha=0.5, edgecolor=INK, label=label) for colour, label in looks]
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=3, fontsize=8.5, frameon=False)


def _look(piece: SweepPiece) -> tuple[str, str]:
    return _ANSWERS[piece.answer] if piece.kind is Kind.SETTLED else _OTHERS[piece.kind]


def _beta(piece: SweepPiece) -> tuple[float, float] | None:
    number = piece.number("beta")
    return None if number is None else float_bounds(number.to_ball())


def caption(result: Sweep) -> str:
    """What is certified in the picture."""
    left = sum(piece.kind in (Kind.OPEN, Kind.NO_TUBE) for piece in result.pieces)
    text = (
        f"{result.name}. Certified: on each of the {len(result.pieces)} pieces the colour holds for every value of "
        f"{' and '.join(axis.name for axis in result.axes)}"
    )
    if len(result.axes) == 1:
        text += f"; β lies in the dark boxes. Dotted: where Case or side may change ({len(result.crossings)})"
        text += ". Red: a fold" if result.folds else ""
    return f"{text}." + (f" {left} pieces are not settled." if left else "")
