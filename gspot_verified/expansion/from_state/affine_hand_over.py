"""The set of deviations that Theorem B' hands over to Theorem U1 at s = -S, for all delta of a range.

Proof page: ``proofs/from_state.md``, section 8. The reference of the tube and the polynomials of Theorem 1 are compared
exactly, as polynomials in delta.
"""

from __future__ import annotations

from flint import arb, fmpq, fmpq_mpoly, fmpq_poly

from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, carried, power_of
from gspot_verified.expansion.from_state.hand_over import Beside, HandOver, framed
from gspot_verified.expansion.from_state.slow_manifold import H, R, SlowManifold, excess_terms, still_terms
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import add_remainder, ball
from gspot_verified.numbers.evidence import less

_DELTA = fmpq_poly([0, 1])


def affine_hand_over(
    equations: DeviationEquations, given: AffineStart, tube: AffineTube, place: fmpq
) -> HandOver | str:
    """The set (17) at s = -``place``, or what is not certain; the trajectory is that of the start's system.

    :raises ValueError: the tube is for larger e only.
    """
    manifold, a = given.manifold, given.manifold.system.a
    if not a * equations.exact_delta**3 <= tube.start.e:
        raise ValueError("the tube is for larger epsilon only")
    scaled = equations.expansion("p", ball(-place))
    if less(ball(a**2), ball(tube.rectangle.h**2) * scaled**3) is None:
        return "the tube ends before the hand-over"
    if less(scaled * equations.delta**2, ball(given.p)) is None:
        return "the start lies after the hand-over"
    beside = _beside(equations, manifold, place)
    if beside is None:
        return "the reference differs from Theorem 1 at an order below mu, or is no polynomial in p and epsilon"
    root = scaled.sqrt()
    h, r = ball(a) / (root * scaled), root * equations.small
    z = tube.bound(h, r.upper())
    coefficient = given.coefficient(tube.start.e) * carried(given, tube, h, r).exp()
    excess = -coefficient * power_of(r, manifold.mu)
    parts = (H * R * manifold.u, H * manifold.u, manifold.w, manifold.f)
    slow = tuple(_over_excess(one, h, r, excess) for one in parts)
    return framed(equations, manifold.beta, slow, tube.shares, z, coefficient, scaled=scaled, beside=beside)


def _over_excess(polynomial: fmpq_mpoly, h: arb, r: arb, excess: arb) -> arb:
    """The terms with L, over L."""
    terms = ((i, n, k - 1, value) for (i, n, k), value in excess_terms(polynomial).items() if k)
    return sum((ball(value) * h**i * r**n * excess**k for i, n, k, value in terms), arb(0))


def _beside(equations: DeviationEquations, manifold: SlowManifold, place: fmpq) -> Beside | None:
    """Reference minus polynomials at s = -``place``; None unless they are polynomials in delta with orders >= mu."""
    known = {
        name: fmpq_poly([fmpq_poly(term.coefficients())(-place) for term in terms])
        for name, terms in equations.trajectory.terms().items()
    }
    kappa, lag = manifold.contact.kappa, manifold.contact.lag / manifold.contact.rate
    speed, fast = H * R * manifold.u, R * R * manifold.f
    force, square = manifold.force + manifold.w, _DELTA * _DELTA
    compared = (
        (-R * R * manifold.force, square * known["b"], 2),
        ((fast - force - lag * speed) / kappa, known["y"], 0),
        (speed, _DELTA * known["v"], 1),
        (fast, known["lambda_n"] + kappa * known["y"] + lag * _DELTA * known["v"], 0),
    )
    p = square * known["p"]
    sizes = list[arb | None]()
    for reference, polynomial, unit in compared:
        exact = _in_delta(reference, p, manifold.system.a)
        sizes.append(None if exact is None else _over(equations, exact - polynomial, manifold.mu + unit))
    own = (known["p"], known["b"], square * square * known["y"], square * known["v"])
    for i, value in enumerate(own):
        sizes.append(_over(equations, value - known[f"xi_{i + 1}"], manifold.mu))
    found = [one for one in sizes if one is not None]
    if len(found) < len(sizes):
        return None
    b, y, v, phi, first, second, third, fourth = found
    return Beside(b, y, v, phi, (first, second, third, fourth))


def _in_delta(polynomial: fmpq_mpoly, p: fmpq_poly, a: fmpq) -> fmpq_poly | None:
    """The polynomial at L = 0, where e = a delta^3 and p are polynomials in delta; None if it is none in p and e."""
    total = fmpq_poly([0])
    for (i, n), value in still_terms(polynomial).items():
        power, odd = divmod(n - 3 * i, 2)  # h^i r^n = e^i p^((n - 3 i)/2)
        if power < 0 or odd:
            return None
        total += value * (a * _DELTA**3) ** i * p**power
    return total


def _over(equations: DeviationEquations, polynomial: fmpq_poly, power: fmpq) -> arb | None:
    """0 +- a bound of the polynomial over delta^power for all delta of the range; None if an order is below."""
    total = arb(0)
    for n, value in enumerate(polynomial.coeffs()):
        if value == 0:
            continue
        if not n >= power:
            return None
        total += abs(ball(value)) * equations.delta ** ball(n - power)
    return add_remainder(arb(0), total.upper())
