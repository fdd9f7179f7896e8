"""A bound on |Theta| over balls of any width, for inputs that no other route can use.

Proof page: ``proofs/majorant.md``.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, nonfinite, working_bits
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
