"""The one way to run a scene: certified, or quickly with floats."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from gspot_verified.scenes.certified.certified_integration import MAX_STEPS
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.scenes.scene.scene import Scene, SceneError

METHOD, TOLERANCE = "Radau", 1e-10


def simulate(
    scene: Scene | str | Path,
    *,
    floats: bool = False,
    digits: int | None = None,
    route: str | None = None,
    budget: int | None = None,
    method: str | None = None,
    tolerance: float | None = None,
    points: int | None = None,
    journal: str | Path | None = None,
    progress: Callable[[str], None] = lambda _: None,
) -> SceneRun:
    """What a scene does, event after event: certified, or with ``floats`` a quick run in which nothing is proved.

    :param scene: a scene, or the file or name that :func:`load_scene` takes.
    :param digits: certified: decimals of the times, 1..80; 15 if left out.
    :param route: certified: "exact" or "integrator"; left out, the exact solution where it decides.
    :param budget: certified: how many steps the integrator may make at each precision; 20 000 if left out.
    :param method: floats: "Radau" (if left out), "LSODA" or "BDF".
    :param tolerance: floats: relative, 1e-13..1e-2; 1e-10 if left out.
    :param points: at how many equal steps of time samples are taken; left out, a certified run has none and a float
        run has the solver's own steps. The certified integrator gives them at times of its own, with boxes that hold
        the trajectory between them. Events are among them.
    :param journal: a file that keeps what is done; the same call goes on from there.
    :param progress: is told how far a certified run is.
    :raises SceneError: no such scene, route or method; the exact solution does not cover the scene; an argument is of
        the other kind of run.
    :raises ValueError: the journal is that of another run.

    >>> from gspot_verified import load_scene
    >>> scene = load_scene("fig-varsim1", beta="1/2")
    >>> simulate(scene).fate
    'impact without collision'
    >>> simulate(scene, floats=True, points=5).strength
    'simulated'
    """
    kind = "certified" if floats else "float"
    of_certified = {"digits": digits, "route": route, "budget": budget}
    of_floats = {"method": method, "tolerance": tolerance}
    others = of_certified if floats else of_floats
    for name, value in others.items():
        if value is not None:
            raise SceneError(f"{name}: it is for a {kind} run")
    chosen = scene if isinstance(scene, Scene) else load_scene(scene)
    if floats:
        return float_run(
            chosen, METHOD if method is None else method, TOLERANCE if tolerance is None else tolerance, points, journal
        )
    accuracy, steps = 15 if digits is None else digits, MAX_STEPS if budget is None else budget
    return certified_run(chosen, accuracy, route, points, journal, steps, progress)
