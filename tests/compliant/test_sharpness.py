"""Places where a bound is attained almost exactly, or up to a factor far from 2^20: a radius that is too small would
exclude the value here.

``tests/house/test_sabotage.py`` runs this file with each bound shrunk on purpose and wants it red.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import acb, arb, fmpq
from samples.strategies import ends

from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient
from gspot_verified.compliant.fast.fast_solutions import Ray, decaying, oscillating
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.side.side_rule import coefficients
from gspot_verified.compliant.slow.epsilon_series import epsilon_series
from gspot_verified.compliant.slow.grid import _half_phi, _half_phi_at, scale
from gspot_verified.compliant.slow.routes import integral
from gspot_verified.compliant.slow.slow_coefficient import slow_coefficient
from gspot_verified.compliant.slow.slow_integral import TrapezoidPlan, slow_moments
from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.value.evaluate import evaluate


def _exact(value: arb) -> Fraction:
    """The midpoint of a very accurate enclosure, for comparison with a much wider one."""
    lower, upper = ends(value)
    return (lower + upper) / 2


def _contained(value: arb, number: Fraction) -> bool:
    lower, upper = ends(value)
    return lower <= number <= upper


@pytest.mark.parametrize("length", [1, 2, 5])
def test_few_terms_of_the_exponent(length: int) -> None:
    x = arb((1, -40))
    with working_bits(1000):
        few = _half_phi_at(x, *_half_phi(length, 1000))
        many = _half_phi_at(x, *_half_phi(40, 1000))
    assert _contained(few, _exact(many))


@pytest.mark.parametrize("b", [fmpq(-1), fmpq(-5, 2)])
def test_nodes_left_out_near_zero(b: fmpq) -> None:
    """The grid begins at rho = e^-20 and the step is so short that nothing but the left end is seen."""
    step = fmpq(1, 80)
    plan = TrapezoidPlan(step, -1600, 240, fmpq(1, 4), fmpq(1, 4), fmpq(3), 300)
    full = TrapezoidPlan(step, -10_000, 240, fmpq(1, 4), fmpq(1, 4), fmpq(3), 300)
    found = slow_moments(arb(1), b, fmpq(1, 10), 1, plan)[0]
    assert _contained(found, _exact(slow_moments(arb(1), b, fmpq(1, 10), 1, full)[0]))


def test_series_in_eta_with_one_order() -> None:
    epsilon, b = fmpq(1, 10**30), fmpq(-1, 2)
    with working_bits(400):
        eta = scale(epsilon)
        first = [evaluate(arb(0), b, derivative=j, digits=100).value for j in range(3)]
    found = epsilon_series(first, arb(0), b, eta, [(arb(1), arb(2))], 400)
    assert _contained(found, _exact(integral(fmpq(0), b, epsilon, 300)))


@pytest.mark.parametrize("orders", [2, 3, 5])
def test_series_in_eta_with_several_orders(orders: int) -> None:
    """At tau = 1: each further order makes the radius smaller, and the value stays inside."""
    epsilon, b, tau = fmpq(2, 10**15), fmpq(-1, 2), fmpq(1)
    with working_bits(400):
        first = [evaluate(tau, b, derivative=j, digits=100).value for j in range(3)]
        eta = scale(epsilon)
    found = epsilon_series(first, arb(tau), b, eta, [(arb(1), arb(4))] * orders, 400)
    assert _contained(found, _exact(integral(tau * 10**5, b, epsilon, 300)))
    assert arb(10) ** (-5 * orders - 4) < found.rad() < arb(10) ** (6 - 5 * orders)


@pytest.mark.parametrize("epsilon", [fmpq(1), fmpq(1, 100_000)])
@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3)])
def test_ends_of_the_integral_of_the_slow_coefficient(beta: fmpq, epsilon: fmpq) -> None:
    state = Deviation(beta, epsilon, fmpq(1), fmpq(1), fmpq(0), fmpq(0), fmpq(0))
    assert _contained(slow_coefficient(state, 4), _exact(slow_coefficient(state, 200)))


def test_ends_of_the_path_of_the_fast_coefficient() -> None:
    state = Deviation(fmpq(3, 2), fmpq(8), fmpq(1, 2), fmpq(0), fmpq(0), fmpq(1), fmpq(1))
    coarse, fine = fast_coefficient(state, 4), fast_coefficient(state, 200)
    assert _contained(coarse.real, _exact(fine.real))
    assert _contained(coarse.imag, _exact(fine.imag))


@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(-1)])
def test_ends_of_the_rays_of_the_fast_solutions(monkeypatch: pytest.MonkeyPatch, p: fmpq) -> None:
    """The rays are cut where the integrand is no small number yet, as far as its bound allows."""
    arguments = fmpq(1, 2), fmpq(40), p, ("b", "V"), 240
    waves, falls = oscillating(*arguments)[0], decaying(*arguments)[0]
    monkeypatch.setattr(Ray, "_last", lambda self, _: (5 * abs(self.corner) + 4).mid())
    cut_waves, cut_falls = oscillating(*arguments)[0], decaying(*arguments)[0]
    for cut, whole in zip([*cut_waves, *map(acb, cut_falls)], [*waves, *map(acb, falls)], strict=True):
        assert whole.real.rad() < cut.real.rad() / 1000
        assert _contained(cut.real, _exact(whole.real))
        assert _contained(cut.imag, _exact(whole.imag))


def test_the_bound_that_stands_for_the_fast_part() -> None:
    state = Deviation(fmpq(1, 2), fmpq(1, 6000), fmpq(1, 2), fmpq(1), fmpq(0), fmpq(4), fmpq(2))
    fast = coefficients(state, 4)[1]
    true = fast_coefficient(state, 60)
    assert fast.real.contains(0)
    assert fast.imag.contains(0)
    assert _contained(fast.real, _exact(true.real))
    assert _contained(fast.imag, _exact(true.imag))
