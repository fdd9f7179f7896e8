"""A run of a scene: λ_N, y and b over p (over t where p turns), with its events, the canard and the scaled Θ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from gspot_verified.numbers.balls import approximate
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    VERMILION,
    Picture,
    canvas,
    picture,
    styled,
)
from gspot_verified.report.pictures.scene_prediction import Curve, canard, scaled_theta
from gspot_verified.scenes.scene.run import CERTIFIED, IMPACT, SceneRun
from gspot_verified.scenes.scene.samples import Samples
from gspot_verified.scenes.scene.scene import Scene

if TYPE_CHECKING:
    from numpy import ndarray

    Column = ndarray[Any, Any]

_PANELS = (("lambda_N", "λ_N"), ("y", "y/ε²"), ("b", "b"))
_MARKS = {"lift-off": "o", "touch-down": "*", "stick": "s", IMPACT: "v"}
_OTHER_MARK = "D"
_MARGIN = 0.6  # of the height before the G-spot


@dataclass(frozen=True)
class _Over:
    """What stands on the horizontal axis: the name of its column, and its label."""

    name: str
    label: str


def scene_picture(scene: Scene, runs: Sequence[SceneRun]) -> Picture:
    """The runs of one scene that have samples, one below the other in time, with what the theory says beside them.

    :raises ValueError: no run has samples.
    """
    sampled = [run for run in runs if run.samples is not None and len(run.samples.phases) > 1]
    if not sampled:
        raise ValueError("the picture needs a run with samples: none of the trajectory is known")
    return styled(lambda: _draw(scene, sampled, runs))()


def _draw(scene: Scene, sampled: Sequence[SceneRun], runs: Sequence[SceneRun]) -> Picture:
    first = sampled[0].samples
    assert first is not None
    over = _horizontal(first)
    figure = canvas(7.0)
    panels = figure.subplots(len(_PANELS), 1, sharex=True)
    last_p = min(float(run.samples.columns["p"].min()) for run in sampled if run.samples is not None)
    theory = [curve for curve in (canard(scene, last_p), scaled_theta(scene)) if curve is not None]
    for axes, (name, label) in zip(panels, _PANELS, strict=True):
        scale = approximate(scene.epsilon) ** 2 if name == "y" else 1.0
        axes.axhline(0, color=INK, linewidth=0.6)
        if over.name == "p":
            axes.axvline(0, color=INK, linewidth=0.8, linestyle=":")
            for curve, colour, style in zip(theory, (GREEN, ORANGE), ("-.", (0, (4, 2))), strict=False):
                values = [x / scale for x in _of(curve, name)]
                axes.plot(curve.p, values, color=colour, linestyle=style, label=curve.label, zorder=4)
        for run in sampled:
            _curve(axes, run, over, name, scale)
        _limits(axes, first, name, scale)
        axes.set_ylabel(label)
    _certified_brackets(panels, runs, over, first)
    ends = first.columns[over.name]
    panels[-1].set_xlabel(over.label)
    width = float(ends.max() - ends.min()) or 1.0
    limits = (float(ends.min()) - 0.02 * width, float(ends.max()) + 0.02 * width)
    panels[-1].set_xlim(*(reversed(limits) if over.name == "p" else limits))
    panels[0].set_title(f"{scene.name}, ε = {scene.epsilon}", loc="left")
    panels[-1].legend(loc="best", fontsize=7.5)
    return picture(
        figure,
        "scene",
        f"The scene {scene.name}, ε = {scene.epsilon}",
        _caption(scene, runs, theory, over),
        "Three panels, one above the other: the contact force, the height of the contact point and b along one run.",
    )


def _horizontal(samples: Samples) -> _Over:
    import numpy as np

    if bool(np.all(np.diff(samples.columns["p"]) <= 0)):
        return _Over("p", "p (time runs to the right)")
    return _Over("t", "t after the start")


def _of(curve: Curve, name: str) -> tuple[float, ...]:
    return {"lambda_N": curve.force, "y": curve.y, "b": curve.b}[name]


def _curve(axes: Any, run: SceneRun, over: _Over, name: str, scale: float) -> None:
    """The samples as a line, and a mark for each event of the run."""
    import numpy as np

    assert run.samples is not None
    columns = run.samples.columns
    certified = run.strength == CERTIFIED
    colour, width = (PURPLE, 3.2) if certified else (BLUE, 1.2)
    label = "certified, middles of enclosures" if certified else "simulated with floats"
    axes.plot(columns[over.name], columns[name] / scale, color=colour, linewidth=width, label=label, alpha=0.9)
    if certified:
        return
    seen: set[str] = set()
    for event in run.events:
        time = approximate(event.lower)
        at = [float(np.interp(time, columns["t"], columns[each])) for each in (over.name, name)]
        axes.plot(
            at[0], at[1] / scale, _MARKS.get(event.name, _OTHER_MARK), color=VERMILION, markersize=7, zorder=5,
            label=None if event.name in seen else event.name, clip_on=True,
        )  # fmt: skip
        seen.add(event.name)


def _certified_brackets(panels: Sequence[Any], runs: Sequence[SceneRun], over: _Over, samples: Samples) -> None:
    """A vertical line at each certified event; its bracket is narrower than the line."""
    import numpy as np

    for run in runs:
        if run.strength != CERTIFIED:
            continue
        for event in run.events:
            time = approximate((event.lower + event.upper) / 2)
            at = float(np.interp(time, samples.columns["t"], samples.columns[over.name]))
            for axes in panels:
                axes.axvline(at, color=PURPLE, linewidth=0.8, linestyle=(0, (2, 2)))
            panels[0].annotate(
                event.name, (at, 1), xycoords=("data", "axes fraction"), fontsize=7, color=PURPLE, rotation=90,
                ha="right", va="top",
            )  # fmt: skip


def _limits(axes: Any, samples: Samples, name: str, scale: float) -> None:
    """What happens before the G-spot, and as much again on either side: an impact would hide all else."""
    import numpy as np

    values, p = samples.columns[name] / scale, samples.columns["p"]
    before: Column = values[: int(np.argmax(p < 0)) or len(p)]
    low, high = float(min(before.min(), 0)), float(max(before.max(), 0))
    room = _MARGIN * ((high - low) or 1.0)
    axes.set_ylim(
        max(low - room, float(values.min()) - 0.05 * room), min(high + room, float(values.max()) + 0.05 * room)
    )


def _caption(scene: Scene, runs: Sequence[SceneRun], theory: Sequence[Curve], over: _Over) -> str:
    parts = [f"{run.strength.capitalize()}: {run.fate}." for run in runs]
    if any(run.strength == CERTIFIED for run in runs):
        parts.append("Certified are the events (dashed lines at the brackets) and the end for all times.")
    if any(run.strength != CERTIFIED for run in runs):
        parts.append("The float run proves nothing.")
    if theory and over.name == "p":
        shown = " and ".join(curve.label for curve in theory)
        parts.append(f"Beside it: {shown}; no error of these curves is bounded.")
    left_out = list(scene.assumes())
    if left_out:
        parts.append(f"Effects left out: {', '.join(left_out)}.")
    return " ".join(parts)
