"""A cone of deviations that grow until lambda_N vanishes or exceeds a given force, for all delta of a range.

Proof page: ``proofs/uniform.md``, Theorem U2: the names are those of the page. Everything is computed at delta_0; the
hypotheses (G7) make it hold below.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.track import Track
from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence


@dataclass(frozen=True)
class EntryDeviation:
    """A deviation at s_1: enclosures of Y, V, N over delta^mu, of q, and bounds on |e_xi|, |e_p|, |f| over delta^mu.

    ``side`` is the sign of e_lambda, ``begin`` the s at which the run began.
    """

    side: int
    begin: fmpq
    place: fmpq
    Y: arb
    V: arb
    N: arb
    q: arb
    state: tuple[arb, ...]
    p: arb
    fast: arb


@dataclass(frozen=True)
class DeviationCone:
    """aY <= V <= BY, cV <= N <= CV, |e_xi,i| <= A_i Y, |e_p| <= A_p Y; ``top`` is Y_max. Chosen freely."""

    a: arb
    c: arb
    B: arb
    C: arb
    A: tuple[arb, ...]
    A_p: arb
    top: arb


@dataclass(frozen=True)
class Ranges:
    """What the page writes with a bar, for s_1 <= s <= S* = ``last`` and Y <= Y_max, at delta_0.

    ``state``: the box. ``drift``: |DF + lambda DG|; ``control``: |G|; ``bend``: |D alpha_1|; ``push``:
    |D alpha_2 - lambda D alpha_3|.
    """

    last: arb
    state: tuple[arb, ...]
    drift: list[list[arb]]
    control: list[arb]
    bend: list[arb]
    push: list[arb]
    alpha_1: arb
    alpha_3: arb
    force: arb
    eta: list[arb]
    eta_z: arb


def entry_of(track: Track, index: int) -> EntryDeviation | None:
    """The deviation at the end of a piece, if the sign of e_y is certain there."""
    piece, equations = track.pieces[index], track.equations
    e = piece.end_deviations
    side = 1 if e[equations.y] < 0 else -1 if e[equations.y] > 0 else 0
    if side == 0:
        return None
    place = ball(piece.end)
    scale = hull([equations.delta ** ball(track.power), arb(0)])
    q = -(equations.alpha_1 * place + equations.expansion("p", place, 1) + scale * e[equations.p])
    Y, V = -side * e[equations.y], -side * e[equations.v]
    return EntryDeviation(
        side=side,
        begin=track.pieces[0].start,
        place=piece.end,
        Y=Y,
        V=V,
        N=equations.kappa * q * Y - side * e[equations.b],
        q=q,
        state=tuple(value.abs_upper() for value in e[: equations.dimension]),
        p=e[equations.p].abs_upper(),
        fast=piece.end_fast,
    )


def ranges_of(equations: DeviationEquations, entry: EntryDeviation, power: Exact, cone: DeviationCone) -> Ranges | None:
    """The bars, or None where they are not finite."""
    m, delta, order = equations.dimension, equations.delta, equations.trajectory.order
    least = entry.Y.lower() * delta ** ball(power)
    if not (entry.place >= 0 and least > 0 and entry.V > 0 and cone.top > least and cone.a > 0):
        return None
    last = (ball(entry.place) + (cone.top / least).log() / cone.a).upper()
    state = []
    for i, value in enumerate(equations.point):
        reach = equations.norm(f"xi_{i + 1}", last) + cone.A[i] * cone.top
        state.append(add_remainder(value, (delta * delta * reach).upper()))
    force = add_remainder(equations.mean_force, equations.norm("lambda_n", last, 1).upper())
    values, slopes = equations.functions(state)
    if not all(value.is_finite() for row in (values, [last, force], *slopes) for value in row):
        return None
    bounds, residual_z = equations.residual_below(last)
    ratio = delta ** (order - ball(power)) / entry.V.lower()
    return Ranges(
        last=last,
        state=tuple(state),
        drift=[[(slopes[i][j] + force * slopes[m + i][j]).abs_upper() for j in range(m)] for i in range(m)],
        control=[value.abs_upper() for value in values[m : 2 * m]],
        bend=[value.abs_upper() for value in slopes[2 * m]],
        push=[
            (second - force * third).abs_upper()
            for second, third in zip(slopes[2 * m + 1], slopes[2 * m + 2], strict=True)
        ],
        alpha_1=values[2 * m],
        alpha_3=values[2 * m + 2],
        force=force,
        eta=[bound * ratio for bound in bounds],
        eta_z=residual_z * ratio,
    )


def phi_of(equations: DeviationEquations, entry: EntryDeviation, ranges: Ranges) -> arb:
    """phi_0: |f| <= phi_0 V."""
    slow = equations.delta * equations.lag * (1 + ranges.eta[equations.y])
    return (entry.fast / entry.V.lower()).max((slow + equations.damper * ranges.eta_z) / equations.rate).upper()


def needed_state(equations: DeviationEquations, ranges: Ranges, cone: DeviationCone, phi: arb) -> list[arb]:
    """The right sides of (G5) for A_1, ..., A_m."""
    square = equations.delta * equations.delta
    return [
        square * _dot(ranges.drift[i], cone.A) / cone.a
        + ranges.control[i] * (equations.kappa / cone.a + phi)
        + ranges.eta[i]
        for i in range(equations.dimension)
    ]


def needed_p(equations: DeviationEquations, ranges: Ranges, cone: DeviationCone) -> arb:
    """The right side of (G5) for A_p."""
    square = equations.delta * equations.delta
    return square * _dot(ranges.bend, cone.A) / cone.a + ranges.eta[equations.p]


def grows(
    equations: DeviationEquations, entry: EntryDeviation, power: Exact, cone: DeviationCone
) -> tuple[arb, Evidence] | None:
    """|e_lambda| at Y = Y_max from below, (kappa - phi_0 B) Y_max, with (G0) to (G7) as evidence; None where one is not
    certain."""
    ranges = ranges_of(equations, entry, power, cone)
    if ranges is None:
        return None
    kappa, delta, mu, order = equations.kappa, equations.delta, ball(power), equations.trajectory.order
    a, c, B, C = cone.a, cone.c, cone.B, cone.C
    phi = phi_of(equations, entry, ranges)
    least = entry.Y.lower()
    q_first = entry.q.lower()
    q_last = (entry.q + ranges.alpha_1.abs_upper() * (ranges.last - ball(entry.place))).upper()
    pressed = ranges.force.abs_upper() * cone.A_p / a + ranges.eta[equations.v]
    pi = q_last * phi + pressed
    square = delta * delta
    nu = ranges.alpha_3.abs_upper() * phi + square * _dot(ranges.push, cone.A) / a + ranges.eta[equations.b]
    stretch = ranges.alpha_1 - ranges.alpha_3
    against, along = stretch.max(arb(0)).upper(), (-stretch).max(arb(0)).upper()
    sigma = mu / (a * ranges.last)
    evidence = every([
        # (G0) the cone at s_1
        less(0, entry.V - a * entry.Y), less(0, entry.N - c * entry.V),
        less(0, C * entry.V - entry.N), less(0, B * entry.Y - entry.V), less(0, c), less(0, q_first),
        # (G1) to (G4) the faces
        less(pi, c - a),
        less(0, kappa - c * phi),
        less(0, kappa * q_first - kappa * against / a - nu - c * (c + q_first * phi + pressed)),
        less(pi, B - C),
        less(0, C * (C - pi) - kappa * q_last - kappa * along / a - nu),
        # (G5) what is slaved
        *(less(value, bound * least) for bound, value in zip(cone.A, entry.state, strict=True)),
        *(less(value, bound) for bound, value in zip(cone.A, needed_state(equations, ranges, cone, phi), strict=True)),
        less(entry.p, cone.A_p * least), less(needed_p(equations, ranges, cone), cone.A_p),
        # (G6) p falls
        less(ranges.alpha_1, 0),
        # (G7) what holds at delta_0 holds below
        less(sigma, 1),
        less((ball(fmpq(order, 2)) + 1) * sigma, arb(order) - mu - 1),
        less(ranges.alpha_1.abs_upper() * mu / a, q_last),
        less(delta, equations.least_rate * ball(entry.place - entry.begin)),
        less(phi * B, kappa),
    ])  # fmt: skip
    return None if evidence is None else (((kappa - phi * B) * cone.top).lower(), evidence)


def _dot(row: Sequence[arb], other: Sequence[arb]) -> arb:
    return sum((a * b for a, b in zip(row, other, strict=True)), arb(0))
