"""The announced effort: the route is the one that is taken, and the guess grows as it should."""

from __future__ import annotations

from itertools import pairwise

import pytest
from flint import arb, fmpq

from gspot_verified.theta_function.value.effort import Effort, expected_effort
from gspot_verified.theta_function.value.evaluate import evaluate


@pytest.mark.parametrize(
    ("tau", "beta"),
    [
        (1, fmpq(7, 3)),
        (-(10**6), fmpq(7, 3)),
        (10**6, fmpq(7, 3)),
        (1, fmpq(7, 1009)),
        (1_000, fmpq(1, 2)),
        (0, fmpq(1, 2)),
    ],
)
def test_the_route_is_the_one_that_is_taken(tau: int, beta: fmpq) -> None:
    effort = expected_effort(fmpq(tau), beta, 3_000)
    assert effort is not None
    assert effort.route == evaluate(tau, beta, digits=3_000).route
    assert 0 < effort.seconds < 1


@pytest.mark.parametrize("tau", [1, 1_000, 10**6, -(10**6)])
@pytest.mark.parametrize("beta", [fmpq(7, 3), fmpq(10_007, 100_003)])
def test_more_digits_cost_more_than_in_proportion(tau: int, beta: fmpq) -> None:
    found = [expected_effort(fmpq(tau), beta, digits) for digits in (20_000, 40_000, 80_000, 160_000)]
    seconds = [effort.seconds for effort in found if effort is not None]
    assert len(seconds) == 4
    assert all(2 * one < two < 6 * one for one, two in pairwise(seconds))


def test_no_guess_without_a_model() -> None:
    assert expected_effort(arb(1), fmpq(7, 3), 20_000) is None
    # Beyond what a route allows itself there is none either.
    assert expected_effort(50_000 + fmpq(1, 3**3300), fmpq(7, 3), 10**6) is None


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0.01, "about 1 s"), (1.6, "about 2 s"), (89, "about 89 s"), (100, "about 2 minutes"), (3600, "about 60 minutes")],
)
def test_words(seconds: float, text: str) -> None:
    assert str(Effort("taylor", seconds)) == text
