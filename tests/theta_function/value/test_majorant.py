"""A bound over balls of any width.

Page: proofs/majorant.md.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, holds

from gspot_verified import evaluate
from gspot_verified.numbers.complex_numbers import ExactComplex
from gspot_verified.theta_function.value.majorant import majorant_bound, turned_argument, turned_bound


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


@given(st.integers(-60, 60), st.integers(-60, 60), st.integers(1, 80), st.integers(-26, 26), st.sampled_from([0, 3]))
def test_on_a_turned_ray_it_bounds_every_point(x: int, y: int, beta: int, turn: int, width: int) -> None:
    tangent, b, r = fmpq(turn, 100), fmpq(-beta, 10), fmpq(width, 8)
    wide = acb(arb(fmpq(x, 4), r), arb(fmpq(y, 4), r))
    argument = turned_argument(wide, tangent, 64)
    bound = turned_bound(b, tangent, evaluate(argument, b, digits=30).value, 64)
    assert bound.is_finite()
    for s, t in ((0, 0), (1, 1), (-1, 1), (1, -1)):
        inside = evaluate(ExactComplex(fmpq(x, 4) + s * r, fmpq(y, 4) + t * r), b, digits=30).value
        assert inside.abs_lower() <= bound


@pytest.mark.parametrize("turn", [-26, -10, 0, 7, 26])
def test_on_a_turned_ray_it_is_the_one_of_the_page(turn: int) -> None:
    """cos(3 psi)^(beta/3) Theta(v, beta) by mpmath; attained at psi = 0."""
    with mpmath.workdps(40):
        psi, beta = 2 * mpmath.atan(mpmath.mpf(turn) / 100), mpmath.mpf(-5) / 2
        kappa = mpmath.cos(3 * psi)
        v = (mpmath.mpc(2, 3) * mpmath.expj(psi)).real / kappa ** (mpmath.mpf(1) / 3)
        page = kappa ** (beta / 3) * _theta(v, beta)
        argument = turned_argument(acb(2, 3), fmpq(turn, 100), 64)
        bound = turned_bound(fmpq(-5, 2), fmpq(turn, 100), evaluate(argument, "-5/2", digits=30).value, 64)
        for found, expected in ((argument, v), (bound, page)):
            lower, upper = ends(found)
            tiny = abs(expected) * mpmath.mpf(10) ** -10
            assert abs(mpmath.mpf(lower.numerator) / lower.denominator - expected) < tiny
            assert mpmath.mpf(upper.numerator) / upper.denominator >= expected - tiny / 10**6
    real = evaluate(2, "-5/2", digits=30).value
    assert turned_bound(fmpq(-5, 2), fmpq(0), real, 64) <= real * (1 + fmpq(1, 10**15))


def test_hypotheses_of_the_turned_ray() -> None:
    for tangent in (fmpq(27, 100), fmpq(-27, 100), fmpq(1), fmpq(2), fmpq(-5)):
        assert not turned_bound(fmpq(-2), tangent, arb(1), 64).is_finite()
    assert not turned_argument(acb(1, 2), fmpq(27, 100), 64).is_finite()
    assert turned_argument(acb(1, 2), fmpq(26, 100), 64).is_finite()
    for beta in (fmpq(0), fmpq(1, 2), arb(0, 1), arb(-1, 1)):
        assert not turned_bound(beta, fmpq(0), arb(1), 64).is_finite()
    assert turned_bound(arb(-2, 1), fmpq(1, 5), arb(1), 64).is_finite()
    assert not turned_bound(fmpq(-2), fmpq(1, 5), arb.nan(), 64).is_finite()
