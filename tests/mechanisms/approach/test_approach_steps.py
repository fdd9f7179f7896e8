"""The steps of an approach by themselves: when it begins again, what is watched, what is kept of the path.

Whole approaches against closed forms: test_approach.py.
"""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.integrator.field.event import Watch
from gspot_verified.mechanisms.approach import approach as module
from gspot_verified.mechanisms.approach.approach import MAX_STEPS, _Attempt, approach
from gspot_verified.mechanisms.approach.approach_result import LIFT_OFF, Approach
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Evidence, Outcome

SHOWN = Evidence._of_facts(("for the test",))
MODEL = shipped_mechanism("model system")


def finite(value: arb | None) -> arb:
    assert value is not None
    assert value.is_finite()
    return value


def from_model(p: str, b: str, u: str = "100", steps: int = MAX_STEPS) -> Approach:
    return approach(MODEL, {"x": 0, "u": u, "p": p, "b": b}, max_steps=steps)


@pytest.mark.parametrize(
    ("coefficient", "exit_code", "attempts"),
    [(arb(1), 0, 1), (arb(1), 2, 1), (arb(-1), 2, 1), (arb(0, 1), 2, 2), (arb(0), 2, 2), (None, 0, 1), (None, 2, 2)],
)
def test_more_bits_are_tried_where_they_may_say_more(
    monkeypatch: pytest.MonkeyPatch, coefficient: arb | None, exit_code: int, attempts: int
) -> None:
    asked: list[tuple[Any, int, int]] = []

    def attempt(_: Any, __: Any, velocity: Any, bits: int, steps: int, **_more: Any) -> Any:
        asked.append((velocity, bits, steps))
        return SimpleNamespace(result=lambda: SimpleNamespace(coefficient=coefficient, exit_code=exit_code))

    monkeypatch.setattr(module, "_Attempt", attempt)
    approach(MODEL, {}, surface_velocity="-1/3", max_steps=7)
    assert asked == [(fmpq(-1, 3), bits, 7) for bits in (160, 400)[:attempts]]
    approach(MODEL, {})
    assert asked[-1] == (None, asked[-1][1], 600)


@pytest.mark.parametrize(
    ("u", "velocity", "surface"),
    [(3, None, "0"), (-3, None, None), (3, fmpq(2), "2"), (-3, fmpq(-4), "-4"), (3, fmpq(3), ""), (0, None, "")],
)
def test_the_surface_that_slip_is_over(u: int, velocity: fmpq | None, surface: str | None) -> None:
    """At rest when u > 0; not asked for when u < 0; else slip must be positive at the start."""
    given = (shift(MODEL), {"x": 0, "u": u, "p": "1/2", "b": -2}, velocity, 160, 10)
    if surface == "":
        with pytest.raises(StateError, match="no positive slip"):
            _Attempt(*given)
    else:
        found = _Attempt(*given)
        assert found.surface_text == surface
        assert (found.surface is None) is (surface is None)
        assert found.surface is None or found.surface == fmpq(int(surface or 0))


def test_the_path_begins_at_the_start_and_has_each_part_of_a_segment_once() -> None:
    class Segment:
        def __init__(self, begin: int) -> None:
            self.begin = begin

        def states(self, tau: arb) -> list[arb]:
            return [arb(7), 10 * (self.begin + tau), self.begin + tau]

    attempt: Any = object.__new__(_Attempt)
    attempt.rows, attempt.least_slip, attempt.goal = [], None, None
    attempt.numbers = SimpleNamespace(on=lambda states: SimpleNamespace(u=states[1]))
    attempt._remember(Segment(3))
    attempt._remember(Segment(4))
    assert [time for time, _ in attempt.rows] == [3 + fmpq(k, 4) for k in range(9)]
    assert all(len(states) == 2 and states[1] == 10 * time for time, states in attempt.rows)
    assert finite(attempt.least_slip) <= 30
    assert finite(attempt.least_slip) > 29


@pytest.mark.parametrize("u", [arb(5), arb(100)])
def test_the_least_slip_includes_the_end_of_the_path(monkeypatch: pytest.MonkeyPatch, u: arb) -> None:
    """What is known of u from the last segment to the G-spot counts; and so does what was before."""
    unchanged = module.capture

    def capture(*given: Any) -> Any:
        found = unchanged(*given)
        return None if found is None else replace(found, numbers=replace(found.numbers, u=u))

    monkeypatch.setattr(module, "capture", capture)
    found = from_model("1/1000", "-1/250", "50")
    assert found.end == "G-spot"
    assert finite(found.least_slip) <= u.min(arb(50))


def test_a_g_spot_is_not_reached_where_an_event_on_the_way_is_not_excluded(monkeypatch: pytest.MonkeyPatch) -> None:
    """The signs at the first capture are evidence: without them, or those of the capture, nothing is concluded."""
    monkeypatch.setattr(module, "PRECISIONS", (160,))
    found = from_model("1/1000", "-1/250", "50", steps=40)
    assert found.verdict.outcome is Outcome.PROVED
    assert "lies in the interior of" in str(found.verdict.evidence)
    monkeypatch.setattr(Watch, "excluded", lambda *_: None)
    assert from_model("1/1000", "-1/250", "50", steps=40).verdict.outcome is Outcome.UNDECIDED


def test_a_step_without_its_comparison_cannot_conclude(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "PRECISIONS", (160,))
    attempt = _Attempt._doubt

    def forgets(self: Any, segment: Any) -> str | None:
        found = attempt(self, segment)
        self.shown[-1] = None
        return found

    monkeypatch.setattr(_Attempt, "_doubt", forgets)
    assert from_model("1/1000", "-1/250", "50", steps=40).verdict.outcome is Outcome.UNDECIDED


def test_lift_off_is_first_where_stick_is_excluded() -> None:
    """λ = 1 + (λ_0 - 1)(p/p_0)^(-1/2) with α = (-2, 1, -1)."""
    found = approach(
        MODEL.with_parameters(alpha_1=-2, alpha_2=1, alpha_3=-1), {"x": 0, "u": 100, "p": "1/2", "b": "-1/4"}
    )
    assert found.end == "lift-off"


def test_the_path_and_the_json() -> None:
    found = from_model("1/2", "-2")
    path = found.path
    assert len({len(getattr(path, name)) for name in ("time", "states", "p", "b", "u", "force")}) == 1
    with working_bits(160):
        for time, p, b, force in zip(path.time, path.p, path.b, path.force, strict=True):
            assert finite(p + time).contains(fmpq(1, 2)) or (p + time).overlaps(arb(fmpq(1, 2)))
            exact = -2 * p - arb(2) * p * p.sqrt() / arb(fmpq(1, 2)).sqrt() if p > 0 else b
            assert b.overlaps(exact)
            assert not force.is_finite() or force > 0
        # p falls with rate 1 all the way: the time left is at most the last p, and nearly that.
        assert all(one < other for one, other in pairwise(path.time[:-1]))
        left = finite(found.time) - path.time[-1].mid()
        assert left.contains(0)
        assert left.contains(path.p[-1].mid() * arb("0.999"))
        assert left.rad() < path.p[-1]
        # du/dt = -λ, λ = 2 + 2 (p/p_0)^(1/2) with p_0 = 1/2: u falls by 1 + 2/3 until p = 0; C_1 = -8^(1/2).
        assert 98 < finite(found.least_slip) <= 100 - arb(fmpq(5, 3))
        assert finite(found.coefficient).overlaps(-arb(8).sqrt())
    data = json.loads(json.dumps(found.to_json()))
    assert data["side"] == LIFT_OFF
    assert data["end"] == "G-spot"
    assert len(data["path"]["p"]) == len(path.p)
    with pytest.raises(TypeError, match="no truth value"):
        bool(found)


@pytest.mark.parametrize("place", [fmpq(k, 16) for k in range(17)])
def test_the_hypotheses_are_asked_for_on_every_part_of_a_segment(place: fmpq) -> None:
    """Where one fails in a single point of [0, 1], it is seen; and nothing is asked outside of the segment."""
    asked: list[arb] = []

    class Hypotheses:
        def checked(self, box: list[arb]) -> Evidence | str:
            asked.extend(box)
            return "here" if box[0].contains(place) else SHOWN

    class Segment:
        step = SimpleNamespace(h=arb(1))

        def states(self, tau: arb) -> list[arb]:
            return [tau]

    attempt: Any = object.__new__(_Attempt)
    attempt.shown = []
    attempt.hypotheses = Hypotheses()
    assert attempt._doubt(Segment()) == "here"
    assert all(side.contains(place) or (side >= 0 and side <= 1) for side in asked)
