"""The slow deviation at leading order with a given C_1: paper, eqs. bhat_inner and inner_scaling.

Proof page: ``proofs/uniform.md``, Corollary 2.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import ball
from gspot_verified.theta_function.theta import theta

_DIGITS = 36  # of the centre of the family; its ball counts


def slow_deviation(equations: DeviationEquations, beta: fmpq, c_1: fmpq, s: fmpq) -> list[arb]:
    """D(s): the deviation of xi, p, b, y, v over delta^(2 beta - 2) as delta tends to 0."""
    scale = (-equations.alpha_1 * equations.kappa).root(3)
    size = ball(c_1) * scale ** (-ball(beta))
    values = [theta(scale * ball(s), beta, derivative=k, digits=_DIGITS) for k in range(3)]
    b, y, v = (size * scale**k * value for k, value in enumerate(values))
    pressed = equations.kappa * equations.alpha_3
    return [*(-control / equations.alpha_3 * b for control in equations.control), arb(0), b, y / pressed, v / pressed]
