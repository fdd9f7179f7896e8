"""Runs from states of all kinds against the plain Taylor method, phase after phase. Page: proofs/flight.md."""

from __future__ import annotations

import pytest
from flint import fmpq
from witnesses.hybrid_run import disagreement

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_model, compliant_state
from gspot_verified.compliant.motion.run import IMPACT, ONE_FLIGHT, events
from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.paper.numerics.paper_state import paper_state


@pytest.mark.parametrize(
    ("beta", "epsilon", "alpha_1", "alpha_2", "nu"),
    [("7/16", "1/137", "-15/16", "11/8", "61/32"), ("13/16", "1/114", "-13/8", "7/8", "25/16")],
)
def test_an_impact_without_collision_in_case_ii(beta: str, epsilon: str, alpha_1: str, alpha_2: str, nu: str) -> None:
    """alpha_2 > 0: the sets take the pull upwards into their load."""
    model = compliant_model(beta, epsilon, alpha_1=alpha_1, alpha_2=alpha_2)
    run = events(model, paper_state(model, nu))
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement == IMPACT
    assert disagreement(run) is None


# beta, epsilon, alpha_1, alpha_2; p, b, y/epsilon^2, v/epsilon, z/epsilon^2: drawn at random, Cases I, II and III
STATES = [
    ("1/4 1/589 -29/16 15/16 9/64 53/32 23/32 5/16 43/32", "the flight never ends"),
    ("13/32 1/746 -19/16 17/16 11/64 -3/64 -45/64 -83/64 67/64", "the flight never ends"),
    ("9/32 1/77 -9/8 3/4 7/8 -11/32 -53/16 43/32 -27/32", "2 flights, and the last one never ends"),
    ("53/64 1/57 -19/16 7/4 47/64 -93/64 -19/8 -31/16 -5/64", "2 flights, and the last one never ends"),
    ("3 1/53 -11/16 -9/8 67/64 13/16 -115/64 7/16 33/64", ONE_FLIGHT),
    (
        "215/64 1/147 -13/16 -13/16 23/64 -41/32 -45/64 -15/64 -3/16",
        "exactly 2 flights, then contact for ever: an impact without collision",
    ),
    pytest.param("29/64 1/183 -27/16 -5/4 9/32 1/64 -13/16 1/32 -9/64", ONE_FLIGHT, marks=pytest.mark.slow),
    pytest.param("57/64 1/199 -2 -11/16 9/64 -87/64 -7/16 107/64 11/8", ONE_FLIGHT, marks=pytest.mark.slow),
    pytest.param("21/64 1/78 -25/16 21/16 13/64 -15/64 -5/16 19/32 25/64", ONE_FLIGHT, marks=pytest.mark.slow),
    pytest.param(
        "7/16 1/326 -27/16 -11/8 27/32 -1/2 -67/32 117/64 5/64",
        "exactly 2 flights, then contact for ever: an impact without collision",
        marks=pytest.mark.slow,
    ),
    pytest.param(
        "15/64 1/506 -15/16 7/16 29/32 -9/64 -71/16 -109/64 -13/8",
        "4 flights, and the last one never ends",
        marks=pytest.mark.slow,
    ),
]
TWO_FLIGHTS = STATES[2][0]


def given(text: str) -> tuple[CompliantModel, CompliantState]:
    beta, epsilon, first, second, p, b, Y, V, Z = (fmpq(*map(int, f"{one}/1".split("/")[:2])) for one in text.split())
    model = compliant_model(beta, epsilon, alpha_1=first, alpha_2=second)
    return model, compliant_state(p, b, Y * epsilon**2, V * epsilon, Z * epsilon**2)


@pytest.mark.parametrize(("text", "statement"), STATES)
def test_a_run_is_followed_to_its_end(text: str, statement: str) -> None:
    run = events(*given(text))
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement == statement
    assert disagreement(run) is None
    for event in run.events:
        assert str(event.evidence) in str(run.verdict.evidence)


def test_a_budget_of_flights_is_named() -> None:
    run = events(*given(TWO_FLIGHTS), flights=1)
    assert run.verdict.outcome is Outcome.UNDECIDED
    assert run.verdict.reason is Reason.BUDGET
    assert "its budget of one flight" in run.verdict.detail
    assert [event.name for event in run.events] == ["lift-off", "touch-down", "lift-off"]
    for flights in (0, True, 2.5):
        with pytest.raises(ValueError, match="flights"):
            events(*given(TWO_FLIGHTS), flights=flights)  # type: ignore[arg-type]
