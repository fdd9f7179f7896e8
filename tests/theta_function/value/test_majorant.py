"""A bound over balls of any width.

Page: proofs/majorant.md.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, holds

from gspot_verified import evaluate
from gspot_verified.theta_function.value.majorant import majorant_bound


@given(st.integers(-40, 40), st.integers(-60, 60), st.integers(0, 20))
def test_contains_every_point(tau: int, beta: int, more: int) -> None:
    size = fmpq(max(abs(beta), 10), 10) + fmpq(more, 10)
    far = fmpq(abs(tau), 4) + fmpq(more, 7)
    bound = majorant_bound(fmpq(beta, 10), size, evaluate(far, -size, digits=30).value, 128)
    lower, upper = ends(bound)
    first, last = ends(evaluate(fmpq(tau, 4), fmpq(beta, 10), digits=30).value)
    assert lower <= first
    assert last <= upper


def test_it_is_attained_at_the_negative_parameter() -> None:
    """beta = -B, tau = X: M = 1 and the bound is the value itself."""
    value = evaluate(3, Fraction(-5, 2), digits=30).value
    upper = ends(majorant_bound(fmpq(-5, 2), fmpq(5, 2), value, 128))[1]
    first, last = ends(value)
    assert last <= upper <= first * (1 + Fraction(1, 10**8))


@pytest.mark.parametrize("order", [0, 1, 2])
def test_each_initial_value_counts(order: int) -> None:
    """At beta = 0, 1, 2 Theta is 1, -tau, tau^2: one initial value is not zero, and M is its quotient alone."""
    beta, size, far = fmpq(order), fmpq(5, 2), fmpq(3)
    bound = majorant_bound(beta, size, evaluate(far, -size, digits=30).value, 128)
    assert holds(bound, (-3) ** order)
    # M Theta(X, -B) from the page, by mpmath.
    with mpmath.workdps(40):
        ours = abs([1, -1, 2][order])
        theirs = mpmath.diff(lambda t: _theta(t, mpmath.mpf(-5) / 2), 0, order)
        page = ours / theirs * _theta(mpmath.mpf(3), mpmath.mpf(-5) / 2)
        radius = ends(bound)[1]
        assert abs(mpmath.mpf(radius.numerator) / radius.denominator - page) < page * mpmath.mpf(10) ** -8


def _theta(tau: mpmath.mpf, beta: mpmath.mpf) -> mpmath.mpf:
    """The Laplace integral for beta < 0."""
    integral = mpmath.quad(lambda r: r ** (-beta - 1) * mpmath.exp(r * tau - r**3 / 3), [0, 1, 3, 6, 12])
    return integral / mpmath.gamma(-beta)


def test_hypotheses() -> None:
    value = evaluate(3, -2).value
    assert not majorant_bound(fmpq(3), fmpq(2), value, 64).is_finite()
    assert not majorant_bound(fmpq(-3), fmpq(2), value, 64).is_finite()
    assert not majorant_bound(arb(2, 1), fmpq(2), value, 64).is_finite()
    assert not majorant_bound(arb(-2, 1), fmpq(2), value, 64).is_finite()
    assert not majorant_bound(arb(-9, 1), fmpq(2), value, 64).is_finite()
    assert not majorant_bound(fmpq(1, 2), fmpq(1, 2), value, 64).is_finite()
    assert not majorant_bound(fmpq(1), fmpq(2), arb.nan(), 64).is_finite()


@pytest.mark.parametrize(
    ("tau", "beta"),
    [
        (arb(0, 10**11), fmpq(1)),
        (arb(0, 10**11), arb(0, 3)),
        (arb(-(10**6), 10**5), arb(0, 300)),
        (arb(0, 5 * 10**11), arb(0, 4_000)),
        (arb(100, 90), arb(5, 30)),
    ],
)
def test_no_ball_of_the_domain_is_too_wide(tau: arb, beta: arb) -> None:
    wide = evaluate(tau, beta)
    assert wide.value.is_finite()
    middle = beta if isinstance(beta, fmpq) else beta.mid()
    for point in (tau.mid(), tau.lower(), tau.upper()):
        inside = evaluate(point, middle, digits=20).value
        assert wide.value.overlaps(inside)
