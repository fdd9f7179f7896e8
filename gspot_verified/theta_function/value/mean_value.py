"""Theta over a ball of tau, from its value at the midpoint and a bound on its slope.

Proof page: ``proofs/identities.md``, "Mean value form".
"""

from __future__ import annotations

from flint import arb

from gspot_verified.numbers.balls import Ball, Exact, add_remainder, working_bits


def mean_value_form(beta: Exact, radius: arb, center: Ball, below: Ball, bits: int) -> Ball:
    """A ball that contains Theta(t, b) for every b in ``beta`` and every t with |t - m| <= ``radius``, real or complex.

    ``center`` encloses Theta(m, b) for every b in ``beta``; ``below`` encloses Theta(t, b - 1) for all those t and b.
    """
    with working_bits(bits):
        return add_remainder(center, beta * below * radius)
