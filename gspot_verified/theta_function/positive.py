"""tau -> +infinity: the saddle point r = sqrt(tau) with an explicit remainder, and the algebraic part near integers.

Proof page: ``proofs/positive.md``; E_1 .. E_5 are its labels.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.balls import Exact, add_remainder, ball, current_bits, nonfinite, working_bits
from gspot_verified.theta_function.finite_part import near_integers, weight
from gspot_verified.theta_function.reciprocal_gamma import reciprocal_gamma

_SHARE = fmpq(9, 10)
_BLOCK = 64
_LEAST_BITS = 64


@dataclass(frozen=True, slots=True)
class SaddlePlan:
    """What the bound may choose freely: N terms, the disc |u| <= disc, the cut r = cut * sqrt(tau), and how much
    of the disc of convergence in s is used. Hypotheses: 0 < disc < 1, 0 < cut <= 1 - disc, 0 < share < 1, N >= 1."""

    terms: int
    disc: fmpq
    cut: fmpq
    share: fmpq = _SHARE


def positive_sum(tau: Exact, beta: Exact, plan: SaddlePlan, bits: int) -> arb:
    """An enclosure of Theta(tau, beta) for tau > 0, with lambda = tau^(3/2):

        algebraic part + K (sqrt(pi) sum_(k<N) g_k lambda^(-k) +- sqrt(lambda) (E_1 + E_2 + E_3 + E_4)) +- E_5,
        K = (1/Gamma(-beta)) tau^(-beta/2) lambda^(-1/2) e^(2 lambda/3),   g_k = c_k (3/2)^k.

    The algebraic part holds the integers next to beta; it takes over where 1/Gamma(-beta) is tiny, and is the whole
    at an integer. Hypotheses (tau > 0, the plan's, lambda sigma^2 >= 2N, 2 lambda sigma > -beta - 1), checked: when
    one is not certain the result is not finite.
    """
    with working_bits(bits):
        point, center = ball(tau), ball(beta)
        if not point > 0:
            return nonfinite()
        root = point.sqrt()
        large = point * root
        cut = plan.cut * root
        algebraic = arb(0)
        for n in near_integers(beta):
            algebraic += weight(n, beta, bits) * _exponential_coefficient(n, point) * cut ** (n - center)
        reciprocal = reciprocal_gamma(-beta, bits)
        if reciprocal.is_zero():
            return algebraic
        front = reciprocal * root ** (-center) * (2 * large / 3).exp() / large.sqrt()
        bracket = arb.pi().sqrt() * _saddle_series(large, beta, plan.terms)
        bracket = add_remainder(bracket, _saddle_remainder(large, center, plan))
        near_zero = 2 * reciprocal * cut ** (-center) * (large * (plan.cut + plan.cut**3 / 3)).exp()
        return add_remainder(algebraic + front * bracket, near_zero)


def _exponential_coefficient(n: int, tau: arb) -> arb:
    """p_n(tau) = [r^n] e^(r tau - r^3/3) = sum_j tau^(n-3j) (-1/3)^j / ((n-3j)! j!), tau > 0."""
    term = tau**n / arb.fac_ui(n)
    total = term
    inverse_cube = 1 / (tau * tau * tau)
    for j in range(n // 3):
        m = n - 3 * j
        term = term * fmpq(-m * (m - 1) * (m - 2), 3 * (j + 1)) * inverse_cube
        total += term
    return total


def _saddle_series(large: arb, beta: Exact, terms: int) -> arb:
    """sum_(k<N) g_k lambda^(-k), by the recurrence of ``asymptotic_coefficients.coefficient``."""
    exponent = -beta / 3 - fmpq(1, 2)
    inverse = 1 / large
    previous, current, total = arb(0), arb(1), arb(1)
    bits = current_bits()
    for start in range(1, terms, _BLOCK):
        # A term of relative size 2^-m needs m bits less; what rounding costs is in its ball.
        with working_bits(max(_LEAST_BITS, bits - _bits_below_one(abs(current) + abs(previous)))):
            part = arb(0)
            for k in range(start, min(start + _BLOCK, terms)):
                first, second = exponent - (k - 1), exponent - (k - 2)
                # For a rational beta the factors are small rationals, cheap to multiply by.
                following = current * ((27 * first * first - 9 * first - 1) / (12 * k))
                following += inverse * previous * (second * (3 * second - 2) * (3 * second - 4) / (8 * k))
                previous, current = current, following * inverse
                part += current
        total += part
    return total


def _bits_below_one(size: arb) -> int:
    """m >= 0 with |size| <= 2^-m, or 0. For heuristics only."""
    if not size.is_finite():
        return 0
    mantissa, exponent = size.abs_upper().man_exp()
    return max(0, -int(exponent) - int(mantissa).bit_length())


def _saddle_remainder(large: arb, beta: arb, plan: SaddlePlan) -> arb:
    """sqrt(lambda) (E_1 + E_2 + E_3 + E_4) of the proof page; not finite when a hypothesis is not certain."""
    with working_bits(64):
        terms, disc = plan.terms, plan.disc
        if not (0 < disc < 1 and 0 < plan.cut <= 1 - disc and 0 < plan.share < 1 and terms >= 1):
            return nonfinite()
        radius = disc * arb(1 - disc / 3).sqrt()
        sigma = plan.share * radius
        growth = (-beta - 1).max(arb(0))
        if not (large * sigma * sigma >= 2 * terms and 2 * large * sigma > growth):
            return nonfinite()
        on_circle = (arb(1 - disc) ** (-beta - 1)).max(arb(1 + disc) ** (-beta - 1))
        majorant = on_circle * arb(1 + disc / 3).sqrt() / arb(1 - disc / 2)
        geometric = 1 / arb(1 - plan.share**2)
        gauss = (-large * sigma * sigma).exp()
        inside = majorant * geometric * (arb(terms) + fmpq(1, 2)).gamma() / (radius * radius * large) ** terms
        outside = 2 * majorant * geometric * gauss / sigma / large.sqrt()
        right = (growth * sigma).exp() * gauss / (2 * large * sigma - growth) * large.sqrt()
        left = (arb(plan.cut) ** (-beta - 1)).max(arb(1)) * gauss * large.sqrt()
        return inside + outside + right + left
