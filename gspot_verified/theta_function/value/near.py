"""The common case in few steps: exact tau near 0, a beta of small size and height, few digits.

A heuristic that chooses between two ways of the Taylor series; every other case is left to
:mod:`gspot_verified.theta_function.value.choice`.
"""

from __future__ import annotations

import math
from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.theta_function.sums.taylor import taylor_sum
from gspot_verified.theta_function.value.chains import chain_sum_at

_FARTHEST_RIGHT = 20  # tau, up to which the series at 0 is the quickest
_FARTHEST_LEFT = 12  # -tau, likewise
_LARGEST_BETA = 8  # |beta|, likewise
_MOST_BITS = 800  # likewise; beyond it the routes are compared
_LONGEST_HEIGHT = 400  # bits of beta's numerator or denominator; likewise
_LONGEST_CUBE = 300  # bits of tau^3, which every term of a chain is multiplied by; likewise
_GUARD = 8  # bits beyond those asked for, lost on the way; any number is right
_LN2 = math.log(2)  # nats of a bit


def near_value(tau: fmpq, beta: fmpq, goal: int) -> tuple[arb, int] | None:
    """An enclosure of Theta(tau, beta) planned for ``goal`` bits, and the working bits; None: not this case.

    An integer beta is not: its polynomial gives the exact value.

    At the first visit to a beta the series is summed for this tau alone, from the second on its polynomial is kept.
    """
    if goal > _MOST_BITS:
        return None
    p, q = int(beta.p), int(beta.q)
    if q == 1 or abs(p) > _LARGEST_BETA * q or beta.height_bits() > _LONGEST_HEIGHT:
        return None
    above, below = int(tau.p), int(tau.q)
    if not -_FARTHEST_LEFT * below <= above <= _FARTHEST_RIGHT * below:
        return None
    length, bits = _plan(above / below, p / q, goal)
    if first_visit(p, q) and _is_short(above, below):
        return chain_sum_at(above, below, p, q, length, bits), bits
    return taylor_sum(tau, beta, length, bits), bits


def one_value(tau: fmpq, beta: fmpq, length: int, bits: int) -> arb:
    """An enclosure of Theta(tau, beta) from ``length`` Taylor terms: by chains at the first visit to a short beta."""
    above, below, p, q = int(tau.p), int(tau.q), int(beta.p), int(beta.q)
    if first_visit(p, q) and _is_short(above, below) and beta.height_bits() <= _LONGEST_HEIGHT:
        return chain_sum_at(above, below, p, q, length, bits)
    return taylor_sum(tau, beta, length, bits)


def _is_short(above: int, below: int) -> bool:
    return 3 * max(above.bit_length(), below.bit_length()) <= _LONGEST_CUBE


def first_visit(p: int, q: int) -> bool:
    """Whether nobody asked this before for beta = p/q; the last 64 of them are remembered."""
    return not _visits(p, q).again()


class _Visits:
    """Whether one beta was asked for before."""

    __slots__ = ("_seen",)

    def __init__(self) -> None:
        self._seen = False

    def again(self) -> bool:
        seen, self._seen = self._seen, True
        return seen


@lru_cache(maxsize=64)
def _visits(_p: int, _q: int) -> _Visits:
    return _Visits()


def _plan(tau: float, beta: float, goal: int) -> tuple[int, int]:
    """Terms and bits, as :func:`gspot_verified.theta_function.value.choice.taylor_plan` has them, with fewer steps."""
    size = abs(tau) + 1e-9
    scale = size**1.5
    logarithm = math.log1p(size)
    peak = scale / 1.5 + logarithm
    value = min(peak, beta * logarithm) if tau < 0 else peak
    bits = goal + _GUARD + int((peak - value) / _LN2)
    step = 16 if bits <= 128 else 32
    target = 1.5 * ((goal + 3) * _LN2 - value + max(-beta, 0.0) * min(size, 1.0))
    k = math.e * scale + target / 4
    for _ in range(2):
        k = (target + k) / max(math.log(k / scale), 0.1)
    return 3 * math.ceil(max(k, 2 * scale + 3) / 3), -(-bits // step) * step
