"""What the theory says beside a run: the canard, and the scaled Theta. No error of these curves is bounded.

Paper: eqs. modelSysDistB, modelSysDistZY (the model's trivial solution), Theorem 1 (a mechanism's distinguished
trajectory), Sec. 4.5 (Theta).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.theta_function.value.evaluate import evaluate

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
