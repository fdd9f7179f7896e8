"""The force on the slow manifold: against mpmath's integral, its equation, and the leading order.

Page: proofs/monotone.md.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified import evaluate
from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.compliant.slow.profile import Profile, in_range
from gspot_verified.leading_order.contact_force import contact_force

PARAMETERS = st.fractions(Fraction(1, 10), Fraction(49, 10), max_denominator=12).filter(lambda b: b.denominator > 1)
ROOTS = st.fractions(Fraction(1, 20), 2, max_denominator=40)
PLACES = st.fractions(-12, 8, max_denominator=30)


@settings(max_examples=40, deadline=None)
@given(PARAMETERS, ROOTS, ROOTS, PLACES)
def test_theorem_c(beta: Fraction, one: Fraction, more: Fraction, tau: Fraction) -> None:
    """sG_b increases strictly in eta, and lies above s Theta; b < 4."""
    place, parameter = to_fmpq(tau), to_fmpq(beta)
    small, large = (Profile.at_root(parameter, to_fmpq(root)) for root in (one, one + more))
    at_zero = small.direction * evaluate(place, parameter, derivative=1, digits=20).value
    assert at_zero < small.value(place, 20)
    assert small.value(place, 20) < large.value(place, 20)


@settings(max_examples=40, deadline=None)
@given(st.fractions(Fraction(1, 9), 12, max_denominator=9).filter(lambda b: b.denominator > 1), ROOTS, PLACES)
def test_the_derivatives(beta: Fraction, root: Fraction, tau: Fraction) -> None:
    """f^(n) > 0, and G''' - tau G' + b G = eta (tau G'' + (1 - b) G' - G''''/2) for f = beta s G_b."""
    profile, place, b = Profile.at_root(to_fmpq(beta), to_fmpq(root)), to_fmpq(tau), to_fmpq(beta) - 1
    assert profile.derivatives(place, range(profile.order, profile.order + 3), 12)[0] > 0
    f = profile.derivatives(place, range(5), 40)
    eta = arb(to_fmpq(root))
    rest = f[3] - place * f[1] + b * f[0] - eta * (place * f[2] + (1 - b) * f[1] - f[4] / 2)
    assert rest.is_finite()
    assert rest.contains(0)
    assert abs(rest).upper() < 10**-9 * (1 + abs(f[0]).upper() + abs(place) * abs(f[1]).upper())


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3, 2), fmpq(5, 2), fmpq(7, 2)])
def test_at_leading_order_it_is_the_limit(beta: fmpq) -> None:
    """f^(k) = sign Gamma(-beta) d^(k+1) Theta/dtau^(k+1); at a small eta the difference is small."""
    tau = fmpq(2, 3)
    leading = Profile.leading_order(beta).derivatives(tau, range(1, 4), 20)
    nearby = Profile.at_root(beta, fmpq(1, 10**9)).derivatives(tau, range(1, 4), 20)
    for k, value, near in zip(range(1, 4), leading, nearby, strict=True):
        assert value.overlaps(evaluate(tau, beta, derivative=k + 1, digits=25).value * Profile(beta, fmpq(0)).direction)
        assert abs(value - near) < fmpq(1, 10**7)
        assert abs(value) > fmpq(1, 100)


def test_the_range_of_the_slow_solution() -> None:
    force = contact_force("5/2", alpha_1=-2)
    for epsilon, inside in (
        (fmpq(10) ** -300 / 2, True), (fmpq(10) ** 6 / 2, True),
        (fmpq(10) ** -301, False), (fmpq(10) ** 6, False), (fmpq(0), False), (fmpq(-1), False),
    ):  # fmt: skip
        assert in_range(force, epsilon) is inside


def test_below_1_it_is_the_integral_by_another_program() -> None:
    """lambda-hat = -(C/eps) (1/Gamma(1 - beta)) int r^(-beta) e^(psi/eps + r T) dr, C = C_1 eps^beta, alpha_1 = -2."""
    force = contact_force("1/3", alpha_1=-2, alpha_2=1, c1="-3/2")
    epsilon, time = fmpq(1, 7), fmpq(1, 3)
    with mpmath.workdps(30):
        sigma, beta = mpmath.mpf(1) / 2, mpmath.mpf(1) / 3
        small = mpmath.mpf(1) / 7 / sigma
        scaled = mpmath.mpf(1) / 3 / sigma / small

        def weight(r: mpmath.mpf) -> mpmath.mpf:
            return r**-beta * mpmath.exp((r - r**2 / 2 - r**3 / 3 - mpmath.log1p(r)) / small + r * scaled)

        integral = mpmath.quad(weight, [0, 1e-3, 0.1, 0.5, 1, 2, 4]) / mpmath.gamma(1 - beta)
        charge = mpmath.mpf(-3) / 2 * sigma ** (2 + beta)
        mean = mpmath.mpf(1) / (-2 * beta + 2)
        expected = mean - charge * small ** (beta - 1) * integral / sigma**2
        tau = mpmath.cbrt(1) * mpmath.mpf(1) / 3 * mpmath.mpf(7) ** (mpmath.mpf(2) / 3)  # kappa = 1
    nearby = fmpq(int(tau * 2**60), 2**60)
    found = slow_force(force, nearby, epsilon, 15)
    assert time > 0
    assert found.is_finite()
    assert abs(float(found.mid()) - float(expected)) < 1e-9 * abs(float(expected))


def test_an_integer_beta_has_no_side() -> None:
    with pytest.raises(ValueError, match="integer"):
        _ = Profile(fmpq(2), fmpq(1)).direction
