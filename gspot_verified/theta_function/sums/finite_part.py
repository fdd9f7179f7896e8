"""The part of the Laplace integral next to r = 0, as Hadamard's finite part: what remains finite for every beta.

    Theta(tau, beta) = sum_n w_n p_n(tau) c^(n - beta) + (1/Gamma(-beta)) int_c^oo r^(-beta-1) e^(r tau - r^3/3) dr

with p_n(tau) = [r^n] e^(r tau - r^3/3) and w_n = 1/(Gamma(-beta) (n - beta)), entire in beta.

Proof page: ``proofs/laplace.md``.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma


def weight(n: int, beta: Exact, bits: int) -> arb:
    """w_n = 1/(Gamma(-beta) (n - beta)) at precision ``bits``, finite at beta = n too.

    By reflection it is (-1)^n Gamma(1 + beta) sin(pi (beta - n))/(pi (beta - n)); used where beta > -1/2 is certain, so
    that the factors are finite; the exact beta - n of a rational keeps the accuracy, and Gamma of a rational is much
    faster than Gamma of a ball at many bits. Elsewhere it is (-beta)(1 - beta)...(n - 1 - beta)/Gamma(n + 1 - beta).
    """
    if not beta > fmpq(-1, 2):
        value = reciprocal_gamma(n + 1 - beta, bits)
        for j in range(n):
            value = value * (j - beta)
        return value
    gamma = 1 / reciprocal_gamma(1 + beta, bits) if isinstance(beta, fmpq) else (1 + beta).gamma()
    value = gamma * ball(beta - n).sinc_pi()
    return -value if n % 2 else value


def near_integers(beta: Exact) -> range:
    """The integers n >= 0 whose distance to a number of ``beta`` may be below 1/2."""
    with working_bits(64):
        center = ball(beta)
        lower = _whole((center - fmpq(1, 2)).lower().floor())
        upper = _whole((center + fmpq(1, 2)).upper().ceil())
    return range(max(0, lower), upper + 1)


def _whole(value: arb) -> int:
    number = value.unique_fmpz()
    if number is None:
        raise ValueError(f"beta: {value} is not within the domain")
    return int(number)


def series_part(tau: Exact, beta: Exact, cut: Exact, terms: int, bits: int) -> arb:
    """An enclosure of sum_n w_n p_n(tau) c^(n - beta), the first ``terms`` = K of it summed, the rest bounded.

    Hypotheses, checked: cut > 0 and beta <= K - 1, certain. By Cauchy's estimate on |r| = 4c,
    |p_n| c^n <= 4^(-n) e^(4 c |tau| + 64 c^3/3), and |w_n| <= |1/Gamma(-beta)| for n >= K.
    """
    with working_bits(bits):
        point, center, c = ball(tau), ball(beta), ball(cut)
        if not (c > 0 and center <= terms - 1):
            return nonfinite()
        reciprocal = reciprocal_gamma(-beta, bits)
        near = near_integers(beta)
        step, cube = point * c, c * c * c
        polynomials = [arb(0), arb(0), arb(1)]
        total = arb(0)
        for n in range(terms):
            share = weight(n, beta, bits) if n in near else reciprocal / (n - beta)
            total += share * polynomials[2]
            following = (step * polynomials[2] - cube * polynomials[0]) / (n + 1)
            polynomials = [polynomials[1], polynomials[2], following]
        exponent = 4 * c * point.abs_upper() + 64 * cube / 3
        rest = reciprocal.abs_upper() * exponent.exp() * arb(4) ** (1 - terms) / 3
        return add_remainder(total, rest) * c ** (-center)
