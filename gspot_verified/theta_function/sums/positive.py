"""tau -> +infinity: the saddle point r = sqrt(tau) with an explicit remainder, and the algebraic part near integers.

Proof page: ``proofs/positive.md``; E_1 .. E_5 are its labels.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from flint import arb, fmpq

from gspot_verified.numbers.balls import MAX_WORKING_BITS, Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta_function.gamma.power import positive_power
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.sums.finite_part import near_integers, weight
from gspot_verified.theta_function.sums.saddle_series import saddle_series, split_length, split_saddle_series

_THREE_QUARTERS = fmpq(3, 4)  # exact, made once
_BITS_OF_A_BOUND = 64  # of a bound, of which a few digits count; any number is right


@dataclass(frozen=True, slots=True)
class SaddlePlan:
    """What the bound may choose freely: N terms, the disc |u| <= disc and the cut r = cut * sqrt(tau).
    Hypotheses: 0 < disc < 1, 0 < cut <= 1 - disc, N >= 1.
    ``split``: sum the series by binary splitting where tau and beta are rational, N rounded up to whole blocks."""

    terms: int
    disc: fmpq
    cut: fmpq
    split: bool = False


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
        reciprocal = reciprocal_gamma(-beta, bits)
        if reciprocal.is_zero():
            return _algebraic_part(point, beta, plan, bits)
        root = point.sqrt()
        large = point * root
        if plan.split and isinstance(tau, fmpq) and isinstance(beta, fmpq):
            plan = replace(plan, terms=split_length(plan.terms))
            series = split_saddle_series(tau, beta, plan.terms)
        else:
            series = saddle_series(large, beta, plan.terms)
        front = reciprocal * (2 * large / 3).exp() * positive_power(point, -(beta / 2 + _THREE_QUARTERS))
        value = front * add_remainder(arb.pi().sqrt() * series, _saddle_remainder(large, center, plan))
        algebraic = _algebraic_part_beside(value, point, beta, plan, bits)
        return add_remainder(algebraic + value, _near_zero(reciprocal, point, center, plan))


def _near_zero(reciprocal: arb, tau: arb, beta: arb, plan: SaddlePlan) -> arb:
    """E_5."""
    with working_bits(_BITS_OF_A_BOUND):
        root = tau.sqrt()
        exponent = tau * root * (plan.cut + plan.cut**3 / 3)
        return 2 * reciprocal.abs_upper() * (plan.cut * root) ** (-beta) * exponent.exp()


def _algebraic_part(tau: arb, beta: Exact, plan: SaddlePlan, bits: int) -> arb:
    """An enclosure of sum_n w_n p_n(tau) (cut sqrt(tau))^(n - beta) over the integers n next to beta."""
    with working_bits(bits):
        cut = plan.cut * tau.sqrt()
        total = arb(0)
        for n in near_integers(beta):
            total += weight(n, beta, bits) * _exponential_coefficient(n, tau) * positive_power(cut, n - beta)
        return total


def _algebraic_part_beside(value: arb, tau: arb, beta: Exact, plan: SaddlePlan, bits: int) -> arb:
    """The algebraic part, no more accurate than the sum with ``value`` at the precision ``bits`` can show."""
    least = _algebraic_part(tau, beta, plan, _BITS_OF_A_BOUND)
    needed = bits - _bits_above(value, least)
    return least if needed <= _BITS_OF_A_BOUND else _algebraic_part(tau, beta, plan, needed)


def _bits_above(large: arb, small: arb) -> int:
    """m >= 0 with |small| about 2^-m |large|, 0 where nothing is known. For heuristics only."""
    if not (large.is_finite() and small.is_finite()) or large.is_zero():
        return 0
    if small.is_zero():
        return MAX_WORKING_BITS
    exponents = []
    for value in (large, small):
        mantissa, exponent = value.abs_upper().man_exp()
        exponents.append(int(exponent) + int(mantissa).bit_length())
    return max(0, exponents[0] - exponents[1])


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


def _saddle_remainder(large: arb, beta: arb, plan: SaddlePlan) -> arb:
    """sqrt(lambda) (E_1 + E_2 + E_3 + E_4) of the proof page; not finite when a hypothesis is not certain."""
    with working_bits(64):
        terms, disc = plan.terms, plan.disc
        if not (0 < disc < 1 and 0 < plan.cut <= 1 - disc and terms >= 1):
            return nonfinite()
        root = arb(1 - disc / 3).sqrt()
        sigma = disc * root
        growth = (-beta - 1).max(arb(0))
        if not (large * sigma * sigma >= 2 * terms and 2 * large * sigma > growth):
            return nonfinite()
        m = growth.upper().ceil()  # any integer >= -beta - 1
        norm = arb(1 + disc) ** m * arb(1 - disc) ** (-beta - 1 - m) * (2 - root) / arb(1 - disc / 2)
        gauss = (-large * sigma * sigma).exp()
        inside = norm * (arb(terms) + fmpq(1, 2)).gamma() / (sigma * sigma * large) ** terms
        outside = 2 * norm * gauss / sigma / large.sqrt()
        right = (growth * sigma).exp() * gauss / (2 * large * sigma - growth) * large.sqrt()
        left = (arb(plan.cut) ** (-beta - 1)).max(arb(1)) * gauss * large.sqrt()
        return inside + outside + right + left
