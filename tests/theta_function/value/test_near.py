"""The common case: it answers as the other routes do, at the first visit and later."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq

from gspot_verified import evaluate, theta_by
from gspot_verified.numbers.balls import relative_bits
from gspot_verified.theta_function.value import near
from gspot_verified.theta_function.value.near import first_visit, near_value


@given(st.fractions(-14, 22, max_denominator=12), small_heights(), st.sampled_from([20, 53, 170, 700]))
def test_both_visits_give_one_number(tau: Fraction, beta: Fraction, goal: int) -> None:
    t, b = to_fmpq(tau), to_fmpq(beta)
    near._visits.cache_clear()
    first, second = near_value(t, b, goal), near_value(t, b, goal)
    if first is None or second is None:
        assert first is second
        assert beta.denominator == 1 or not (-12 <= tau <= 20 and abs(beta) <= 8)
        return
    other = evaluate(t, b, digits=max(30, goal // 3 + 20)).value
    for value, bits in (first, second):
        assert value.is_finite()
        assert bits >= goal
        assert value.overlaps(other)
        assert relative_bits(value) > goal - 70  # less only next to a zero


@given(
    st.sampled_from([fmpq(1), fmpq(-5), fmpq(20), fmpq(123_456_789, 10**8), fmpq(10**35 + 1, 10**35)]),
    st.one_of(st.integers(-8 * 10**30, 8 * 10**30), st.integers(-9, 9).map(lambda far: 2 * 10**30 + far)),
    st.sampled_from([30, 110]),
    st.sampled_from([53, 170]),
)
def test_betas_of_many_decimals(tau: fmpq, above: int, decimals: int, goal: int) -> None:
    """Also next to an integer, and at tau too long for chains."""
    beta = fmpq(above, 10**30) + (fmpq(1, 10**decimals) if decimals > 30 else 0)
    near._visits.cache_clear()
    first, second = near_value(tau, beta, goal), near_value(tau, beta, goal)
    if first is None or second is None:
        assert beta.q == 1 or abs(beta) > 8
        return
    other = theta_by("laplace", tau, beta, digits=25)
    assert relative_bits(other) > 20
    for value, _ in (first, second):
        assert value.is_finite()
        assert value.overlaps(other)
        assert relative_bits(value) > goal - 70


def test_the_plan_mostly_reaches_its_goal() -> None:
    short = 0
    for above in range(-48, 80):
        for beta in (fmpq(1, 2), fmpq(7, 3), fmpq(13, 2), fmpq(-5, 2)):
            for goal in (53, 170):
                found = near_value(fmpq(above, 4), beta, goal)
                assert found is not None
                short += relative_bits(found[0]) < goal
    assert short < 30  # of 1024


def test_visits() -> None:
    near._visits.cache_clear()
    assert [first_visit(1, 3), first_visit(1, 3), first_visit(2, 3)] == [True, False, True]


def test_what_is_left_to_others() -> None:
    assert near_value(fmpq(13), fmpq(1, 2), 2_000) is None
    assert near_value(fmpq(-13), fmpq(1, 2), 60) is None
    assert near_value(fmpq(1), fmpq(9), 60) is None
    assert near_value(fmpq(1), fmpq(1, 2) + fmpq(1, 10**130), 60) is None
    assert theta_by("taylor", 1, "1/2").overlaps(evaluate(1, "1/2").value)
