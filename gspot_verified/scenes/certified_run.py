"""Certified runs of the linear model scene, by its exact solution. Proof pages: ``proofs/flight.md``, section 8."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.compliant.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.run import IMPACT as LASTING
from gspot_verified.compliant.run import ONE_FLIGHT, Run, compliant_run
from gspot_verified.compliant.run import TRIVIAL as CONSTANT
from gspot_verified.scenes.run import CERTIFIED, FLIGHT_THEN_IMPACT, IMPACT, OPEN, TRIVIAL, RunEvent, SceneRun
from gspot_verified.scenes.scene import Scene, SceneError
from gspot_verified.verdict import Outcome

LINEAR = {"compliant_contact", "lift_off"}


def certified_run(scene: Scene, digits: int = 15) -> SceneRun:
    """The events of the run with certified brackets, and its end as a statement for all times; or undecided.

    :param digits: 1..80, decimals of the lift-off time in the unit of the G-spot.
    :raises SceneError: the scene is not the linear model scene from a state in contact with p > 0.

    >>> from gspot_verified.scenes.file import load_scene
    >>> certified_run(load_scene("fig-varsim1", beta="1/2")).fate
    'impact without collision'
    """
    check_linear(scene)
    values, start = scene.values(), scene.initial()
    model = compliant_model(values["beta"], scene.epsilon, alpha_1=values["alpha_1"], alpha_2=values["alpha_2"])
    run = compliant_run(model, compliant_state(*(start[name] for name in "pbyvz")), digits)
    return SceneRun(CERTIFIED, _fate(run), _events(run), run.verdict)


def check_linear(scene: Scene) -> None:
    """Passes for the scenes that the exact solution covers.

    :raises SceneError: it does not; the message says why.
    """
    others = set(scene.effects).symmetric_difference(LINEAR)
    if others:
        known, wrong = ", ".join(sorted(LINEAR)), ", ".join(sorted(others))
        raise SceneError(f"certified runs cover scenes with {known}, not one that differs in: {wrong}")
    if any(scene.values()[name] != 1 for name in ("k_1", "k_2", "damping")):
        raise SceneError("certified runs cover k_1 = k_2 = damping = 1")
    start = scene.initial()
    if not (start["p"] > 0 and start["y"] < start["z"]):
        raise SceneError("certified runs start in contact with p > 0")


def _fate(run: Run) -> str:
    if run.verdict.outcome is not Outcome.PROVED:
        return OPEN
    return {LASTING: IMPACT, CONSTANT: TRIVIAL, ONE_FLIGHT: FLIGHT_THEN_IMPACT}.get(run.verdict.statement, OPEN)


def _events(run: Run) -> tuple[RunEvent, ...]:
    return tuple(
        RunEvent(event.name, fmpq(event.lower - run.start), fmpq(event.upper - run.start)) for event in run.events
    )
