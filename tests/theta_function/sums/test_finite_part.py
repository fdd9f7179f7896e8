"""Hadamard's finite part next to r = 0.

Page: proofs/laplace.md.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights, to_fmpq

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.sums.finite_part import near_integers as integers_next_to
from gspot_verified.theta_function.sums.finite_part import series_part, weight


@given(st.integers(0, 30), st.one_of(small_heights(), near_integers(20)))
def test_weights_by_their_two_forms(n: int, beta: Fraction) -> None:
    b = to_fmpq(beta)
    assume(b != n)
    value = weight(n, b, 200)
    quotient = arb(-b).rgamma() / (n - b)
    assert value.is_finite()
    assert quotient.is_finite()
    assert value.overlaps(quotient)


def test_weights_at_many_bits() -> None:
    """There Gamma of a rational has its own series; of a ball with the same number it has not."""
    for beta in (fmpq(7, 3), fmpq(1, 1_009), fmpq(5), fmpq(-1, 3)):
        with working_bits(4_000):
            rational, of_a_ball = weight(2, beta, 4_000), weight(2, arb(beta) + arb(0, arb(2) ** -3_990), 4_000)
            assert relative_bits(rational) > 3_900
            assert of_a_ball.is_finite()
            assert of_a_ball.contains(rational)


def test_integers_next_to_a_ball() -> None:
    assert list(integers_next_to(fmpq(-3))) == []
    assert 2 in integers_next_to(fmpq(7, 3))
    assert set(range(1, 5)) <= set(integers_next_to(arb(fmpq(5, 2), fmpq(3, 2))))
    assert 0 in integers_next_to(fmpq(-1, 2))


@pytest.mark.parametrize("beta", ["-1/2", "-7/3"])
@pytest.mark.parametrize(("tau", "cut"), [(-2, "1/2"), (3, "1"), (1, "5/4")])
def test_the_part_is_the_integral_up_to_the_cut(tau: int, cut: str, beta: str) -> None:
    b, c = Fraction(beta), Fraction(cut)
    with mpmath.workdps(30):
        exponent = -mpmath.mpf(b.numerator) / b.denominator
        whole = mpmath.quad(
            lambda r: r ** (exponent - 1) * mpmath.exp(tau * r - r**3 / 3), [0, mpmath.mpf(c.numerator) / c.denominator]
        )
        expected = arb(mpmath.nstr(whole * mpmath.rgamma(exponent), 25))
    with working_bits(100):
        found = series_part(fmpq(tau), to_fmpq(b), to_fmpq(c), 80, 100)
        assert found.is_finite()
        assert found.rad() < arb("1e-15")
        assert abs(found - expected) < arb("1e-12")


def test_finite_part_wants_a_certain_cut() -> None:
    assert not series_part(fmpq(1), fmpq(1, 2), arb(0, 1), 20, 100).is_finite()
