"""Runs of the model with all their events: the paper's fifteen, times of touch-down, what must stay undecided."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from witnesses.flight import lift_off_by_series
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.motion.contact_series import MAX_WORK
from gspot_verified.compliant.motion.first_zero import FirstZero, first_zero
from gspot_verified.compliant.motion.run import (
    IMPACT,
    ONE_FLIGHT,
    TRIVIAL,
    CompliantRun,
    _Followed,
    _next_contact,
    events,
)
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict
from gspot_verified.paper.numerics.paper_state import paper_state

NUS = ("1/4", "1/2", "1", "2", "4")
VERDICTS = {
    "1/2": (IMPACT,) * 5,
    "3/2": (IMPACT, IMPACT, TRIVIAL, ONE_FLIGHT, ONE_FLIGHT),
    "5/2": (ONE_FLIGHT, ONE_FLIGHT, TRIVIAL, IMPACT, IMPACT),
}
FIFTEEN = [(beta, nu, verdict) for beta, row in VERDICTS.items() for nu, verdict in zip(NUS, row, strict=True)]

# Touch-down after the start, by independent prototypes: power series in contact, root finding in flight.
TOUCH_DOWN = {
    ("3/2", "2", "1e-4"): "0.55084605490847719780",
    ("3/2", "2", "1e-5"): "0.51307067000298769388",
    ("3/2", "2", "1e-6"): "0.50325893525683302821",
    ("3/2", "2", "1e-9"): "0.50004422198376101390",
    ("5/2", "1/2", "1e-4"): "0.54942531483749593409",
    ("5/2", "1/2", "1e-5"): "0.51249099375764133147",
    ("5/2", "1/2", "1e-6"): "0.50304597403913484763",
    ("5/2", "1/2", "1e-9"): "0.50003969472218972272",
}


def run_of(beta: str, nu: str, epsilon: str, digits: int = 15) -> CompliantRun:
    model = compliant_model(beta, epsilon)
    return events(model, paper_state(model, nu), digits)


@pytest.mark.parametrize(("beta", "nu", "verdict"), FIFTEEN)
def test_the_fifteen_runs_of_the_paper_at_one_small_epsilon(beta: str, nu: str, verdict: str) -> None:
    run = run_of(beta, nu, "1e-6")
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement == verdict
    names = [event.name for event in run.events]
    assert names == {IMPACT: ["contact for ever from"], TRIVIAL: [], ONE_FLIGHT: ["lift-off", "touch-down"]}[verdict]


@pytest.mark.parametrize(("case", "wanted"), TOUCH_DOWN.items(), ids=str)
def test_touch_down_times(case: tuple[str, str, str], wanted: str) -> None:
    run = run_of(*case)
    assert run.verdict.statement == ONE_FLIGHT
    lift, land = run.events
    assert land.lower < land.upper < land.lower + fmpq(1, 10**14)
    assert lift.upper < land.lower
    with working_bits(200):
        since = arb(land.lower - run.start).union(arb(land.upper - run.start))
        assert abs(since - arb(wanted)) < arb("1e-14")
        assert lift.velocity > 0
        assert land.velocity < 0


@pytest.mark.parametrize(("beta", "nu", "series"), [("3/2", "2", ("1.5", "2")), ("5/2", "1/2", ("2.5", "0.5"))])
def test_lift_off_at_a_large_epsilon_by_power_series(beta: str, nu: str, series: tuple[str, str]) -> None:
    run = run_of(beta, nu, "1/1000", digits=20)
    assert run.verdict.statement == ONE_FLIGHT
    p, (_, V, _) = lift_off_by_series(*series, "0.001")
    exact = -to_fraction(p)
    lift = run.events[0]
    assert lift.lower < fmpq(exact.numerator, exact.denominator) < lift.upper
    assert contains_witness(lift.velocity, to_fraction(V) / 1000, 30)


def test_more_digits_give_nested_brackets() -> None:
    coarse, fine = (run_of("3/2", "2", "1e-9", digits) for digits in (12, 25))
    for first, second in zip(coarse.events, fine.events, strict=True):
        assert first.lower < second.lower < second.upper < first.upper
    assert fine.events[1].upper - fine.events[1].lower < fmpq(1, 10**22)


def test_a_lift_off_whose_velocity_is_not_enclosed_says_so() -> None:
    model = compliant_model(2, "1/300", alpha_2=0)
    run = events(model, compliant_state("5/16", "-185/512", "-1/30000", "-17/4800", "-7/720000"), flights=1)
    assert run.verdict.outcome is Outcome.UNDECIDED
    assert [event.velocity.is_finite() for event in run.events] == [True, True, False]
    assert "after the start, v has no enclosure" in str(run)
    assert "no information" not in str(run)


def test_units_other_than_the_normal_form() -> None:
    """alpha_1 = -2: t' = 2 t; b, lambda are four times as large, v twice."""
    one = run_of("3/2", "2", "1e-6")
    model = compliant_model("3/2", "5e-7", alpha_1=-2, alpha_2=-8)
    start = compliant_state("1/2", -8, "-8e-12", 0, "-4e-12")
    two = events(model, start)
    assert two.verdict.statement == ONE_FLIGHT
    for first, second in zip(one.events, two.events, strict=True):
        assert first.lower < 2 * second.upper
        assert 2 * second.lower < first.upper
        assert second.velocity.overlaps(2 * first.velocity)


@pytest.mark.parametrize(("beta", "alpha_2"), [("3/2", -1), ("3/2", 1)], ids=["one flight", "it never ends"])
def test_what_follows_a_lift_off_rests_on_it(monkeypatch: pytest.MonkeyPatch, beta: str, alpha_2: int) -> None:
    model = compliant_model(beta, "1e-4", alpha_2=alpha_2)
    run = events(model, paper_state(model, 2))
    assert run.verdict.outcome is Outcome.PROVED
    assert str(run.events[0].evidence) in str(run.verdict.evidence)

    def not_shown(*arguments: Any) -> FirstZero:
        """The bracket without its verdict."""
        found = first_zero(*arguments)
        return dataclasses.replace(found, verdict=Verdict.undecided("it", Reason.BUDGET, "for the test"))

    monkeypatch.setattr("gspot_verified.compliant.motion.run.first_zero", not_shown)
    assert events(model, paper_state(model, 2)).verdict.outcome is Outcome.UNDECIDED


def test_a_flight_that_never_ends() -> None:
    """alpha_2 > 0, beta > 1: the mean force is negative; contact is lost before the G-spot, and b grows in flight."""
    model = compliant_model("3/2", "1e-4", alpha_2=1)
    run = events(model, paper_state(model, 2))
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement == "the flight never ends"
    assert [event.name for event in run.events] == ["lift-off"]
    assert run.events[0].upper < 0


def test_a_flight_that_ends_nowhere_for_all_that_b_is_negative() -> None:
    """alpha_2 > 0 and b < 0 at lift-off: shown by pieces of time."""
    model = compliant_model("5/2", "1e-4", alpha_2=1)
    run = events(model, paper_state(model, 2))
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement == "the flight never ends"
    start = run.events[-1].state
    assert start.b < 0
    with mpmath.workdps(40):  # the gap itself, where it is least
        b, V, Y = (mpmath.mpf(value.str(30, radius=False)) for value in (start.b, start.V, start.Y))
        places = [mpmath.mpf(k) / 4 for k in range(1, 8000)]
        gaps = [V * u + b * u**2 / 2 + mpmath.mpf("1e-4") * u**3 / 6 - Y * mpmath.expm1(-u) for u in places]
    assert all(gap > 0 for gap in gaps)
    assert gaps[-1] > gaps[-2]


def test_a_budget_that_ends_is_named() -> None:
    model = compliant_model("3/2", "1/10", alpha_2=1)
    short = events(model, paper_state(model, 2), budget=2)
    assert short.verdict.outcome is Outcome.UNDECIDED
    assert short.events == ()
    assert "its budget of 2 (its work, rate times time)" in short.verdict.detail
    assert events(model, paper_state(model, 2)).events


@pytest.mark.parametrize(("value", "outcome"), [(arb(-1), Outcome.PROVED), (arb(1), None), (arb(0, 1), None)])
def test_a_contact_is_lost_again_only_where_k_is_certainly_negative(
    monkeypatch: pytest.MonkeyPatch, value: arb, outcome: Outcome | None
) -> None:
    state = run_of("3/2", "2", "1e-6").events[1].state
    monkeypatch.setattr("gspot_verified.compliant.motion.run.side", lambda *_: value)
    found = _next_contact(state, 60, 1, (Reason.BUDGET, "not found"))
    assert found.outcome is (outcome or Outcome.UNDECIDED)
    assert (found.reason is Reason.BUDGET) is (outcome is None)
    assert outcome is None or found.statement == "one flight, then a contact that is lost again"


def test_the_budget_has_an_end() -> None:
    model = compliant_model("3/2", "1e-6")
    trivial = paper_state(model, 1)
    assert events(model, trivial, budget=MAX_WORK).verdict.statement == TRIVIAL
    for budget in (MAX_WORK + 1, True, 2.5):
        with pytest.raises(ValueError, match="budget"):
            events(model, trivial, budget=budget)  # type: ignore[arg-type]


def test_bad_input() -> None:
    model = compliant_model("3/2", "1/1000")
    with pytest.raises(ValueError, match="digits"):
        events(model, paper_state(model, 2), 0)
    with pytest.raises(ValueError, match="budget"):
        events(model, paper_state(model, 2), budget=0)
    with pytest.raises(ValueError, match="p: expected"):
        events(model, compliant_state("-1/2", 1, -1, 0, 0))
    with pytest.raises(ValueError, match="nu"):
        paper_state(model, 0)
    with pytest.raises(TypeError):
        paper_state(model, 0.5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="verdict"):
        bool(run_of("3/2", "1", "1e-6"))


def test_text_and_json() -> None:
    run = run_of("3/2", "2", "1e-9")
    assert "touch-down: [0.500044221983761013" in str(run)
    data = json.loads(json.dumps(run.to_json()))
    assert [event["event"] for event in data["events"]] == ["lift-off", "touch-down"]
    assert data["verdict"]["outcome"] == "proved"


@pytest.mark.parametrize(("beta", "nu", "verdict"), [("3/2", "2", ONE_FLIGHT), ("5/2", "4", IMPACT)])
def test_a_run_does_not_depend_on_the_units(beta: str, nu: str, verdict: str) -> None:
    """alpha_1 = -2, sigma = 1/2: times in halves, v twice, by exact_solution.md, section 1."""
    sigma, normal = fmpq(1, 2), compliant_model(beta, "1e-6")
    model = compliant_model(alpha_1=-2, alpha_2=-8, alpha_3=2 * normal.alpha_3, epsilon=normal.epsilon * sigma)
    state = paper_state(normal, nu)
    scaled = compliant_state(state.p, state.b / sigma**2, state.y, state.v / sigma, state.z)
    one, two = events(normal, state), events(model, scaled)
    assert one.verdict.statement == two.verdict.statement == verdict
    assert [event.name for event in one.events] == [event.name for event in two.events]
    for first, second in zip(one.events, two.events, strict=True):
        assert second.lower <= second.upper
        if verdict == ONE_FLIGHT:
            assert max(first.lower * sigma, second.lower) <= min(first.upper * sigma, second.upper)
            with working_bits(200):
                assert first.velocity.is_finite()
                assert second.velocity.is_finite()
                assert (first.velocity / sigma).overlaps(second.velocity)
                assert abs(second.velocity).rad() < abs(second.velocity).lower() / 10**6


@pytest.mark.parametrize(("reason", "text"), [(Reason.BUDGET, "its budget of 7 "), (Reason.WIDE_INPUT, "too wide")])
def test_what_was_lacking_is_named(reason: Reason, text: str) -> None:
    followed = _Followed(compliant_model("3/2", "1/10"), compliant_state("1/2", -2, 0, 0, 1), 64, 7)
    assert followed._open(reason)[0] is reason
    assert text in followed._open(reason)[1]


@pytest.mark.parametrize("digits", [1, 80])
def test_the_first_and_the_last_number_of_digits(digits: int) -> None:
    state = compliant_state("1/2", -1, "-1/25", 0, "-1/50")
    assert events(compliant_model("3/2", "1/10"), state, digits).verdict.statement == TRIVIAL
