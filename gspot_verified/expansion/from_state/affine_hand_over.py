"""The set of deviations that Theorem B' hands over to Theorem U1 at s = -S, for all delta of a range.

Proof page: ``proofs/from_state.md``, section 8. The reference of the tube and the polynomials of Theorem 1 are compared
exactly, as polynomials in delta.
"""

from __future__ import annotations

from flint import arb, fmpq, fmpq_poly

from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, carried
from gspot_verified.expansion.from_state.hand_over import Beside, HandOver, framed
from gspot_verified.expansion.from_state.slow_series import Contact, SlowSeries
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import add_remainder, ball
from gspot_verified.numbers.evidence import less

_DELTA = fmpq_poly([0, 1])


def affine_hand_over(
    equations: DeviationEquations, given: AffineStart, tube: AffineTube, series: SlowSeries, place: fmpq
) -> HandOver | str:
    """The set (17) at s = -``place``, or what is not certain; the trajectory is that of ``given.system.system()``.

    :raises ValueError: the tube is for larger e only.
    """
    system = given.system
    if not system.a * equations.exact_delta**3 <= tube.start.e:
        raise ValueError("the tube is for larger epsilon only")
    scaled = equations.expansion("p", ball(-place))
    if less(ball(system.a**2), ball(tube.rectangle.h**2) * scaled**3) is None:
        return "the tube ends before the hand-over"
    if less(scaled * equations.delta**2, ball(given.p)) is None:
        return "the start lies after the hand-over"
    root = scaled.sqrt()
    h, r = ball(system.a) / (root * scaled), root * equations.small
    z = tube.bound(h, r.upper())
    coefficient = given.coefficient * carried(given, tube, series, h, r).exp()
    beside = _beside(equations, system, place)
    if beside is None:
        return "the reference differs from Theorem 1 at an order below mu"
    return framed(equations, series, tube.shares, z, coefficient, scaled, beside)


def _beside(equations: DeviationEquations, system: AffineSystem, place: fmpq) -> Beside | None:
    """Reference minus polynomials at s = -``place``; None unless every order is above mu."""
    known = {
        name: fmpq_poly([_at(term.coefficients(), -place) for term in terms])
        for name, terms in equations.trajectory.terms().items()
    }
    contact = Contact.of(system.regularisation)
    p, square = known["p"], _DELTA * _DELTA
    force, speed = system.mean_force + system.tilt * square * p, system.a * system.tilt / contact.kappa * square
    lag = contact.lag / contact.rate * _DELTA
    more = (
        -p * force - known["b"],
        -(force + lag * speed) / contact.kappa - known["y"],
        speed - known["v"],
        known["lambda_n"] + contact.kappa * known["y"] + lag * known["v"],  # the sign does not matter
    )
    own = (known["p"], known["b"], square * square * known["y"], square * known["v"])
    state = [value - known[f"xi_{i + 1}"] for i, value in enumerate(own)]
    power = 2 * (system.beta - 1)
    sizes = [_over(equations, one, power) for one in (*more, *state)]
    found = [one for one in sizes if one is not None]
    if len(found) < len(sizes):
        return None
    b, y, v, fast, first, second, third, fourth = found
    return Beside(b, y, v, fast, (first, second, third, fourth))


def _over(equations: DeviationEquations, polynomial: fmpq_poly, power: fmpq) -> arb | None:
    """0 +- a bound of the polynomial over delta^mu for all delta of the range; None if an order is below mu."""
    total = arb(0)
    for n, value in enumerate(polynomial.coeffs()):
        if value == 0:
            continue
        if not n >= power:
            return None
        total += abs(ball(value)) * equations.delta ** ball(n - power)
    return add_remainder(arb(0), total.upper())


def _at(coefficients: list[fmpq], s: fmpq) -> fmpq:
    value: fmpq = fmpq_poly(coefficients)(s)
    return value
