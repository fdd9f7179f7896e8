"""The polynomial P of Theorem C: f minus a finite sum of derivatives at leading order increases in eta, for every beta.

Proof page: ``proofs/monotone.md``, sections 3 and 10.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq

from gspot_verified.compliant.slow.epsilon_series import series_coefficients, theta_derivatives
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.balls import hull, working_bits

_BITS = 128  # of the arithmetic with those digits
_DIGITS = 40  # of Theta and two derivatives, from which the recurrence makes all others


class Term(NamedTuple):
    """c eta^power f_0^(order)."""

    power: int
    order: int
    coefficient: fmpq


@lru_cache(maxsize=64)
def lower_terms(b: fmpq) -> tuple[Term, ...]:
    """The terms of P for b: m = 1, ..., M, 4 (M + 1) > b, and k = m, ..., K_m, K_m - m odd, K_m + 1 + 3 m > b.

    >>> [tuple(map(str, term)) for term in lower_terms(fmpq(9, 2))]
    [('1', '4', '1/8'), ('2', '5', '-1/10')]
    """
    terms = []
    m = 1
    while 4 * m <= b:
        last = m + 1
        while last + 1 + 3 * m <= b:
            last += 2
        terms += [Term(k, k + 3 * m, series_coefficients(k)[m - 1]) for k in range(m, last + 1)]
        m += 1
    return tuple(terms)


@lru_cache(maxsize=4096)
def leading_derivatives(beta: fmpq, tau: fmpq, count: int) -> tuple[arb, ...]:
    """f_0(tau), ..., f_0^(count-1)(tau), f_0 = sign Gamma(-beta) dTheta/dtau (tau, beta), by Theta's recurrence."""
    first = Profile.leading_order(beta).derivatives(tau, range(3), _DIGITS)
    with working_bits(_BITS):
        return tuple(theta_derivatives(first, arb(tau), beta - 1, max(count, 3)))


def leading_enclosures(beta: fmpq, lower: fmpq, upper: fmpq, count: int) -> list[arb]:
    """Enclosures of f_0^(k) on [lower, upper], k < count: where k > b it increases; below by the mean value theorem."""
    count = max(count, int(beta.floor()) + 1)
    left, middle, right = (leading_derivatives(beta, tau, count) for tau in (lower, (lower + upper) / 2, upper))
    enclosures: list[arb] = [arb(0)] * count
    with working_bits(_BITS):
        wide = arb(0, (upper - lower) / 2)
        for k in range(count - 1, -1, -1):
            enclosures[k] = hull([left[k], right[k]]) if k > beta - 1 else middle[k] + wide * enclosures[k + 1]
    return enclosures


def drift(beta: fmpq, derivative: int, roots: tuple[fmpq, fmpq], enclosures: Sequence[arb]) -> arb:
    """A number <= 0 that is at most P_j(tau; y) - P_j(tau; x) for all x <= y between the two roots, where f_0^(k)(tau)
    lies in enclosures[k], and f^(j) - P_j increases in eta, j = ``derivative``.

    From y^k - x^k = (y - x)(y^(k-1) + ... + x^(k-1)).
    """
    terms = lower_terms(beta - 1 - derivative)
    with working_bits(_BITS):
        width = arb(roots[1] - roots[0])
        between = hull([arb(roots[0]), arb(roots[1])])
        slope = arb(0)
        for power, order, coefficient in terms:
            slope += coefficient * power * between ** (power - 1) * enclosures[order + derivative]
        return (width * slope.lower().min(arb(0))).lower()
