"""The set of deviations that the tube hands over to Theorem U1 at s = -S, for all delta of a range.

Proof page: ``proofs/from_state.md``, section 5. The model system; a = -alpha_1.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, arb_mat, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.barrier import Tube
from gspot_verified.expansion.from_state.slow_series import R, SlowSeries, terms_of
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.frames import identity
from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull


@dataclass(frozen=True)
class HandOver:
    """e delta^-mu = ``frame`` u with \\|u - centre\\| <= radii, and \\|phi\\| delta^-mu <= ``fast``.

    ``coefficient`` encloses C_1 at the hand-over, ``z`` bounds z there.
    """

    frame: arb_mat
    centre: tuple[arb, ...]
    radii: tuple[arb, ...]
    fast: arb
    coefficient: arb
    z: arb


def hand_over_set(equations: DeviationEquations, tube: Tube, series: SlowSeries, c_1: arb, place: fmpq) -> HandOver:
    """The set (13) at s = -``place``, for a system whose state is (p, b, y, v), for all delta of the equations.

    :raises ValueError: the tube ends before it, or it is for larger e only.
    """
    rate: fmpq = -equations.trajectory.system.check()[0]
    if not (rate * place**3 * tube.rectangle.h**2 >= 1 and rate * equations.exact_delta**3 <= tube.start.e):
        raise ValueError("the tube ends before the hand-over")
    a, far = ball(rate), ball(place)
    h, r = (1 / (a * far**3)).sqrt(), (a * far).sqrt() * equations.small
    z = tube.bound(h, r.upper())
    slow = tuple(evaluated(one, h, r) for one in (series.v, series.v / R, series.w, series.f))
    return framed(equations, series.beta, slow, tube.shares, z, c_1 * carried(tube, series, h, r).exp(), a * far)


@dataclass(frozen=True)
class Beside:
    """Reference of the tube minus polynomials of Theorem 1, over delta^mu: of b, y, v, phi, and bounds of what p, b, y,
    v of the expansion's state differ by from these polynomials, over delta^2 besides."""

    b: arb
    y: arb
    v: arb
    fast: arb
    state: tuple[arb, arb, arb, arb]


_NOTHING = Beside(arb(0), arb(0), arb(0), arb(0), (arb(0), arb(0), arb(0), arb(0)))


def framed(
    equations: DeviationEquations,
    beta: Exact,
    slow: tuple[arb, ...],
    shares: tuple[arb, arb, arb],
    z: arb,
    coefficient: arb,
    scaled: arb,
    beside: Beside = _NOTHING,
    slopes: arb_mat | None = None,
) -> HandOver:
    """The set (13), or (17), where p = ``scaled`` delta^2, C is in the ball ``coefficient``, and V = L r v, W = L p w,
    phi = L p f on the slow part, (r v, v, w, f) = ``slow``: r v by itself, as r is a ball.

    ``slopes`` encloses the derivatives of the state by p, b, y, v; without it they are the state."""
    root = scaled.sqrt()
    r = root * equations.small
    last = r.upper()
    size = -coefficient * scaled ** ball(beta - 1)  # L delta^-mu
    first, second, third = (share * z for share in shares)
    speed, v, w, f = slow
    lag, kappa = equations.lag / equations.rate, equations.kappa
    slow_b, slow_y = -scaled, (r * r * f - lag * speed - 1 - w) / kappa
    slow_v = root * v
    spread_y, spread_v = (second + (third + lag * first) * last) / kappa, first * root
    fast = abs(size) * (abs(r * r * f) + third * last) + abs(beside.fast)

    column, radii = [arb(0)] * equations.size, [arb(0)] * equations.size
    column[equations.b] = (size.mid() * slow_b).mid()
    shift = abs(beside.b / column[equations.b])
    for i, along, spread, more in (
        (equations.y, slow_y, spread_y, beside.y),
        (equations.v, slow_v, spread_v, beside.v),
    ):
        column[i] = (size.mid() * along).mid()
        beyond = along - slow_b * column[i] / column[equations.b]
        radii[i] = (abs(size) * (beyond.abs_upper() + spread) + abs(more) + shift * abs(column[i])).upper()
    radii[equations.b] = (abs(size * slow_b / column[equations.b] - 1) + shift).upper()
    square, turned = equations.delta**2, identity(4) if slopes is None else slopes
    most = (
        arb(0),
        arb(0),
        (abs(size) * (abs(slow_y) + spread_y) + abs(beside.y)) * square**2,
        ((abs(size) * (abs(slow_v) + spread_v) + abs(beside.v)) * square),
    )
    for i in range(equations.dimension):
        along_b = turned[i, 1] * column[equations.b]
        column[i] = along_b.mid()
        total = abs(along_b - column[i]) * (1 + radii[equations.b])
        for j, (own, more) in enumerate(zip(most, beside.state, strict=True)):
            total += abs(turned[i, j]) * (own + abs(more))
        radii[i] = total.upper()
    frame = identity(equations.size)
    for i, value in enumerate(column):
        frame[i, equations.b] = value
    centre = tuple(arb(int(i == equations.b)) for i in range(equations.size))
    return HandOver(frame, centre, tuple(radii), fast.abs_upper(), coefficient, z)


def carried(tube: Tube, series: SlowSeries, h: arb, r: arb) -> arb:
    """log of C_1 at (h, r) over C_1 at p_1, (12)."""
    start = tube.start
    nearest = hull([arb(0), (ball(start.e) / ball(start.p) ** ball(fmpq(3, 2))).upper()])
    largest = ball(start.p).sqrt()
    total = arb(0)
    for (i, n), value in terms_of(series.w).items():
        growth = fmpq(3 * i - n, 2)
        if not growth > 0:
            raise ArithmeticError(f"the slow series has the monomial h^{i} r^{n} in w")
        total += ball(value / growth) * (h**i * r**n - nearest**i * largest**n)
    return add_remainder(-ball(series.beta) * total, tube.drift(r.upper()))


def evaluated(polynomial: fmpq_mpoly, h: arb, r: arb) -> arb:
    """Its value on the balls."""
    return sum((ball(value) * h**i * r**n for (i, n), value in terms_of(polynomial).items()), arb(0))
