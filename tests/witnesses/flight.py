"""The paper's runs carried to lift-off by power series in mpmath, and flights and later contacts beside them."""

from __future__ import annotations

from functools import lru_cache

import mpmath
from flint import arb, fmpq
from witnesses.contact import moved

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.numbers.balls import working_bits

WITNESS_DIGITS = 35


@lru_cache(maxsize=8)
def lift_off_by_series(beta: str, nu: str, epsilon: str) -> tuple[mpmath.mpf, tuple[mpmath.mpf, ...]]:
    """p and (b, V, Y) at the first zero of the force, from the paper's data (alpha = -1, -1, -beta, p = 1/2)."""
    with mpmath.workdps(WITNESS_DIGITS + 15):
        power, small = mpmath.mpf(beta), mpmath.mpf(epsilon)
        mean = 1 / (power - 1)
        p = mpmath.mpf(1) / 2
        b = -mpmath.mpf(nu) * p * abs(mean)
        hats = [b + p * mean, mpmath.mpf(0), 2 * b / p + 2 * mean, b / p + mean]
        step = mpmath.mpf(4)
        while step > mpmath.mpf(10) ** -WITNESS_DIGITS:
            later, after = moved(hats, p, power, small, step, steps=max(1, int(step)))
            if later[3] - later[2] + mean > 0:
                hats, p = later, after
            else:
                step /= 2
        b, V, Y, _ = hats
        return p, (b - p * mean, V, Y - 2 * mean)


def lift_off_state(beta: str, nu: str, epsilon: str, radius: str = "1e-25") -> ContactState:
    """The same as balls."""
    p, values = lift_off_by_series(beta, nu, epsilon)
    with working_bits(160):
        balls = [arb(mpmath.nstr(value, WITNESS_DIGITS)) + arb(0, radius) for value in (p, *values)]
    return ContactState(fmpq(*_ratio(beta)), fmpq(1) / _inverse(epsilon), fmpq(-1), *balls, arb(0))


def _ratio(text: str) -> tuple[int, int]:
    return int(mpmath.mpf(text) * 4), 4


def _inverse(epsilon: str) -> int:
    return int(mpmath.nint(1 / mpmath.mpf(epsilon)))
