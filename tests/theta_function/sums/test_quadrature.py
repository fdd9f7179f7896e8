"""The integral of holomorphic functions: right at full budget, wide but right at a small one."""

from __future__ import annotations

import math
from fractions import Fraction

from flint import arb
from samples.strategies import holds

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral


def test_holomorphic_integral() -> None:
    with working_bits(100):
        cube = holomorphic_integral(lambda z, _: z * z * 3, arb(0), arb(3), 1000).real
        root = holomorphic_integral(lambda z, analytic: z.sqrt(analytic), arb(1), arb(4), 10_000).real
    assert holds(cube, 27)
    assert holds(root, Fraction(14, 3))
    assert relative_bits(cube) > 80
    assert relative_bits(root) > 80


def test_holomorphic_integral_with_a_small_budget_is_wide_but_right() -> None:
    with working_bits(200):
        value = holomorphic_integral(lambda z, analytic: z.log(analytic), arb((1, -40)), arb(1), 10).real
    exact_value = -1 + Fraction(1, 2**40) * (1 + 40 * Fraction(math.log(2)))
    assert not value.is_finite() or holds(value, exact_value)
