"""The distinguished trajectory of rigid slip through a G-spot, as a Taylor polynomial in p with a bounded rest.

Proof page: ``proofs/approach.md``, Theorem A3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from flint import acb, arb, arb_poly, arb_series, fmpq, fmpz

from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import add_remainder, current_bits, hull, series_length

_KEPT = 32  # polynomials of shared boxes
_GRID = 3 / 4  # of the working bits are those of the grid on which a shared box lies
_OFFSET = fmpq(191, 499)  # of that grid, so that no simple number stands on it


@dataclass(frozen=True, slots=True)
class FlowBounds:
    """Bounds on a box of (ξ, λ), for (S, R) of :meth:`SlipFlow.by_p`: norms of S_ξ, S_λ and R_ξ; β - 1 there."""

    box: tuple[arb, ...]
    S: tuple[arb, ...]
    S_state: arb
    S_force: arb
    R_state: arb
    exponent: arb

    @classmethod
    def on(cls, field: VectorField, box: Sequence[arb]) -> FlowBounds | None:
        """On a box; None when something is not finite."""
        size = field.dimension - 1
        values, rows = field.on_box(box)
        entries = [entry for row in rows for entry in row]
        if not all(value.is_finite() for value in (*values, *entries)):
            return None
        sums = [sum((abs(entry) for entry in row[:size]), arb(0)).upper() for row in rows]
        largest, force = arb(0), arb(0)
        for i in range(size):
            largest, force = largest.max(sums[i]), force.max(abs(rows[i][size]).upper())
        return cls(tuple(box), tuple(values[:size]), largest, force, sums[size], rows[size][size])


@dataclass(frozen=True, slots=True)
class Distinguished:
    """Taylor coefficients in p of ξ (by component) and λ; β - 1 at the G-spot."""

    state: tuple[arb_poly, ...]
    force: arb_poly
    exponent: arb
    order: int


def taylor_in_p(field: VectorField, place: Sequence[arb], order: int) -> Distinguished | None:
    """The coefficients up to ``order`` for every G-spot in the box ``place``; None when β may be an integer there.

    :raises ValueError: a divisor may vanish.
    """
    size = field.dimension - 1
    rows = [[value] for value in place]
    with series_length(1):
        # R = (β - 1) λ - α_2/α_1 is affine in λ: its values at λ = 0 and 1 give β - 1 and the start.
        zero = field.series([arb_series([value], 1) for value in (*place, arb(0))])
        one = field.series([arb_series([value], 1) for value in (*place, arb(1))])
    exponent = _term(one[size], 0) - _term(zero[size], 0)
    if not (exponent > 0 or exponent < 0):
        return None
    force = [-_term(zero[size], 0) / exponent]
    # S is affine in λ, too: a term is what it is without the last coefficient of λ, and that times S_λ at p = 0.
    slopes = [row[size] for row in field.on_box([*place, arb(0)])[1][:size]]
    terms = [_term(function, 0) for function in zero[:size]]
    for k in range(1, order + 1):
        if not (k - exponent > 0 or k - exponent < 0):
            return None
        for row, term, slope in zip(rows, terms, slopes, strict=True):
            row.append((term + slope * force[-1]) / k)
        with series_length(k + 1):
            *S, R = field.series([arb_series(row, k + 1) for row in (*rows, [*force, arb(0)])])
        force.append(_term(R, k) / (k - exponent))
        terms = [_term(function, k) for function in S]
    polynomials = [arb_poly(row) for row in rows]
    return Distinguished(tuple(polynomials), arb_poly(force), exponent, order)


def shared_taylor_in_p(field: VectorField, place: Sequence[arb], order: int) -> Distinguished | None:
    """The same in a box around ``place`` that all narrow enclosures of one point have in common, but for chance: made
    once for many states that reach one G-spot, and the same whatever was asked before.

    :raises ValueError: a divisor may vanish.
    """
    bits = round(_GRID * current_bits())
    unit = arb((1, -bits))
    cells = []
    for side in place:
        shifted = side / unit - _OFFSET
        low, high = shifted.lower().floor().unique_fmpz(), shifted.upper().ceil().unique_fmpz()
        if low is None or high is None or high - low > 2:  # a box of many G-spots
            return taylor_in_p(field, place, order)
        cells.append((low, high))
    return _taylor_in_cells(field, tuple(cells), order, bits)


@lru_cache(_KEPT)
def _taylor_in_cells(
    field: VectorField, cells: tuple[tuple[fmpz, fmpz], ...], order: int, bits: int
) -> Distinguished | None:
    """Between these points of the grid; the field is known by its identity."""
    unit = arb((1, -bits))
    return taylor_in_p(field, [hull([(k + _OFFSET) * unit for k in cell]) for cell in cells], order)


def _term(series: arb_series, k: int) -> arb:
    terms = series.coeffs()
    return terms[k] if k < len(terms) else arb(0)


def force_at(field: VectorField, trajectory: Distinguished, p: arb, disc: arb, region: FlowBounds) -> arb | None:
    """λ on the distinguished trajectory at p, 0 < p < disc, or None when a hypothesis of Theorem A3 is not certain.

    ``region`` must hold the trajectory for all smaller p.
    """
    if not p > 0:
        return None
    rest = force_rest(field, trajectory, p.upper(), disc, region)
    return None if rest is None else add_remainder(trajectory.force(p), rest * p.upper() ** (trajectory.order + 1))


def force_rest(field: VectorField, trajectory: Distinguished, last: arb, disc: arb, region: FlowBounds) -> arb | None:
    """E of Theorem A3: λ on the distinguished trajectory is within E p^(order + 1) of the polynomial for every p with
    0 <= p <= ``last`` < ``disc``; None when a hypothesis is not certain.
    """
    n = trajectory.order
    if not (last > 0 and last < disc):
        return None
    bounds = _bounds(field, trajectory, disc)
    if bounds is None:
        return None
    S_bound, R_bound = bounds
    geometric = 1 / (1 - last / disc)
    d_S = S_bound * disc**-n * geometric
    d_R = R_bound * disc ** (-n - 1) * geometric
    gap = n + 1 - region.exponent
    if not gap > 0:
        return None
    free = 1 - region.S_state * last / (n + 2) - region.S_force * region.R_state * last / ((n + 2) * gap)
    if not free > 0:
        return None
    H = (region.S_force * d_R * last / ((n + 2) * gap) + d_S / (n + 1)) / free
    E = (region.R_state * H + d_R) / gap
    whole = hull([arb(0), last])
    power = last ** (n + 1)
    widths = (*[H] * len(trajectory.state), E)
    for polynomial, side, width in zip((*trajectory.state, trajectory.force), region.box, widths, strict=True):
        if not side.contains_interior(add_remainder(polynomial(whole), width * power)):
            return None
    return E.upper()


def _bounds(field: VectorField, trajectory: Distinguished, disc: arb) -> tuple[arb, arb] | None:
    """Bounds on |S| and |R| along the polynomials on the complex disc |p| <= disc."""
    box = []
    for polynomial in (*trajectory.state, trajectory.force):
        start, *rest = polynomial.coeffs() or [arb(0)]
        reach = arb_poly([0, *(abs(c) for c in rest)])(disc)
        box.append(acb(add_remainder(start, reach), add_remainder(arb(0), reach)))
    values = [value.abs_upper() for value in field.values_on_complex_box(box)]
    if not all(value.is_finite() for value in values):
        return None
    largest = arb(0)
    for value in values[:-1]:
        largest = largest.max(value)
    return largest, values[-1]
