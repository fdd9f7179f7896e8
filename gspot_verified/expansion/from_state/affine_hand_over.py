"""The set of deviations that Theorem B' hands over to Theorem U1 at s = -S, for all delta of a range.

Proof page: ``proofs/from_state.md``, section 8. The reference of the tube and the polynomials of Theorem 1 are compared
as polynomials in delta: exactly, or by Lemma T in balls.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from flint import arb, arb_mat, arb_poly, fmpq, fmpq_poly

from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, carried, power_of
from gspot_verified.expansion.from_state.analytic import Polynomial
from gspot_verified.expansion.from_state.hand_over import Beside, HandOver, framed
from gspot_verified.expansion.from_state.passage import rounded_up
from gspot_verified.expansion.from_state.slow_manifold import H, R, SlowManifold, excess_terms, still_terms
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.frames import identity
from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull
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
    if less(ball(a) ** 2, ball(tube.rectangle.h**2) * scaled**3) is None:
        return "the tube ends before the hand-over"
    if less(scaled * equations.delta**2, ball(given.p)) is None:
        return "the start lies after the hand-over"
    beside = _beside(equations, manifold, place)
    if beside is None:
        return "the reference differs from Theorem 1 at an order below mu, or is no polynomial in p and epsilon"
    slopes = _slopes(equations, manifold, tube, scaled, place)
    if slopes is None:
        return "p, b, y, v are not certainly coordinates of the state at the hand-over"
    root = scaled.sqrt()
    h, r = ball(a) / (root * scaled), root * equations.small
    z = tube.bound(h, r.upper())
    coefficient = given.coefficient(tube.start.e) * carried(given, tube, h, r).exp()
    excess = -coefficient * power_of(r, manifold.mu)
    parts = (H * R * manifold.u, H * manifold.u, manifold.w, manifold.f)
    slow = tuple(_over_excess(one, h, r, excess) for one in parts)
    return framed(
        equations, manifold.beta, slow, tube.shares, z, coefficient, scaled=scaled, beside=beside, slopes=slopes
    )


def _slopes(
    equations: DeviationEquations, manifold: SlowManifold, tube: AffineTube, scaled: arb, place: fmpq
) -> arb_mat | None:
    """The derivatives of the state by p, b, y, v between that of the expansion and all states of the tube."""
    chart = manifold.system.chart
    if chart is None:
        return identity(4)
    last = rounded_up((equations.delta**2 * scaled).upper())
    left = equations.residuals.conditions(fmpq(-place))
    sides = []
    for side, name, power, more in zip(
        replace(tube.cone, last=last).place, ("p", "b", "y", "v"), (2, 2, 6, 4), left, strict=True
    ):
        far = equations.norm(name, ball(place)) * equations.delta**power
        rest = more * equations.delta ** (equations.trajectory.order + 2)
        sides.append(hull([side, add_remainder(arb(0), (far + rest).upper())]))
    region = chart.region(sides)
    return None if region is None else region.inverse


def _over_excess(polynomial: Polynomial, h: arb, r: arb, excess: arb) -> arb:
    """The terms with L, over L."""
    terms = ((i, n, k - 1, value) for (i, n, k), value in excess_terms(polynomial).items() if k)
    return sum((ball(value) * h**i * r**n * excess**k for i, n, k, value in terms), arb(0))


def _beside(equations: DeviationEquations, manifold: SlowManifold, place: fmpq) -> Beside | None:
    """Reference minus polynomials at s = -``place``; None unless they are polynomials in delta with orders >= mu."""
    exact, mu = manifold.system.is_exact, manifold.mu
    cut, order = manifold.cut, equations.trajectory.order
    if not (order >= mu and (exact or (3 * cut.order >= mu + 1 and order >= mu + 1 and cut.weight + cut.mu >= mu))):
        return None  # beside Lemma T
    known = {
        name: _polynomial([term(fmpq(-place) if exact else ball(-place)) for term in terms])
        for name, terms in equations.trajectory.terms().items()
    }
    kappa, lag = manifold.contact.kappa, manifold.contact.lag / manifold.contact.rate
    speed, fast = H * R * manifold.u, R * R * manifold.f
    force, square = manifold.force + manifold.w, _DELTA * _DELTA
    compared = (
        (-R * R * manifold.force, square * known["b"], 2),
        ((fast - force - lag * speed) / kappa, known["y"], 0),
        (speed, _DELTA * known["v"], 1),
        (fast, known["lambda_n"] + known["y"] * kappa + _DELTA * known["v"] * lag, 0),
    )
    p = square * known["p"]
    sizes = list[arb | None]()
    for reference, polynomial, unit in compared:
        of_delta = _in_delta(reference, p, manifold.system.a)
        sizes.append(None if of_delta is None else _over(equations, of_delta - polynomial, mu + unit))
    found = [one for one in sizes if one is not None]
    if len(found) < len(sizes):
        return None
    shrunk = equations.delta ** ball(order - mu)
    first, second, third, fourth = (value * shrunk for value in equations.residuals.conditions(fmpq(-place)))
    b, y, v, phi = found
    return Beside(b, y, v, phi, (first, second, third, fourth))


def _polynomial(values: Sequence[Exact]) -> Any:
    """In delta; exact where the coefficients are."""
    exact = [value for value in values if isinstance(value, fmpq)]
    return fmpq_poly(exact) if len(exact) == len(values) else arb_poly([ball(value) for value in values])


def _in_delta(polynomial: Polynomial, p: Any, a: Exact) -> Any:
    """The polynomial at L = 0, where e = a delta^3 and p are polynomials in delta; None if it is none in p and e."""
    total: Any = fmpq_poly([0])
    for (i, n), value in still_terms(polynomial).items():
        power, odd = divmod(n - 3 * i, 2)  # h^i r^n = e^i p^((n - 3 i)/2)
        if odd or (power < 0 and not _vanishes(value)):
            return None
        if power >= 0:
            total = total + _polynomial([*[fmpq(0)] * (3 * i), value * a**i]) * p**power
    return total


def _vanishes(value: Exact) -> bool:
    """Whether a number may be 0, and so is it where Lemma T says it; what is not finite would contain everything."""
    return bool(value == 0) if isinstance(value, fmpq) else bool(value.is_finite() and value.contains(0))


def _over(equations: DeviationEquations, polynomial: Any, power: Exact) -> arb | None:
    """0 +- a bound of the polynomial over delta^power for all delta of the range; None if an order is below."""
    total = arb(0)
    coefficients: list[Exact] = list(polynomial.coeffs())
    for n, value in enumerate(coefficients):
        if n >= power:
            total += abs(ball(value)).upper() * equations.delta ** ball(n - power)
        elif not (n < power and _vanishes(value)):
            return None
    return add_remainder(arb(0), total.upper())
