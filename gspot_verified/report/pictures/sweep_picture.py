"""Sweeps drawn from their certified pieces: over one parameter or component, or on a map of two.

Of parameters: β, or Case and side; of initial states: the fate.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fates_result import Fates
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
    typeset,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ANSWERS: dict[Any, tuple[str, str]] = {
    ("I", None, -1): (BLUE, "Case I"),
    ("II", None, -1): (GREEN, "Case II"),
    ("III", -1, 1): (ORANGE, "Case III, C₁ < 0 lifts off"),
    ("III", 1, -1): (PURPLE, "Case III, C₁ > 0 lifts off"),
    ("I", None, None): (BLUE, "Case I, no side: no damper"),
    ("II", None, None): (GREEN, "Case II, no side: no damper"),
    ("III", None, None): (ORANGE, "Case III, no side: no damper"),
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
    _legend(axes, dict.fromkeys(map(look, result.pieces)), 0.5)
    _write_below(figure, caption(result))
    return save_figure(figure, "sweep", f"{result.name}: {result.asked} over {_over(result)}", path)


def _write_below(figure: Figure, words: str) -> None:
    figure.supxlabel("\n".join(textwrap.wrap(words, 116)), fontsize=8, x=0.02, ha="left")


def _over(result: Sweep | Fates) -> str:
    return ", ".join(f"{axis.name} from {axis.lower} to {axis.upper}" for axis in result.axes)


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
        colours.append(look(piece)[0])
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
    _draw_pieces(result, axes, [look(piece)[0] for piece in result.pieces], 0.6)


def _draw_pieces(result: Sweep | Fates, axes: Axes, colours: list[str], alpha: float) -> None:
    """Each piece in its colour; over one parameter or component it is as high as the picture."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Rectangle

    boxes = []
    for piece in result.pieces:
        (left, *low), (right, *high) = (tuple(map(approximate, end)) for end in (piece.lower, piece.upper))
        bottom, top = (low[0], high[0]) if low else (0.0, 1.0)
        boxes.append(Rectangle((left, bottom), right - left, top - bottom))
    axes.add_collection(PatchCollection(boxes, facecolors=colours, alpha=alpha, linewidths=0, rasterized=True))
    first, *second = result.axes
    axes.set(xlim=(approximate(first.lower), approximate(first.upper)), xlabel=typeset(first.name))
    if second:
        axes.set(ylim=(approximate(second[0].lower), approximate(second[0].upper)), ylabel=typeset(second[0].name))
    else:
        axes.set(ylim=(0.0, 1.0))
        axes.set_yticks([])
    axes.grid(False)


def _legend(axes: Axes, looks: Iterable[tuple[str, str]], alpha: float) -> None:
    """The words of each colour."""
    from matplotlib.patches import Patch

    handles = [Patch(facecolor=colour, alpha=alpha, edgecolor=INK, label=label) for colour, label in looks]
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=3, fontsize=8.5, frameon=False)


def look(piece: SweepPiece) -> tuple[str, str]:
    """The colour of a piece, and what it means."""
    return _ANSWERS[piece.answer] if piece.kind is Kind.SETTLED else _OTHERS[piece.kind]


def _beta(piece: SweepPiece) -> tuple[float, float] | None:
    number = piece.number("beta")
    return None if number is None else float_bounds(number.to_ball())


def caption(result: Sweep) -> str:
    """What is certified in the picture."""
    left = sum(piece.kind in (Kind.OPEN, Kind.NO_TUBE) for piece in result.pieces)
    text = (
        f"{result.name}: {result.asked}. Certified: on each of the {len(result.pieces)} pieces the colour holds for "
        f"every value of "
        f"{' and '.join(axis.name for axis in result.axes)}"
    )
    if len(result.axes) == 1:
        text += f"; β lies in the dark boxes. Dotted: where Case or side may change ({len(result.crossings)})"
        text += ". Red: a fold" if result.folds else ""
    if any(piece.lift_off_sign is not None for piece in result.pieces):
        text += ". Which sign of C₁ lifts off: by the paper's rule as ε → 0"
    return f"{text}." + (f" {left} pieces are not settled." if left else "")


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
    return styled_figure(lambda: _saved_fates(result, path))


def _saved_fates(result: Fates, path: Path) -> Path:
    figure = canvas(5.2)
    axes = figure.subplots()
    _draw_pieces(result, axes, [_COLOURS[piece.fate] for piece in result.pieces], 0.7)
    found = {piece.fate for piece in result.pieces}
    _legend(axes, [(_COLOURS[fate], _label(result, fate)) for fate in Fate if fate in found], 0.7)
    _write_below(figure, fates_caption(result))
    return save_figure(figure, "fates", f"{result.name}: where slip ends over {_over(result)}", path)


def _label(result: Fates, fate: Fate) -> str:
    side = {Fate.BELOW: result.sides.below, Fate.ABOVE: result.sides.above}.get(fate)
    return _LABELS[fate] + (f": {side}" if side else "")


def fates_caption(result: Fates) -> str:
    """What is certified in the picture."""
    left = sum(piece.fate is Fate.UNDECIDED for piece in result.pieces)
    text = (
        f"{result.name}: {result.states}. Certified: on each of the {len(result.pieces)} pieces the "
        f"colour holds for every initial state{f'; {left} are undecided' if left else ''}."
    )
    if not result.names_a_side:
        return text
    return (
        f"{text} What follows the G-spot: for starts at rest in the contact, and epsilon below some epsilon_0 > 0, "
        "one a state, not computed."
    )
