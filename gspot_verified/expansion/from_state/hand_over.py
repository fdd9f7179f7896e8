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
from gspot_verified.numbers.balls import add_remainder, ball, hull


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
    h = (1 / (a * far**3)).sqrt()
    root = (a * far).sqrt()
    r = root * equations.small
    last = r.upper()
    z = tube.bound(h, last)
    coefficient = c_1 * carried(tube, series, h, r).exp()
    size = -coefficient * (a * far) ** ball(series.beta - 1)  # L delta^-mu
    first, second, third = (share * z for share in tube.shares)
    v, w, f = (evaluated(one, h, r) for one in (series.v, series.w, series.f))
    lag, kappa = equations.lag / equations.rate, equations.kappa
    slow_b, slow_y = -a * far, (r * r * f - lag * v - 1 - w) / kappa
    slow_v = root * evaluated(series.v / R, h, r)
    spread_y, spread_v = (second + (third + lag * first) * last) / kappa, first * root
    fast = abs(size) * (abs(r * r * f) + third * last)

    column, radii = [arb(0)] * equations.size, [arb(0)] * equations.size
    column[equations.b] = (size.mid() * slow_b).mid()
    for i, slow, spread in ((equations.y, slow_y, spread_y), (equations.v, slow_v, spread_v)):
        column[i] = (size.mid() * slow).mid()
        beside = slow - slow_b * column[i] / column[equations.b]
        radii[i] = (abs(size) * (beside.abs_upper() + spread)).upper()
    column[_B], square = column[equations.b], equations.delta**2
    radii[_Y] = (abs(size) * (abs(slow_y) + spread_y) * square**2).upper()
    radii[_V] = (abs(size) * (abs(slow_v) + spread_v) * square).upper()
    radii[equations.b] = (size * slow_b / column[equations.b] - 1).abs_upper()
    frame = identity(equations.size)
    for i, value in enumerate(column):
        frame[i, equations.b] = value
    centre = tuple(arb(int(i == equations.b)) for i in range(equations.size))
    return HandOver(frame, centre, tuple(radii), fast.abs_upper(), coefficient, z)


_B, _Y, _V = 1, 2, 3  # the components b, y, v of the model system's state


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
