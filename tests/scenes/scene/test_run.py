"""What a run says: times as text, events as rows, and whether a simulation contradicts a certified run."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.scenes.scene.assumption import ASSUMED, CHECKED, Assumption
from gspot_verified.scenes.scene.run import (
    CERTIFIED,
    FLIGHT_THEN_IMPACT,
    IMPACT,
    NO_EVENT,
    OPEN,
    REFUTED,
    SIMULATED,
    TRIVIAL,
    RunEvent,
    SceneRun,
    agreement,
    fate_of,
)

LIFT, LAND, STICK = "lift-off", "touch-down", "stick"
SOME = Verdict.undecided("?", Reason.BUDGET, "for the test")


def run(strength: str, *events: str | tuple[str, int], fate: str | None = None) -> SceneRun:
    """Events at the times 1, 2, 3, or at their own."""
    timed = [(event, i) if isinstance(event, str) else event for i, event in enumerate(events, 1)]
    found = tuple(RunEvent(name, fmpq(time), fmpq(time)) for name, time in timed)
    return SceneRun(strength, fate_of([name for name, _ in timed]) if fate is None else fate, found, SOME)


def simulated(*events: str | tuple[str, int]) -> SceneRun:
    return run(SIMULATED, *events)


def certified(*events: str | tuple[str, int], fate: str | None = None) -> SceneRun:
    return run(CERTIFIED, *events, fate=fate)


def test_the_words_are_those_of_the_page() -> None:
    assert (fate_of([]), fate_of([LIFT, LAND, IMPACT])) == (NO_EVENT, FLIGHT_THEN_IMPACT)
    assert FLIGHT_THEN_IMPACT == "lift-off, touch-down, impact without collision"


@pytest.mark.parametrize(
    ("seen", "known", "expected"),
    [
        (simulated(LIFT), certified(LIFT), True),
        (simulated(), certified(), True),
        (simulated(LIFT), certified(LIFT, LAND), None),  # it ended before
        (simulated(), certified(LIFT), None),
        (simulated(LIFT, LAND), certified(LIFT), False),
        (simulated(LAND), certified(LIFT), False),
        (simulated(STICK), certified(LIFT, STICK), False),
        (simulated(LIFT), certified(LIFT, fate=OPEN), None),
        (simulated(LIFT), certified(LAND, fate=OPEN), None),
        (simulated(LIFT), certified(LAND, fate=REFUTED), None),
        (simulated(), certified(fate=OPEN), None),
        # on the canard every event contradicts
        (simulated(), certified(fate=TRIVIAL), True),
        (simulated(LIFT), certified(fate=TRIVIAL), False),
        (simulated(IMPACT), certified(fate=TRIVIAL), False),
        # the float run need not name an impact that something follows
        (simulated(STICK), certified(IMPACT, STICK), True),
        (simulated(STICK, LIFT), certified(IMPACT, STICK, LIFT), True),
        (simulated(LIFT, LAND), certified(LIFT, LAND, IMPACT), None),
        (simulated(STICK), certified(IMPACT), False),
        (simulated(IMPACT, STICK), certified(IMPACT, STICK), True),
        (simulated(IMPACT, LIFT), certified(IMPACT, STICK), False),
        # it is exact about the last one
        (simulated(LIFT, LAND, IMPACT), certified(LIFT, LAND, fate=FLIGHT_THEN_IMPACT), True),
        (simulated(LIFT, IMPACT), certified(LIFT, LAND, fate=FLIGHT_THEN_IMPACT), False),
    ],
)
def test_whether_they_end_alike(seen: SceneRun, known: SceneRun, expected: bool | None) -> None:
    assert agreement(seen, known) is expected


@pytest.mark.parametrize(
    ("seen", "known", "expected"),
    [
        # a force that has grown, before the next certified event
        (simulated(LIFT, LAND, (IMPACT, 3)), certified(LIFT, LAND), None),
        (simulated(LIFT, LAND, (IMPACT, 3)), certified(LIFT, LAND, (STICK, 4)), None),
        (simulated(LIFT, LAND, (IMPACT, 3)), certified(LIFT, LAND, (STICK, 3)), False),
        (simulated(LIFT, LAND, (IMPACT, 4)), certified(LIFT, LAND, (STICK, 3)), False),
        (simulated((IMPACT, 3)), certified(), None),
        (simulated((IMPACT, 3)), certified((LIFT, 4)), None),
        (simulated((IMPACT, 3)), certified((LIFT, 2)), False),
        # more events than are certified, or others
        (simulated(LIFT, LAND, (IMPACT, 3)), certified(LIFT), False),
        (simulated(LIFT, LAND, (IMPACT, 3)), certified(LIFT, STICK), False),
        (simulated(LIFT, LAND, (IMPACT, 3)), certified(STICK, LAND, (STICK, 4)), False),
        # where an impact is certified it is compared with that
        (simulated(LIFT, (IMPACT, 3)), certified(LIFT, LAND, (IMPACT, 5)), False),
        (simulated((IMPACT, 3)), certified((IMPACT, 5), (STICK, 6)), None),
        (simulated(LIFT, (IMPACT, 3)), certified(LIFT, (STICK, 4), fate=FLIGHT_THEN_IMPACT), False),
    ],
)
def test_a_force_that_only_grew_is_neither(seen: SceneRun, known: SceneRun, expected: bool | None) -> None:
    assert agreement(seen, known) is expected


@given(st.fractions(), st.fractions(min_value=0, max_value=1))
def test_a_time_as_text_holds_its_bracket(lower: Fraction, width: Fraction) -> None:
    first, last = (fmpq(value.numerator, value.denominator) for value in (lower, lower + width))
    event = RunEvent("x", first, last)
    shown = event.shown(CERTIFIED)
    if width == 0:
        assert shown == str(first)
        return
    with working_bits(400):
        ball = arb(shown)
        assert ball.is_finite()
        assert ball.contains(arb(first))
        assert ball.contains(arb(last))


def test_a_narrow_bracket_is_shown_with_all_its_digits_and_a_float_with_12() -> None:
    event = RunEvent("x", fmpq(1, 3), fmpq(1, 3) + fmpq(1, 10**40))
    assert event.shown(CERTIFIED).startswith("[0.333333333333333333333333333333 +/- ")
    assert event.shown(SIMULATED) == "0.333333333333"
    assert RunEvent("x", fmpq(1, 3), fmpq(1, 3)).shown(SIMULATED) == "0.333333333333"


def test_what_is_printed_and_what_is_written() -> None:
    events = (RunEvent(LIFT, fmpq(1, 2), fmpq(1, 2)), RunEvent(LAND, fmpq(3, 4), fmpq(7, 8)))
    verdict = Verdict.proved("what is proved", less(0, 1))
    assumed = Assumption("stick", "u > 0", ASSUMED, fmpq(0), fmpq(0), "why")
    certain = SceneRun(CERTIFIED, "both", events, verdict, assumptions=(assumed,))
    lines = str(certain).splitlines()
    assert lines[0] == "certified, under the condition below: both"
    checked = (replace(assumed, standing=CHECKED, lower=None, upper=None),)
    assert str(replace(certain, assumptions=checked)).splitlines()[0] == "certified: both"
    assert str(replace(certain, fate=OPEN)).splitlines()[0] == "certified: open"
    assert [line[:2] for line in lines[1:]] == ["  "] * (len(lines) - 1)
    assert lines[1].strip().startswith("proved: what is proved")
    assert "  lift-off: t = 1/2 after the start" in lines
    assert lines[-1] == f"  {assumed}"
    assert [tuple(row) for row in certain.event_rows] == [
        (LIFT, fmpq(1, 2), fmpq(1, 2)), (LAND, fmpq(3, 4), fmpq(7, 8))
    ]  # fmt: skip
    floats = SceneRun(SIMULATED, "both", events, SOME)
    assert [tuple(row) for row in floats.event_rows] == [(LIFT, 0.5), (LAND, 0.75)]
    assert "  touch-down: t = 0.75 after the start" in str(floats).splitlines()
    grows = (RunEvent(IMPACT, fmpq(1, 2), fmpq(1, 2)),)
    shown = "  impact without collision: {} from t = {} after the start on".format
    assert shown("shown", "1/2") in str(replace(certain, events=grows)).splitlines()
    assert shown("seen", "0.5") in str(replace(floats, events=grows)).splitlines()
    written = json.loads(json.dumps(certain.to_json()))
    assert set(written) == {"strength", "fate", "events", "verdict", "assumptions"}
    assert [row["event"] for row in written["events"]] == [LIFT, LAND]
    with pytest.raises(TypeError):
        bool(certain)
