"""What the plans of the quadrature rest on: the integrand and its peak by mpmath, and plans that serve.

Any plan is correct; these are good ones.
"""

from __future__ import annotations

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.compliant.slow.slow_integral import slow_moments
from gspot_verified.compliant.slow.slow_plan import log_integrand, peak, steps_from_below, trapezoid_plan
from gspot_verified.numbers.balls import relative_bits, working_bits

CASES = [(0.0, -2.0, 1e-6), (3.0, -1.5, 0.3), (-4.0, -2.5, 2.0), (12.0, -4.0, 1e-3), (-30.0, -1.25, 0.01)]
ANGLES = [0.0, 0.2, 0.45]


def _exact(rho: mpmath.mpf, tau: float, b: float, eta: float, angle: float) -> mpmath.mpf:
    x = mpmath.mpf(eta) * rho
    cubic = (x - x**2 / 2 - x**3 / 3 - mpmath.log1p(x)) / (2 * mpmath.mpf(eta) ** 3)
    return -b * mpmath.log(rho) + rho * tau * mpmath.cos(angle) + mpmath.cos(3 * angle) * cubic


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize(("tau", "b", "eta"), CASES)
def test_the_logarithm_of_the_integrand_and_its_peak(tau: float, b: float, eta: float, angle: float) -> None:
    with mpmath.workdps(60):
        top = mpmath.mpf(peak(tau, b, eta, angle))
        for rho in (top / 3, top, 2 * top):
            exact = _exact(rho, tau, b, eta, angle)
            assert abs(log_integrand(float(rho), tau, b, eta, angle) - exact) < 1e-6 * (1 + abs(exact))
        slope = mpmath.diff(lambda u: _exact(mpmath.exp(u), tau, b, eta, angle), mpmath.log(top))
        assert abs(slope) < 1e-7 * (abs(b) + abs(tau) * top + top**3)


@pytest.mark.parametrize("x", [0.0099, 0.0101])
def test_on_both_sides_of_the_border_of_the_series(x: float) -> None:
    with mpmath.workdps(40):
        exact = _exact(mpmath.mpf(3), 1.0, -2.0, x / 3, 0.0)
    assert abs(log_integrand(3.0, 1.0, -2.0, x / 3) - exact) < 1e-7


@pytest.mark.parametrize("bits", [60, 200])
@pytest.mark.parametrize(("tau", "b", "eta"), CASES)
def test_a_plan_reaches_what_it_is_made_for(tau: float, b: float, eta: float, bits: int) -> None:
    plan = trapezoid_plan(tau, b, eta, 4, bits)
    with working_bits(plan.bits):
        exact = [fmpq(*value.as_integer_ratio()) for value in (tau, b, eta)]
        found = slow_moments(arb(exact[0]), exact[1], 2 * exact[2] ** 3, 4, plan)
    assert min(map(relative_bits, found)) > bits - 4


@pytest.mark.parametrize("b", [-3.5, 0.5, 7.25])
@pytest.mark.parametrize("tau", [-9.0, 2.0, 400.0])
def test_the_integrals_stand_where_their_bounds_hold(b: float, tau: float) -> None:
    """b - steps <= -1, the hypothesis of the trapezoidal rule."""
    for eta in (0.0, 0.1, 10.0):
        steps = steps_from_below(b, tau, 100, eta)
        assert steps >= 0
        assert b - steps <= -1
