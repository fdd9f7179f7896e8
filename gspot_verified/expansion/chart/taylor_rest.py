"""What the Taylor polynomial of a function of the state leaves on a cone, the state being one of p, b, y, v.

Proof page: ``proofs/chart.md``.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from gspot_verified.expansion.chart.chart import Chart, Region
from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.balls import ball

_MORE = 8  # orders of p that are paid by themselves: any number is right
_KEPT = 2  # orders that stay by themselves in a bound: any number is right
_SLABS, _PIECES = 4, 16  # parts of the cone: any numbers are right
_THIN = 4  # times as many at p = 0, where they cost less


class NoTaylorError(ValueError):
    """The function has no enclosure on the box; the message says why."""


def taylor_rests(chart: Chart, functions: Sequence[Expression], cone: Cone, order: int) -> list[dict[int, arb]]:
    """For each function K_n, n >= ``order``: on the cone, which begins at p = 0, it differs from its terms of weight
    below ``order`` by at most the sum of K_n p^n.

    :raises NoTaylorError: it is not certainly an analytic function of p, b, y, v there.
    """
    last, terms = order + _MORE, NumberTerms(BALLS)
    largest = [dict.fromkeys(range(order, last + 1), arb(0)) for _ in functions]

    def note(part: Cone, start: Sequence[arb], slopes: Sequence[Sequence[arb]], orders: range) -> None:
        series = chart.series(functions, part.rows(orders.stop)[1:], start, slopes, terms, BALLS)
        for known, function in zip(largest, functions, strict=True):
            for n in orders:
                known[n] = known[n].max(abs(series[function][n]).upper())

    try:
        star = [ball(value) for value in chart.system.point]
        turned = [[ball(value) for value in row] for row in chart.slopes()]
        for slab in cone.slabs(_SLABS * _THIN):
            note(slab.tip, star, turned, range(order, last))
        covering = covered(chart, cone)
        if covering is None:
            raise NoTaylorError(f"p, b, y, v are not certainly coordinates of the state up to p = {cone.last}")
        for part, region in covering:
            note(part, region.states, region.inverse.tolist(), range(last, last + 1))
    except (ValueError, ZeroDivisionError) as error:
        raise NoTaylorError(str(error)) from error
    return [_folded(known, order + _KEPT, ball(cone.last)) for known in largest]


def _folded(known: dict[int, arb], most: int, p: arb) -> dict[int, arb]:
    """The same with orders up to ``most``, for all smaller p."""
    kept = {n: size for n, size in known.items() if n <= most}
    for n, size in known.items():
        if n > most:
            kept[most] = (kept[most] + size * p ** (n - most)).upper()
    return kept


def covered(chart: Chart, cone: Cone) -> list[tuple[Cone, Region]] | None:
    """Parts that cover a cone from p = 0 on, with their regions; None: it is not certain that there is one X on it."""
    covering = list[tuple[Cone, Region]]()
    for slab in cone.slabs(_SLABS):
        pieces = slab.pieces(_PIECES)
        regions = chart.chain(pieces)
        if regions is None:
            return None
        covering += zip(pieces, regions, strict=True)
    return covering
