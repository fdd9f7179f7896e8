"""One value of the Taylor series at 0, term by term along its three chains: nothing is kept for another tau.

The terms are integers, 2^s times the quotients of each term and the first of its chain, rounded down; the errors of
that rounding are bounded by a chain of integers of their own. Cheaper than the polynomial of
:mod:`gspot_verified.theta_function.sums.taylor` for one value at few digits. Proof page: ``proofs/taylor.md``.
"""

from __future__ import annotations

from flint import arb, fmpq, fmpz

from gspot_verified.numbers.balls import add_remainder, nonfinite, working_bits
from gspot_verified.theta_function.gamma.initial_values import rational_initial_values

# (k+1)(k+2)(k+3), the denominators of the first quotients.
_PRODUCTS = tuple((k + 1) * (k + 2) * (k + 3) for k in range(600))
# 2^s has so many bits more than the balls: what the rounding of some ten terms of the largest size adds up to.
_MORE_BITS = 10


def chain_sum(tau: fmpq, beta: fmpq, length: int, bits: int) -> arb:
    """An enclosure of Theta(tau, beta) from ``length`` = K Taylor terms, rounded up to a multiple of 3.

    Not finite where the ratio q of the page, (1 + |beta|/K) X^3/((K+1)(K+2)), is above 1/2 (compared in integers); else
    the rest is at most twice the sum of the three first omitted terms.
    """
    return chain_sum_at(int(tau.p), int(tau.q), int(beta.p), int(beta.q), length, bits)


def chain_sum_at(above: int, below: int, p: int, q: int, length: int, bits: int) -> arb:
    """The same at tau = above/below and beta = p/q in lowest terms, below > 0, q > 0: a long fmpq is slow to read."""
    value, slope, curvature = rational_initial_values(p, q, bits)
    length = -(-length // 3) * 3
    rise, fall = above**3, q * below**3
    if 2 * (length * q + abs(p)) * abs(rise) > length * (length + 1) * (length + 2) * fall:
        return nonfinite()
    scale = bits + _MORE_BITS
    sums, errors = _chains(-p, q, rise, fall, length, scale)
    with working_bits(bits):
        slope, curvature = slope * above / below, curvature * above**2 / (2 * below**2)
        total = value * sums[0] + slope * sums[1] + curvature * sums[2]
        error = abs(value) * errors[0] + abs(slope) * errors[1] + abs(curvature) * errors[2]
        return add_remainder(total, error) / (fmpz(1) << scale)


_Three = tuple[int, int, int]


def _chains(factor: int, q: int, rise: int, fall: int, length: int, scale: int) -> tuple[_Three, _Three]:
    """The sums of the three chains from 1 on, times 2^scale, and a bound on the error of each: rounding and rest.

    The quotient of the terms k + 3 and k is (factor + k q) rise/((k+1)(k+2)(k+3) fall), q > 0, fall > 0; the rest is
    bounded where the page's q is at most 1/2.
    """
    products = _PRODUCTS if length <= len(_PRODUCTS) else _products(length)
    first = second = third = 1 << scale
    first_sum = second_sum = third_sum = error = errors = 0
    numerator, step = factor * rise, q * rise
    largest, size = abs(numerator), abs(step)
    for k in range(0, length, 3):
        first_sum += first
        second_sum += second
        third_sum += third
        errors += error
        denominator = products[k] * fall
        error = error * largest // denominator + 2
        first = first * numerator // denominator
        second = second * (numerator + step) // (products[k + 1] * fall)
        third = third * (numerator + 2 * step) // (products[k + 2] * fall)
        numerator += 3 * step
        largest += 3 * size
    errors += 2 * error
    bounds = errors + 2 * abs(first), errors + 2 * abs(second), errors + 2 * abs(third)
    return (first_sum, second_sum, third_sum), bounds


def _products(count: int) -> tuple[int, ...]:
    return tuple((k + 1) * (k + 2) * (k + 3) for k in range(count))
