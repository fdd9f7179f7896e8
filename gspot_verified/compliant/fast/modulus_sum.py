"""An upper bound of int |front| e^(Re(E - E_top)/epsilon) over a path on which Re E <= Re E_top: it serves all smaller
epsilon, because the integrand falls with epsilon.

Proof page: ``proofs/fast_part.md``, section 3.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import acb, arb, fmpq

from gspot_verified.numbers.balls import hull, nonfinite

_PARTS = 128  # boxes on a path: more of them make the bound less


@dataclass(frozen=True, slots=True)
class PathPiece:
    """A piece of a path, x from 0 to ``length``: E, its derivative, bounds of |front| (dr/dx included) on balls of x.

    ``curvature``: E'', for a piece that begins at a saddle (E' = 0 at x = 0); None for others.
    """

    length: arb
    exponent: Callable[[arb], acb]
    slope: Callable[[arb], acb]
    fronts: Callable[[arb], list[arb]]
    curvature: Callable[[arb], acb] | None = None


def modulus_sum(piece: PathPiece, top: arb, largest: arb) -> list[arb]:
    """Bounds of int_0^length |front| e^((Re E - top)/epsilon) dx for every 0 < epsilon <= ``largest``.

    Not finite unless Re E <= top is certain on the whole piece.
    """
    totals: list[arb] = []
    for k in range(_PARTS):
        begin, end = (piece.length * fmpq(j * j, _PARTS**2) for j in (k, k + 1))
        whole, width = hull([begin, end]), end - begin
        excess = _excess(piece, top, begin, end, whole)
        weight = (excess / largest).exp() * width if excess <= 0 else nonfinite()
        parts = [(weight * front).abs_upper() for front in piece.fronts(whole)]
        totals = [total + part for total, part in zip(totals, parts, strict=True)] if totals else parts
    return totals


def _excess(piece: PathPiece, top: arb, begin: arb, end: arb, whole: arb) -> arb:
    """An upper bound of Re E - top on [begin, end]: from the middle by the mean value theorem, or from the saddle."""
    middle = ((begin + end) / 2).mid()
    reach = (end - middle).max(middle - begin).abs_upper()
    excess = (piece.exponent(middle).real - top + abs(piece.slope(whole).real) * reach).upper()
    if piece.curvature is not None:
        # x = 0 is the saddle, top its value: Re E - top <= sup Re E'' x^2/2, E'' over [0, end].
        bend = piece.curvature(hull([arb(0), end])).real.upper()
        if bend < 0:
            excess = excess.min((bend * begin * begin / 2).upper()) if excess.is_finite() else bend * begin * begin / 2
    return excess


def weakest(bounds: list[list[arb]]) -> list[arb]:
    """The sums, member by member, of the bounds of several pieces."""
    return [sum(column[1:], column[0]) for column in map(list, zip(*bounds, strict=True))]
