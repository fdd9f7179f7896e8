"""The phase plane (p, b) of a mechanism's rigid slip next to its G-spot.

With lambda_N = -b/p and dt = p dsigma the motion is dxi/dsigma = p F - b G, regular at the G-spot, which is a node for
alpha_1, alpha_3 < 0: p' = alpha_1 p, b' = alpha_2 p + alpha_3 b at first order (paper, Sec. 1.2). Runs are made with
balls cut to their midpoints, without any bound: they show, they prove nothing. The eigen-directions are exact.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.approach.state_beside import state_beside
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.report.pictures.canvas import (
    BLUE,
    GREEN,
    INK,
    LAMBDA_N,
    ORANGE,
    PURPLE,
    Picture,
    canvas,
    picture,
    styled,
)

_OWN = " The given start: middles of enclosures at certified points of its path; lines between them are only drawn."
_BITS = 80  # beyond what a picture shows
_ORDER = 13  # of the expansion that starts the distinguished trajectory
_STEPS = 220  # of Runge-Kutta in a run
_REACH = 6  # how long a run is, in units of the longer of 1/|alpha_1| and 1/|alpha_3|
_SHRINKS = 12  # halvings of the window, where no states in contact are found or p does not fall
_STARTS = (fmpq(1, 12), fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(3, 2), fmpq(2))
"""Of -b at the start, in units of the picture."""
_BACK = 16  # the expansion serves over this part of the way to the window's edge

Run = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class PhasePlane:
    """What is drawn: runs as points (p, b); ``slope`` is b/p of the eigen-direction of alpha_1."""

    name: str
    alphas: tuple[float, float, float]
    slope: float
    reach: float
    runs: tuple[Run, ...]
    distinguished: Run
    own: Run


class RigidSlip:
    """dxi/dsigma = p F - b G, as floats would do it."""

    def __init__(self, spot: GSpot) -> None:
        system = spot.system
        self.dimension = len(system.point)
        self._field = BoxProgram([*system.F, *system.G, system.p, system.b], self.dimension)
        self._spot = spot

    def place(self, state: Sequence[arb]) -> tuple[float, float]:
        """p and b."""
        values = self._field.values(state)
        return float(values[-2].mid()), float(values[-1].mid())

    def slope(self, state: Sequence[arb]) -> list[arb]:
        """The right-hand side."""
        values, m = self._field.values(state), self.dimension
        p, b = values[-2], values[-1]
        return [(p * values[i] - b * values[m + i]).mid() for i in range(m)]

    def state_at(self, p: arb, b: arb) -> list[arb] | None:
        """A state next to the G-spot with these p and b, on the surface, J = 0, by Newton's method; None: not found."""
        return state_beside(self._spot, p, b)

    def run(self, state: Sequence[arb], span: float) -> Run:
        """(p, b) along the run, by the classical Runge-Kutta method."""
        step, current = arb(span / _STEPS), list(state)
        places = [self.place(current)]
        for _ in range(_STEPS):
            first = self.slope(current)
            second = self.slope(_moved(current, first, step / 2))
            third = self.slope(_moved(current, second, step / 2))
            fourth = self.slope(_moved(current, third, step))
            mean = [(a + 2 * b + 2 * c + d) / 6 for a, b, c, d in zip(first, second, third, fourth, strict=True)]
            current = _moved(current, mean, step)
            if not all(value.is_finite() for value in current):
                break
            places.append(self.place(current))
        return tuple(places)


def _moved(state: Sequence[arb], slope: Sequence[arb], step: arb) -> list[arb]:
    return [(value + step * rate).mid() for value, rate in zip(state, slope, strict=True)]


def phase_plane(mechanism: Mechanism, state: StateInput | None = None, spot: int | None = None) -> PhasePlane:
    """The runs of the picture; ``state``: one of the user's own, as for :func:`mechanisms.approach.approach.approach`;
    ``spot``: the number of the G-spot in the list of ``classify_all``.

    :raises GSpotError: the mechanism has no G-spot there.
    :raises ValueError: ``state`` is no start (see there); alpha_1 or alpha_3 is not negative; no runs in contact were
        found on which p falls; or there is no G-spot of that number.
    """
    mechanism = at_spot(mechanism, spot)
    centre = find_g_spot(mechanism, _BITS)
    own = () if state is None else _path(mechanism, state)
    with working_bits(_BITS):
        system = centre.system
        first, second, third = (ball(value).mid() for value in system.check())
        slope = (second / (first - third)).mid()
        slip = RigidSlip(centre)
        span = _REACH / min(float(abs(first)), float(abs(third)))
        reach = arb(abs(own[0][0])) if own else arb(fmpq(1, 4))
        for _ in range(_SHRINKS):
            width = arb(max(2 * abs(float(slope)), 1.0)) * reach
            starts = [slip.state_at(reach, (-ball(k) * width).mid()) for k in _STARTS]
            runs = tuple(_in_contact(slip.run(start, span)) for start in starts if start is not None)
            if len(runs) == len(starts) and all(map(_falls, runs)):
                window = max(float(reach), *(p for p, _ in own), 0.0) if own else float(reach)
                straight = _distinguished(slip, expand(mechanism, _ORDER), window)
                alphas = (float(first), float(second), float(third))
                return PhasePlane(mechanism.name, alphas, float(slope), window, runs, straight, own)
            reach = reach / 2
    raise ValueError(f"{mechanism.name}: no runs in contact on which p falls were found next to the G-spot")


def _path(mechanism: Mechanism, state: StateInput) -> Run:
    """Middles of the enclosures of (p, b) along the validated path."""
    path = approach(mechanism, state).path
    return tuple((float(p.mid()), float(b.mid())) for p, b in zip(path.p, path.b, strict=True))


def _in_contact(run: Run) -> Run:
    """The run up to its lift-off, b = 0."""
    end = next((i for i, (_, b) in enumerate(run) if b > 0), len(run))
    return run[: end + 1]


def _falls(run: Run) -> bool:
    """Whether p does: far from the G-spot alpha_1 is not its rate, and slip may lead away."""
    return all(later[0] <= earlier[0] for earlier, later in pairwise(run))


def _distinguished(slip: RigidSlip, trajectory: Trajectory, reach: float) -> Run:
    """Theorem 1's expansion at epsilon = 0, still close to the G-spot, and from there a run backwards while p rises."""
    series = trajectory.in_time()
    rate = abs(float(ball(series.p[1, 0]).mid()))
    time = arb(-reach / _BACK / rate)
    state = []
    for start, table in zip(trajectory.system.point, series.xi, strict=True):
        terms = (ball(value) * time**k for (k, m), value in table.items() if m == 0)
        state.append((ball(start) + sum(terms, arb(0))).mid())
    back = [(0.0, 0.0)]
    for point in slip.run(state, -math.log(4 * _BACK) / rate):
        if not back[-1][0] < point[0] <= 1.05 * reach:
            break
        back.append(point)
    return tuple(back)


def arrow_of_time(run: Run, width: float, height: float) -> Run | None:
    """Two points of a run, one after the other in time, in the middle of its length in a picture of this size; None:
    the run has no length.

    >>> arrow_of_time(((1.0, 0.0), (0.8, 0.0), (0.4, 0.0), (0.0, 0.0)), 1, 1)
    ((0.8, 0.0), (0.4, 0.0))
    """
    lengths = [math.hypot((q[0] - p[0]) / width, (q[1] - p[1]) / height) for p, q in pairwise(run)]
    passed = 0.0
    for k, length in enumerate(lengths):
        passed += length
        if length > 0 and passed >= sum(lengths) / 2:
            return run[k], run[k + 1]
    return None


def phase_plane_picture(mechanism: Mechanism, state: StateInput | None = None, spot: int | None = None) -> Picture:
    """The phase plane as a figure with its caption; arguments and errors as for :func:`phase_plane`."""
    plane = phase_plane(mechanism, state, spot)
    return styled(lambda: _draw(plane))()


def _arrow(axes: Any, ends: Run | None, colour: str) -> None:
    if ends is not None:
        look = {"arrowstyle": "-|>", "color": colour, "linewidth": 0, "mutation_scale": 11, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", ends[1], ends[0], arrowprops=look)


def _draw(plane: PhasePlane) -> Picture:
    figure = canvas(4.8)
    axes = figure.add_subplot()
    reach = plane.reach
    height = 1.1 * max(abs(b) for run in (*plane.runs, plane.own) for _, b in run)
    axes.axhspan(0, height, color=ORANGE, alpha=0.12, linewidth=0)
    axes.text(reach, 0.31 * height, rf"{LAMBDA_N} $= -b/p < 0$: lift-off", ha="right", va="top", fontsize=8.5)
    for index, run in enumerate(plane.runs):
        label = None if index else "slip, float runs"
        axes.plot(*zip(*run, strict=True), color=BLUE, linewidth=1.0, label=label)
        _arrow(axes, arrow_of_time(run, reach, height), BLUE)
    ends = (0.0, 1.05 * reach)
    dashed = [plane.slope * p for p in ends]
    axes.plot(ends, dashed, color=INK, linewidth=1.0, linestyle="--", label="eigen-direction, α₁")
    axes.axvline(0, color=INK, linewidth=1.0, linestyle=":", label="eigen-direction, α₃ (p = 0)")
    axes.plot(*zip(*plane.distinguished, strict=True), color=GREEN, linewidth=2.4, label="distinguished trajectory")
    _arrow(axes, arrow_of_time(plane.distinguished[::-1], reach, height), GREEN)
    if plane.own:
        axes.plot(*zip(*plane.own, strict=True), color=PURPLE, linewidth=2, label="the given start, certified points")
        axes.plot(*plane.own[0], "s", color=PURPLE, markersize=5)
    axes.plot(0, 0, "o", color=INK, markersize=6, zorder=6)
    axes.annotate("G-spot", (0, 0), xytext=(6, 6), textcoords="offset points")
    axes.set(xlabel="$p$", ylabel="$b$", xlim=(-0.08 * reach, 1.05 * reach), ylim=(-height, 0.35 * height))
    axes.set_title(plane.name, loc="left", parse_math=False)
    axes.legend(loc="lower left", fontsize=8)
    return picture(
        figure,
        "phase-plane",
        f"Slip next to the G-spot: {plane.name}",
        "Motion is to the left, as the arrows say: p falls to 0. The eigen-directions are those of the proved G-spot. "
        "The thick curve begins with Theorem 1's expansion at ε = 0, next to the G-spot, and goes on as a float run "
        "backwards. The thin curves are float runs of rigid slip, up to lift-off, b = 0: they show, they prove nothing."
        + (_OWN if plane.own else ""),
        "Curves that flow into the origin, along one straight direction or along the vertical axis.",
    )
