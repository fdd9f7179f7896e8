"""What follows the first flight: each step asks for what it says, without a run."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_6 import section_7 as ledger
from gspot_verified.paper.section_6.section_7 import LIFT_OFF, STICK, TOUCH_DOWN
from gspot_verified.scenes.scene.run import IMPACT, RunEvent

AGAIN = (LIFT_OFF, TOUCH_DOWN, LIFT_OFF)
FIRST = next(iter(ledger.RUNS))


def events(*names: str, late: fmpq = fmpq(0)) -> tuple[Any, ...]:  # noqa: B008
    """One event a unit of time, each as late."""
    return tuple(RunEvent(name, fmpq(k + late), fmpq(k + late)) for k, name in enumerate(names))


def run(*names: str, outcome: Outcome = Outcome.PROVED) -> Any:
    return SimpleNamespace(events=events(*names), verdict=SimpleNamespace(outcome=outcome))


@pytest.mark.parametrize(
    ("found", "answer"),
    [
        (run(*AGAIN), True),
        (run(LIFT_OFF, TOUCH_DOWN, IMPACT, LIFT_OFF), True),
        (run(LIFT_OFF, TOUCH_DOWN, STICK, LIFT_OFF), False),
        (run(LIFT_OFF, TOUCH_DOWN), False),
        (run(*AGAIN, TOUCH_DOWN), False),
        (run(*AGAIN, outcome=Outcome.UNDECIDED), None),
    ],
)
def test_exactly_these_events(monkeypatch: pytest.MonkeyPatch, found: Any, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "run_of", lambda _: found)
    assert ledger.happens(FIRST) is answer


@pytest.mark.parametrize(
    ("first", "second", "answer"),
    [
        (events(*AGAIN), events(*AGAIN), True),
        (events(*AGAIN, late=fmpq(99, 10**6)), events(*AGAIN), True),
        (events(*AGAIN), events(*AGAIN, late=fmpq(99, 10**6)), True),
        (events(*AGAIN, late=fmpq(101, 10**6)), events(*AGAIN), False),
        (events(*AGAIN), events(*AGAIN, late=fmpq(101, 10**6)), False),
        (events(*AGAIN), (*events(*AGAIN)[:2], *events(IMPACT, IMPACT, LIFT_OFF, late=fmpq(1))[2:]), False),
        (events(*AGAIN), events(*AGAIN)[:2], False),
        (events(*AGAIN)[:2], events(*AGAIN), False),
        (events(LIFT_OFF, STICK), events(LIFT_OFF, TOUCH_DOWN), False),
    ],
)
def test_nearly_the_same_events(first: Any, second: Any, answer: bool) -> None:
    assert ledger.near(first, list(second)) is answer


def test_the_float_runs_are_of_the_same_start_and_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """And the impact that the certified run may show is left out."""
    asked = {}

    def float_run(scene: Any, *_: Any) -> Any:
        case = ledger.Case(scene.parameters["chi"], scene.epsilon, scene.until)
        asked[case] = scene.parameters["beta"]
        return run(*ledger.RUNS[case])

    monkeypatch.setattr(
        ledger, "load_scene", lambda _, beta, nu, chi, epsilon, until: scene_of(beta, nu, chi, epsilon, until)
    )
    monkeypatch.setattr(ledger, "float_run", float_run)
    monkeypatch.setattr(ledger, "is_far", lambda _: True)
    monkeypatch.setattr(ledger, "run_of", lambda case: run(*ledger.RUNS[case], IMPACT))
    assert all(ledger.floats_agree(case) for case in ledger.RUNS)
    assert asked == dict.fromkeys(ledger.RUNS, fmpq(5, 2))
    monkeypatch.setattr(ledger, "run_of", lambda case: run(*ledger.RUNS[case], STICK))
    assert not any(ledger.floats_agree(case) for case in ledger.RUNS)
    monkeypatch.setattr(ledger, "run_of", lambda case: run(*ledger.RUNS[case], IMPACT))
    monkeypatch.setattr(ledger, "is_far", lambda _: False)
    assert not any(ledger.floats_agree(case) for case in ledger.RUNS)


@pytest.mark.parametrize(
    ("names", "b", "answer"),
    [
        (AGAIN, [0.0, 60.0, 60.0], True),
        (AGAIN, [60.0, 60.0, 50.0], False),
        (AGAIN, [60.0, 60.0, 51.0], True),
        (AGAIN[:2], [60.0, 60.0, 60.0], None),
        ((), [60.0, 60.0, 60.0], None),
    ],
)
def test_the_last_lift_off_is_far_from_the_g_spot(names: tuple[str, ...], b: list[float], answer: bool | None) -> None:
    found = run(*names)
    found.samples = SimpleNamespace(columns={"t": [0.0, 1.5, 2.0], "b": b})
    assert ledger.is_far(found) is answer


def scene_of(beta: fmpq, nu: fmpq, chi: int, epsilon: fmpq, until: fmpq) -> Any:
    assert nu == fmpq(1, 4)
    return SimpleNamespace(parameters={"beta": beta, "chi": chi}, epsilon=epsilon, until=until)


def test_the_statement_names_what_is_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "run_of", lambda case: run(*ledger.RUNS[case]))
    monkeypatch.setattr(ledger, "floats_agree", lambda _: True)
    statement = ledger.ENTRIES["7-lift-off-again"]().statement
    assert "with β = 5/2, ν = 1/4, u(0) = 70 loses contact again after its first flight. Its events, but" in statement
    for part in (
        "χ = 1, ε = 1/100, up to t = 6/5: lift-off, touch-down, lift-off;",
        "χ = 1, ε = 1/1000, up to t = 13/20: lift-off, touch-down, lift-off;",
        "χ = 0, ε = 1/100, up to t = 11/10: lift-off, touch-down, stick, lift-off",
    ):
        assert part in statement
