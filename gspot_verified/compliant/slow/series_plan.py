"""Heuristic: how many orders of the series in eta, where its remainder is bounded, and with how many bits.

Any choice is correct; a bad one gives a wide ball.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from gspot_verified.compliant.slow.epsilon_series import series_coefficients
from gspot_verified.compliant.slow.slow_plan import log_integrand, peak

ORDERS = (3, 4, 5, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96)
_GUARD_BITS = 16  # bits beyond those asked for, lost on the way; any number is right
_LN2 = math.log(2)  # nats of a bit


class SeriesPlan(NamedTuple):
    """Orders N, two points for the tangents of each of N integrals, working bits."""

    terms: int
    places: Sequence[tuple[float, float]]
    bits: int


def series_plan(tau: float, b: float, eta: float, goal: int) -> SeriesPlan | None:
    """The fewest orders that reach ``goal`` bits relative to Theta's size; None where none of :data:`ORDERS` does."""
    size = _log_size(tau, b)
    for terms in ORDERS:
        if b >= terms + 2:
            continue
        places, remainder = _remainder(tau, b, eta, terms)
        if remainder < size - goal * _LN2:
            return SeriesPlan(terms, places, goal + _loss(tau, terms) + _GUARD_BITS)
    return None


def _log_size(tau: float, b: float) -> float:
    """About log |rGamma(-b) G_b|, without the factor 1/Gamma(-b)."""
    if tau <= 1:
        return (b * math.log(1 - tau) if tau < 0 else 0.0) + math.lgamma(abs(b) + 1)
    exponential: float = 2 / 3 * tau**1.5
    return exponential - (b / 2 + 0.75) * math.log(tau)


def _remainder(tau: float, b: float, eta: float, terms: int) -> tuple[list[tuple[float, float]], float]:
    places, largest = [], -math.inf
    for m, log_coefficient in enumerate(_log_coefficients(terms), 1):
        exponent = b - terms - 3 * m
        top = peak(tau, exponent + 1, eta)
        width = top / math.sqrt(-(exponent + 1) + top**3)
        places.append((max(top / 2, top - width), top + width))
        largest = max(largest, log_coefficient + log_integrand(top, tau, exponent + 1, eta) + math.log(width))
    return places, terms * math.log(eta) + largest + math.log(terms)


@lru_cache(maxsize=128)
def _log_coefficients(terms: int) -> tuple[float, ...]:
    return tuple(math.log(abs(int(c.p))) - math.log(int(c.q)) for c in series_coefficients(terms))


def _loss(tau: float, terms: int) -> int:
    """Bits that the recurrence for Theta's derivatives loses: for tau < 0 it runs against the decay."""
    return math.ceil(4 * terms * 1.5 * math.log2(1 - tau)) if tau < 0 else 2 * terms
