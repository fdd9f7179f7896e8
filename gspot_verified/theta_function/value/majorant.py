"""A bound on |Theta| over balls of any width, for inputs that no other route can use.

Proof page: ``proofs/majorant.md``.
"""

from __future__ import annotations

from flint import acb, arb, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta_function.gamma.initial_values import initial_values


def majorant_bound(beta: Exact, size: fmpq, value: arb, bits: int) -> arb:
    """A ball around 0 that contains Theta(tau, b) for every b in ``beta`` and every |tau| <= X.

    ``size`` = B, with |beta| <= B and B >= 1, checked, else the result is not finite; ``value`` is an enclosure of
    Theta(X, -B). Then |Theta(tau, b)| <= M Theta(X, -B), M = max_j |Theta^(j)(0, b)| / Theta^(j)(0, -B).
    """
    with working_bits(bits):
        reach = abs(beta) if isinstance(beta, fmpq) else beta.abs_upper()
        if not (reach <= size and size >= 1):
            return nonfinite()
        quotients = [
            ours.abs_upper() / theirs
            for ours, theirs in zip(initial_values(beta, bits), initial_values(-size, bits), strict=True)
        ]
        largest = quotients[0].max(quotients[1]).max(quotients[2])
        return add_remainder(arb(0), largest * value)


def turned_argument(tau: acb, tangent: fmpq, bits: int) -> arb:
    """A number v >= Re(tau e^(i psi)) cos(3 psi)^(-1/3) for every tau in the rectangle, tan(psi/2) = ``tangent``."""
    with working_bits(bits):
        cosine, sine, kappa = _turn(tangent)
        if not kappa > 0:
            return nonfinite()
        return ((tau.real * cosine - tau.imag * sine) / arb(kappa).root(3)).upper()


def turned_bound(beta: Exact, tangent: fmpq, value: arb, bits: int) -> arb:
    """A bound on |Theta(tau, b)| for every b in ``beta`` and every tau that :func:`turned_argument` made v of.

    ``value`` is an enclosure of Theta(v, b) for every b in ``beta``. The bound is cos(3 psi)^(b/3) Theta(v, b).
    Hypotheses, checked: |psi| < pi/6 and beta < 0, certain; else the result is not finite.
    """
    with working_bits(bits):
        kappa = _turn(tangent)[2]
        if not (abs(tangent) < 1 and kappa > 0 and beta < 0):
            return nonfinite()
        return (value * arb(kappa) ** (ball(beta) / 3)).abs_upper()


def _turn(tangent: fmpq) -> tuple[fmpq, fmpq, fmpq]:
    """cos psi, sin psi and cos(3 psi), exactly."""
    cosine, sine = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
    return cosine, sine, 4 * cosine**3 - 3 * cosine
