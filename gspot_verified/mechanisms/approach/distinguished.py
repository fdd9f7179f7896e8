"""The distinguished trajectory of rigid slip through a G-spot, as a Taylor polynomial in p with a bounded rest.

Proof page: ``proofs/approach.md``, Theorem A3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import acb, arb, arb_poly, arb_series

from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import add_remainder, hull, series_length


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
        zero = field.series([arb_series([value], 1) for value in (*place, arb(0))])[size]
        one = field.series([arb_series([value], 1) for value in (*place, arb(1))])[size]
    exponent = _term(one, 0) - _term(zero, 0)
    if not (exponent > 0 or exponent < 0):
        return None
    force = [-_term(zero, 0) / exponent]
    for k in range(1, order + 1):
        if not (k - exponent > 0 or k - exponent < 0):
            return None
        with series_length(k):
            S = field.series([arb_series(row, k) for row in (*rows, force)])
        for row, function in zip(rows, S[:size], strict=True):
            row.append(_term(function, k - 1) / k)
        with series_length(k + 1):
            R = field.series([arb_series(row, k + 1) for row in (*rows, [*force, arb(0)])])[size]
        force.append(_term(R, k) / (k - exponent))
    polynomials = [arb_poly(row) for row in rows]
    return Distinguished(tuple(polynomials), arb_poly(force), exponent, order)


def _term(series: arb_series, k: int) -> arb:
    terms = series.coeffs()
    return terms[k] if k < len(terms) else arb(0)


def force_at(field: VectorField, trajectory: Distinguished, p: arb, disc: arb, region: FlowBounds) -> arb | None:
    """λ on the distinguished trajectory at p, 0 < p < disc, or None when a hypothesis of Theorem A3 is not certain.

    ``region`` must hold the trajectory for all smaller p.
    """
    if not (p > 0 and p < disc):
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
