"""Flight and touch-down: against the differential equations, the number of touch-downs, states that must be refused.

Page: proofs/flight.md.
"""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from witnesses.flight import lift_off_state
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.flight import ContactState, Flight
from gspot_verified.compliant.motion.touch_down import flight_end
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason

RUNS = [("1.5", "2", "0.69312"), ("2.5", "0.5", "0.68322")]
STATE = ContactState(
    fmpq(3, 2), fmpq(1, 10), fmpq(-2), arb(fmpq(-1, 4)), arb(fmpq(1, 2)), arb(2), arb(fmpq(-3, 2)), arb(0)
)


def test_the_closed_form_solves_the_equations_of_flight() -> None:
    with mpmath.workdps(20):
        solution = mpmath.odefun(
            lambda _, x: [mpmath.mpf(-1) / 5, x[0], x[1], -x[3]],
            0,
            [mpmath.mpf(1) / 2, mpmath.mpf(2), -mpmath.mpf(3) / 2, -mpmath.mpf(3) / 2],
        )
        with working_bits(120):
            for u in (fmpq(1, 3), fmpq(3)):
                b, V, Y, Z = solution(mpmath.mpf(int(u.p)) / int(u.q))
                flight, there = Flight(STATE), Flight(STATE).landed(arb(u))
                assert contains_witness(there.b, to_fraction(b), 14)
                assert contains_witness(there.V, to_fraction(V), 14)
                assert contains_witness(there.Y, to_fraction(Z), 14)
                assert contains_witness(flight.gap(arb(u)), to_fraction(Y - Z), 14)
                assert contains_witness(flight.gap_rate(arb(u)), to_fraction(V + Z), 14)
                assert there.p.overlaps(arb(fmpq(-1, 4) - u / 10))
                assert there.force.is_zero()


@pytest.mark.parametrize(("beta", "nu", "landing"), RUNS)
def test_touch_down_of_the_paper_runs(beta: str, nu: str, landing: str) -> None:
    start = lift_off_state(beta, nu, "0.001")
    end = flight_end(start, 90)
    assert end.verdict.outcome is Outcome.PROVED
    assert end.lower is not None
    assert end.upper is not None
    assert 0 < end.upper - end.lower < fmpq(1, 10**15)
    with working_bits(120):
        time = fmpq(1, 2) - start.p + start.epsilon * arb(end.lower)
        assert abs(time - arb(landing)) < arb("6e-6")
    assert end.state is not None
    assert end.state.b < 0
    assert end.state.V < 0
    assert end.state.force_rate > 0


@given(
    b=st.integers(-20, 20),
    excess=st.integers(1, 40),
    depth=st.integers(0, 30),
    pull=st.integers(1, 30),
)
def test_the_gap_is_positive_inside_and_negative_beyond_the_bracket(b: int, excess: int, depth: int, pull: int) -> None:
    start = ContactState(
        fmpq(5, 2), fmpq(1, 100), fmpq(-pull), arb(-1), arb(b), arb(depth + excess), arb(-depth), arb(0)
    )
    end = flight_end(start, 60)
    assert end.verdict.outcome is Outcome.PROVED
    assert end.lower is not None
    assert end.upper is not None
    with working_bits(200):
        flight = Flight(start)
        for part in range(1, 12):
            assert flight.gap(arb(end.lower * fmpq(part, 12))) > 0
            assert flight.gap(arb(end.upper * (1 + fmpq(part, 2)))) < 0


def test_a_flight_without_gravity_never_ends() -> None:
    for alpha_2, b in ((fmpq(0), 0), (fmpq(1), 2)):
        end = flight_end(replace(STATE, alpha_2=alpha_2, b=arb(b)), 60)
        assert end.verdict.outcome is Outcome.PROVED
        assert end.state is None
        assert "never ends" in end.verdict.statement
    falling = flight_end(replace(STATE, alpha_2=fmpq(0), b=arb(-1)), 60)
    assert falling.state is not None


@pytest.mark.parametrize(
    "changed",
    [
        {"V": arb(fmpq(3, 2))},
        {"V": arb(1)},
        {"V": arb(2, 1)},
        {"b": arb("nan")},
    ],
    ids=["touching", "no lift-off", "wide", "nan"],
)
def test_what_is_no_certain_flight_is_undecided(changed: dict[str, arb]) -> None:
    end = flight_end(replace(STATE, **changed), 60)
    assert end.verdict.outcome is Outcome.UNDECIDED
    assert end.verdict.reason in (Reason.HYPOTHESIS, Reason.WIDE_INPUT)
    assert end.state is None


def test_a_wide_state_gives_a_wide_bracket_that_holds_the_narrow_one() -> None:
    narrow = flight_end(STATE, 60)
    wide = flight_end(replace(STATE, b=STATE.b + arb(0, "1e-6")), 60)
    assert narrow.lower is not None
    assert wide.lower is not None
    assert wide.lower < narrow.lower
    assert narrow.upper < wide.upper
    assert wide.upper - wide.lower > fmpq(1, 10**7)


def test_a_touch_down_at_which_the_gap_may_stand_still_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    """h' < 0 is asked for on the whole bracket: not <= 0."""
    for rate, outcome in ((arb(0), Outcome.UNDECIDED), (-arb((1, -60)), Outcome.PROVED)):
        monkeypatch.setattr(Flight, "gap_rate", lambda _, u, later=rate: arb(1) if u == 0 else later)
        assert flight_end(STATE, 60).verdict.outcome is outcome


def test_the_rate_of_the_force_in_contact() -> None:
    """lambda' = Z' - Y' = -(Y + lambda) - lambda - V, as long as the contact lasts."""
    state = replace(STATE, V=arb(3), Y=arb(-7), force=arb(5))
    assert state.force_rate == -(-7 + 5) - 5 - 3
    assert replace(STATE, V=arb(-3), Y=arb(7), force=arb(11)).force_rate == -(7 + 11) - 11 + 3
