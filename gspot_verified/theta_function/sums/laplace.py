"""The Laplace integral by rigorous quadrature: an independent witness for every real tau and beta.

Proof page: ``proofs/laplace.md``.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import acb, arb, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.sums.finite_part import series_part
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral


@dataclass(frozen=True, slots=True)
class LaplacePlan:
    """What the route may choose freely: the cut, the end R, the terms that stand for [0, cut], a point near the
    integrand's peak by which it is scaled, and how often the quadrature may evaluate it. Hypotheses: 0 < cut < R,
    0 < peak."""

    cut: fmpq
    end: fmpq
    terms: int
    peak: fmpq
    max_evaluations: int = 20_000


def laplace_sum(tau: Exact, beta: Exact, plan: LaplacePlan, bits: int) -> arb:
    """An enclosure of Theta(tau, beta): a series on [0, cut], quadrature on [cut, R], a bound beyond.

    Hypotheses, checked: the plan's, beta <= terms - 1, and s = R^2 - tau - max(0, -beta - 1)/R > 0; then the
    integral beyond R is at most R^(-beta-1) e^(R tau - R^3/3) / s.
    No formula is shared with the series at tau = 0 or with the asymptotic routes.
    """
    with working_bits(bits):
        point, center, c, last = ball(tau), ball(beta), ball(plan.cut), ball(plan.end)
        if not (c > 0 and c < last and plan.peak > 0):
            return nonfinite()
        decay = last * last - point - (-center - 1).max(arb(0)) / last
        if not decay > 0:
            return nonfinite()
        reciprocal = reciprocal_gamma(-beta, bits)
        near_zero = series_part(tau, beta, plan.cut, plan.terms, bits)
        if reciprocal.is_zero():  # beta = 0, 1, 2, ...: the integral has the factor 0
            return near_zero
        # Scaled by e^height, so that the quadrature's absolute goal 2^-bits is a relative one; any height is right.
        height = _exponent(arb(plan.peak), point, center).mid()
        middle = _quadrature(point, center, c, last, height, plan.max_evaluations)
        beyond = (_exponent(last, point, center) - height).exp() / decay
        return near_zero + reciprocal * height.exp() * add_remainder(middle, beyond)


def _exponent(r: arb, tau: arb, beta: arb) -> arb:
    """ln of the integrand, r > 0."""
    return r * tau - r * r * r / 3 - (beta + 1) * r.log()


def _quadrature(tau: arb, beta: arb, lower: arb, upper: arb, height: arb, max_evaluations: int) -> arb:
    """The integral of r^(-beta-1) e^(r tau - r^3/3 - height) over [lower, upper], 0 < lower.

    Holomorphic away from r <= 0: ``log`` gets the flag and answers NaN on a box that meets its branch cut.
    """

    def integrand(r: acb, analytic: bool) -> acb:
        return (r * tau - r * r * r / 3 - (beta + 1) * r.log(analytic) - height).exp()

    return holomorphic_integral(integrand, lower, upper, max_evaluations).real
