"""A sweep over initial states drawn from its certified pieces: the fate over one component, or on a map of two."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.numbers.balls import approximate
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

_COLOURS = {
    Fate.BELOW: ORANGE,
    Fate.ABOVE: PURPLE,
    Fate.SPOT: INK,
    Fate.LIFT_OFF: BLUE,
    Fate.STOPS: GREEN,
    Fate.OPENS: "#d9dcdf",
    Fate.PAINLEVE: "#8a8f94",
    Fate.NO_SLIP: PAPER,
    Fate.UNDECIDED: VERMILION,
}
_LABELS = {
    Fate.BELOW: "G-spot, C₁ < 0",
    Fate.ABOVE: "G-spot, C₁ > 0",
    Fate.SPOT: "G-spot, sign of C₁ open",
    Fate.LIFT_OFF: "lift-off before",
    Fate.STOPS: "slip stops before",
    Fate.OPENS: "b > 0: opens at once",
    Fate.PAINLEVE: "p < 0: nothing more is said",
    Fate.NO_SLIP: "no positive slip",
    Fate.UNDECIDED: "undecided",
}


def save_fates(result: Fates, path: Path) -> Path:
    """Draw a sweep over states as a PNG, PDF or SVG file; a file that is there is replaced when the new one is ready.

    :raises ValueError: another suffix.
    """
    return styled_figure(lambda: _saved(result, path))


def _saved(result: Fates, path: Path) -> Path:
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Patch, Rectangle

    figure = canvas(5.2)
    axes = figure.subplots()
    boxes = []
    for piece in result.pieces:
        (left, *low), (right, *high) = (tuple(map(approximate, end)) for end in (piece.lower, piece.upper))
        bottom, top = (low[0], high[0]) if low else (0.0, 1.0)
        boxes.append(Rectangle((left, bottom), right - left, top - bottom))
    colours = [_COLOURS[piece.fate] for piece in result.pieces]
    axes.add_collection(PatchCollection(boxes, facecolors=colours, alpha=0.7, linewidths=0, rasterized=True))
    _frame(result, axes)
    found = {piece.fate for piece in result.pieces}
    handles = [
        Patch(facecolor=_COLOURS[fate], alpha=0.7, edgecolor=INK, label=_label(result, fate))
        for fate in Fate
        if fate in found
    ]
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=3, fontsize=8.5, frameon=False)
    figure.supxlabel("\n".join(textwrap.wrap(caption(result), 116)), fontsize=8, x=0.02, ha="left")
    over = ", ".join(f"{axis.name} from {axis.lower} to {axis.upper}" for axis in result.axes)
    return save_figure(figure, "fates", f"{result.name}: where slip ends over {over}", path)


def _frame(result: Fates, axes: Axes) -> None:
    first, *second = result.axes
    axes.set(xlim=(approximate(first.lower), approximate(first.upper)), xlabel=typeset(first.name))
    if second:
        axes.set(ylim=(approximate(second[0].lower), approximate(second[0].upper)), ylabel=typeset(second[0].name))
    else:
        axes.set(ylim=(0.0, 1.0))
        axes.set_yticks([])
    axes.grid(False)


def _label(result: Fates, fate: Fate) -> str:
    side = {Fate.BELOW: result.sides.below, Fate.ABOVE: result.sides.above}.get(fate)
    return _LABELS[fate] + (f": {side}" if side else "")


def caption(result: Fates) -> str:
    """What is certified in the picture."""
    state = ", ".join(f"{word} = {value}" for word, value in result.state)
    left = sum(piece.fate is Fate.UNDECIDED for piece in result.pieces)
    text = (
        f"{result.name}{f', from {state}' if state else ''}. Certified: on each of the {len(result.pieces)} pieces the "
        f"colour holds for every initial state{f'; {left} are undecided' if left else ''}."
    )
    if result.sides.below is None:
        return text
    return f"{text} What follows the G-spot: for epsilon below some epsilon_0 > 0, one a state, not computed."
