"""Which route a certified run takes, what the exact solution covers, and how its answer is written down."""

from __future__ import annotations

import inspect
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import fmpq

from gspot_verified.compliant.motion.run import AFTER_FLIGHTS, ONE_FLIGHT, TRIVIAL
from gspot_verified.compliant.motion.run import IMPACT as LASTING
from gspot_verified.compliant.motion.run import events as exact_events
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict
from gspot_verified.scenes import certified_run as module
from gspot_verified.scenes.certified.certified_integration import MAX_STEPS
from gspot_verified.scenes.certified_run import EXACT, INTEGRATOR, NotCovered, certified_run, exact_start, with_boxes
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import CERTIFIED, FLIGHT_THEN_IMPACT, IMPACT, OPEN, SceneRun
from gspot_verified.scenes.scene.run import TRIVIAL as CONSTANT
from gspot_verified.scenes.scene.samples import Boxes, Samples
from gspot_verified.scenes.scene.scene import SceneError

SCENE = load_scene("fig-varsim1", epsilon="1/10", beta="1/2", nu="1/4")
UNDECIDED = Verdict.undecided("?", Reason.BUDGET, "for the test")


def answers(monkeypatch: pytest.MonkeyPatch, fate: str | None) -> list[Any]:
    """The exact route gives this (None: it does not cover the scene); what each route was asked."""
    asked: list[Any] = []

    def exact(*given: Any) -> SceneRun:
        asked.append((EXACT, *given))
        if fate is None:
            raise NotCovered("not covered")
        return SceneRun(CERTIFIED, fate, (), UNDECIDED)

    def integrated(*given: Any) -> SceneRun:
        asked.append((INTEGRATOR, *given))
        return SceneRun(CERTIFIED, "integrated", (), UNDECIDED)

    monkeypatch.setattr(module, "_exact_run", exact)
    monkeypatch.setattr(module, "integrated_run", integrated)
    return asked


@pytest.mark.parametrize(
    ("route", "fate", "routes"),
    [
        (None, IMPACT, [EXACT]),
        (None, OPEN, [EXACT, INTEGRATOR]),
        (None, None, [EXACT, INTEGRATOR]),
        (EXACT, IMPACT, [EXACT]),
        (EXACT, OPEN, [EXACT]),
        (INTEGRATOR, IMPACT, [INTEGRATOR]),
    ],
)
def test_the_exact_solution_first_where_it_covers_and_decides(
    monkeypatch: pytest.MonkeyPatch, route: str | None, fate: str | None, routes: list[str]
) -> None:
    asked = answers(monkeypatch, fate)
    run = certified_run(SCENE, 20, route, 2, Path("x"), 7, print)
    assert [each[0] for each in asked] == routes
    assert run.fate == ("integrated" if routes[-1] == INTEGRATOR else fate)
    given = {EXACT: (SCENE, 20, 2), INTEGRATOR: (SCENE, 20, None, True, Path("x"), 7, print)}
    assert all(tuple(rest) == given[name] for name, *rest in asked)


def test_what_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """15 decimals, the stated budget of steps, no samples, no journal, silence."""
    asked = answers(monkeypatch, None)
    certified_run(SCENE)
    (_, *exact), (_, *integrated) = asked
    assert exact == [SCENE, 15, None]
    assert integrated[:-1] == [SCENE, 15, None, False, None, MAX_STEPS]
    assert integrated[-1]("nothing is shown") is None
    assert set(inspect.signature(certified_run).parameters) == {
        "scene", "digits", "route", "points", "journal", "budget", "progress"
    }  # fmt: skip


def test_a_scene_that_is_not_covered_is_an_error_of_the_exact_route_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = answers(monkeypatch, None)
    with pytest.raises(NotCovered, match="not covered"):
        certified_run(SCENE, route=EXACT)
    assert [each[0] for each in asked] == [EXACT]
    for route in ("other", "", "Exact"):
        with pytest.raises(SceneError, match=f"^route: expected exact or integrator, got '{route}'$"):
            certified_run(SCENE, route=route)


def test_what_the_exact_solution_covers() -> None:
    """Each hypothesis alone, with the start beside it that is covered."""
    in_contact = {"y": "-2/100", "v": "0", "z": "-1/100"}
    for scene in (SCENE, SCENE.with_settings(p="1/10000", **in_contact)):
        model, state = exact_start(scene)
        values, start = scene.values(), scene.initial()
        assert (model.epsilon, model.beta, model.alpha_1, model.alpha_2) == (
            scene.epsilon, values["beta"], values["alpha_1"], values["alpha_2"]
        )  # fmt: skip
        assert [getattr(state, name) for name in "pbyvz"] == [start[name] for name in "pbyvz"]
    for name in ("k_1", "k_2", "damping"):
        for value in ("2", "999999/1000000"):
            with pytest.raises(NotCovered, match="covers k_1 = k_2 = damping = 1"):
                exact_start(SCENE.with_settings(**{name: value}, **in_contact))
    closed = replace(SCENE.with_settings(**in_contact), stop_at_force=None)
    for change in ({"p": 0}, {"p": "-1/1000"}, {"z": "-2/100"}, {"z": "-3/100"}, {"p": -1, "z": "-3/100"}):
        with pytest.raises(NotCovered, match="a start in contact with p > 0"):
            exact_start(closed.with_settings(**change))
    with pytest.raises(NotCovered, match=r"differs in: lift_off$"):
        exact_start(replace(SCENE, effects=("compliant_contact",)))
    with pytest.raises(NotCovered, match="covers scenes with compliant_contact, lift_off, not one that differs in"):
        exact_start(load_scene("fig-varsim2"))
    coupled = load_scene("fig-varsim2", chi=0)
    others = ("tangential_motion", "stick", "tangential_place", "two_way_coupling")
    far = replace(coupled, effects=("compliant_contact", *others), start={**coupled.start, "x": fmpq(0)})
    with pytest.raises(NotCovered, match=f"differs in: {', '.join(sorted(['lift_off', *others]))}$"):
        exact_start(far)
    with pytest.raises(NotCovered, match="not a mechanism"):
        exact_start(load_scene("rod"))
    with pytest.raises(NotCovered, match="does not cover this scene: beta"):
        exact_start(load_scene("fig-varsim1", beta=1, b=-1))


@pytest.mark.parametrize(
    ("statement", "fate"),
    [(LASTING, IMPACT), (TRIVIAL, CONSTANT), (ONE_FLIGHT, FLIGHT_THEN_IMPACT),
     ("one flight, then a contact that is lost again", OPEN)],
)  # fmt: skip
def test_the_fate_is_that_of_what_is_proved(statement: str, fate: str) -> None:
    proved = Verdict.proved(statement, less(0, 1))
    assert module._fate(SimpleNamespace(verdict=proved)) == fate  # type: ignore[arg-type]
    undecided = Verdict.undecided(statement, Reason.BUDGET, "for the test")
    assert module._fate(SimpleNamespace(verdict=undecided)) == OPEN  # type: ignore[arg-type]


def test_times_are_counted_from_the_start_in_the_units_of_the_paper() -> None:
    """p = alpha_1 t: the start lies at t = -1/4 for alpha_1 = -2 and p = 1/2."""
    scene = load_scene("fig-varsim1", epsilon="1/10", alpha_1=-2)
    exact = exact_events(*exact_start(scene), 4)
    run = certified_run(scene, 4, EXACT)
    assert exact.start == fmpq(-1, 4)
    assert (run.fate, run.strength, run.samples) == (FLIGHT_THEN_IMPACT, CERTIFIED, None)
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict == exact.verdict
    assert [(event.name, event.lower, event.upper) for event in run.events] == [
        (event.name, event.lower + fmpq(1, 4), event.upper + fmpq(1, 4)) for event in exact.events
    ]


def test_samples_are_of_as_many_points_as_are_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "certified_samples", lambda *given: given)
    scene = load_scene("fig-varsim1", epsilon="1/10")
    run = certified_run(scene, 7, EXACT, 3)
    assert run.samples is not None
    found, until, points = run.samples  # type: ignore[misc]
    assert (found.verdict, until, points) == (run.verdict, scene.until, 3)


@pytest.mark.parametrize("points", [2, 100_000])
def test_the_first_and_the_last_number_of_points_that_are_taken(monkeypatch: pytest.MonkeyPatch, points: int) -> None:
    asked = answers(monkeypatch, IMPACT)
    certified_run(SCENE, points=points)
    assert [(each[0], each[-1]) for each in asked] == [(EXACT, points)]


@pytest.mark.parametrize("points", [0, 1, 100_001])
def test_points_are_checked_before_the_work(monkeypatch: pytest.MonkeyPatch, points: int) -> None:
    def started(*_: object) -> None:
        raise AssertionError("the work was started")

    monkeypatch.setattr(module, "_exact_run", started)
    monkeypatch.setattr(module, "integrated_run", started)
    with pytest.raises(SceneError, match=f"^points: expected 2..100000, got {points}$"):
        certified_run(SCENE, points=points)


def sampled(last: float, boxes: Boxes | None = None) -> Samples:
    return Samples({"t": np.array([0.0, last])}, ("slip", "slip"), boxes)


@pytest.mark.parametrize(
    ("own", "found", "taken"),
    [
        (None, sampled(0), True),
        (None, None, False),
        (sampled(2), None, False),
        (sampled(2), sampled(2), True),
        (sampled(2), sampled(2.5), True),
        (sampled(2), sampled(1.9), False),
    ],
)
def test_boxes_take_the_place_of_samples_that_reach_no_farther(
    monkeypatch: pytest.MonkeyPatch, own: Samples | None, found: Samples | None, taken: bool
) -> None:
    asked: list[Any] = []

    def integrated(*given: Any, **options: Any) -> SceneRun:
        asked.append((*given, options["sampled"], options["progress"]))
        return SceneRun(CERTIFIED, "integrated", (), UNDECIDED, found)

    monkeypatch.setattr(module, "integrated_run", integrated)
    run = SceneRun(CERTIFIED, IMPACT, (), UNDECIDED, own)
    boxed = with_boxes(SCENE, run, print)
    assert asked == [(SCENE, True, print)]
    assert boxed.samples is (found if taken else own)
    assert boxed.fate == IMPACT


def test_a_run_that_has_boxes_keeps_them(monkeypatch: pytest.MonkeyPatch) -> None:
    def started(*_: object, **__: object) -> None:
        raise AssertionError("the work was started")

    monkeypatch.setattr(module, "integrated_run", started)
    run = SceneRun(CERTIFIED, IMPACT, (), UNDECIDED, sampled(2, Boxes({}, {}, ())))
    assert with_boxes(SCENE, run) is run


def test_the_fate_of_several_flights_names_each() -> None:
    shown = less(0, 1)
    assert shown is not None
    names = ("lift-off", "touch-down", "lift-off", "touch-down", "contact for ever from")
    run: Any = SimpleNamespace(
        verdict=Verdict.proved(f"exactly 2 flights, {AFTER_FLIGHTS}", shown),
        events=tuple(SimpleNamespace(name=name) for name in names),
    )
    assert module._fate(run) == ", ".join([*names[:4], IMPACT])
