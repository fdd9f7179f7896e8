"""The growth sets: motions that start in them are followed by series; each hypothesis is needed for membership; states
whose K is negative are in none of them.

Page: proofs/flight.md.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from witnesses.contact import moved
from witnesses.flight import lift_off_state

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.growth_set import (
    excess,
    in_fast_set,
    in_monotone_set,
    in_slow_set,
    slopes,
)
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.compliant.motion.touch_down import flight_end
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome

RATE, LAG, DOWN = fmpq(1, 10), fmpq(1, 4), fmpq(-1)


def built(
    D: fmpq, W: fmpq, G: fmpq, q: fmpq, force: fmpq, beta: fmpq, epsilon: fmpq, alpha_2: fmpq = DOWN
) -> ContactState:
    """The state with these slopes: V = -W, b = -G - p lambda, Y = -2 lambda - V - D."""
    with working_bits(200):
        b, Y = -G + q * force, -2 * force + W - D
        return ContactState(beta, epsilon, alpha_2, *map(arb, (-q, b, -W, Y, force)))


SLOW = built(fmpq(1), fmpq(1), fmpq(1), fmpq(1, 4), fmpq(1, 8), fmpq(2), fmpq(1, 1000))
FAST = built(fmpq(1), fmpq(1), fmpq(1), fmpq(1, 4), fmpq(1), fmpq(2), fmpq(1, 1000))
MONOTONE = built(fmpq(1), fmpq(0), fmpq(0), fmpq(0), fmpq(0), fmpq(1, 2), fmpq(1))


def test_slopes_are_the_derivatives() -> None:
    x = slopes(SLOW)
    for value, wanted in zip((x.q, x.force, x.D, x.W, x.G), (fmpq(1, 4), fmpq(1, 8), 1, 1, 1), strict=True):
        assert value.contains(wanted)
    assert excess(SLOW) == fmpq(1, 1000)


def follow(state: ContactState, duration: int) -> list[tuple[mpmath.mpf, mpmath.mpf]]:
    """(p, lambda) of the contact motion at equal times."""

    def number(value: arb | fmpq) -> mpmath.mpf:
        if isinstance(value, fmpq):
            return mpmath.mpf(int(value.p)) / int(value.q)
        mantissa, exponent = value.mid().man_exp()
        return mpmath.ldexp(mpmath.mpf(int(mantissa)), int(exponent))

    beta, small = number(state.beta), number(state.epsilon)
    mean = number(state.alpha_2) / (1 - beta)
    p, force = number(state.p), number(state.force)
    hats = [
        number(state.b) + p * mean,
        number(state.V),
        number(state.Y) + 2 * mean,
        number(state.Y) + force + mean,
    ]
    found = [(p, force)]
    for _ in range(duration):
        hats, p = moved(hats, p, beta, small, mpmath.mpf(1), steps=1)
        found.append((p, hats[3] - hats[2] + mean))
    return found


@pytest.mark.parametrize(("state", "rate"), [(SLOW, RATE), (FAST, RATE), (MONOTONE, fmpq(0))])
def test_the_force_grows_from_a_state_in_the_sets(state: ContactState, rate: fmpq) -> None:
    with mpmath.workdps(30):
        run = follow(state, 60)
        growth = mpmath.exp(mpmath.mpf(int(rate.p)) / int(rate.q))
        for (_, before), (_, after) in pairwise(run):
            assert after > before * growth
        assert run[-1][1] > 50


def test_membership() -> None:
    with working_bits(100):
        assert in_slow_set(SLOW, RATE, LAG)
        assert in_fast_set(FAST, RATE)
        assert in_monotone_set(MONOTONE)
        assert not in_fast_set(MONOTONE, RATE)
        assert not in_slow_set(MONOTONE, RATE, LAG)
        assert not in_monotone_set(SLOW)


def slow_with(**changed: fmpq) -> ContactState:
    values = {
        "D": fmpq(1), "W": fmpq(1), "G": fmpq(1), "q": fmpq(1, 4), "force": fmpq(1, 8), "beta": fmpq(2),
        "epsilon": fmpq(1, 1000),
    }  # fmt: skip
    return built(**{**values, **changed})


@pytest.mark.parametrize(
    "changed",
    [
        {"force": fmpq(-1, 1000)},
        {"W": fmpq(-1, 1000)},
        {"D": fmpq(99, 10000)},
        {"D": fmpq(25), "W": fmpq(1), "G": fmpq(1)},
        {"G": fmpq(1, 10)},
        {"D": fmpq(49, 100)},
        {"q": fmpq(1, 25)},
        {"q": fmpq(-1, 4)},
        {"alpha_2": fmpq(1)},
        {"alpha_2": fmpq(-2000)},
        {"epsilon": fmpq(1, 4)},
    ],
    ids=["lambda", "W", "D >= a lambda", "S >= a M", "G >= a S", "D >= c S", "turning", "p > 0", "A < 0", "lag", "q1"],
)
def test_each_hypothesis_of_the_slow_set_is_checked(changed: dict[str, fmpq]) -> None:
    with working_bits(100):
        assert in_slow_set(slow_with(), RATE, LAG)
        assert not in_slow_set(slow_with(**changed), RATE, LAG)


def test_rates_outside_their_range_are_refused() -> None:
    with working_bits(100):
        for rate, lag in ((fmpq(0), LAG), (fmpq(1), LAG), (fmpq(-1, 10), LAG), (RATE, fmpq(0)), (RATE, fmpq(2, 5))):
            assert not in_slow_set(SLOW, rate, lag)
        assert not in_fast_set(FAST, fmpq(0))
        assert not in_fast_set(FAST, fmpq(-1, 10))


@pytest.mark.parametrize(
    "changed",
    [
        {"force": fmpq(-1)},
        {"W": fmpq(-1, 10)},
        {"G": fmpq(-1, 10)},
        {"D": fmpq(9, 100)},
        {"W": fmpq(1, 20), "G": fmpq(1, 20)},
        {"q": fmpq(21, 100)},
        {"alpha_2": fmpq(4)},
        {"force": fmpq(0), "D": fmpq(0)},
    ],
)
def test_each_hypothesis_of_the_fast_set_is_checked(changed: dict[str, fmpq]) -> None:
    with working_bits(100):
        assert in_fast_set(slow_with(force=fmpq(1)), RATE)
        assert not in_fast_set(slow_with(**{"force": fmpq(1), **changed}), RATE)


@pytest.mark.parametrize("name", ["p", "b", "V", "Y", "force"])
def test_no_information_is_in_no_set(name: str) -> None:
    for state in (SLOW, FAST, MONOTONE):
        assert lasting_contact(state if state is not MONOTONE else slow_with()).outcome is Outcome.PROVED
        assert lasting_contact(replace(state, **{name: arb("nan")})).outcome is Outcome.UNDECIDED
        assert lasting_contact(replace(state, **{name: arb(0, 10**9)})).outcome is Outcome.UNDECIDED


@given(
    slopes=st.tuples(*(st.integers(-8, 60) for _ in range(3))),
    force=st.integers(0, 20),
    q=st.integers(1, 60),
    beta=st.sampled_from([fmpq(1, 2), fmpq(3, 2), fmpq(4)]),
    small=st.sampled_from([fmpq(1, 10), fmpq(1, 1000)]),
    alpha_2=st.sampled_from([DOWN, fmpq(1), fmpq(20)]),
)
def test_a_contact_that_is_lost_is_never_called_lasting(
    slopes: tuple[int, int, int], force: int, q: int, beta: fmpq, small: fmpq, alpha_2: fmpq
) -> None:
    D, W, G = (fmpq(value, 8) for value in slopes)
    state = built(D, W, G, fmpq(q, 100), fmpq(force, 10), beta, small, alpha_2)
    if lasting_contact(state).outcome is Outcome.PROVED:
        with mpmath.workdps(25):
            assert all(value > 0 for _, value in follow(state, 6)[1:])


@pytest.mark.parametrize(("beta", "nu"), [("1.5", "2"), ("2.5", "0.5")])
def test_the_paper_runs_end_in_an_impact_after_one_flight(beta: str, nu: str) -> None:
    end = flight_end(lift_off_state(beta, nu, "0.001"), 90)
    assert end.state is not None
    assert lasting_contact(end.state).outcome is Outcome.PROVED
    upwards = replace(end.state, V=-end.state.V)
    assert lasting_contact(upwards).outcome is Outcome.UNDECIDED


def test_the_slow_set_asks_for_the_whole_of_m() -> None:
    """S >= a M, M = D + 2 lambda: with lambda = 5 it is 2 lambda that decides. S = W + G."""
    with working_bits(100):
        inside = {"force": fmpq(5), "D": fmpq(1), "W": fmpq(1, 2), "G": fmpq(7, 10)}
        assert in_slow_set(slow_with(**inside), RATE, LAG)
        assert not in_slow_set(slow_with(**{**inside, "G": fmpq(1, 2)}), RATE, LAG)
        assert not in_slow_set(slow_with(**{**inside, "D": fmpq(49, 100)}), RATE, LAG)  # D >= a lambda


def test_the_monotone_set_with_a_force_of_0_needs_a_pull_downwards() -> None:
    """-alpha_2 >= 0; any pull, however small, will do."""
    with working_bits(100):
        for alpha_2, holds in ((fmpq(0), True), (fmpq(-1, 1000), True), (fmpq(1, 1000), False)):
            state = built(fmpq(1), fmpq(0), fmpq(0), fmpq(0), fmpq(0), fmpq(1, 2), fmpq(1), alpha_2)
            assert bool(in_monotone_set(state) is not None) is holds


TINY = fmpq(1, 2**40)


def test_the_load_where_alpha_2_pulls_upwards() -> None:
    """kappa + epsilon alpha_2/lambda, beside each equality; the force is not below its mean alpha_2/(1 - beta)."""
    with working_bits(200):
        for alpha_2, holds in ((fmpq(1, 2), True), (fmpq(1, 2) + TINY, False)):
            state = built(fmpq(1), fmpq(0), fmpq(0), fmpq(0), fmpq(1), fmpq(1, 2), fmpq(1), alpha_2)
            assert (in_monotone_set(state) is not None) is holds
        small, rate = fmpq(1, 1024), fmpq(1, 8)  # short in binary: the balls are points
        least = (small + small * 3 / 2) / rate + 2 * rate + rate**2
        for q, holds in ((least, True), (least - TINY, False)):
            fast = built(fmpq(1), fmpq(2), fmpq(1), q, fmpq(2), fmpq(2), small, fmpq(3))
            assert (in_fast_set(fast, rate) is not None) is holds
        touching = built(fmpq(1), fmpq(1), fmpq(1), fmpq(4), fmpq(0), fmpq(2), fmpq(1, 1000), fmpq(1))
        assert in_fast_set(touching, RATE) is None
        assert in_fast_set(replace(touching, alpha_2=fmpq(-1)), RATE) is not None


PULLED = {
    "monotone": built(fmpq(1, 100), fmpq(1, 10), fmpq(1, 10), fmpq(1, 10), fmpq(3), fmpq(1, 2), fmpq(1, 10), fmpq(1)),
    "fast": built(fmpq(1), fmpq(1), fmpq(1), fmpq(1, 4), fmpq(1), fmpq(2), fmpq(1, 1000), fmpq(1)),
}


@pytest.mark.parametrize("state", PULLED.values(), ids=PULLED)
def test_the_force_grows_where_alpha_2_pulls_upwards(state: ContactState) -> None:
    assert lasting_contact(state).outcome is Outcome.PROVED
    with mpmath.workdps(30):
        run = follow(state, 60)
        assert all(before < after for (_, before), (_, after) in pairwise(run))
        assert run[-1][1] > 10


@pytest.mark.parametrize("size", [fmpq(1, 1000), fmpq(1000)])
def test_membership_does_not_depend_on_the_size(size: fmpq) -> None:
    """The equations are linear in the state and alpha_2 at a given p: so are the sets."""
    with working_bits(200):
        slow, fast = (
            slow_with(D=size, W=size, G=size, force=size * force, alpha_2=-size) for force in (fmpq(1, 8), fmpq(1))
        )
        assert in_slow_set(slow, RATE, LAG)
        assert in_fast_set(fast, RATE)
        assert in_monotone_set(built(size, fmpq(0), fmpq(0), fmpq(0), fmpq(0), fmpq(1, 2), fmpq(1), -size))
