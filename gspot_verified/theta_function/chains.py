"""One value of the Taylor series at 0, term by term along its three chains: nothing is kept for another tau.

Cheaper than the polynomial of :mod:`gspot_verified.theta_function.taylor` for one value at few digits. Proof page:
``proofs/taylor.md``.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.balls import add_remainder, nonfinite, working_bits
from gspot_verified.theta_function.initial_values import initial_values

# (k+1)(k+2)(k+3), the denominators of the first quotients.
_PRODUCTS = tuple((k + 1) * (k + 2) * (k + 3) for k in range(600))


def chain_sum(tau: fmpq, beta: fmpq, length: int, bits: int) -> arb:
    """An enclosure of Theta(tau, beta) from ``length`` = K Taylor terms, rounded up to a multiple of 3.

    Not finite where the ratio q of the page, (1 + |beta|/K) X^3/((K+1)(K+2)), is above 1/2 (compared in integers); else
    the rest is at most twice the sum of the three first omitted terms.
    """
    values = initial_values(beta, bits)
    p, q = int(beta.p), int(beta.q)
    length = -(-length // 3) * 3
    above, below = abs(int(tau.p)), int(tau.q)
    if 2 * (length * q + abs(p)) * above**3 > length * q * (length + 1) * (length + 2) * below**3:
        return nonfinite()
    products = _PRODUCTS if length <= len(_PRODUCTS) else _products(length)
    with working_bits(bits):
        point = arb(tau)
        square = point * point
        step = square * point / q
        first, second, third = values[0], values[1] * point, values[2] * square / 2
        total = first + second + third
        factor = -p
        for k in range(0, length, 3):
            # The term k + 3 is the term k times (k - beta) tau^3/((k+1)(k+2)(k+3)).
            first = first * step * factor / products[k]
            second = second * step * (factor + q) / products[k + 1]
            third = third * step * (factor + 2 * q) / products[k + 2]
            factor += 3 * q
            if k + 3 < length:
                total += first + second + third
        return add_remainder(total, 2 * (abs(first) + abs(second) + abs(third)))


def _products(count: int) -> tuple[int, ...]:
    return tuple((k + 1) * (k + 2) * (k + 3) for k in range(count))
