"""G_b(tau; eta) for b <= -1 by the trapezoidal rule in the logarithm of the integration variable.

Proof page: ``proofs/slow_integral.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import Grid, cubic_exponent, grid, scale
from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits

_BOUND_BITS = 64  # of a bound, of which a few digits count; any number is right


@dataclass(frozen=True, slots=True)
class TrapezoidPlan:
    """What the rule may choose freely: step and range of the nodes rho = e^(k step), the half-width ``angle`` of the
    strip, and two points for the tangents that bound the shifted integral. Hypotheses: 0 < angle <= pi/6, step > 0,
    first < last; those on the tangents are checked where they are drawn."""

    step: fmpq
    first: int
    last: int
    angle: fmpq
    rising: fmpq
    falling: fmpq
    bits: int


def slow_moments(tau: arb, b: Exact, epsilon: Exact, count: int, plan: TrapezoidPlan) -> list[arb]:
    """Enclosures of I_(b-j) = int_0^oo rho^(j-b-1) e^(-rho^3/3 + rho tau + h(rho; eta)) drho, j = 0, ..., count - 1.

    Hypotheses, checked: b <= -1, eta > 0 and the plan's; else the balls are not finite.
    """
    with working_bits(plan.bits):
        top, eta = ball(b), scale(epsilon)
        if not (top <= -1 and eta > 0 and plan.angle > 0 and plan.step > 0 and plan.first < plan.last):
            return [nonfinite()] * count
        if not arb(plan.angle) * 6 <= arb.pi():
            return [nonfinite()] * count
        nodes = grid(epsilon, plan.step, plan.first, plan.last, plan.bits)
        sums = [plan.step * total for total in _sums(tau, top, count, nodes)]
        exponents = [top - j for j in range(count)]
        with working_bits(_BOUND_BITS):
            remainders = _remainders(tau, exponents, eta, plan, nodes)
        return [add_remainder(total, remainder) for total, remainder in zip(sums, remainders, strict=True)]


def _remainders(tau: arb, exponents: Sequence[arb], eta: arb, plan: TrapezoidPlan, nodes: Grid) -> list[arb]:
    """Bounds of what the sums leave out and of the discretisation, for each b of ``exponents``."""
    shifted = _tangent_bounds(tau, exponents, eta, arb(plan.angle), arb(plan.rising), arb(plan.falling))
    ratio = (2 * arb.pi() * plan.angle / plan.step).exp() - 1
    return [
        plan.step * (_left_of_the_nodes(tau, b, eta, plan, nodes) + _right_of_the_nodes(tau, b, eta, plan, nodes))
        + 2 * bound / ratio
        for b, bound in zip(exponents, shifted, strict=True)
    ]


def _sums(tau: arb, b: arb, count: int, nodes: Grid) -> list[arb]:
    """sum_k rho_k^(j-b) e^(exponent_k + rho_k tau), j = 0, ..., count - 1."""
    # rho_k^(-b) = e^(-b k step): one logarithm less at each node, and no power.
    slope = -b * nodes.step
    terms = [
        (exponent + rho * tau + slope * k).exp()
        for k, rho, exponent in zip(range(nodes.first, nodes.last + 1), nodes.nodes, nodes.exponents, strict=True)
    ]
    sums = []
    for j in range(count):
        if j:
            terms = [term * rho for term, rho in zip(terms, nodes.nodes, strict=True)]
        sums.append(sum(terms, arb(0)))
    return sums


def _left_of_the_nodes(tau: arb, b: arb, eta: arb, plan: TrapezoidPlan, nodes: Grid) -> arb:
    """sum_(k<first) rho_k^(-b) e^(...): a geometric series of ratio e^(b step), times the last exponential or a bound.

    Where E' >= 0 at the first node, E increases up to it; otherwise E(rho) <= max(0, rho tau).
    """
    rho = nodes.nodes[0]
    rising = _slope(rho, tau, eta, arb(1)) >= 0
    growth = nodes.exponents[0] + rho * tau if rising else (rho * tau).max(arb(0))
    ratio = (b * plan.step).exp()
    return (growth - b * plan.step * (plan.first - 1)).exp() / (1 - ratio)


def _right_of_the_nodes(tau: arb, b: arb, eta: arb, plan: TrapezoidPlan, nodes: Grid) -> arb:
    """sum_(k>last): the logarithm of the term falls at least as fast in k step as at the last node.

    Hypotheses, checked: E' < 0 and the slope -b + rho E' < 0 at the last node.
    """
    rho = nodes.nodes[-1]
    slope = _slope(rho, tau, eta, arb(1))
    fall = b - rho * slope
    if not (slope < 0 and fall > 0):
        return nonfinite()
    last = (nodes.exponents[-1] + rho * tau - b * plan.step * plan.last).exp()
    ratio = (-fall * plan.step).exp()
    return last * ratio / (1 - ratio)


def _slope(rho: arb, tau: arb, eta: arb, cosine_3: arb) -> arb:
    """tau + cosine_3 d/drho (-rho^3/3 + h(rho; eta)) = tau - cosine_3 rho^2 (x + 2)/(2 (1 + x)), x = eta rho."""
    x = eta * rho
    return tau - cosine_3 * rho * rho * (x + 2) / (2 * (1 + x))


def tangent_bound(tau: arb, b: arb, eta: arb, angle: arb, rising: arb, falling: arb) -> arb:
    """A bound of int_0^oo rho^(-b-1) e^(rho tau cos(angle) + cos(3 angle)(-rho^3/3 + h)) drho, 0 <= angle <= pi/6.

    The logarithm of the integrand is concave for b <= -1, so it lies below its tangents at ``rising`` and ``falling``.
    Hypotheses, checked: 0 < rising < falling, slope > 0 at the first and < 0 at the second.
    """
    return _tangent_bounds(tau, (b,), eta, angle, rising, falling)[0]


def _tangent_bounds(tau: arb, exponents: Sequence[arb], eta: arb, angle: arb, rising: arb, falling: arb) -> list[arb]:
    """:func:`tangent_bound` for several b: what does not depend on b is made once."""
    cosine, cosine_3 = angle.cos(), (3 * angle).cos()
    if not (0 < rising < falling and cosine_3 >= 0):
        return [nonfinite()] * len(exponents)
    places = [
        (rho.log(), 1 / rho, rho * tau * cosine + cosine_3 * cubic, _slope(rho, tau * cosine, eta, cosine_3))
        for rho, cubic in zip((rising, falling), cubic_exponent(eta, (rising, falling)), strict=True)
    ]
    return [_below_the_tangents(places, -b - 1, falling - rising) if b <= -1 else nonfinite() for b in exponents]


def _below_the_tangents(places: Sequence[tuple[arb, arb, arb, arb]], power: arb, distance: arb) -> arb:
    """The integral of e^min(tangents); ``places`` hold log rho, 1/rho and the rest of the logarithm and its slope."""
    height, other = (power * log + rest for log, _, rest, _ in places)
    up, down = (power * inverse + slope for _, inverse, _, slope in places)
    if not (up > 0 and down < 0):
        return nonfinite()
    # The tangents meet at rising + x: height + up x = other + down (x - distance).
    meeting = (other - height - down * distance) / (up - down)
    return (height + up * meeting).exp() * (1 / up - 1 / down)
