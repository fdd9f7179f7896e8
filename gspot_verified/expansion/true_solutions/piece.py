"""One piece of s: bounds on the deviation that hold for all delta of a range.

Proof page: ``proofs/uniform.md``, Theorem U1. What is checked here is an inequality between numbers; the guesses come
from ``frames.py`` and may be anything.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.true_solutions.equations import Coupling, DeviationEquations
from gspot_verified.expansion.true_solutions.frames import Frame, frame_at, larger, matrix_value, turned_frame
from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull

_ATTEMPTS = 40  # to guess bounds that hold; then nothing is said


@dataclass(frozen=True)
class Deviations:
    """At one s: e delta^-mu = Q (centre + u), |u_i| <= radii_i, and |phi| delta^-mu <= initial + forced.

    ``initial`` bounds phi at the start of the run, ``elapsed`` is the s since then; ``forced`` bounds what the equation
    has fed into phi.
    """

    centre: tuple[arb, ...]
    radii: tuple[arb, ...]
    turned: arb_mat
    initial: arb
    elapsed: fmpq
    forced: arb


@dataclass(frozen=True)
class TrackPiece:
    """``deviations`` encloses e delta^-mu for start <= s <= end; ``fast`` bounds |phi| delta^-mu, ``force`` encloses
    the deviation of lambda_N, delta^-mu times; ``mean`` is the expansion's lambda_N, ``states`` holds the states.

    ``at_end`` is the state at the end, ``end_deviations`` the enclosure there; ``end_fast`` bounds |f| delta^-mu there,
    f = e_lambda + kappa e_y.
    """

    start: fmpq
    end: fmpq
    deviations: tuple[arb, ...]
    fast: arb
    force: arb
    mean: arb
    states: tuple[arb, ...]
    at_end: Deviations
    end_deviations: tuple[arb, ...]
    end_fast: arb


class Rules:
    """What stays the same on all pieces: the equations, and delta_0^mu and delta_0^(M - mu)."""

    def __init__(self, equations: DeviationEquations, power: Exact) -> None:
        self.equations = equations
        delta = equations.delta
        self.scale = delta ** ball(power)
        self.forcing = delta ** (equations.trajectory.order - ball(power))
        self.rate = equations.least_rate

    def fast_start(self, state: Deviations, later: fmpq) -> arb:
        """What is left of the initial phi after ``later`` more s: the exponential grows with delta."""
        return state.initial * (-self.rate * ball(state.elapsed + later) / self.equations.delta).exp()

    def keeps_rate(self, p: arb) -> bool:
        """Whether g_- bounds the rate of phi from below: the first inequality of (b)."""
        equations = self.equations
        return bool(self.rate <= equations.rate - equations.share * equations.small**2 * p)

    def fed(self, deviations: Sequence[arb], coupling: Coupling, residual: Sequence[arb], residual_z: arb) -> arb:
        """What these deviations and residuals feed into phi, (3)."""
        equations, p = self.equations, coupling.p
        b, place, y, v = (deviations[i] for i in (equations.b, equations.p, equations.y, equations.v))
        turn = b + coupling.force * place - equations.kappa * p * y - equations.share * equations.small * p * v
        slow = equations.share * equations.delta**2 * (turn.abs_upper() + self.forcing * residual[equations.v])
        rest = equations.delta * equations.lag * residual[equations.y] + equations.damper * residual_z
        return ((slow + self.forcing * rest) / self.rate).upper()


def advance(rules: Rules, state: Deviations, start: fmpq, end: fmpq) -> TrackPiece | None:
    """The piece, or None when the inequality could not be satisfied."""
    equations, length = rules.equations, ball(end - start)
    frame = frame_at(equations, start, state.turned)
    time = hull([length, arb(0)])
    s = ball(start) + time
    flow = frame.at(time)
    try:
        inverse = state.turned.inv() * flow.inv()
    except ZeroDivisionError:
        return None
    defect = _defect(equations, frame, start, time)
    basis = flow * state.turned
    steady = basis * arb_mat([[value] for value in state.centre])
    bounds, residual_z = equations.residual(max(abs(start), abs(end)))
    residual = [row * rules.forcing for row in _row_sums(inverse, bounds)]
    first = rules.fast_start(state, fmpq(0))
    burst = first * equations.delta / rules.rate
    guess = [larger(value) for value in state.radii]
    for _ in range(_ATTEMPTS):
        spread = _row_sums(basis, guess)
        deviations = [add_remainder(steady[i, 0], spread[i]) for i in range(equations.size)]
        coupling = equations.coupling(s, [value * rules.scale for value in deviations])
        if not all(value.is_finite() for value in coupling.matrix.entries()):
            return None
        if not rules.keeps_rate(coupling.p):
            return None
        rates = inverse * ((coupling.matrix * flow + defect) * state.turned)
        column = inverse * coupling.fast
        forced = state.forced.max(rules.fed(deviations, coupling, bounds, residual_z))
        moved = _row_sums(rates, [bound + abs(value) for bound, value in zip(guess, state.centre, strict=True)])
        reached = []
        for i in range(equations.size):
            weight = column[i, 0].abs_upper()
            total = state.radii[i] + weight * burst + length * (moved[i] + weight * forced + residual[i])
            reached.append(total.upper())
        if not all(value.is_finite() for value in reached):
            return None
        if all(value < bound for value, bound in zip(reached, guess, strict=True)):
            break
        guess = [bound if value < bound else larger(value) for value, bound in zip(reached, guess, strict=True)]
    else:
        return None
    fast = (first + forced).upper()
    later = Deviations(state.centre, tuple(reached), state.turned, state.initial, state.elapsed + end - start, forced)
    last = frame.at(length) * state.turned
    at_end, end_deviations = _turned(later, last), tuple(enclosure(later, last))
    if at_end is None:
        return None
    return TrackPiece(
        start=start,
        end=end,
        deviations=tuple(deviations),
        fast=fast,
        force=add_remainder(
            -equations.kappa * deviations[equations.y], equations.lagged(fast, deviations[equations.v])
        ),
        mean=coupling.force,
        states=tuple(equations.states(s, [value * rules.scale for value in deviations])),
        at_end=at_end,
        end_deviations=end_deviations,
        end_fast=equations.lagged(rules.fast_start(state, end - start) + forced, end_deviations[equations.v]),
    )


def enclosure(state: Deviations, basis: arb_mat) -> list[arb]:
    """e delta^-mu for the coordinates of a state in the columns of ``basis``."""
    coordinates = [[add_remainder(value, bound)] for value, bound in zip(state.centre, state.radii, strict=True)]
    return list((basis * arb_mat(coordinates)).entries())


def _turned(state: Deviations, columns: arb_mat) -> Deviations | None:
    """The same set in orthonormal coordinates; ``columns`` is the frame at this s."""
    turned = turned_frame(columns, state.radii)
    try:
        change = turned.inv() * columns
    except ZeroDivisionError:
        return None
    centre = (change * arb_mat([[value] for value in state.centre])).entries()
    radii = _row_sums(change, state.radii)
    if not all(value.is_finite() for value in (*centre, *radii)):
        return None
    return Deviations(
        tuple(value.mid() for value in centre),
        tuple((bound + value.rad()).upper() for bound, value in zip(radii, centre, strict=True)),
        turned,
        state.initial,
        state.elapsed,
        state.forced,
    )


def _defect(equations: DeviationEquations, frame: Frame, start: fmpq, time: arb) -> arb_mat:
    """A_0 Y - Y', as a polynomial in s - s_k and so without the cancellation of its value."""
    matrix, slope = equations.limit(ball(start)), equations.limit_slope()
    nothing = arb_mat(equations.size, equations.size)
    flow = frame.flow
    terms = []
    for k in range(len(flow) + 1):
        term = matrix * flow[k] if k < len(flow) else nothing
        if k:
            term = term + slope * flow[k - 1]
        if k + 1 < len(flow):
            term = term - flow[k + 1] * (k + 1)
        terms.append(term)
    return matrix_value(terms, time)


def _row_sums(matrix: arb_mat, bounds: Sequence[arb]) -> list[arb]:
    """The upper ends of sum over j of |matrix_ij| bounds_j."""
    return [
        sum((abs(entry) * bound for entry, bound in zip(row, bounds, strict=True)), arb(0)).upper()
        for row in matrix.table()
    ]
