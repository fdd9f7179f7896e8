"""dTheta/dbeta as users call it: its accuracy, its laws, integers and balls, and what it refuses.

Page: proofs/beta_series.md.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq

from gspot_verified import BudgetError, beta_derivative, theta
from gspot_verified.numbers.balls import bits_for_digits, nonfinite, relative_bits, working_bits
from gspot_verified.theta_function.value import beta_derivative as module

_TAUS = st.builds(Fraction, st.integers(-400, 400), st.integers(8, 40))


@given(_TAUS, small_heights(), st.sampled_from([5, 15, 40]))
def test_the_accuracy_is_reached(tau: Fraction, beta: Fraction, digits: int) -> None:
    value = beta_derivative(tau, beta, digits)
    assert relative_bits(value) >= bits_for_digits(digits)
    finer = beta_derivative(tau, beta, digits + 20)
    assert value.overlaps(finer)


@given(_TAUS, small_heights())
def test_the_recurrence_in_beta(tau: Fraction, beta: Fraction) -> None:
    """proofs/identities.md by beta: Theta(beta) = -tau Theta(beta-1) + (1-beta)(2-beta) Theta(beta-3)."""
    t, b = to_fmpq(tau), to_fmpq(beta)
    with working_bits(300):
        left = beta_derivative(t, b, 40)
        right = (
            -t * beta_derivative(t, b - 1, 40)
            + (1 - b) * (2 - b) * beta_derivative(t, b - 3, 40)
            + (2 * b - 3) * theta(t, b - 3, digits=40)
        )
        assert left.is_finite()
        assert right.is_finite()
        assert left.overlaps(right)


@pytest.mark.parametrize("beta", [0, 1, 2, 3, 6, -1, -4])
@pytest.mark.parametrize("tau", [0, "1/2", -7, 12])
def test_integers(tau: int | str, beta: int) -> None:
    """The mean value theorem on both sides of an integer."""
    found = beta_derivative(tau, beta, 25)
    step = fmpq(1, 10**20)
    below, above = (theta(tau, beta + part, digits=60) for part in (-step, step))
    with working_bits(300):
        quotient = (above - below) / arb(2 * step)
        assert abs(found - quotient) < (1 + abs(quotient)) * arb(10) ** -20


def test_balls_hold_what_their_numbers_give() -> None:
    ball = beta_derivative(arb(3, "1e-6"), arb(2, "1e-6"))
    step = fmpq(1, 10**6)
    for tau in (3 - step, fmpq(3), 3 + step):
        for beta in (2 - step, fmpq(2), 2 + step):
            value = beta_derivative(tau, beta, 30)
            assert value.is_finite()
            assert ball.contains(value)
    assert ball.rad() < arb(1) / 50
    narrow = beta_derivative(arb(3, "1e-20"), "7/2", 30)
    assert 40 < relative_bits(narrow) < bits_for_digits(30)


def test_many_digits() -> None:
    assert relative_bits(beta_derivative("-7/2", "1/3", 400)) >= bits_for_digits(400)


@settings(max_examples=10)
@given(st.sampled_from([100, -100, 150]), st.sampled_from(["1/2", "-7/3"]))
def test_far_from_zero(tau: int, beta: str) -> None:
    step = fmpq(1, 10**12)
    near = fmpq(*map(int, beta.split("/"))) + step
    between = beta_derivative(tau, beta)
    with working_bits(200):
        quotient = (theta(tau, near, digits=50) - theta(tau, beta, digits=50)) / arb(step)
        assert abs(between / quotient - 1) < arb(10) ** -9


def of_bits(bits: int) -> arb:
    """1 with so many certain bits."""
    return arb(1, (1, -bits - 1))


def given_attempts(monkeypatch: pytest.MonkeyPatch, values: list[arb | None]) -> list[int]:
    """The series gives these balls in turn, the last one again and again; the bits that were planned are noted."""
    planned: list[int] = []

    def attempt(_: object, __: object, wanted: int) -> arb | None:
        planned.append(wanted)
        assert len(planned) < 40
        return values[min(len(planned), len(values)) - 1]

    monkeypatch.setattr(module, "_attempt", attempt)
    return planned


_EXACT = ("1/3", "1/2")
_BALLS = [(arb(1, "0.1"), "1/2"), ("1/3", arb(1, "0.1")), (arb(1, "0.1"), arb(1, "0.1"))]


def test_what_is_not_accurate_enough_is_computed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two bits beyond the goal are taken, one is not: rounding to the goal and 16 bits then costs none of its own."""
    goal = bits_for_digits(15)
    for enough, attempts in ((goal + 2, 1), (goal + 1, 2), (goal, 2), (3, 2)):
        first, last = of_bits(enough), of_bits(goal + 40)
        assert relative_bits(first) == enough
        planned = given_attempts(monkeypatch, [first, last])
        value = beta_derivative(*_EXACT)
        assert len(planned) == attempts
        assert relative_bits(value) >= goal
        assert value.contains(last)
    assert planned == sorted(set(planned))


def test_a_series_that_says_nothing_is_tried_again_and_takes_nothing_away(monkeypatch: pytest.MonkeyPatch) -> None:
    good = of_bits(90)
    for arguments in (_EXACT, *_BALLS):
        planned = given_attempts(monkeypatch, [nonfinite(), nonfinite(), good])
        assert beta_derivative(*arguments).contains(good)
        assert len(planned) == 3
    planned = given_attempts(monkeypatch, [of_bits(7), nonfinite(), None])
    value = beta_derivative(*_EXACT)
    assert len(planned) == 3
    assert value.is_finite()
    assert value.contains(of_bits(8))
    for nothing in (nonfinite(), None):
        given_attempts(monkeypatch, [nothing])
        with pytest.raises(BudgetError):
            beta_derivative(*_EXACT)


@pytest.mark.parametrize("arguments", _BALLS)
def test_a_ball_that_stays_wide_is_not_computed_for_ever(
    monkeypatch: pytest.MonkeyPatch, arguments: tuple[Any, Any]
) -> None:
    """What a ball gives has a width of its own; at exact numbers every precision narrows the value."""
    planned = given_attempts(monkeypatch, [of_bits(9), of_bits(9), of_bits(70)])
    assert relative_bits(beta_derivative(*arguments)) == 9
    assert len(planned) == 2
    planned = given_attempts(monkeypatch, [of_bits(9), of_bits(12), of_bits(70)])
    assert relative_bits(beta_derivative(*arguments)) == 70
    assert len(planned) == 3
    planned = given_attempts(monkeypatch, [of_bits(9), of_bits(9), of_bits(70)])
    assert relative_bits(beta_derivative(*_EXACT)) == 70
    assert len(planned) == 3


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((0.5, 1), TypeError, "tau"),
        ((1, 0.5), TypeError, "beta"),
        ((arb("nan"), 1), ValueError, "tau"),
        ((1, 10**5), ValueError, "beta"),
        ((1, 1, 0), ValueError, "digits"),
        ((10**6, "1/2"), BudgetError, "a smaller .tau."),
    ],
)
def test_what_is_refused(arguments: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        beta_derivative(*arguments)
