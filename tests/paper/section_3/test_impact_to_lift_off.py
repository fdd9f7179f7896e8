"""An impact that ends in lift-off: what the boxes and the samples must show, without a simulation."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_3 import impact_to_lift_off as ledger
from gspot_verified.scenes.scene.samples import Boxes, Samples

QUARTER, LOST = fmpq(1, 4), fmpq(25)


def box(**values: Any) -> ledger.Box:
    return {name: arb(value) if isinstance(value, int | float) else value for name, value in values.items()}


def motion() -> list[ledger.Box]:
    """The start, the G-spot, a box after it, and two boxes after each turn: of p, v, λ_N (by z) and y."""
    return [
        box(t=0, p=0.5, b=-0.2, v=0, lambda_N=1, z=-1, u=70),
        box(t=1, p=arb(0, 0.001), b=-0.1, v=-0.01, lambda_N=20, z=-1, u=69),
        box(t=2, p=-0.01, b=-0.1, v=-0.02, lambda_N=30, z=-1, u=68),
        box(t=3, p=-0.01, b=2, v=-0.1, lambda_N=300, z=-1, u=66),
        box(t=4, p=-0.01, b=2, v=-0.1, lambda_N=400, z=-1, u=65),
        box(t=5, p=-0.001, b=4, v=-0.2, lambda_N=900, z=-1, u=60),
        box(t=6, p=0.001, b=5, v=-0.2, lambda_N=1100, z=-1, u=58),
        box(t=7, p=0.01, b=8, v=-0.1, lambda_N=1200, z=0, u=55),
        box(t=8, p=0.02, b=9, v=-0.1, lambda_N=1000, z=0, u=50),
        box(t=9, p=0.1, b=10, v=0.1, lambda_N=900, z=0, u=46),
    ]


def test_a_motion_as_it_is_claimed() -> None:
    assert ledger.as_claimed(motion(), LOST) is True


@pytest.mark.parametrize(
    ("changes", "answer"),
    [
        ({2: {"b": 0.1}}, False),
        ({1: {"v": -0.03}}, False),
        ({1: {"v": 0.01}}, False),
        ({1: {"lambda_N": 150}}, False),
        ({1: {"lambda_N": -1}}, False),
        ({1: {"lambda_N": arb(130, 20)}}, None),
        ({1: {"b": arb(-1, 1.5)}}, None),  # b at the G-spot
        ({1: {"z": 1}}, False),  # the force falls at the G-spot
        ({1: {"z": arb(0, 1)}}, None),
        ({place: {"lambda_N": 999} for place in (6, 7, 8)}, False),
        ({6: {"lambda_N": 999}, 7: {"lambda_N": arb(1000, 1)}, 8: {"lambda_N": 999}}, None),
        ({9: {"u": 44}}, False),
        ({9: {"u": arb(45, 1)}}, None),
        ({9: {"b": 0.5}}, False),  # p falls again
        ({9: {"z": -1}}, False),  # the force grows again
        ({9: {"v": -0.1}}, False),  # y does not rise
        ({3: {"b": 0.5}}, None),  # p turns later, perhaps with v
        ({3: {"b": 0.5}, 4: {"b": 0.5}, 5: {"b": 0.9, "p": 0.001}, 6: {"b": 0.9}}, False),  # after v
        ({8: {"v": arb(0, 1), "z": 2}}, None),  # y turns perhaps with the force
    ],
)
def test_each_part_of_the_claim_decides(changes: dict[int, dict[str, Any]], answer: bool | None) -> None:
    boxes = motion()
    for place, values in changes.items():
        boxes[place] |= box(**values)
    assert ledger.as_claimed(boxes, LOST) is answer


def test_a_motion_that_does_not_pass_the_spot_shows_nothing() -> None:
    assert ledger.as_claimed(motion()[:2], LOST) is None
    assert ledger.as_claimed([], LOST) is None


@pytest.mark.parametrize(("slower", "answer"), [(60, False), (46, False), (45.5, True)])
def test_a_stop_before_lift_off_is_refused(slower: float, answer: bool) -> None:
    boxes = motion()
    for at in boxes:
        at["u"] -= slower
    assert ledger.as_claimed(boxes, LOST) is answer


def test_a_run_without_boxes_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    verdict = SimpleNamespace(outcome=Outcome.PROVED)
    run = SimpleNamespace(events=[SimpleNamespace(name=ledger.LIFT_OFF)], verdict=verdict, samples=None)
    monkeypatch.setattr(ledger, "run_of", lambda _: run)
    monkeypatch.setattr(ledger, "float_run", lambda *_: run)
    for none in (None, SimpleNamespace(boxes=None)):
        run.samples = none
        assert ledger.boxes_of(QUARTER) == []
        assert ledger.is_shown(QUARTER) is None
        assert ledger.floats_agree(QUARTER) is None
        assert ledger._told(QUARTER) == "ν = 1/4: turns at t = ; lift-off with u = "


def test_near_is_two_steps_of_the_float_samples() -> None:
    assert 2 * ledger.scene_of(QUARTER).until / (ledger._FLOATS[2] - 1) == ledger.FLOAT_NEAR


def test_where_no_sign_is_certain_the_turn_can_be_anywhere() -> None:
    boxes = [box(t=t, p=-1, b=arb(1, 1), v=0, lambda_N=1, z=0) for t in (1, 2, 4)]
    answer, time = ledger.turns(boxes)["p"]
    assert answer is None
    assert time.contains(1)
    assert time.contains(4)


@pytest.mark.parametrize(
    ("signs", "answer"),
    [
        ([-1, -1, 1], True),
        ([-1, None, None, 1, 1], True),
        ([-1, None, -1, 1], None),
        ([None, -1, 1], None),
        ([-1, 1, None], None),
        ([-1, None], None),
        ([None], None),
        ([-1, 1, -1], False),
        ([-1, None, 1, None, -1], False),
        ([1, -1], False),
        ([-1, -1], False),
        ([1], False),
        ([], None),
    ],
)
def test_one_turn(signs: list[int | None], answer: bool | None) -> None:
    assert ledger.one_turn(signs, -1) is answer
    assert ledger.one_turn([None if sign is None else -sign for sign in signs], 1) is answer


def test_the_time_of_a_turn_is_between_the_certain_signs() -> None:
    (_, time), *_ = ledger.turns(motion()[2:]).values()
    assert time.contains(2)
    assert time.contains(3)
    assert not time.contains(4)


def test_boxes_end_where_slip_ends() -> None:
    columns = {"t": np.array([0.0, 1.0, 2.0])}
    boxes = Boxes(columns, {"t": columns["t"] + 1}, ("slip", "slip", "flight"))
    found = ledger.slip_boxes(boxes)
    assert len(found) == 2
    assert found[1]["t"].contains(1)
    assert found[1]["t"].contains(2)
    assert ledger.rows_of_slip(("slip", "slip")) == 2


def samples(**changes: Any) -> Samples:
    columns = {
        "t": [0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
        "p": [1.0, -1.0, 0.0, 1.0, 2.0, -9.0],
        "v": [0.0, -1.0, -2.0, -1.0, 1.0, -9.0],
        "lambda_N": [1.0, 10.0, 500.0, 1100.0, 900.0, 9999.0],
        "y": [0.0, -1.0, -2.0, -3.0, -4.0, -9.0],
        "u": [70.0, 69.0, 60.0, 50.0, 46.0, 0.0],
    } | changes
    return Samples({name: np.array(column) for name, column in columns.items()}, (*5 * ["slip"], "flight"))


@pytest.mark.parametrize(
    ("changes", "answer"),
    [
        ({}, True),
        ({"lambda_N": [1.0, 10.0, 500.0, 999.0, 900.0, 9999.0]}, False),
        ({"lambda_N": [1.0, 1100.0, 500.0, 999.0, 900.0, 9999.0]}, False),
        ({"u": [70.0, 69.0, 60.0, 50.0, 44.0, 0.0]}, False),
    ],
)
def test_the_samples(changes: dict[str, Any], answer: bool) -> None:
    assert ledger.as_sampled(samples(**changes), LOST) is answer
    assert ledger.extremes(samples()) == {"p": 1, "v": 2, "lambda_N": 3, "y": 4}


@pytest.mark.parametrize(("shift", "answer"), [(0.0, True), (0.25, None), (1.5, False)])
def test_a_float_run_beside_the_boxes(monkeypatch: pytest.MonkeyPatch, shift: float, answer: bool | None) -> None:
    times = {"p": 2.5, "v": 4.5, "lambda_N": 6.5, "y": 8.5}
    monkeypatch.setattr(ledger, "FLOAT_NEAR", fmpq(6, 10))
    monkeypatch.setattr(ledger, "scene_of", lambda _: "scene")
    monkeypatch.setattr(ledger, "slip_boxes", lambda _: motion())
    monkeypatch.setattr(ledger, "run_of", lambda _: SimpleNamespace(samples=SimpleNamespace(boxes="boxes")))
    monkeypatch.setattr(ledger, "as_sampled", lambda *_: True)
    monkeypatch.setattr(
        ledger, "extremes", lambda _: {name: fmpq(int(4 * (time + shift)), 4) for name, time in times.items()}
    )
    events = [SimpleNamespace(name=ledger.LIFT_OFF)]
    monkeypatch.setattr(ledger, "float_run", lambda *_: SimpleNamespace(samples="samples", events=events))
    assert ledger.floats_agree(QUARTER) is answer
    events.append(SimpleNamespace(name="touch-down"))
    assert ledger.floats_agree(QUARTER) is False


def test_the_only_event_is_lift_off(monkeypatch: pytest.MonkeyPatch) -> None:
    names = [ledger.LIFT_OFF]
    verdict = SimpleNamespace(outcome=Outcome.PROVED)
    monkeypatch.setattr(ledger, "slip_boxes", lambda _: motion())

    def run_of(_: fmpq) -> Any:
        events = [SimpleNamespace(name=name) for name in names]
        return SimpleNamespace(events=events, verdict=verdict, samples=SimpleNamespace(boxes="boxes"))

    monkeypatch.setattr(ledger, "run_of", run_of)
    assert ledger.is_shown(QUARTER) is True
    names.insert(0, "stick")
    assert ledger.is_shown(QUARTER) is False
    verdict.outcome = Outcome.UNDECIDED
    assert ledger.is_shown(QUARTER) is None


def test_the_statement_names_what_is_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("is_shown", "floats_agree"):
        monkeypatch.setattr(ledger, name, lambda _: True)
    monkeypatch.setattr(ledger, "_told", str)
    entry = ledger.ENTRIES["3-impact-to-lift-off"]()
    assert [check.agrees for check in entry.checks] == [True, True]
    assert {"b": (-3, 0), "v": (fmpq(-1, 40), 0), "lambda_N": (0, 140)} == ledger.AT_SPOT
    assert "-3 < b < 0, -1/40 < v < 0 and 0 < λ_N < 140, and beyond; " in entry.statement
    assert "ν = 1/4 with u(0) = 70, and ν = 4 with u(0) = 200: " in entry.statement
    assert "(less than 25 for ν = 1/4, less than 77 for ν = 4)" in entry.statement
