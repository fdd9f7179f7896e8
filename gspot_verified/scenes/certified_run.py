"""Certified runs: the linear model scene by its exact solution, every scene by the validated integrator.

Proof pages: ``proofs/flight.md``, section 8; those of ``certified_integration.py``.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from flint import fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_model, compliant_state
from gspot_verified.compliant.motion.run import AFTER_FLIGHTS, ONE_FLIGHT, CompliantRun, events
from gspot_verified.compliant.motion.run import IMPACT as LASTING
from gspot_verified.compliant.motion.run import TRIVIAL as CONSTANT
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified.certified_integration import MAX_STEPS, integrated_run
from gspot_verified.scenes.certified.certified_samples import MAX_POINTS, certified_samples
from gspot_verified.scenes.certified.run_steps import Progress
from gspot_verified.scenes.effects.lift_off import LIFT_OFF, TOUCH_DOWN
from gspot_verified.scenes.scene.run import CERTIFIED, FLIGHT_THEN_IMPACT, IMPACT, OPEN, TRIVIAL, RunEvent, SceneRun
from gspot_verified.scenes.scene.scene import Scene, SceneError

LINEAR = ("compliant_contact", "lift_off")


EXACT, INTEGRATOR = "exact", "integrator"
_STEPS_OF_BOXES = 2_000  # against long work for a picture


def certified_run(
    scene: Scene,
    digits: int = 15,
    route: str | None = None,
    points: int | None = None,
    journal: str | Path | None = None,
    budget: int = MAX_STEPS,
    progress: Progress = lambda _: None,
) -> SceneRun:
    """The events of the run with certified brackets, and its end as a statement for all times; or undecided.

    :param digits: 1..80, decimals of the lift-off time in the unit of the G-spot (exact), of the times of all events
        in the unit epsilon (integrator).
    :param route: "exact" (the linear model scene from a state in contact with p > 0) or "integrator" (any scene);
        None: the exact solution where it covers the scene and decides, else the integrator.
    :param points: enclosures of the trajectory: by the exact solution at so many equal steps of time and at the
        events, by the integrator at times of its own, with boxes between them; None: none.
    :param journal, budget: of the integrator, as :func:`integrated_run` has them; the exact solution needs none.
    :raises SceneError: an unknown route, points out of range, or the exact solution does not cover the scene.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> certified_run(load_scene("fig-varsim1", beta="1/2")).fate
    'impact without collision'
    """
    if route not in (None, EXACT, INTEGRATOR):
        raise SceneError(f"route: expected {EXACT} or {INTEGRATOR}, got {route!r}")
    if points is not None and not 2 <= points <= MAX_POINTS:
        raise SceneError(f"points: expected 2..{MAX_POINTS}, got {points}")
    if route != INTEGRATOR:
        try:
            run = _exact_run(scene, digits, points)
        except NotCovered:
            if route == EXACT:
                raise
        else:
            if route == EXACT or run.fate != OPEN:
                return run
    run = integrated_run(scene, digits, None, points is not None, journal, budget, progress)
    return replace(run, route=INTEGRATOR)


def _exact_run(scene: Scene, digits: int, points: int | None) -> SceneRun:
    run = events(*exact_start(scene), digits)
    samples = None if points is None else certified_samples(run, scene.until, points)
    return SceneRun(CERTIFIED, _fate(run), _events(run), run.verdict, samples, route=EXACT)


def with_boxes(scene: Scene, run: SceneRun, progress: Progress = lambda _: None) -> SceneRun:
    """A certified run with samples and boxes by the integrator in place of its own samples, which know nothing between
    their times; as it is where it has boxes, or where the integrator reaches less far than they do.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> scene = load_scene("fig-varsim1", beta="1/2", epsilon="1/10")
    >>> with_boxes(scene, certified_run(scene)).samples.boxes is not None
    True
    """
    samples = run.samples
    if samples is not None and samples.boxes is not None:
        return run
    found = integrated_run(scene, sampled=True, budget=_STEPS_OF_BOXES, progress=progress).samples
    known = 0.0 if samples is None else float(samples.columns["t"].max(initial=0.0))
    return replace(run, samples=found) if found is not None and found.columns["t"].max(initial=0.0) >= known else run


class NotCovered(SceneError):
    """The exact solution does not cover a scene; the message says why."""


def exact_start(scene: Scene) -> tuple[CompliantModel, CompliantState]:
    """The model and the state from which the exact solution starts.

    :raises NotCovered: it does not cover the scene.
    """
    if scene.mechanism is not None:
        raise NotCovered("the exact solution covers the model system, not a mechanism")
    others = set(scene.effects).symmetric_difference(LINEAR)
    if others:
        known, wrong = ", ".join(LINEAR), ", ".join(sorted(others))
        raise NotCovered(f"the exact solution covers scenes with {known}, not one that differs in: {wrong}")
    values, start = scene.values(), scene.initial()
    if any(values[name] != 1 for name in ("k_1", "k_2", "damping")):
        raise NotCovered("the exact solution covers k_1 = k_2 = damping = 1")
    if not (start["p"] > 0 and start["y"] < start["z"]):
        raise NotCovered("the exact solution is used from a start in contact with p > 0")
    try:
        model = compliant_model(values["beta"], scene.epsilon, alpha_1=values["alpha_1"], alpha_2=values["alpha_2"])
    except ValueError as error:
        raise NotCovered(f"the exact solution does not cover this scene: {error}") from None
    return model, compliant_state(*(start[name] for name in "pbyvz"))


def _fate(run: CompliantRun) -> str:
    if run.verdict.outcome is not Outcome.PROVED:
        return OPEN
    statement = run.verdict.statement
    if statement != ONE_FLIGHT and statement.endswith(AFTER_FLIGHTS):
        return ", ".join([*(event.name for event in run.events if event.name in (LIFT_OFF, TOUCH_DOWN)), IMPACT])
    return {LASTING: IMPACT, CONSTANT: TRIVIAL, ONE_FLIGHT: FLIGHT_THEN_IMPACT}.get(statement, OPEN)


def _events(run: CompliantRun) -> tuple[RunEvent, ...]:
    return tuple(
        RunEvent(event.name, fmpq(event.lower - run.start), fmpq(event.upper - run.start)) for event in run.events
    )
