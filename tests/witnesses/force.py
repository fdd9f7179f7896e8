"""The contact force at leading order by mpmath: the printed formulas with the corrected mean force."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from flint import fmpq
from witnesses.theta import theta_witness

from gspot_verified.leading_order.contact_force import ContactForce


def slope(tau: fmpq, beta: fmpq) -> Fraction:
    """dTheta/dtau by mpmath, through -beta Theta(beta - 1)."""
    b = Fraction(int(beta.p), int(beta.q))
    return -b * theta_witness(Fraction(int(tau.p), int(tau.q)), b - 1, 25)


def force_by_mpmath(force: ContactForce, tau: fmpq, epsilon: fmpq) -> mpmath.mpf:
    """lambda_N without the package's own rearrangement."""

    def number(value: fmpq | Fraction) -> mpmath.mpf:
        fraction = value if isinstance(value, Fraction) else Fraction(int(value.p), int(value.q))
        return mpmath.mpf(fraction.numerator) / fraction.denominator

    with mpmath.workdps(40):
        a1, a2, a3, beta = (number(x) for x in (force.alpha_1, force.alpha_2, force.alpha_3, force.beta))
        kappa = mpmath.power(-a1 / 2, mpmath.mpf(1) / 3)
        front = -number(force.c1) / a3 * kappa ** (1 - beta) * number(epsilon) ** ((2 * beta - 2) / 3)
        return a2 / (a3 - a1) + front * number(slope(tau, force.beta))
