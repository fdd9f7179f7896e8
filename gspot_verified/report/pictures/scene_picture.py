"""A run of a scene over p (over t where p turns): λ_N, y and b, then the slip velocity and the mechanism's own
coordinates where they are integrated, with the events, the canard and the scaled Θ, whose errors are not bounded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq

from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    LAMBDA_N,
    ORANGE,
    PURPLE,
    VERMILION,
    Picture,
    canvas,
    picture,
    styled,
    typeset,
)
from gspot_verified.report.pictures.scene_curves import boxes_over, falls, outline, phase_rows, places
from gspot_verified.scenes.scene.run import CERTIFIED, IMPACT, SceneRun
from gspot_verified.scenes.scene.samples import RADIUS, Samples
from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.theta_function.value.evaluate import evaluate

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.legend import Legend
    from numpy import ndarray

    Column = ndarray[Any, Any]


ORDER = 15  # of the expansion; that of two orders less is compared
_POINTS = 160  # of a curve
_BITS = 80  # beyond what a picture shows
_REACH = 5
"""The expansion is shown for |t| up to so many units epsilon^(2/3)/kappa, as far as its orders agree."""
_AGREE = 0.02  # two orders whose forces differ more are no picture of the trajectory
_LAST_TAU = fmpq(3)  # a little past the G-spot
_FIRST_TAU = fmpq(-12)  # where the curve begins


@dataclass(frozen=True, slots=True)
class Curve:
    """A curve over p, in the units of the paper: b, y, lambda_N."""

    label: str
    p: tuple[float, ...]
    b: tuple[float, ...]
    y: tuple[float, ...]
    force: tuple[float, ...]


def canard(scene: Scene, last_p: float) -> Curve | None:
    """The trivial solution of the model from the start to ``last_p``, or the expansion of a mechanism's distinguished
    trajectory next to the G-spot; None where there is none with a positive force, or the model is coupled."""
    if scene.mechanism is not None:
        return _expanded(scene.mechanism, scene.epsilon)
    values = scene.values()
    slope = (values["beta"] - 1) * values["alpha_1"]
    if "two_way_coupling" in scene.effects or slope == 0 or values["alpha_2"] / slope <= 0:
        return None
    force = values["alpha_2"] / slope
    depth = -(scene.epsilon**2) * force * (1 / values["k_1"] + 1 / values["k_2"])
    p = (approximate(scene.initial()["p"]), last_p)
    b = tuple(-approximate(force) * each for each in p)
    return Curve("trivial solution", p, b, 2 * (approximate(depth),), 2 * (approximate(force),))


def _expanded(mechanism: Mechanism, epsilon: fmpq) -> Curve | None:
    """Where the series of the last two orders agree within 2 %."""
    try:
        series = [expand(mechanism, order) for order in (ORDER - 2, ORDER)]
    except ValueError:  # no G-spot at the mechanism's place, or an integer beta: there is no expansion to draw
        return None
    alpha = approximate(series[1].system.check()[0])
    unit = approximate(epsilon) ** (2 / 3) * (2 / -alpha) ** (1 / 3)
    with working_bits(_BITS):
        step = fmpq(*float(unit).as_integer_ratio()) * _REACH / (_POINTS // 2)
        rows = [*reversed(_agreeing(series, -step, epsilon)), *_agreeing(series, step, epsilon)[1:]]
    if not rows or any(row[3] <= 0 for row in rows):
        return None
    p, b, y, force = (tuple(column) for column in zip(*rows, strict=True))
    return Curve(f"distinguished trajectory, expansion to order {ORDER}", p, b, y, force)


def _agreeing(series: Sequence[Trajectory], step: fmpq, epsilon: fmpq) -> list[list[float]]:
    """p, b, y, lambda_N at t = 0, step, 2 step, ... until the two orders differ."""
    rows = []
    for k in range(_POINTS // 2 + 1):
        both = ({n: approximate(v) for n, v in s.evaluate_in_time(k * step, epsilon).items()} for s in series)
        before, higher = both
        if not abs(higher["lambda_n"] - before["lambda_n"]) <= _AGREE * abs(higher["lambda_n"]):
            break
        rows.append([higher[name] for name in ("p", "b", "y", "lambda_n")])
    return rows


def scaled_theta(scene: Scene) -> Curve | None:
    """b = b-bar + C_1 kappa^(-beta) epsilon^(2 beta/3) Theta(tau), lambda_N likewise, C_1 from the rigid slip of the
    start, b-hat ~ (-t)^beta; None for scenes that are not the model's, or start at p <= 0 or on the canard.

    tau = kappa t epsilon^(-2/3) for a stiffness h = 1/k_1 + 1/k_2 = 2; in general epsilon sqrt(h/2) stands for epsilon.
    """
    if scene.mechanism is not None or "two_way_coupling" in scene.effects:
        return None
    values, start = scene.values(), scene.initial()
    first, second, beta = values["alpha_1"], values["alpha_2"], values["beta"]
    if not (first < 0 and beta > 0 and beta != 1 and start["p"] > 0):
        return None
    mean = second / ((beta - 1) * first)
    deviation = start["b"] + mean * start["p"]
    if deviation == 0:
        return None
    with working_bits(_BITS):
        small = arb(scene.epsilon) * (arb(1 / values["k_1"] + 1 / values["k_2"]) / 2).sqrt()
        kappa, power = arb(-first / 2).root(3), arb(beta)
        charge = arb(deviation) / arb(start["p"] / -first) ** power
        unit = small ** (arb(2) / 3) / kappa
        size = charge * unit**power
        rows = []
        for k in range(_POINTS + 1):
            tau = _FIRST_TAU + (_LAST_TAU - _FIRST_TAU) * fmpq(k, _POINTS)
            value, slope = (evaluate(tau, beta, derivative=n, digits=8).value for n in (0, 1))
            p = arb(first) * tau * unit
            force = mean - size * slope / (unit * beta * first)
            rows.append([float(x.mid()) for x in (p, -mean * p + size * value, force)])
    p_s, b, forces = (tuple(column) for column in zip(*rows, strict=True))
    depth = approximate(scene.epsilon) ** 2 * approximate(1 / values["k_1"] + 1 / values["k_2"])
    return Curve("scaled Θ, leading order", p_s, b, tuple(-depth * x for x in forces), forces)


_FIRST = {"lambda_N": f"force {LAMBDA_N}", "y": r"height $y/\varepsilon^2$", "b": "$b$"}
_NEVER = ("t", "p", "v", "z")  # columns without a panel
_MARKS = {"lift-off": "o", "touch-down": "*", "stick": "s", IMPACT: "v"}
_OTHER_MARK = "D"
_MARGIN = 0.6  # of the height before the G-spot
_HEIGHTS = (2.1, 1.3)  # inches, of the first panels and of the others
_FINEST = 250  # boxes are put together up to this part of a panel's height and width


@dataclass(frozen=True)
class _Panel:
    """A column, its label, what its values are divided by, and where it has a thin line."""

    name: str
    label: str
    scale: float = 1.0
    line: float | None = 0.0


def scene_picture(scene: Scene, runs: Sequence[SceneRun]) -> Picture:
    """The runs of one scene that have samples, one below the other in time, with what the theory says beside them.

    Of a certified run boxes are drawn, in which the whole trajectory lies, where its samples have them; else points.

    :raises ValueError: no run has samples.
    """
    sampled = [run for run in runs if run.samples is not None and len(run.samples.phases) > 1]
    if not sampled:
        raise ValueError("the picture needs a run with samples: none of the trajectory is known")
    return styled(lambda: _draw(scene, sampled, runs))()


def panels_of(scene: Scene, samples: Samples) -> list[_Panel]:
    """λ_N, y and b; then u, x and the components of the mechanism that the run integrates."""
    scales = {"y": approximate(scene.epsilon) ** 2}
    shown = [_Panel(name, label, scales.get(name, 1.0)) for name, label in _FIRST.items()]
    for name in samples.columns:
        if name in _NEVER or name in _FIRST or name.endswith(RADIUS):
            continue
        if name == "u":
            belt = approximate(scene.values().get("belt_velocity", fmpq(0)))
            shown.append(_Panel(name, "slip velocity $u$", line=belt))
        else:
            counted = " − ".join(typeset(part) for part in name.split(" - "))  # an angle, from its reference
            shown.append(_Panel(name, counted, line=None))
    return shown


def _draw(scene: Scene, sampled: Sequence[SceneRun], runs: Sequence[SceneRun]) -> Picture:
    first = sampled[0].samples
    assert first is not None
    over = "p" if all(falls(run.samples) for run in sampled if run.samples is not None) else "t"
    shown = panels_of(scene, first)
    ratios = [_HEIGHTS[0 if panel.name in _FIRST else 1] for panel in shown]
    figure = canvas(1.2 + sum(ratios))
    fields = figure.subplots(len(shown), 1, sharex=True, height_ratios=ratios)
    last_p = min(float(run.samples.columns["p"].min()) for run in sampled if run.samples is not None)
    theory = [] if over == "t" else [each for each in (canard(scene, last_p), scaled_theta(scene)) if each is not None]
    ends = first.columns[over]
    width = float(ends.max() - ends.min()) or 1.0
    for axes, panel in zip(fields, shown, strict=True):
        if panel.line is not None:
            axes.axhline(panel.line, color=INK, linewidth=0.6)
        if over == "p":
            axes.axvline(0, color=INK, linewidth=0.8, linestyle=":", label="$p = 0$")
        for curve, colour, style in zip(theory, (GREEN, ORANGE), ("-.", (0, (4, 2))), strict=False):
            if panel.name in _FIRST:
                values = [x / panel.scale for x in _of(curve, panel.name)]
                axes.plot(curve.p, values, color=colour, linestyle=style, label=curve.label, zorder=4)
        low, high = _limits(first, panel)
        axes.set_ylim(low, high)
        for run in sampled:
            _curve(axes, run, over, panel, ((high - low) / _FINEST, width / _FINEST))
        axes.set_ylabel(panel.label)
    for run in runs:
        _events(fields, shown, run, over)
    _axis(fields[-1], over, float(ends.min()), width)
    fields[0].set_title(f"{scene.name}, ε = {scene.epsilon}", loc="left", parse_math=False)
    legend_above(figure, fields[0])
    return picture(
        figure,
        "scene",
        f"The scene {scene.name}, ε = {scene.epsilon}",
        caption(scene, runs, theory, over),
        "Panels one above the other: the contact force, the height of the contact point, b, and what else is "
        "integrated, along one run.",
    )


def _axis(axes: Any, over: str, least: float, width: float) -> None:
    """Time runs to the right, and an arrow says so where p stands for it."""
    limits = (least - 0.02 * width, least + 1.02 * width)
    axes.set_xlim(*(reversed(limits) if over == "p" else limits))
    axes.set_xlabel(r"$p$ (time runs $\longrightarrow$)" if over == "p" else "$t$ after the start")


def legend_above(figure: Figure, axes: Any) -> Legend:
    """The legend above the panels, each name once, in as many columns as the picture has room for."""
    for columns in (3, 2, 1):
        legend = figure.legend(*_named_once(axes), loc="outside upper left", fontsize=8, ncols=columns, frameon=False)
        if legend.get_window_extent().width <= figure.bbox.width or columns == 1:
            break
        legend.remove()
    return legend


def _named_once(axes: Any) -> tuple[list[Any], list[str]]:
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    return list(once.values()), list(once)


def _of(curve: Curve, name: str) -> tuple[float, ...]:
    return {"lambda_N": curve.force, "y": curve.y, "b": curve.b}[name]


def _curve(axes: Any, run: SceneRun, over: str, panel: _Panel, finest: tuple[float, float]) -> None:
    """The lines of a float run, phase by phase; the boxes of a certified one, or its points where it has none."""
    assert run.samples is not None
    samples = run.samples
    at, values = samples.columns[over], samples.columns[panel.name] / panel.scale
    if run.strength != CERTIFIED:
        for first, last in phase_rows(samples):
            part = slice(first, last + 1)
            look: dict[str, Any] = {"color": BLUE, "linewidth": 1.0, "zorder": 3}
            axes.plot(at[part], values[part], label="simulated with floats", **look)
    elif samples.boxes is None:
        label = "certified, at these points"
        axes.plot(at, values, "o", color=PURPLE, markersize=2.5, linestyle="none", label=label)
    else:
        _boxes(axes, samples, over, panel, finest)


def _boxes(axes: Any, samples: Samples, over: str, panel: _Panel, finest: tuple[float, float]) -> None:
    from matplotlib.collections import PolyCollection

    assert samples.boxes is not None
    stretches = boxes_over(samples.boxes, over, panel.name, panel.scale, *finest)
    look: dict[str, Any] = {"facecolor": (PURPLE, 0.35), "edgecolor": (PURPLE, 0.8), "linewidth": 1.8, "zorder": 2}
    label = "certified: the curve lies in the boxes"
    axes.add_collection(PolyCollection([outline(each) for each in stretches], label=label, **look), autolim=False)


def _events(fields: Sequence[Any], shown: Sequence[_Panel], run: SceneRun, over: str) -> None:
    """A mark on the curve at each event, and a line through all panels."""
    certified = run.strength == CERTIFIED
    colour, size = (PURPLE, 9) if certified else (VERMILION, 6)
    look: dict[str, Any] = {"color": colour, "markersize": size, "linestyle": "none", "zorder": 5}
    look |= {"markerfacecolor": "none" if certified else colour}
    for place in places(run, over):
        for axes, panel in zip(fields, shown, strict=True):
            axes.axvline(place.at, color=colour, linewidth=0.8, linestyle=(0, (2, 2)))
            value = None if run.samples is None else place.value(run.samples.columns[panel.name])
            if value is not None:
                mark = _MARKS.get(place.name, _OTHER_MARK)
                label = f"{place.name}, {'certified' if certified else 'floats'}"
                axes.plot(place.at, value / panel.scale, mark, label=label, **look)


def _limits(samples: Samples, panel: _Panel) -> tuple[float, float]:
    """Of the first panels what happens before the G-spot, and as much again on either side: an impact would hide all
    else. Of the others everything."""
    import numpy as np

    values, p = samples.columns[panel.name] / panel.scale, samples.columns["p"]
    ends = [float(values.min()), float(values.max()), *([] if panel.line is None else [panel.line])]
    least, most = min(ends), max(ends)
    if panel.name not in _FIRST:
        room = 0.08 * ((most - least) or 1.0)
        return least - room, most + room
    before: Column = values[: int(np.argmax(p < 0)) or len(p)]
    low, high = float(min(before.min(), 0)), float(max(before.max(), 0))
    room = _MARGIN * ((high - low) or 1.0)
    return max(low - room, least - 0.1 * room), min(high + room, most + 0.1 * room)


def caption(scene: Scene, runs: Sequence[SceneRun], theory: Sequence[Curve], over: str) -> str:
    """What is certified in the picture of these runs over "t" or "p", and what is only drawn."""
    parts = [f"{run.heading.capitalize()}: {run.fate}." for run in runs]
    certified = [run for run in runs if run.strength == CERTIFIED]
    if certified:
        impact = any(event.name == IMPACT for run in certified for event in run.events)
        shown = "; an impact has its mark where it is shown, it may begin before" if impact else ""
        parts.append(f"Certified are the events (marks in their brackets){shown}.")
    for verdict in (run.verdict for run in certified):
        parts.append(f"{verdict.outcome.value.capitalize()}: {verdict.statement}.")
    if any(run.samples is not None and run.samples.boxes is not None for run in certified):
        parts.append("The boxes are certified: at each time that is shown the trajectory lies in them.")
    elif any(run.samples is not None for run in certified):
        parts.append("The points are certified, nothing between them.")
    for run in runs:
        missing = [event.name for event in run.events if not places(replace(run, events=(event,)), over)]
        if missing:
            parts.append(f"Not shown, because nothing is sampled there: {', '.join(missing)}.")
    if len(certified) < len(runs):
        parts.append("The float run proves nothing.")
    if theory:
        shown = " and ".join(curve.label for curve in theory)
        parts.append(f"Beside it: {shown}; no error of these curves is bounded.")
    parts.append("All quantities are in the units of the scene.")
    left_out = list(scene.assumes())
    if left_out:
        parts.append(f"Effects left out: {', '.join(left_out)}.")
    return " ".join(parts)
