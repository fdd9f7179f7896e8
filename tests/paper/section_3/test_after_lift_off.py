"""What follows lift-off: what is stated is what is checked, and each condition decides."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.motion.run import ONE_FLIGHT
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.numerics import slow_flights
from gspot_verified.paper.section_3 import after_lift_off, section_3


def run(
    *,
    speed: Any = arb("0.02"),  # noqa: B008
    free: Any = arb("0.1"),  # noqa: B008
    rise: Any = arb("0.21"),  # noqa: B008
    height: Any = arb("-0.2"),  # noqa: B008
    lower: Any = fmpq(1, 9),  # noqa: B008
    upper: Any = fmpq(1, 9),  # noqa: B008
    events: int = 2,
    outcome: Outcome = Outcome.PROVED,
    statement: str = ONE_FLIGHT,
) -> Any:
    """As a run of ε = 1/1000: 300 ε^(4/3) is 0.03, 13 ε^(2/3) 0.13 and 45 ε^(2/3) 0.45; at lift-off b, V and Y are
    ``free``, ``rise`` and ``height``."""
    first = SimpleNamespace(lower=fmpq(-1), velocity=arb(5), state=SimpleNamespace(b=free, V=rise, Y=height))
    last = SimpleNamespace(lower=lower, upper=upper, velocity=-speed, state="at touch-down")
    return SimpleNamespace(
        verdict=SimpleNamespace(outcome=outcome, statement=statement),
        events=(first, last, last)[:events],
        model=SimpleNamespace(epsilon=fmpq(1, 1000)),
    )


@pytest.mark.parametrize(
    ("given", "answer"),
    [
        (run(), True),
        (run(speed=arb("0.0299999")), True),
        (run(speed=arb("0.0300001")), False),
        (run(speed=arb("1e-9")), True),
        (run(speed=arb(0)), False),
        (run(speed=arb("-0.02")), False),
        (run(speed=arb("0.02", "0.02")), None),
        (run(free=arb("0.129999")), True),
        (run(free=arb("0.130001")), False),
        (run(free=arb(0)), False),
        (run(free=arb("-0.1")), False),
        (run(free=arb("0.1", "0.1")), None),
        (run(rise=arb("0.19")), False),
        (run(rise=arb("0.21", "0.1")), None),
        (run(height=arb(0)), False),
        (run(height=arb("0.1")), False),
        (run(lower=fmpq(0)), None),
        (run(lower=fmpq(-1)), None),
        (run(upper=fmpq(449999, 1000000)), True),
        (run(upper=fmpq(450001, 1000000)), None),
        (run(lower=fmpq(450001, 1000000), upper=fmpq(46, 100)), False),
        (run(lower=fmpq(-1), upper=fmpq(-1, 2)), False),
        (run(events=1), False),
        (run(events=3), False),
        (run(statement="another"), False),
        (run(outcome=Outcome.UNDECIDED), None),
        (run(outcome=Outcome.UNDECIDED, events=1), None),
    ],
)
def test_what_a_run_must_have_proved(given: Any, answer: bool | None) -> None:
    assert after_lift_off.as_claimed(given) is answer


@pytest.mark.parametrize(("side", "answer"), [(arb(1), True), (arb(-1), False), (arb(0, 1), None)])
def test_the_side_at_touch_down(monkeypatch: pytest.MonkeyPatch, side: arb, answer: bool | None) -> None:
    monkeypatch.setattr(after_lift_off, "side", lambda state, _: side if state == "at touch-down" else arb(0))
    assert after_lift_off.side_at_touch_down(run()) is answer
    for events in (0, 1, 3):
        assert after_lift_off.side_at_touch_down(run(events=events)) is None


def test_all_runs_that_lift_off_and_both_epsilon_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """The runs are those on the other side of what takes an impact in Sec. 3."""
    assert {
        beta: tuple(nu for nu in section_3.FACTORS if nu != 1 and (1 if nu < 1 else -1) != side)
        for beta, side in section_3.IMPACT["corrected"].items()
    } == after_lift_off.LIFTING
    asked = []

    def of(beta: fmpq, nu: fmpq, epsilon: fmpq) -> Any:
        asked.append((beta, nu, epsilon))
        return run(events=0 if epsilon == fmpq(1, 1000) else 2)

    monkeypatch.setattr(after_lift_off, "run_of", of)
    monkeypatch.setattr(after_lift_off, "side", lambda *_: arb(1))
    entry = after_lift_off.ENTRIES["3-after-lift-off"]()
    assert len(asked) == len(set(asked)) == 8
    assert [check.agrees for check in entry.checks] == [False, None]
    assert entry.checks[0].finding.count("ε = 1/1000000000: v = [-0.02") == 4


def test_the_statement_names_what_is_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(after_lift_off, "run_of", lambda *_: run(events=0))
    entry = after_lift_off.ENTRIES["3-after-lift-off"]()
    first, last = (f"10^-{len(str(int(1 / epsilon))) - 1}" for epsilon in after_lift_off.EPSILONS)
    assert [1 / epsilon for epsilon in after_lift_off.EPSILONS] == [10**3, 10**9]
    assert f"at ε = {first} and {last}, has exactly one flight" in entry.statement
    assert f"0 < -v < {after_lift_off.MOST} ε^({after_lift_off.POWER})" in entry.statement
    assert f"0 < b < {after_lift_off.MOST_FREE} ε^({after_lift_off.FREE_POWER})" in entry.statement
    assert f"less than {after_lift_off.MOST_TIME} ε^({after_lift_off.TIME_POWER}) after the G-spot" in entry.statement
    assert f"late enough and has t <= {slow_flights.LATEST} (proofs/flight.md, section 5)" in entry.note


def test_a_lift_off_can_be_too_late_for_the_note() -> None:
    """What it repeats is proved up to a time, and not much later."""
    assert slow_flights.one_flight("3/2", "1/100", 2).outcome is Outcome.PROVED
    assert slow_flights.one_flight("3/2", "1/100", 2, "1/3").outcome is Outcome.UNDECIDED
