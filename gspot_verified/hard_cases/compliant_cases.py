"""Hard cases of the compliant model: next to the canard, small ε, data of any size; a whole simulation."""

from __future__ import annotations

import math

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.hard_cases.hard_case import (
    Case,
    HardCase,
    bits_lost,
    double_text,
    log10,
    near,
    nearest_double,
    timed,
)
from gspot_verified.numbers.balls import ball_text, sign_of, working_bits
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import RunEvent
from gspot_verified.scenes.scene.scene import Scene, SceneError

BETA = fmpq(5, 2)  # of the run of the paper's Fig. varsim1 next to the canard
EPSILON = fmpq(1, 1000)  # of the same run
START = fmpq(1, 2)  # its p at the start
_SMALL_BETA, _SMALL_NU = fmpq(15, 2), fmpq(2)  # of the case of small epsilon


def start(beta: fmpq, epsilon: fmpq, nu: fmpq) -> tuple[CompliantModel, CompliantState]:
    """The paper's start p = 1/2, b = -nu lambda-bar/2, y = 4 b epsilon^2, v = 0, z = 2 b epsilon^2; alpha = (-1, -1,
    -beta)."""
    b = -nu / (2 * (beta - 1))
    return compliant_model(beta, epsilon), compliant_state(START, b, 4 * b * epsilon**2, 0, 2 * b * epsilon**2)


def next_to_the_canard(k: int) -> HardCase:
    """The sign of K for nu = 1 - 10^-k, epsilon = 1/1000, beta = 5/2; nu = 1 is the canard."""
    nu = near(1, k, -1)
    model, state = start(BETA, EPSILON, nu)
    rule, seconds = timed(lambda: side_rule(model, state))
    sign = sign_of(rule.side)
    mean = 1 / (nearest_double(BETA) - 1)
    given = -nearest_double(nu) * mean / 2
    canard = -mean / 2
    double = float((given > canard) - (given < canard))

    def deviation_of(bits: int) -> arb:
        with working_bits(bits):
            return arb(nu) / 2 - arb(fmpq(1, 2))

    # K has the sign of minus the deviation of b from the canard's value, at this beta and epsilon.
    return HardCase(
        level=k,
        asked=f"the sign of K, ν = 1 − 10^−{k}, β = 5/2, ε = 1/1000",
        condition=float(k),
        lost=bits_lost(deviation_of, 1),
        double=-double,
        double_said=f"b − b̄ = {double_text((given - canard) or 0.0)}",
        certified=sign,
        text=f"K = {ball_text(rule.side, 3)}",
        work=int(nu.q).bit_length(),
        seconds=seconds,
    )


def small_epsilon(k: int) -> HardCase:
    """The coefficient C of the slow solution, beta = 15/2, nu = 2, epsilon = 10^-k: an integral, its peak of width
    epsilon."""
    epsilon = fmpq(1, 10**k)
    model, state = start(_SMALL_BETA, epsilon, _SMALL_NU)
    rule, seconds = timed(lambda: side_rule(model, state))
    coefficient = rule.slow
    assert coefficient is not None
    double = slow_coefficient_in_doubles(nearest_double(epsilon))
    asked = f"C, β = 15/2, ν = 2, ε = 10^−{k}"
    return HardCase(
        level=k,
        asked=asked,
        condition=log10(_SMALL_BETA),
        double=double,
        certified=coefficient,
        text=ball_text(coefficient),
        work=int(coefficient.bits()),
        seconds=seconds,
    )


def slow_coefficient_in_doubles(epsilon: float) -> float:
    """C = epsilon (b_hat/p_0) H_(beta-1)(p_0) by scipy's quadrature on (0, 1)."""
    import warnings

    from scipy.integrate import quad

    a, p = float(_SMALL_BETA.p) / float(_SMALL_BETA.q) - 1, 0.5
    b_hat = -(2.0 - 1) / (2 * a)

    def weight(x: float) -> float:
        exponent = math.log1p(-x) + x + x * x / 2 - x**3 / 3 - p * x if x < 1 else -math.inf
        return float(x ** (a - 1) * math.exp(max(exponent / epsilon, -745.0)))

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it says itself that it may be wrong, and goes on
        integral = quad(weight, 0.0, 1.0)[0]
    return float(epsilon * b_hat / p * integral / math.gamma(a))


def tiny_deviation(k: int) -> HardCase:
    """The sign of K for a deviation of size 10^-k and no mean force."""
    state = compliant_state(START, -fmpq(1, 10**k), -fmpq(4, 10**k) * EPSILON**2, 0, -fmpq(2, 10**k) * EPSILON**2)
    model = compliant_model(BETA, EPSILON, alpha_2=0)
    rule, seconds = timed(lambda: side_rule(model, state))
    sign = sign_of(rule.side)
    b = -nearest_double(fmpq(1, 10**k))
    double = float((b > 0) - (b < 0)) * _SIGN_OF_SIDE
    text = f"b = {double_text(b or 0.0)}"
    asked = f"the sign of K, b = −10^−{k}, α₂ = 0"
    return HardCase(
        level=k,
        asked=asked,
        condition=0.0,
        lost=0,
        double=double,
        double_said=text,
        certified=sign,
        text=f"K = {ball_text(rule.side, 3)}",
        work=k,
        seconds=seconds,
    )


_SIGN_OF_SIDE = -1.0
"""That of K for b > 0 at the beta and epsilon of these cases: it is linear in the state."""


_PRECISIONS = (128, 256, 384)  # bits, tried in turn
_SOLVER, _TOLERANCE = "LSODA", 1e-10


def scene_next_to_the_canard(k: int) -> Scene:
    """The paper's run with nu = 1 - 10^-k."""
    return load_scene("fig-varsim1", beta=BETA, nu=near(1, k, -1), epsilon=EPSILON, until="1")


def certified_lift_off(scene: Scene) -> tuple[RunEvent | None, int]:
    """The first lift-off, and the first precision of a list at which it is found; None if at none."""
    for bits in _PRECISIONS:
        events = integrated_run(scene, bits=(bits,)).events
        if events and events[0].name == LIFT_OFF:
            return events[0], bits
    return None, _PRECISIONS[-1]


def run_next_to_the_canard(k: int) -> HardCase:
    """When a run that starts 10^-k from the canard lifts off."""
    scene = scene_next_to_the_canard(k)
    (lift_off, work), seconds = timed(lambda: certified_lift_off(scene))
    certified, text = None, "undecided"
    if lift_off is not None:
        with working_bits(work):
            certified = arb(lift_off.lower).union(arb(lift_off.upper))
            text = f"t = {ball_text(certified, 12)} after the start"
    double = None
    try:
        events = float_run(scene, _SOLVER, _TOLERANCE).events
        double = next((int(e.lower.p) / int(e.lower.q) for e in events if e.name == LIFT_OFF), None)
        said = "no event" if double is None else double_text(double)
    except SceneError:
        said = "the solver gave up"

    def deviation(bits: int) -> arb:
        with working_bits(bits):
            return arb(near(1, k, -1)) - 1

    asked = f"lift-off of a run, ν = 1 − 10^−{k}, β = 5/2, ε = 1/1000"
    return HardCase(
        level=k,
        asked=asked,
        condition=float(k),
        lost=bits_lost(deviation),
        double=double,
        double_said=said,
        certified=certified,
        text=text,
        work=work,
        seconds=seconds,
    )


CASES: dict[str, Case] = {
    "canard": next_to_the_canard,
    "small-epsilon": small_epsilon,
    "tiny-data": tiny_deviation,
    "run": run_next_to_the_canard,
}
