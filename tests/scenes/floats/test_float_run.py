"""A float run piece by piece: spans, what follows an event, samples, the journal, what is refused."""

from __future__ import annotations

import math
from dataclasses import asdict, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import fmpq
from full_disk import full_after

from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.scenes.equations.scaled_system import CONTACT
from gspot_verified.scenes.floats import float_run as module
from gspot_verified.scenes.floats.float_run import (
    MAX_PHASES,
    MAX_POINTS,
    PIECES,
    SolverPiece,
    _check,
    _FloatRun,
    _kept_piece,
    _pieces,
    _rows,
    float_run,
)
from gspot_verified.scenes.scene.assumption import ASSUMED
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import SIMULATED
from gspot_verified.scenes.scene.scene import Scene, SceneError

SCENE = load_scene("fig-varsim1", epsilon="1/100", until=1)
STICK = ("compliant_contact", "lift_off", "tangential_motion", "stick")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"tolerance": 0.99e-13}, r"tolerance: expected 1e-13\.\.1e-2, got 9\.9e-14"),
        ({"tolerance": 1.01e-2}, "tolerance: expected"),
        ({"tolerance": math.nan}, "tolerance: expected"),
        ({"points": 1}, r"points: expected 2\.\.1000000, got 1"),
        ({"points": MAX_POINTS + 1}, "points: expected"),
        ({"method": "radau"}, "method: expected one of Radau, LSODA, BDF, got 'radau'"),
        ({"scene": SCENE.with_settings(epsilon="999999999999/1000000000000000000000000")}, "epsilon >= 1e-12"),
    ],
)
def test_what_is_just_beyond_is_refused(words: dict[str, Any], message: str) -> None:
    given = {"scene": SCENE, "method": "BDF", "tolerance": 1e-6, "points": None}
    with pytest.raises(SceneError, match=message):
        _check(**(given | words))


def test_what_is_just_within_is_not_refused() -> None:
    least = SCENE.with_settings(epsilon="1e-12")
    for scene, tolerance, points in ((least, 1e-13, 2), (SCENE, 1e-2, MAX_POINTS), (SCENE, 1e-2, None)):
        for method in ("Radau", "LSODA", "BDF"):
            _check(scene, method, tolerance, points)


class Solved:
    """In place of the compiled scene: every span is solved to its end, but for events at these times."""

    calls: list[Any]

    def __init__(self, _: Scene) -> None:
        self.start = {"b": 7.0}

    def contact_phase(self, state: dict[str, float], time: float, at_rest: bool) -> str:
        assert (state, time, at_rest) == ({"b": 7.0}, 0.0, True)
        return "reverse slip"

    def piece(self, phase: str, state: dict[str, float], span: tuple[float, float], *others: Any) -> SolverPiece:
        type(self).calls.append((phase, span, *others[2:]))
        begin, end = span
        at = next((time for time in EVENTS if begin < time <= end), None)
        if at is None:
            return SolverPiece(phase, [], end, state, None, phase)
        return SolverPiece(phase, [], at, state, "x", "flight" if at < max(EVENTS) else None)


EVENTS: list[float] = []


def spans(
    monkeypatch: pytest.MonkeyPatch, cuts: int, events: list[float], last: SolverPiece | None = None
) -> list[tuple[str, float, float, bool]]:
    monkeypatch.setattr(module, "_FloatRun", Solved)
    monkeypatch.setitem(globals(), "EVENTS", events)
    Solved.calls = []
    list(_pieces(SCENE, "BDF", 1e-6, None, last, cuts))
    return [(phase, *span, begins) for phase, span, _, begins in Solved.calls]


def test_a_span_is_cut_into_equal_parts_and_at_events(monkeypatch: pytest.MonkeyPatch) -> None:
    """T = 100 is the end. A piece after an event begins a phase; one after a cut has its first state already."""
    assert spans(monkeypatch, 1, []) == [("slip", 0.0, 100.0, True)]
    assert spans(monkeypatch, 4, []) == [
        ("slip", 0.0, 25.0, True), ("slip", 25.0, 50.0, False), ("slip", 50.0, 75.0, False),
        ("slip", 75.0, 100.0, False),
    ]  # fmt: skip
    assert spans(monkeypatch, 2, [30.0, 50.0, 90.0]) == [
        ("slip", 0.0, 50.0, True), ("flight", 30.0, 50.0, True), ("flight", 50.0, 100.0, True),
    ]  # fmt: skip
    assert spans(monkeypatch, 1, [100.0, 200.0]) == [("slip", 0.0, 100.0, True)]
    # a cut that rounding has put just before its place is not made again
    just = SolverPiece("flight", [], 50.0 * (1 - 1e-13), {"b": 1.0}, None, "flight")
    assert spans(monkeypatch, 2, [], just) == [("flight", just.time, 100.0, False)]


def test_a_run_goes_on_from_its_last_piece(monkeypatch: pytest.MonkeyPatch) -> None:
    last = SolverPiece("slip", [], 60.0, {"b": 1.0}, "lift-off", "flight")
    assert spans(monkeypatch, 1, [], last) == [("flight", 60.0, 100.0, True)]
    assert spans(monkeypatch, 1, [], replace(last, event=None)) == [("flight", 60.0, 100.0, False)]
    assert spans(monkeypatch, 1, [], replace(last, next_phase=None)) == []
    assert spans(monkeypatch, 1, [], replace(last, time=100.0)) == []


def test_a_start_in_stick_asks_friction_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Scene, "first_phase", lambda _: "stick")
    assert spans(monkeypatch, 1, []) == [("reverse slip", 0.0, 100.0, True)]


def test_a_run_of_too_many_phases_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    times = [k / 10 for k in range(1, 900)]
    assert len(spans(monkeypatch, 1, times)) == MAX_PHASES + 1


def test_equal_steps_are_those_of_the_whole_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_FloatRun", Solved)
    Solved.calls = []
    list(_pieces(SCENE, "BDF", 1e-6, 7, None, 1))
    assert Solved.calls == [("slip", (0.0, 100.0), (100.0, 7), True)]


def solved(times: list[float]) -> Any:
    """A state equal to the time."""
    return SimpleNamespace(t=np.array(times), y=np.array([times]), sol=lambda time: np.array([time]))


COMPILED: Any = SimpleNamespace(rows=lambda times, states: [list(pair) for pair in zip(times, states[0], strict=True)])


@pytest.mark.parametrize(
    ("points", "begins", "ends", "expected"),
    [
        (None, True, False, [2.0, 2.5, 4.0]),
        (None, False, True, [2.5, 4.0]),
        ((8.0, 9), True, False, [2.0, 3.0, 4.0]),
        ((8.0, 9), False, False, [3.0, 4.0]),
        ((8.0, 5), True, True, [2.0, 4.0]),
        ((7.0, 8), False, True, [3.0, 4.0]),
        ((9.0, 4), False, False, [3.0]),
        ((9.0, 4), True, True, [2.0, 3.0, 4.0]),
        ((9.0, 2), True, False, [2.0]),
        ((9.0, 2), False, False, []),
    ],
)
def test_the_rows_of_a_piece(points: tuple[float, int] | None, begins: bool, ends: bool, expected: list[float]) -> None:
    """The solver went from 2 to 4. A cut is shown once, an event twice, equal steps where they fall."""
    assert _rows(COMPILED, solved([2.0, 2.5, 4.0]), points, begins, ends) == [[time, time] for time in expected]


def block(push: str = "-1/2", mu: str = "1/4", belt: str = "0") -> Scene:
    made = lagrangian("block", ["X", "H"], [[1, 0], [0, 1]], [push, -1], "X", "H", mu)
    effects, values = (STICK, {}) if belt == "0" else ((*STICK, "belt"), {"belt_velocity": fmpq(belt)})
    return Scene("test", effects, fmpq(1, 10), fmpq(1), values, {"X_dot": "1"}, None, made)


PRESSED = {"Y": -2.0, "V": 0.0, "Z": -1.0}


@pytest.mark.parametrize(
    ("made", "u", "at_rest", "expected"),
    [
        (block(), 1e-9, False, "slip"),
        (block(), -1e-9, False, "reverse slip"),
        (block(), 0.0, False, "reverse slip"),  # the force 1 holds up to 1/4, and 1/2 pushes backwards
        (block("1/2"), 0.0, False, "slip"),
        (block("1/8"), 0.0, False, "stick"),
        (block("1/8"), 5.0, True, "stick"),
        (block(), 5.0, True, "reverse slip"),
        (block("1/8", belt="3"), 3.0, False, "stick"),
        (block("1/8", belt="3"), 3.5, False, "slip"),
        (block("1/8", belt="3"), 2.5, False, "reverse slip"),
    ],
)
def test_which_phase_of_contact_follows(made: Scene, u: float, at_rest: bool, expected: str) -> None:
    run = _FloatRun(made)
    state = {**run.start, **PRESSED, "X_dot": u}
    assert run.contact_phase(state, 0.0, at_rest) == expected


def test_without_stick_the_contact_slips() -> None:
    run = _FloatRun(SCENE)
    assert {run.contact_phase(run.start, 0.0, at_rest) for at_rest in (True, False)} == {"slip"}


def test_a_start_that_no_float_holds_is_refused() -> None:
    far = replace(SCENE, stop_at_force=None).with_settings(y="1e400", v=0, z=0)
    with pytest.raises(SceneError, match=r"^start: [yY] is too large for a float$"):
        _FloatRun(far)


def test_an_end_that_no_float_holds_is_refused() -> None:
    """The integrator went on for ever."""
    with pytest.raises(SceneError, match=r"^until/epsilon is too large for a float$"):
        float_run(replace(SCENE, until=fmpq(10) ** 400))


def test_the_force_at_which_a_run_stops_is_measured_by_that_of_rigid_slip() -> None:
    start = SCENE.initial()
    run = _FloatRun(replace(SCENE, stop_at_force=fmpq(7)))
    assert run._large == pytest.approx(float((-7 * start["b"] / start["p"]).p) / float((start["b"] / start["p"]).q))
    assert run._phase("slip").ends[-1] == ("impact without collision", None)
    none = _FloatRun(replace(SCENE, stop_at_force=None))
    assert none._large is None
    assert [name for name, _ in none._phase("slip").ends] == ["lift-off"]


def ended(name: str | None, following: str | None, u: float = 1.0, made: Scene | None = None) -> SolverPiece:
    """The piece whose solver ends with this event."""
    run = _FloatRun(block() if made is None else made)
    compiled = SimpleNamespace(
        phase="slip",
        states=("X_dot",),
        ends=[("another", "flight"), (name, following)],
        integrate=lambda *_: SimpleNamespace(
            t=np.array([0.0, 3.0]), y=np.array([[9.0, u]]), t_events=[[], [] if name is None else [3.0]]
        ),
        rows=lambda times, _: [[time] for time in times],
    )
    phases = {"slip": compiled}
    run._compiled["slip"] = phases["slip"]  # type: ignore[assignment]
    run.contact_phase = lambda *_, at_rest: "stick" if at_rest else "reverse slip"  # type: ignore[method-assign, misc]
    state = {**run.start, **PRESSED, "u": 5.0}
    return run.piece("slip", state, (0.0, 3.0), "BDF", 1e-6, None, True)


def test_what_follows_an_event() -> None:
    """The name of the end of slip is that of what follows; in stick the slip velocity is that of the surface."""
    none = ended(None, None)
    assert (none.event, none.next_phase, none.time, none.state["X_dot"], none.state["u"]) == (
        None,
        "slip",
        3.0,
        1.0,
        5.0,
    )
    assert none.rows == [[0.0], [3.0]]
    lift = ended("lift-off", "flight")
    assert (lift.event, lift.next_phase, lift.state["u"]) == ("lift-off", "flight", 5.0)
    stop = ended("slip stops", CONTACT)
    assert (stop.event, stop.next_phase, stop.state["u"]) == ("stick", "stick", 0.0)
    moving = ended("slip stops", CONTACT, made=block(belt="3"))
    assert moving.state["u"] == 3.0
    land = ended("touch-down", CONTACT)
    assert (land.event, land.next_phase, land.state["u"]) == ("touch-down", "reverse slip", 5.0)
    over = ended("impact without collision", None)
    assert (over.event, over.next_phase) == ("impact without collision", None)


def test_slip_that_turns_round_is_called_so() -> None:
    run = _FloatRun(block())
    for following, name in (("reverse slip", "slip backwards"), ("slip", "slip forwards")):
        compiled = SimpleNamespace(
            phase="slip", states=(), ends=[("slip stops", CONTACT)],
            integrate=lambda *_: SimpleNamespace(t=np.array([0.0, 1.0]), y=np.zeros((0, 2)), t_events=[[1.0]]),
            rows=lambda *_: [],
        )  # fmt: skip
        run._compiled["slip"] = compiled  # type: ignore[assignment]
        run.contact_phase = lambda *_, chosen=following, **__: chosen  # type: ignore[method-assign, misc]
        piece = run.piece("slip", run.start, (0.0, 1.0), "BDF", 1e-6, None, True)
        assert (piece.event, piece.next_phase) == (name, following)


PAPERS = load_scene("fig-varsim1")
PIECE = SolverPiece("slip", [[0.0] * 7, [1.0] * 7], 3.0, dict.fromkeys(PAPERS.scaled_initial(), 1.0), None, "slip")


def test_a_piece_of_a_journal_is_read_as_it_was_written() -> None:
    for piece in (PIECE, replace(PIECE, event="lift-off", next_phase=None), replace(PIECE, rows=[])):
        assert _kept_piece(asdict(piece), Path("x"), PAPERS) == piece


@pytest.mark.parametrize(
    "change",
    [{"rows": [[0.0] * 6 + [math.nan]]}, {"rows": [[0.0] * 7, [math.inf] * 7]}, {"time": math.nan}, {"time": math.inf},
     {"rows": 3}, {"rows": [["a"] * 7]}, {"rows": [[0.0] * 7, [0.0] * 6]}, {"time": "late"}, {"surprise": 1},
     {"event": 1}, {"event": True}, {"event": ["lift-off"]}, {"phase": "slide"}, {"phase": 1}, {"phase": []},
     {"next_phase": "slide"}, {"next_phase": 0}, {"state": 1}, {"state": {}}, {"state": {"b": 1.0}},
     {"state": PIECE.state | {"b": "1"}}, {"state": PIECE.state | {"b": math.nan}}],
)  # fmt: skip
def test_a_piece_that_is_none_of_the_scene_is_refused(change: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"^x: a line of the journal cannot be read: "):
        _kept_piece(asdict(PIECE) | change, Path("x"), PAPERS)


@pytest.mark.parametrize("data", [3, None, [1], {"phase": "slip"}])
def test_a_line_that_is_no_piece_is_refused(data: Any) -> None:
    with pytest.raises(ValueError, match=r"^x: a line of the journal cannot be read: "):
        _kept_piece(data, Path("x"), PAPERS)


def test_nothing_of_a_float_run_is_checked_or_proved() -> None:
    plain = load_scene("fig-varsim2", chi=0, epsilon="1/50", until="1/100")
    effects = ("compliant_contact", "tangential_motion")
    scene = Scene("test", effects, plain.epsilon, plain.until, {}, {**plain.start, "u": fmpq(1)})
    run = float_run(scene, "LSODA", 1e-5, 3)
    assert (run.strength, run.fate, run.verdict.outcome) == (SIMULATED, "no event", Outcome.UNDECIDED)
    assert [(each.effect, each.standing, each.lower, each.why) for each in run.assumptions] == [
        (name, ASSUMED, fmpq(0), "a run with floats checks nothing") for name in ("lift_off", "stick")
    ]
    assert "provided that" in run.verdict.statement
    assert run.verdict.reason is Reason.FLOATS
    assert run.verdict.detail == "simulated with floats (LSODA, relative tolerance 1e-05): no error is bounded"
    assert run.notes == ()


def test_a_full_disk_is_a_note(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The run goes on without its journal, and tries no second line."""
    tried = full_after(1_000, tmp_path / "journal", monkeypatch)
    scene = load_scene("fig-varsim1", epsilon="1/50", until="1/100")
    run = float_run(scene, "LSODA", 1e-5, journal=tmp_path / "journal")
    assert len(tried) == 1
    assert run.notes == (
        f"the journal {tmp_path / 'journal'} could not be written: [Errno 28] No space left on device; the run went "
        "on without it",
    )
    assert run.samples is not None
    assert len(run.samples.phases) > 60
    assert np.all(np.diff(run.samples.columns["t"]) > 0)
    assert run.samples.columns["t"][-1] == pytest.approx(0.01)


def test_times_of_events_are_in_the_units_of_the_paper(monkeypatch: pytest.MonkeyPatch) -> None:
    pieces = [
        SolverPiece("slip", [[0.0] * 7], 50.0, {}, None, "slip"),
        SolverPiece("slip", [[0.5] * 7], 75.0, {}, "lift-off", "flight"),
        SolverPiece("flight", [[1.0] * 7] * 2, 100.0, {}, None, "flight"),
    ]
    monkeypatch.setattr(module, "_pieces", lambda *_: iter(pieces))
    run = float_run(SCENE)
    (event,) = run.events
    assert (event.name, event.lower, event.upper) == ("lift-off", fmpq(3, 4), fmpq(3, 4))
    assert run.samples is not None
    assert run.samples.phases == ("slip", "slip", "flight", "flight")
    assert run.samples.columns["t"].tolist() == [0.0, 0.5, 1.0, 1.0]
    assert (run.fate, run.verdict.statement) == ("lift-off", "lift-off")


def test_only_a_run_with_a_journal_is_cut(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And it goes on after the last piece that the journal has."""
    asked: list[tuple[Any, ...]] = []
    row = [0.0] * 7

    def pieces(*given: Any) -> Any:
        asked.append(given)
        return iter([SolverPiece("slip", [row], float(len(asked)), PIECE.state, None, "slip")])

    monkeypatch.setattr(module, "_pieces", pieces)
    float_run(SCENE, "BDF", 1e-6, 7)
    for _ in range(2):
        float_run(SCENE, "BDF", 1e-6, 7, tmp_path / "journal")
    assert [given[:4] for given in asked] == [(SCENE, "BDF", 1e-6, 7)] * 3
    assert [(None if last is None else last.time, cuts) for *_, last, cuts in asked] == [
        (None, 1), (None, PIECES), (2.0, PIECES)
    ]  # fmt: skip


def test_the_phase_of_contact_is_that_of_its_time() -> None:
    """Of a surface with the acceleration sin t: friction 1/2 holds the block at 0 and at pi, not between."""
    driven = lagrangian("block", ["X", "H"], [[1, 0], [0, 1]], [0, -1], "X - t + sin(t)", "H", "1/2", time="t")
    effects = ("compliant_contact", "lift_off", "tangential_motion", "stick")
    made = Scene("driven", effects, fmpq(1, 10), fmpq(1), {}, {"X_dot": fmpq(0)}, mechanism=driven)
    run = _FloatRun(made)
    state = {**run.start, **PRESSED}
    phases = [run.contact_phase(state, 10 * time, at_rest=True) for time in (0.0, math.pi / 2, math.pi)]
    assert phases == ["stick", "reverse slip", "stick"]
