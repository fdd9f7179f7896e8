"""The heuristics: any choice is correct, so what is tested is that they answer, and that the answers serve."""

from __future__ import annotations

import math

from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import betas, taus, to_fmpq

from gspot_verified.numbers.balls import approximate, relative_bits
from gspot_verified.theta_function.value import choice, routes
from gspot_verified.theta_function.value.choice import largest_term, log_theta, stationary

_GOALS = st.sampled_from([4, 53, 100, 340])


@given(taus(), betas(), _GOALS)
def test_every_argument_of_the_domain_gets_plans(tau: object, beta: object, goal: int) -> None:
    t, b = to_fmpq(tau), to_fmpq(beta)  # type: ignore[arg-type]
    point, parameter = approximate(t), approximate(b)
    plan = choice.taylor_plan(point, parameter, goal)
    assert plan.length % 3 == 0
    assert plan.bits >= goal
    assert set(choice.preferred_routes(t, b, goal)) <= set(routes.ROUTES)
    if point > 1:
        saddle = choice.saddle_plan(point, parameter, goal)
        assert saddle is None or 0 < saddle.cut <= 1 - saddle.disc
    if point < -1:
        negative = choice.negative_plan(-point, parameter, goal)
        assert negative is None or 3 * negative.terms > parameter


@given(st.integers(-80, 80), st.integers(-70, 70), st.sampled_from([40, 110]))
def test_the_first_taylor_plan_mostly_reaches_its_goal(tau: int, beta: int, goal: int) -> None:
    value = routes.taylor(fmpq(tau, 10), fmpq(beta, 10), goal)
    assert value.is_finite()
    # Where Theta is small against the guess (next to its zeros) a second attempt is needed; never a hundred bits more.
    assert relative_bits(value) > goal - 100


@given(st.floats(-300, 300), st.floats(-2000, 2000))
def test_magnitudes_are_numbers(tau: float, beta: float) -> None:
    size = max(abs(tau), 1e-60)
    assert math.isfinite(largest_term(size, beta))
    assert not math.isnan(log_theta(math.copysign(size, tau), beta))
    r = stationary(tau, beta)
    assert r is None or abs(r * tau - r**3 - beta) <= 1e-6 * (1 + abs(beta) + r**3 + abs(tau) * r)
