"""What the tests of the checker share: its models of F, and F by three 1F2 of mpmath."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from typing import Any

import mpmath
from flint import arb, fmpq
from must_reject import mutate

check = mutate.checker()
DIGITS = 120
LIMITS = check.limits.Limits()
ENDLESS = check.limits.Meter(LIMITS, 10**18)
NO_COLUMN = check.pieces.Column(Fraction(1), Fraction(2), 0, [])


def at_balls(polynomial: Any, at: dict[str, arb]) -> arb:
    """A polynomial of the checker on balls."""
    total = arb(0)
    for key, value in polynomial.items():
        term = arb(fmpq(value.numerator, value.denominator))
        for name in key:
            term = term * at[name]
        total += term
    return total


def on_a_column(budget: int = 10**18, limits: check.limits.Limits = LIMITS) -> check.pieces.ColumnCheck:
    return check.pieces.ColumnCheck(NO_COLUMN, limits, budget)


def local_at(low: Fraction, high: Fraction, bits: int) -> check.theta.Local:
    return check.theta.Local(low, high, bits, Fraction(0), ENDLESS)


def local(low: str, high: str, bits: int) -> check.theta.Local:
    return local_at(Fraction(low), Fraction(high), bits)


def number(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def theta(tau: mpmath.mpf, b: mpmath.mpc) -> mpmath.mpc:
    """Theta for a complex parameter by three 1F2 of mpmath."""
    third, z = mpmath.mpf(1) / 3, tau**3 / 9
    front, g = (
        2 * mpmath.pi * mpmath.power(3, 2 * b / 3 - mpmath.mpf(1) / 2),
        [mpmath.rgamma((j - b) / 3) for j in range(3)],
    )
    return front * (
        g[1] * g[2] * mpmath.hyp1f2(-b / 3, third, 2 * third, z)
        + mpmath.cbrt(3) * g[0] * g[2] * tau * mpmath.hyp1f2((1 - b) / 3, 2 * third, 4 * third, z)
        + mpmath.cbrt(9) * g[0] * g[1] * tau**2 / 2 * mpmath.hyp1f2((2 - b) / 3, 4 * third, 5 * third, z)
    )


def coefficient(tau: mpmath.mpf, b: mpmath.mpc, k: int) -> mpmath.mpc:
    """F^(k)(tau)/k!."""
    return mpmath.rf(-b, k) * theta(tau, b - k) / mpmath.factorial(k)


def polynomial(model: check.theta.Model, eta: mpmath.mpc) -> mpmath.mpc:
    return sum((m * eta**j for j, m in enumerate(model.m)), mpmath.mpf(0))


def points_of_the_disc(seed: int, number_of_points: int) -> list[mpmath.mpc]:
    source = random.Random(seed)
    inside = [source.uniform(0, 1) * mpmath.expjpi(source.uniform(0, 2)) for _ in range(number_of_points)]
    return [mpmath.mpc(1), mpmath.mpc(-1), mpmath.mpc(0, 1), mpmath.mpc(0), *inside]


def assert_rounded(found: check.theta.Model, exact: list[Fraction], error: Fraction) -> None:
    """The error holds what the exact model has, and less than 1 for each coefficient and for the error itself."""
    lost = sum(abs(a - b) for a, b in zip(exact, found.m, strict=True))
    assert lost + error <= found.error <= error + 1 + len(exact)


def length_of(*values: int) -> list[Fraction]:
    return [Fraction(value.bit_length(), 30) for value in values]


def small_local(low: Fraction, high: Fraction) -> check.theta.Local:
    """Cheap to make: only its b and its degree are used."""
    model = object.__new__(check.theta.Local)
    model.unit = 2 * math.lcm(low.denominator, high.denominator)
    model.centre, model.radius = int((low + high) / 2 * model.unit), int((high - low) * model.unit)
    model.x, model.meter = 6, ENDLESS
    return model


STATEMENTS = {
    "iwc": "dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)",
    "iwc by theorem": "dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)",
    "negative beta": "dΘ/dτ > 0 for every τ in (-inf, inf) and every β in (-inf, 0)",
    "hinge": "dΘ/dτ < 0 for every τ in (-inf, 0) and every β in (1, 2)",
    "right": "dΘ/dτ > 0 for every τ in [4, inf) and every β in [5/4, 3/2]",
    "fold sign": "dΘ/dτ < 0 for every τ in (-inf, 1/2] and every β in (3, 49/16]",
    "integer": "dΘ/dτ < 0 at τ = 0 and at β = 4",
    "zero": "dΘ/dτ = 0 at τ = 0 and at β = 3",
    "zeros": "for every β in (1, 9/8] that is not an integer, dΘ/dτ has exactly N real zeros, all simple: "
    "N = 1 on (1, 2)",
    "fold": "for every β in (95/32, 49/16) that is not an integer, dΘ/dτ has exactly N real zeros, all simple: "
    "N = 2 on (2, 3), N = 1 on (3, 4)",
    "brackets": "dΘ/dτ at β = 7/3 has exactly 2 real zeros, all simple, one in each of the intervals: "
    "(-1203/5000, -481/2000), (2077/1000, 1039/500)",
}
