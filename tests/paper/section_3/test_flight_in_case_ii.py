"""The flight in Case II: each step asks for what it says, without a run."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.run import events
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.section_3 import flight_in_case_ii as ledger

START = paper_state(compliant_model(fmpq(1, 2), ledger.EPSILON, alpha_2=ledger.SIGN), ledger.NU)


class Run(NamedTuple):
    """A run of which the events alone are looked at."""

    events: tuple[Any, ...]


@pytest.mark.parametrize("line", ["1", "1 - u", "1 - 2*rate*u", "2 - rate*u", "-rate*u", "1 + rate*u", "w - rate*u"])
def test_a_line_that_is_no_tangent_bounds_nothing(monkeypatch: pytest.MonkeyPatch, line: str) -> None:
    assert ledger.is_above_its_tangent()
    monkeypatch.setattr(ledger, "TANGENT", line)
    assert not ledger.is_above_its_tangent()
    assert ledger.is_a_sum_of_positive_terms() is None


@pytest.mark.parametrize("velocity", ["m*rate - d", "-m*rate", "-d"])
def test_a_body_that_may_fall_does_not_move_away(monkeypatch: pytest.MonkeyPatch, velocity: str) -> None:
    assert ledger.motion_increases()
    monkeypatch.setitem(ledger.AT_LIFT_OFF, "v", velocity)
    assert ledger.motion_increases() is None


@pytest.mark.parametrize(
    ("name", "wrong"),
    [("b", "b - alpha2*u"), ("v", "v + b*u"), ("y", "-m + v*u + b*u^2/2"), ("z", "-m*w^2"), ("z", "m")],
)
def test_each_equation_of_the_free_motion_counts(monkeypatch: pytest.MonkeyPatch, name: str, wrong: str) -> None:
    assert ledger.is_free_motion()
    monkeypatch.setitem(ledger.FLIGHT, name, wrong)
    assert not ledger.is_free_motion()


def test_what_is_run_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "runs_do_not_touch_down", lambda: True)
    monkeypatch.setattr(ledger, "begins_as_stated", lambda _: True)
    runs = ledger.ENTRIES["3-flight-persists"]().checks[-1].what
    assert "with α_2 = 1, ε = 1/100, ν = 1/4, β = 1/4, 1/2, 9/10: lift-off" in runs


@pytest.mark.parametrize("wrong", ["-m + v*u - b*u^2/2", "-m + v*u + b*u^2/2 - alpha2*u^3/6"])
def test_a_distance_that_bends_back_is_not_positive(monkeypatch: pytest.MonkeyPatch, wrong: str) -> None:
    monkeypatch.setattr(ledger, "is_free_motion", lambda: True)
    assert ledger.never_closes() is True
    assert ledger.is_a_sum_of_positive_terms()
    monkeypatch.setitem(ledger.FLIGHT, "y", wrong)
    assert ledger.never_closes() is False
    assert ledger.is_a_sum_of_positive_terms() is None


@pytest.mark.parametrize("wrong", ["-2*m + v*u + b*u^2/2", "-m - v*u + b*u^2/2"])
def test_a_distance_begins_at_0_with_a_positive_slope(monkeypatch: pytest.MonkeyPatch, wrong: str) -> None:
    monkeypatch.setitem(ledger.FLIGHT, "y", wrong)
    assert ledger.never_closes() is None


def test_a_falling_b_ends_the_flight(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "SIGN", -1)
    assert ledger.never_closes() is False
    assert ledger.motion_increases() is False


def test_the_flights_that_are_run_have_the_hypotheses(monkeypatch: pytest.MonkeyPatch) -> None:
    beta = fmpq(1, 2)
    assert ledger.begins_as_stated(beta)
    found = events(compliant_model(beta, ledger.EPSILON, alpha_2=ledger.SIGN), START, ledger.DIGITS)
    assert found.verdict.statement == "the flight never ends"
    for wrong in ({"p": arb(-1)}, {"b": arb(-1)}, {"Y": arb(1)}):
        state = replace(found.events[0].state, **wrong)
        monkeypatch.setattr(ledger, "events", lambda *_, state=state: Run((replace(found.events[0], state=state),)))
        assert ledger.begins_as_stated(beta) is False
    monkeypatch.setattr(ledger, "events", lambda *_: Run(()))
    assert ledger.begins_as_stated(beta) is None
