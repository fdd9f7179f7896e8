"""The slow deviation of proofs/uniform.md, Corollary 2: by the series of Theta, and it solves the limit's equation."""

from __future__ import annotations

import functools
from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from samples.strategies import ends
from witnesses.theta import theta_witness

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.slow_deviation import slow_deviation
from gspot_verified.numbers.balls import working_bits
from gspot_verified.testing import extended_example


@functools.cache
def equations() -> DeviationEquations:
    """alpha_1 = -2, alpha_3 = -5, kappa = 2 3/(2 + 3); delta so small that A_0 is the limit to 14 digits."""
    system = extended_example(chi=1, alpha=(-2, -1, -5))
    with working_bits(128):
        return DeviationEquations(
            expand_system(replace(system, regularisation=Regularisation.of(2, 3, 1)), 4), fmpq(1, 10**15)
        )


@pytest.mark.parametrize("s", [fmpq(-2), fmpq(0), fmpq(3, 4)])
def test_each_component_is_the_one_of_the_page(s: fmpq) -> None:
    c_1, beta, kappa = mpmath.mpf(-3) / 7, mpmath.mpf(5) / 2, mpmath.mpf(6) / 5
    with working_bits(128):
        found = slow_deviation(equations(), fmpq(5, 2), fmpq(-3, 7), s)
    with mpmath.workdps(40):
        unit = mpmath.cbrt(2 * kappa)
        place = unit * int(s.p) / int(s.q)

        def theta(tau: mpmath.mpf) -> mpmath.mpf:
            exact = theta_witness(Fraction(*map(int, mpmath.libmp.to_rational(tau._mpf_))), Fraction(5, 2), 60)
            return mpmath.mpf(exact.numerator) / exact.denominator

        size = c_1 * unit**-beta
        b, y, v = (size * unit**k * mpmath.diff(theta, place, k) for k in range(3))
        control = (0, -1, 0, 0, 0, 5)  # G at the G-spot: u' = -lambda, b' = ... + 5 lambda
        pages = [*(control_i / mpmath.mpf(5) * b for control_i in control), 0, b, y / (kappa * -5), v / (kappa * -5)]
        for ball, page in zip(found, pages, strict=True):
            assert ball.is_finite()
            lower, upper = (mpmath.mpf(end.numerator) / end.denominator for end in ends(ball))
            assert lower - mpmath.mpf("1e-12") <= page <= upper + mpmath.mpf("1e-12")
            assert upper - lower < mpmath.mpf("1e-20")


def test_it_solves_the_equation_of_the_limit() -> None:
    """D' = A_0(s) D: by a difference quotient."""
    s, step = fmpq(1, 2), fmpq(1, 10**6)
    with working_bits(128):
        here = slow_deviation(equations(), fmpq(5, 2), fmpq(1), s)
        before, after = (slow_deviation(equations(), fmpq(5, 2), fmpq(1), s + k * step) for k in (-1, 1))
        matrix = equations().limit(arb(s)).table()
        for i, row in enumerate(matrix):
            rate = sum((a * b for a, b in zip(row, here, strict=True)), arb(0))
            assert abs((after[i] - before[i]) / (2 * step) - rate) < arb(10) ** -9
