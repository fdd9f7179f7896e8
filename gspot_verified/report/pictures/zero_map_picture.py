"""The map of the number of real zeros at finite epsilon with the folds from 6 and 9, drawn from certified pieces."""

from __future__ import annotations

import math
import textwrap
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.compliant.zeros.fold_point import MEETINGS, fold_point
from gspot_verified.compliant.zeros.zero_map import THEOREM_UP_TO, ZeroMap
from gspot_verified.numbers.balls import approximate
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PAPER,
    PURPLE,
    Picture,
    canvas,
    picture,
    styled,
)

_COLOURS = {0: PAPER, 1: BLUE, 2: ORANGE, 3: GREEN, 4: PURPLE}
_LAW_BELOW_4 = (
    (1, 1),
    (2, 2),
    (3, 1),
)  # (m, zeros for m < beta < m + 1), for every epsilon: proofs/finite_epsilon_zeros.md, 4 (a)
_DRAWN_FROM = 1e-6  # the axis of epsilon is logarithmic: 0 is drawn here
_FOLDS_PER_DECADE = 6  # of epsilon: points of a curve of folds
_FOLD_DIGITS = 6  # of beta: more than a picture shows


def save_zero_map(result: ZeroMap, path: Path) -> Path:
    """Draw the map as a PNG, PDF or SVG file; a file that is there is replaced when the new one is ready.

    :raises ValueError: the map is of one epsilon.
    """
    return zero_map_picture(result).save(path)


def zero_map_picture(result: ZeroMap) -> Picture:
    """The map as a figure with its caption.

    :raises ValueError: the map is of one epsilon.
    """
    if result.epsilon[0] == result.epsilon[1]:
        raise ValueError("epsilon: a picture needs a range, not one value")
    return styled(lambda: _draw(result))()


def _draw(result: ZeroMap) -> Picture:
    from matplotlib.patches import Patch, Rectangle

    figure = canvas(5.6)
    axes = figure.subplots()
    least = max(approximate(result.epsilon[0]), min(_DRAWN_FROM, approximate(result.epsilon[1]) / 1e3))
    most = approximate(result.epsilon[1])
    shown: set[int] = set()

    def fill(left: fmpq, right: fmpq, low: float, high: float, number: int) -> None:
        shown.add(number)
        start, end = approximate(left), approximate(right)
        look: dict[str, Any] = {"facecolor": _COLOURS.get(number, PAPER), "alpha": 0.45, "linewidth": 0}
        axes.add_patch(Rectangle((start, low), end - start, high - low, **look))

    for m, number in _LAW_BELOW_4:
        left, right = max(result.beta[0], fmpq(m)), min(result.beta[1], fmpq(m + 1))
        if left < right:
            fill(left, right, least, most, number)
    for row in result.rows:
        low, high = max(approximate(row.lower), least), approximate(row.upper)
        for left, right, numbers in row.stretches():
            if len(numbers) == 1:
                fill(left, right, low, high, numbers[0])
            else:
                axes.add_patch(
                    Rectangle(
                        (approximate(left), low),
                        approximate(right - left),
                        high - low,
                        linewidth=0,
                        facecolor=INK,
                        alpha=0.2,
                    )
                )
    curves = [_folds(least, most, meeting, result.beta) for meeting in MEETINGS]
    for points in curves:
        axes.plot([beta for beta, _ in points], [epsilon for _, epsilon in points], color=INK, linewidth=1.6)
    axes.set(xlim=tuple(map(approximate, result.beta)), ylim=(least, most), yscale="log", xlabel="β", ylabel="ε")
    axes.grid(False)
    handles = [
        Patch(facecolor=_COLOURS.get(number, PAPER), alpha=0.45, label=f"{number} zero{'s' if number != 1 else ''}")
        for number in sorted(shown)
    ]
    handles.append(Patch(facecolor=INK, alpha=0.2, label="two more before the fold than after it"))
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(-0.03, 1.0), ncols=5, fontsize=8.5, frameon=False)
    caption = _caption(result, list(map(len, curves)))
    figure.supxlabel("\n".join(textwrap.wrap(caption, 116)), fontsize=8, x=0.02, ha="left")
    return picture(
        figure,
        "zeros-at-finite-epsilon",
        "Real zeros of λ − λ̄, the deviation of the force on the slow manifold of the compliant model",
        caption,
        "The plane of β and ε in colours for the number of zeros; fold curves leave β = 6 and 9 at ε = 0 to the left.",
    )


def _folds(least: float, most: float, meeting: int, betas: tuple[fmpq, fmpq]) -> list[tuple[float, float]]:
    """Middles of the brackets of one fold, where they lie in the picture."""
    count = max(2, math.ceil(_FOLDS_PER_DECADE * math.log10(most / least)))
    middles = []
    for i in range(count + 1):
        epsilon = fmpq(*(least * (most / least) ** (i / count)).as_integer_ratio())
        point = fold_point(epsilon, _FOLD_DIGITS, meeting) if betas[0] < meeting else None
        if point is not None and betas[0] <= point.lower and point.upper <= betas[1]:
            middles.append((approximate((point.lower + point.upper) / 2), approximate(epsilon)))
    return middles


def _caption(result: ZeroMap, folds: list[int]) -> str:
    left = sum(len(row.unfinished) for row in result.rows)
    columns = sum(len(row.columns) for row in result.rows)
    drawn = [f"{n} certified folds, sought from β = {m} on" for m, n in zip(MEETINGS, folds, strict=True) if n]
    return (
        "The number of real zeros of λ − λ̄ on the slow manifold of the compliant model with α₁ = −1, C₁ ≠ 0. "
        f"Certified: the colours, for every β that is not an integer and every ε, for β < {THEOREM_UP_TO} by theorem, "
        f"beyond by {columns} columns in {len(result.rows)} rows of ε; "
        "in a grey box there is at most one fold at each ε. "
        + (f"The curves join {' and '.join(drawn)}; that they are one curve is not shown. " if drawn else "")
        + (f"White: {left} ranges of β not settled." if left else "")
    )
