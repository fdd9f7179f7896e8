"""Precision that is raised until it is enough, and what is answered where no route knows the inputs."""

from __future__ import annotations

import importlib
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import Reason, evaluate, theta_by
from gspot_verified.numbers.balls import bits_for_digits, is_exact, nonfinite, relative_bits, working_bits
from gspot_verified.theta_function.value import routes
from gspot_verified.theta_function.value.approach import attempt, majorant, tighter
from gspot_verified.theta_function.value.majorant import majorant_bound


def test_the_common_part_of_two_enclosures() -> None:
    left, right = arb(2, 1), arb((7, -1), 1)  # [1, 3] and [5/2, 9/2]
    for first, second in ((left, right), (right, left)):
        common = tighter(first, second)
        assert common.contains(arb((11, -2), (1, -2)))
        assert common.rad() < fmpq(1, 4) + fmpq(1, 10**6)
    assert tighter(left, nonfinite()) is left
    assert tighter(nonfinite(), left) is left
    with pytest.raises(ArithmeticError, match="two enclosures of one number are disjoint"):
        tighter(left, arb(9, 1))


def test_the_common_part_keeps_every_bit_of_both() -> None:
    with working_bits(1000):
        third = arb(fmpq(1, 3))
    for first, second in ((third, arb(0, 1)), (arb(0, 1), third)):
        assert relative_bits(tighter(first, second)) > 960


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The bits that each call of a route is asked for: work counted, not timed."""
    goals: list[int] = []
    for name, route in dict(routes.ROUTES).items():

        def counted(tau: Any, beta: Any, goal: int, route: Any = route) -> arb:
            goals.append(goal)
            value: arb = route(tau, beta, goal)
            return value

        monkeypatch.setitem(routes.ROUTES, name, counted)
    return goals


@pytest.mark.parametrize(
    ("tau", "radius", "beta"), [(2, 20, "-7/3"), (-30, 5, "7/3"), (100, 10, "-7/3"), (300, 30, "-50"), (3000, 5, "5/2")]
)
def test_a_wide_ball_asks_for_no_more_bits_than_it_has(asked: list[int], tau: int, radius: int, beta: str) -> None:
    """At 1000 digits the routes were asked for 3,300 bits and more: no asymptotic one answers there, quadrature was
    started for minutes, and the ball of Θ(-30 +- 10^-5) was +-10^37."""
    with working_bits(4_000):
        ball = arb(tau) + arb(0, arb(10) ** -radius)
        ends = [evaluate(end, beta, digits=50).value for end in (ball.lower().mid(), ball.mid(), ball.upper().mid())]
    asked.clear()
    found = evaluate(ball, beta, digits=1000)
    assert max(asked) < 700
    assert len(asked) <= 6
    assert found.reason is Reason.WIDE_INPUT
    assert not found.reached
    # Valid, and as good as what a few digits give.
    assert all(found.value.overlaps(end) for end in ends)
    few = evaluate(ball, beta, digits=15)
    with working_bits(4_000):
        assert found.value.rad() <= 2 * few.value.rad()


def test_a_result_that_hardly_depends_on_a_wide_input_still_has_all_digits(asked: list[int]) -> None:
    """Θ(τ, β) = 1 + O(β): 200 digits from a ball of τ with one, because β is 10^-400."""
    found = evaluate(arb(1, fmpq(1, 10)), "1e-400", digits=200)
    assert found.reached
    assert found.value.overlaps(arb(1))
    assert max(asked) >= bits_for_digits(200) + 2  # room for the two roundings that follow


def test_the_default_budget_is_eight_times_the_bits_and_some(asked: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    """A value that never gets a certain bit: the goals are doubled until the budget ends."""

    def uncertain(_tau: Any, _beta: Any, goal: int) -> arb:
        asked.append(goal)
        return arb(0, 1)

    _no_shortcut(monkeypatch)
    for name in routes.ROUTES:
        monkeypatch.setitem(routes.ROUTES, name, uncertain)
    for digits in (15, 620, 3000):
        asked.clear()
        found = evaluate("1/3", "7/5", digits=digits)
        assert (found.reached, found.reason) == (False, Reason.BUDGET)
        goal = bits_for_digits(digits) + 2
        assert max(asked) <= 8 * goal + 16_384 < 2 * max(asked) + 64


def test_a_narrow_ball_is_tried_again_as_long_as_that_helps(monkeypatch: pytest.MonkeyPatch) -> None:
    """A value of 2^-300 with an absolute error of 2^-goal: two attempts show nothing, the third has all bits."""
    for name in routes.ROUTES:
        monkeypatch.setitem(routes.ROUTES, name, lambda _tau, _beta, goal: arb((1, -300), (1, -goal)))
    for tau, beta in ((arb(1, (1, -2000)), "7/5"), ("7/5", arb(1, (1, -2000)))):
        found = evaluate(tau, beta)
        assert (found.reached, found.reason) == (True, None)


def _no_shortcut(monkeypatch: pytest.MonkeyPatch) -> None:
    """Exact arguments near 0 go through the routes as all others do."""
    module = importlib.import_module("gspot_verified.theta_function.value.evaluate")
    monkeypatch.setattr(module, "near_value", lambda *_: None)


def no_balls(monkeypatch: pytest.MonkeyPatch, least_goal: int = 0) -> list[int]:
    """Routes that know nothing of balls, and of numbers only from ``least_goal`` bits on; the goals that they get."""
    goals: list[int] = []
    for name, route in dict(routes.ROUTES).items():

        def only_numbers(tau: Any, beta: Any, goal: int, route: Any = route) -> arb:
            goals.append(goal)
            known = is_exact(tau) and is_exact(beta) and goal >= least_goal
            return route(tau, beta, goal) if known else nonfinite()

        monkeypatch.setitem(routes.ROUTES, name, only_numbers)
    return goals


@pytest.mark.parametrize(
    ("tau", "beta", "far", "size"),
    [
        (arb(3, 2), fmpq(-3), 5, 3),  # attained at tau = 5
        (arb(-3, 2), fmpq(-3), 5, 3),
        (fmpq(5), arb(-2, 1), 5, 3),
        (arb(3, 2), arb(-2, 1), 5, 3),
        (fmpq(-2), arb((1, -1), (1, -2)), 2, 1),  # B = 1 where |beta| <= 3/4
    ],
)
def test_where_no_route_knows_balls_the_majorant_is_that_of_the_farthest_numbers(
    monkeypatch: pytest.MonkeyPatch, tau: Any, beta: Any, far: int, size: int
) -> None:
    """M Theta(X, -B) of proofs/majorant.md with |tau| <= X and |beta| <= B over the whole balls."""
    above = size + fmpq(1, 10**6) if isinstance(beta, arb) else fmpq(size)  # the end of a ball is rounded
    page = majorant_bound(beta, above, evaluate(far, -above, digits=30).value, 128)
    assert page.is_finite()
    inside = [evaluate(t, b, digits=30).value for t in _three(tau) for b in _three(beta)]
    no_balls(monkeypatch)
    found = evaluate(tau, beta)
    assert found.route == "majorant"
    assert found.value.is_finite()
    assert all(found.value.contains(value.mid()) for value in inside)
    assert abs(found.value.rad() - page.rad()) < page.rad() * fmpq(1, 10**3)


def _three(value: Any) -> list[Any]:
    """Both ends and the middle."""
    return [value] if isinstance(value, fmpq) else [value.lower(), value.mid(), value.upper()]


def test_the_majorant_of_numbers_that_no_rational_holds_is_not_finite(monkeypatch: pytest.MonkeyPatch) -> None:
    no_balls(monkeypatch)
    tiny = arb((1, -50_000), (1, -50_010))
    for tau, beta in ((tiny, arb(-2, 1)), (arb(1, 1), tiny)):
        assert not majorant(arb(tau), beta).is_finite()


def test_numbers_that_no_route_reaches_are_asked_for_again_with_more_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    goals = no_balls(monkeypatch, least_goal=128)
    _no_shortcut(monkeypatch)
    found = evaluate("1/3", "7/5", digits=5)
    assert found.reached
    assert max(goals) == 128
    assert found.value.overlaps(theta_by("taylor", "1/3", "7/5", digits=40))
    no_balls(monkeypatch, least_goal=10**9)
    for goal in (20, 128, 129):
        with pytest.raises(routes.BudgetError, match=f"no route reaches {max(goal, 128)} bits"):
            attempt(fmpq(1, 3), fmpq(7, 5), goal)


@pytest.mark.parametrize("max_bits", [64, 200, 1000])
def test_max_bits_bounds_the_first_attempt_too(asked: list[int], max_bits: int) -> None:
    found = evaluate("1/3", "7/5", digits=1000, max_bits=max_bits)
    assert max(asked) <= max_bits
    assert (found.reached, found.reason) == (False, Reason.BUDGET)
    assert found.value.is_finite()
    assert found.value.overlaps(evaluate("1/3", "7/5", digits=50).value)
    assert relative_bits(found.value) >= max_bits - 8


def test_max_bits_bounds_what_is_known_from_nearby_too() -> None:
    """Without a budget 112 bits are used here, by the series at a point nearby."""
    free, bound = evaluate("1/2", "7/3", digits=30), evaluate("1/2", "7/3", digits=30, max_bits=64)
    assert (free.reached, free.working_bits > 100) == (True, True)
    assert (bound.reached, bound.working_bits, bound.reason) == (False, 64, Reason.BUDGET)
    assert bound.value.overlaps(free.value)
