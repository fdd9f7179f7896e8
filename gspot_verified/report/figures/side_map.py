"""A picture of the exact side rule over beta and epsilon: where the fast part of the paper's initial data wins."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from flint import fmpq

from gspot_verified.compliant.side.side_map import SidePoint, agreement_limits, side_map
from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.counted import counted
from gspot_verified.report.pictures.canvas import BLUE, INK, ORANGE, Picture, canvas, picture, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COARSE_BETAS = tuple(fmpq(k, 6) for k in range(9, 43, 2))  # none is an integer
_COARSE_EPSILONS = tuple(fmpq(1, part * 10**k) for k in range(1, 4) for part in (1, 2, 5))
_TITLE = "The side rule at finite ε, for the paper's initial data"


def coarse_side_map() -> Picture:
    """The map on so few points that it is drawn in some seconds, for the report."""
    return side_map_picture(side_map(_COARSE_BETAS, _COARSE_EPSILONS))


def side_map_picture(points: Sequence[SidePoint]) -> Picture:
    """The signs of K at the points of a grid, and the line below which the paper's rule holds on it.

    :raises ValueError: no points.
    """
    if not points:
        raise ValueError("there are no points to draw")
    return styled(lambda: _draw(points))()


def _draw(points: Sequence[SidePoint]) -> Picture:
    figure = canvas(4.6)
    axes = figure.add_subplot()
    _squares(axes, points)
    limits = {beta: limit for beta, limit in agreement_limits(points).items() if limit is not None}
    axes.plot(
        [approximate(beta) for beta in limits], [math.log10(1 / approximate(e)) for e in limits.values()],
        color=INK, linewidth=1.6, drawstyle="steps-mid", label="from here on upwards both rules agree on the grid",
    )  # fmt: skip
    axes.set_xlabel("β")
    axes.set_ylabel("log₁₀(1/ε)")
    axes.grid(visible=False)
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), fontsize=8)
    differ = sum(_differs(point) for point in points)
    unsettled = sum(None in (point.exact, point.slow) for point in points)
    caption = (
        f"Certified: the sign of K for α₁ = −1 (else ε|α₁| in the place of ε), p = 1/2, v = 0, y = 2ε²b/p, z = ε²b/p, "
        f"b-hat > 0 at "
        f"{counted(len(points), 'point')} ({unsettled} open): orange K > 0, blue K < 0. Crosses: the sign of C/Γ(−β), "
        f"the paper's rule, is the other one ({counted(differ, 'point')}). Between the points nothing is claimed."
    )
    return picture(
        figure, "side_map", _TITLE, caption, "Vertical stripes that alternate at integer β, with crosses below."
    )


def _squares(axes: Axes, points: Sequence[SidePoint]) -> None:
    for sign, colour in ((1, ORANGE), (-1, BLUE)):
        places = [_place(point) for point in points if point.exact == sign]
        axes.scatter([x for x, _ in places], [y for _, y in places], s=60, marker="s", color=colour, alpha=0.55, lw=0)
    places = [_place(point) for point in points if _differs(point)]
    axes.scatter([x for x, _ in places], [y for _, y in places], s=16, marker="x", color=INK, lw=1.1)


def _place(point: SidePoint) -> tuple[float, float]:
    return approximate(point.beta), -math.log10(approximate(point.epsilon))


def _differs(point: SidePoint) -> bool:
    return point.exact is not None and point.slow is not None and point.exact != point.slow
