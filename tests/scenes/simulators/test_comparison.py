"""What simulators say, beside what is certified: judged by motions that are known."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb

from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.approach_result import IMPACT, LIFT_OFF, SLIP_STOPS, Approach
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.numbers.balls import ball_text
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators import comparison
from gspot_verified.scenes.simulators.comparison import Installed, Program, SimulatorComparison, simulators
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.planar_model import PlanarModel
from gspot_verified.scenes.simulators.simulated import IMPULSE, LEAVES, NOTHING, STOPS, Happened, Simulated

ROD = load("rod with a wrist")
FUNCTIONS = contact_floats(ROD)
START = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}


@cache
def certified(*state: tuple[str, Any]) -> Approach:
    return approach(ROD, dict(state))


@pytest.fixture(autouse=True)
def _certified_once(monkeypatch: pytest.MonkeyPatch) -> None:
    def found(mechanism: Mechanism, state: dict[str, Any], **options: Any) -> Approach:
        return certified(*state.items()) if mechanism is ROD else approach(mechanism, state, **options)

    monkeypatch.setattr(comparison, "approach", found)


def test_rigid_slip_of_the_steps_is_that_of_the_certified_path() -> None:
    """Up to the G-spot all three follow one path: the slip velocity after 9/10 of the way agrees."""
    found = simulators(ROD, START, epsilons=[], steps=[])
    path = found.certified.path
    judge = comparison._Judge(ROD, FUNCTIONS, found.certified, None)
    index = max(i for i, time in enumerate(path.time) if float(time.mid()) < 0.9 * judge.time)
    for _, _, motion in judge.simulations([1e-4], [1e-3]):
        run = motion()
        near = min(range(len(run.times)), key=lambda i: abs(run.times[i] - float(path.time[index].mid())))
        assert FUNCTIONS.contact(run.states[near]).u == pytest.approx(float(path.u[index].mid()), rel=2e-2)


@pytest.mark.parametrize(("rate", "side", "first"), [("33/10", LIFT_OFF, LEAVES), ("17/5", IMPACT, STOPS)])
def test_the_compliant_run_takes_the_certified_side(rate: str, side: str, first: str) -> None:
    found = simulators(ROD, START | {"theta_dot": rate}, epsilons=["1e-4"], steps=[])
    (run,) = found.runs
    assert (found.certified.side, run.happened, run.agrees) == (side, first, comparison.RIGHT)
    assert run.time is not None
    assert run.time > float(found.certified.time.mid())  # type: ignore[union-attr]


def written(path: Path, rows: list[tuple[float, ...]], head: str = "t,X,Y,theta,X_dot,Y_dot,theta_dot") -> Path:
    path.write_text("\n".join([head, *(",".join(map(str, row)) for row in rows)]) + "\n")
    return path


def leaving_early(begin: float = 0.0, spin: float = 3.3) -> list[tuple[float, ...]]:
    """A table from the start with 6 ms of contact, or from another time or angular velocity."""
    start = (0.0, math.sin(0.8), 0.8, 5.0, 3.3 * math.cos(0.8), spin)
    up = (start[0], start[1] + 1e-3, *start[2:])
    return [(begin + k / 1000, *(start if k < 6 else up)) for k in range(60)]


@pytest.mark.parametrize(
    ("begin", "spin", "message"),
    [
        (0.0, 3.4, r"mine\.csv: the table begins with theta_dot = 3\.4, and the certified state has 3\.3"),
        (5.0, 3.3, r"mine\.csv: the table begins at t = 5, and the certified state is that at t = 0"),
    ],
)
def test_a_table_of_another_start_is_refused(tmp_path: Path, begin: float, spin: float, message: str) -> None:
    table = written(tmp_path / "mine.csv", leaving_early(begin, spin))
    with pytest.raises(SceneError, match=message):
        simulators(ROD, START, files=[table], epsilons=[], steps=[])


def test_a_table_that_leaves_early_is_told(tmp_path: Path) -> None:
    found = simulators(ROD, START, files=[written(tmp_path / "mine.csv", leaving_early())], epsilons=[], steps=[])
    (run,) = found.runs
    assert (run.simulator, run.happened, run.agrees) == (str(tmp_path / "mine.csv"), LEAVES, comparison.EARLY)
    assert run.time == 0.006
    assert "too early" in str(found)


def test_what_cannot_be_compared_is_said() -> None:
    for step in (0, -1e-3, 2, "1/10000000", float("nan"), float("inf")):
        with pytest.raises(ValueError, match=r"step of a simulator.*1e-6\.\.1"):
            simulators(ROD, START, epsilons=[], steps=[step])
    for epsilon in (0, -1, 2, "1/10000000"):
        with pytest.raises(ValueError, match="expected a number in"):
            simulators(ROD, START, epsilons=[epsilon], steps=[])
    with pytest.raises(MechanismError, match="simulators need coordinates and velocities"):
        simulators(load("model"), {"x": 0, "u": 3, "p": "1/2", "b": -2})
    with pytest.raises(SceneError, match="a simulator needs the surface's velocity"):
        simulators(load("oscillator"), {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})


def test_angles_are_counted_as_the_user_does() -> None:
    """The shipped rod counts theta from a reference: the sine of its angle is 3/5."""
    functions = contact_floats(load("rod"))
    assert functions.contact([0, 0.6, math.asin(0.6), 2, 0.8, 1]).y == pytest.approx(0)
    assert functions.contact([0, 0.6, math.asin(0.6), 2, 0.8, 1]).p == pytest.approx(0)


def judge(end: str = "G-spot", side: str | None = None, time: float | None = 2.0, **given: Any) -> comparison._Judge:
    """Of a state of the shipped rod, which counts its angle from a reference."""
    rod = load("rod")
    shifted = SimpleNamespace(states=[[arb(value) for value in (0, 0.5, 0.25, 2, 0, 1)]])
    known = {"name": "rod", "end": end, "side": side, "path": shifted, "surface_velocity": arb(0)} | given
    certified = SimpleNamespace(time=None if time is None else arb(time), **known)
    return comparison._Judge(rod, contact_floats(rod), certified, None)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("end", "side", "what", "time", "agrees"),
    [
        ("G-spot", LIFT_OFF, LEAVES, 2.0, "agrees"),
        ("G-spot", LIFT_OFF, LEAVES, 1.9, "agrees"),
        ("G-spot", LIFT_OFF, LEAVES, 1.89, "too early"),
        ("G-spot", LIFT_OFF, LEAVES, 5.9, "agrees"),
        ("G-spot", LIFT_OFF, IMPULSE, 2.0, "differs"),
        ("G-spot", LIFT_OFF, NOTHING, None, "no event"),
        ("G-spot", IMPACT, STOPS, 2.0, "agrees"),
        ("G-spot", IMPACT, IMPULSE, 5.9, "agrees"),
        ("G-spot", IMPACT, LEAVES, 2.0, "differs"),
        ("G-spot", None, LEAVES, 2.0, "not comparable"),
        (SLIP_STOPS, None, STOPS, 2.1, "agrees"),
        (SLIP_STOPS, None, STOPS, 2.11, "too late"),
        (SLIP_STOPS, None, LEAVES, 2.0, "differs"),
        (LIFT_OFF, None, LEAVES, 2.1, "agrees"),
        (LIFT_OFF, None, LEAVES, 2.11, "too late"),
    ],
)
def test_what_agrees(end: str, side: str | None, what: str, time: float | None, agrees: str) -> None:
    assert judge(end, side)._agrees(Happened(what, time, 1.0, time or 6.0)) == agrees


def test_a_table_that_ends_early_has_not_shown_that_nothing_comes() -> None:
    """The runs of the package go on for three times the certified time, 6 here."""
    for end in ("G-spot", SLIP_STOPS, LIFT_OFF):
        found = judge(end)
        assert found._agrees(Happened(NOTHING, None, None, 5.95)) == "no event"
        assert found._agrees(Happened(NOTHING, None, None, 5.93)) == "ends early"
        assert found._agrees(Happened(NOTHING, None, None, 1.0)) == "ends early"
    assert judge(SLIP_STOPS)._agrees(Happened(STOPS, 2.0, 0.0, 1.99)) == "agrees"


def test_what_happens_between_two_distant_rows_is_not_compared() -> None:
    """But for what is too early: it came before the row in which it is seen."""
    for end, side in (("G-spot", LIFT_OFF), (LIFT_OFF, None)):
        found = judge(end, side)
        assert found._agrees(Happened(LEAVES, 2.0, 5.0, 1.95)) == "agrees"
        assert found._agrees(Happened(LEAVES, 2.0, 5.0, 1.9)) == "not comparable"
        assert found._agrees(Happened(STOPS, 4.0, 0.0, 1.0)) == "not comparable"
        assert found._agrees(Happened(STOPS, 1.8, 0.0, 0.0)) == "too early"


def test_a_table_of_the_user_that_ends_before_the_event(tmp_path: Path) -> None:
    for rows, said in ((6, "ends early"), (100, "no event")):
        table = written(tmp_path / f"{rows}.csv", [(k / 1000, *leaving_early()[0][1:]) for k in range(rows)])
        found = simulators(ROD, START, files=[table], epsilons=[], steps=[])
        assert [(run.happened, run.agrees) for run in found.runs] == [(NOTHING, said)]


def test_the_start_is_counted_as_the_user_does() -> None:
    assert judge().start == pytest.approx([0, 0.5, 0.25 + math.asin(0.6), 2, 0, 1])
    assert judge().time == 2.0
    with pytest.raises(SceneError, match="rod: nothing is certified of this state"):
        judge(time=None)
    with pytest.raises(SceneError, match="rod: u is not positive: a simulator needs the surface's velocity"):
        judge(surface_velocity=None)


def test_how_near_a_table_begins() -> None:
    """To a thousandth of the certified time, and of 1 + |value|."""
    found, start = judge(), judge().start

    def check(i: int, change: float, time: float = 0.0) -> None:
        moved = [value + (change if i == k else 0) for k, value in enumerate(start)]
        found.check_start("mine", Simulated([time, 1.0], [moved, moved]))

    for sign in (1, -1):
        check(0, sign * 1e-3)
        check(3, sign * 2.9e-3)
        check(0, 0, sign * 2e-3)
        with pytest.raises(SceneError, match="mine: the table begins with X_dot = "):
            check(3, sign * 3.1e-3)
        with pytest.raises(SceneError, match="mine: the table begins with X = "):
            check(0, sign * 1.001e-3)
        with pytest.raises(SceneError, match="mine: the table begins at t = "):
            check(0, 0, sign * 2.01e-3)


def test_the_runs_that_are_made() -> None:
    made = list(judge().simulations([0.01], [1e-3, 1e-1]))
    assert [case[:2] for case in made] == [
        ("compliant contact, LSODA", "ε = 0.01"),
        ("Moreau-Jean", "h = 2.0e-03, stays"),
        ("Moreau-Jean", "h = 2.0e-03, leaves"),
        ("Moreau-Jean", "h = 2.0e-01, stays"),
        ("Moreau-Jean", "h = 2.0e-01, leaves"),
    ]
    given = [case[2].keywords for case in made]  # type: ignore[attr-defined]
    assert given[0] == {"epsilon": 0.01, "until": 6.0, "surface_velocity": 0.0}
    assert [(each["step"], each["stays"], each["until"]) for each in given[1:]] == [
        (0.002, True, 6.0), (0.002, False, 6.0), (0.2, True, 6.0), (0.2, False, 6.0)
    ]  # fmt: skip


def test_the_limits_of_what_is_asked_for() -> None:
    assert [comparison._epsilon("1/1000000"), comparison._epsilon(1)] == [1e-6, 1]
    assert [comparison._step("1/1000000"), comparison._step(1.0), comparison._step(1e-6)] == [1e-6, 1, 1e-6]


def test_a_program_that_is_installed_is_run(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[float, float]] = []

    def runs(model: PlanarModel, step: float, until: float) -> Iterator[tuple[str, Callable[[], Simulated]]]:
        told.append((step, until))
        yield "well", lambda: Simulated([0.0, until], [model.start, model.start])
        yield "badly", lambda: Simulated([0.0, 1 / 0], [])

    monkeypatch.setattr(
        comparison, "installed", lambda _: Installed((Program("P", "1.2", "another model", runs),), ("Q is missing",))
    )
    monkeypatch.setattr(comparison, "moreau_jean", lambda *_, **__: 1 / 0)
    found = simulators(ROD, START, epsilons=[], steps=[1e-2])
    assert [(r.simulator, r.happened, r.agrees) for r in found.runs[2:]] == [
        ("P 1.2", NOTHING, "no event"), ("P 1.2", "division by zero", "failed")
    ]  # fmt: skip
    assert found.runs[0].agrees == "failed"
    time = float(found.certified.time.mid())  # type: ignore[union-attr]
    assert told == [pytest.approx((time / 100, 3 * time))]
    assert found.notes == ("Q is missing", "P: another model")
    text = str(found).splitlines()
    shown = ball_text(found.certified.time, 6)  # type: ignore[arg-type]
    assert text[1].startswith(f"  after the time t = {shown}; then, by the paper's statement as ε → 0: lift-off (")
    assert text[2].split() == ["simulator", "settings", "what", "comes", "first", "t", "slip"]
    assert text[-4].split() == ["P", "1.2", "well", "no", "event", "no", "event"]
    assert text[-2:] == ["  Q is missing", "  P: another model"]
    columns = [text[k].index(word) for k, word in ((2, "settings"), (-4, "well"), (-3, "badly"))]
    assert columns[0] == columns[1] == columns[2] == len("  Moreau-Jean  ")

    def refuse(*_: Any) -> PlanarModel:
        raise SceneError("no bodies")

    monkeypatch.setattr(comparison, "planar_model", refuse)
    assert simulators(ROD, START, epsilons=[], steps=[1e-2], programs=["P"]).notes == ("P: not run: no bodies",)
    without = simulators(ROD, START, epsilons=[], steps=[])
    assert (without.runs, without.notes) == ((), ())


def test_the_text_names_the_surface_and_says_how_the_mechanism_was_read() -> None:
    """Of the certified answer: a surface at rest needs no word, nor has one that is not known a velocity."""
    slip = replace(certified(*START.items()), notes=("which way u counts",))
    for velocity, said in (("-12/5", True), ("0", False), (None, False)):
        shown = str(SimulatorComparison(replace(slip, surface_velocity=velocity), (), ("MuJoCo: not run",)))
        assert (f"\n  on a surface with the velocity u = {velocity}\n  after the time t = " in shown) == said
        assert ("on a surface with" in shown) == said
        assert shown.endswith("\n  which way u counts\n  MuJoCo: not run")
    supposed = str(SimulatorComparison(replace(slip, supposed=("y", "v")), (), ()))
    assert "\n  the state is supposed to lie on the contact: y, v = 0 there is not shown" in supposed
