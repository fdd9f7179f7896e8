"""Derivative and integral of s^e c(s^3), e = 0, 1, 2, given and returned as the polynomial c in s^3.

Over the rationals in integers: one fraction is reduced, and not one for each coefficient.
"""

from __future__ import annotations

import math
from typing import Any

from flint import fmpq_poly, fmpz_poly

from gspot_verified.functions.rings import Rationals, Ring


def derivative(cubic: Any, e: int, ring: Ring) -> Any:
    """The derivative; it begins with s^(e - 1), or with s^2 where e = 0.

    >>> from gspot_verified.functions.rings import RATIONALS
    >>> derivative(fmpq_poly([7, 5]), 0, RATIONALS), derivative(fmpq_poly([7, 5]), 1, RATIONALS)
    (15, 20*x + 7)
    """
    exponents = range(e, e + 3 * cubic.length(), 3)
    lost = 0 if e else 1
    if isinstance(ring, Rationals):
        numerators = [value * k for value, k in zip(cubic.numer().coeffs(), exponents, strict=True)]
        return fmpq_poly(fmpz_poly(numerators[lost:]), cubic.denom())
    return ring.polynomial([value * ring.number(k) for value, k in zip(cubic.coeffs(), exponents, strict=True)][lost:])


def integral(cubic: Any, e: int, ring: Ring) -> Any:
    """The integral from 0; it begins with s^(e + 1), or with s^0 where e = 2.

    >>> from gspot_verified.functions.rings import RATIONALS
    >>> integral(fmpq_poly([7, 5]), 2, RATIONALS), integral(fmpq_poly([7, 5]), 0, RATIONALS)
    (5/6*x^2 + 7/3*x, 5/4*x + 7)
    """
    divisors = range(e + 1, e + 1 + 3 * cubic.length(), 3)
    gained = 1 if e == 2 and divisors else 0
    if isinstance(ring, Rationals):
        common = math.lcm(*divisors)
        numerators = [value * (common // k) for value, k in zip(cubic.numer().coeffs(), divisors, strict=True)]
        return fmpq_poly(fmpz_poly([0] * gained + numerators), cubic.denom() * common)
    values = [value / ring.number(k) for value, k in zip(cubic.coeffs(), divisors, strict=True)]
    return ring.polynomial([ring.number(0)] * gained + values)
