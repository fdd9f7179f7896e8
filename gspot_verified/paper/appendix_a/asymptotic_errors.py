"""How far the printed asymptotic formulas of Appendix A are from the functions, at single points.

Each answer is three-valued: True or False when the balls are certain, None otherwise.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import certainly_at_most, working_bits
from gspot_verified.paper.appendix_a import hypergeometric as printed
from gspot_verified.paper.checks.entry import all_of
from gspot_verified.theta_function.value.routes import theta_by


def small_error_within(j: int, x: fmpq, beta: fmpq) -> bool | None:
    """th:4, formula j + 1, at tau = -x: the error is at most twice the first omitted terms."""
    bits, orders, powers = 1200, 4, 9
    h = printed.h_terms(x, beta, powers + 1, bits)
    e = printed.e_terms(x, beta, orders + 1, bits)
    exact_value = printed.fundamental_solution(j, -x, beta, bits)
    gamma, outer, real, imaginary = (
        printed.value_of(printed.SMALL[f"{name} {j}"], beta, bits) for name in ("h", "e", "real", "imaginary")
    )
    with working_bits(bits):
        total = sum(e[:orders], e[0] * 0)
        combination = real * total.real + imaginary * total.imag
        error = exact_value - (gamma * sum(h[:powers], arb(0)) + outer * combination)
        allowed = 2 * (abs(gamma * h[powers]) + 2 * abs(outer) * abs(e[orders]))
        return _within(error, allowed)


def power_series_within(x: fmpq, beta: fmpq) -> bool | None:
    """Three terms of the front times h at tau = -x: the error is at most the fourth; the first is the leading term."""
    value = theta_by("laplace", -x, beta, digits=40)
    terms = printed.h_terms(x, beta, 4, 256)
    scale = printed.value_of(printed.THETA["small front"], beta, 256)
    leading = printed.value_of(printed.THETA["small leading"], beta, 256, x=x)
    with working_bits(256):
        error = value - scale * sum(terms[:3], arb(0))
        same = _within(scale * terms[0] - leading, abs(leading) * fmpq(1, 10**40))
        return all_of([_within(error, abs(scale * terms[3])), same])


def large_error_within(j: int, tau: fmpq, beta: fmpq) -> bool | None:
    """th:5, formula j + 1: the error of four terms is at most twice the fifth."""
    terms = printed.e_1_terms(tau, beta, 5, 512)
    value = printed.fundamental_solution(j, tau, beta, 512)
    factor = printed.value_of(printed.LARGE[f"factor {j}"], beta, 512)
    with working_bits(512):
        error = value - factor * sum(terms[:4], arb(0))
        return _within(error, 2 * abs(factor * terms[4]))


def theta_error_within(tau: fmpq, beta: fmpq) -> bool | None:
    """Eq. tlarge: the error of four terms is at most twice the fifth."""
    terms = printed.e_1_terms(tau, beta, 5, 256)
    value = theta_by("taylor", tau, beta, digits=40)
    factor = printed.value_of(printed.THETA["large front"], beta, 256)
    with working_bits(256):
        error = value - factor * sum(terms[:4], arb(0))
        return _within(error, 2 * abs(factor * terms[4]))


def _within(error: arb, allowed: arb) -> bool | None:
    """Whether |error| <= allowed for certain; ``None`` when the balls cannot tell."""
    if not error.is_finite():
        return None
    return certainly_at_most(abs(error), allowed)
