"""One function that draws: a result, a mechanism, or a figure by its name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.compliant.contact.iwc import CompliantIwc
from gspot_verified.compliant.side.side_map import side_map
from gspot_verified.compliant.zeros.zero_map import ZeroMap
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.leading_order.iwc import IwcResult
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.report.figures.atlas import atlas_picture
from gspot_verified.report.figures.b_hat_figure import b_hat_picture
from gspot_verified.report.figures.figures import theta_picture
from gspot_verified.report.figures.force_figure import force_picture, threshold_picture, threshold_points
from gspot_verified.report.figures.side_map import side_map_picture
from gspot_verified.report.pictures.canvas import Picture, checked_suffix
from gspot_verified.report.pictures.contact_force_picture import contact_force_picture
from gspot_verified.report.pictures.expansion_picture import expansion_picture
from gspot_verified.report.pictures.mechanism_animation import check_animated, mechanism_animation
from gspot_verified.report.pictures.mechanism_picture import mechanism_picture
from gspot_verified.report.pictures.phase_plane import phase_plane_picture
from gspot_verified.report.pictures.scene_picture import scene_picture
from gspot_verified.report.pictures.zero_map_picture import zero_map_picture
from gspot_verified.scenes.certified_run import with_boxes
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import CERTIFIED, SceneRun
from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.scenes.simulate import simulate
from gspot_verified.signs.zeros.zeros import ZerosResult


def plot(subject: object, path: str | Path | None = None, **options: Any) -> Picture:
    """Draw ``subject`` and, with ``path``, write it as PNG, PDF or SVG by the suffix; returns it with its caption.

    - "theta": Θ(τ, β) for five β; "b-hat" (``beta=``, ``epsilons=``): b-hat on the slow manifold against Θ;
      "force": the slow force at several ε above leading order; "side-map" (``progress=``): the exact side rule over β
      and ε for the paper's data, about a minute; "threshold": the exact ε0 over β beside the one at leading order, some
      minutes; "mechanism" (``mechanism=``, ``state=``, ``spot=``): its bodies and its contact point at a state, by
      default at its G-spot, as the drawing in its file says; "animation" (``scene=``, ``run=``): its motion along a run
      of a scene with samples, by default one with floats, as an SVG that browsers play; "run" (``scene=``, ``run=``):
      the force, y, b and what else is integrated along a run, by default one with floats, or along several, certified
      ones as boxes;
    - a mechanism (``state=``, ``spot=``): the phase plane (p, b) next to its G-spot, or that of this number;
    - the result of ``expand``: the residual under its proved bound; of ``iwc`` (``epsilon=``): λ_N(τ) at leading order;
      of ``zeros_on_range``: the sign atlas; of ``zero_map``: the map over β and ε.

    The suffix is checked before the work.

    :raises ValueError: an unknown suffix or name; what the figure itself refuses.
    :raises TypeError: ``subject`` is something else, or an option is not the figure's.
    :raises OSError: the file cannot be written.

    >>> from gspot_verified import iwc
    >>> plot(iwc("7/3"), epsilon="1/100").title
    'λ_N(τ) at leading order, β = 7/3, ε = 1/100'
    """
    if path is not None:
        checked_suffix(Path(path))
    drawn = _drawer(subject)(**options)
    if path is not None:
        drawn.save(path)
    return drawn


def _drawer(subject: object) -> Callable[..., Picture]:
    if isinstance(subject, str):
        if subject not in _NAMES:
            raise ValueError(f"plot: expected one of {', '.join(_NAMES)}, got {subject[:60]!r}")
        return _NAMES[subject]
    for kind, draw in _KINDS.items():
        if isinstance(subject, kind):
            return lambda **options: draw(subject, **options)
    raise TypeError(f"plot: a {type(subject).__name__} has no figure")


def _side_map(progress: Callable[[str], None] = lambda _: None) -> Picture:
    betas = [fmpq(2 * n + 1, 8) for n in range(1, 40)]
    parts = (fmpq(1), fmpq(3, 2), fmpq(2), fmpq(3), fmpq(9, 2), fmpq(7))  # of a power of ten
    epsilons = [fmpq(10) ** -(k // 6) / parts[k % 6] for k in range(25)]
    return side_map_picture(side_map(betas, epsilons, lambda done, number: progress(f"{done} of {number} values of β")))


def _threshold() -> Picture:
    return threshold_picture(threshold_points())


def _animation(scene: Scene | str | Path, run: SceneRun | None = None) -> Picture:
    shown = scene if isinstance(scene, Scene) else load_scene(scene)
    check_animated(shown)
    return mechanism_animation(shown, simulate(shown, floats=True) if run is None else run)


def _run(scene: Scene | str | Path, run: SceneRun | Sequence[SceneRun] | None = None) -> Picture:
    shown = scene if isinstance(scene, Scene) else load_scene(scene)
    given = simulate(shown, floats=True) if run is None else run
    runs = [given] if isinstance(given, SceneRun) else given
    return scene_picture(shown, [with_boxes(shown, each) if each.strength == CERTIFIED else each for each in runs])


_NAMES: dict[str, Callable[..., Picture]] = {
    "theta": theta_picture,
    "b-hat": b_hat_picture,
    "force": force_picture,
    "side-map": _side_map,
    "threshold": _threshold,
    "mechanism": mechanism_picture,
    "animation": _animation,
    "run": _run,
}
_KINDS: dict[type, Callable[..., Picture]] = {
    Mechanism: phase_plane_picture,
    Trajectory: expansion_picture,
    CompliantIwc: lambda result, **options: contact_force_picture(result.leading.force, **options),
    IwcResult: lambda result, **options: contact_force_picture(result.force, **options),
    ZerosResult: lambda result: atlas_picture(result, with_texts=True),
    ZeroMap: zero_map_picture,
}
