"""How far the printed asymptotic formulas of Appendix A are from the functions, at single points.

Each answer is three-valued: True or False when the balls are certain, None otherwise.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.balls import certainly_at_most, working_bits
from gspot_verified.ledger import hypergeometric as printed
from gspot_verified.theta_function.routes import theta_by


def small_error_within(j: int, x: fmpq, beta: fmpq) -> bool | None:
    """Theorem 4, formula j + 1, at tau = -x: the error is at most twice the first omitted terms."""
    bits, orders, powers = 1200, 4, 9
    h = printed.h_terms(x, beta, powers + 1, bits)
    e = printed.e_terms(x, beta, orders + 1, bits)
    exact_value = printed.theorem_3_function(j, -x, beta, bits)
    with working_bits(bits):
        power = arb(3) ** arb(fmpq(3 - j, 3))
        gamma = arb((3 - j + beta) / 3).gamma() * (-1) ** j
        outer = arb((j - beta) / 3).rgamma()
        root = arb(3).sqrt()
        total = sum(e[:orders], e[0] * 0)
        combination = (2 * total.real, -(total.real - root * total.imag), -total.real - root * total.imag)[j]
        error = exact_value - power * (gamma * sum(h[:powers], arb(0)) + outer * combination)
        allowed = 2 * power * (abs(gamma * h[powers]) + 2 * abs(outer) * abs(e[orders]))
        return _within(error, allowed)


def power_series_within(x: fmpq, beta: fmpq) -> bool | None:
    """Three terms of 3^(1-beta/3) Gamma(1+beta) h at tau = -x: the error is at most the fourth."""
    value = theta_by("laplace", -x, beta, digits=40)
    terms = printed.h_terms(x, beta, 4, 256)
    with working_bits(256):
        scale = arb(3) ** arb(1 - beta / 3) * arb(1 + beta).gamma()
        error = value - scale * sum(terms[:3], arb(0))
        return _within(error, abs(scale * terms[3]))


def large_error_within(j: int, tau: fmpq, beta: fmpq) -> bool | None:
    """Theorem 5, formula j + 1: the error of four terms is at most twice the fifth."""
    terms = printed.e_1_terms(tau, beta, 5, 512)
    value = printed.theorem_3_function(j, tau, beta, 512)
    with working_bits(512):
        factor = arb(3) ** arb(fmpq(3 - j, 3)) * arb((j - beta) / 3).rgamma()
        error = value - factor * sum(terms[:4], arb(0))
        return _within(error, 2 * abs(factor * terms[4]))


def theta_error_within(tau: fmpq, beta: fmpq) -> bool | None:
    """Eq. tlarge: the error of four terms is at most twice the fifth."""
    terms = printed.e_1_terms(tau, beta, 5, 256)
    value = theta_by("taylor", tau, beta, digits=40)
    with working_bits(256):
        factor = arb(3) ** arb(1 - beta / 3) * arb(-beta).rgamma()
        error = value - factor * sum(terms[:4], arb(0))
        return _within(error, 2 * abs(factor * terms[4]))


def _within(error: arb, allowed: arb) -> bool | None:
    """Whether |error| <= allowed for certain; ``None`` when the balls cannot tell."""
    if not error.is_finite():
        return None
    return certainly_at_most(abs(error), allowed)
