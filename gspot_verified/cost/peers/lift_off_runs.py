"""Runs of three scenes until after the first lift-off: certified, by scipy, by heyoka; and their right decimals.

heyoka, where it is installed: Taylor's method without a bound.
"""

from __future__ import annotations

import importlib.util
import math
import operator
from collections.abc import Callable, Sequence
from typing import Any

from flint import fmpq

from gspot_verified.functions.translation import Target, translated
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.certified_run import EXACT, certified_run
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.equations.terms import SLIP
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError


def heyoka_call(scene: Scene, tolerance: float) -> Callable[[], fmpq | None]:
    """A call that integrates slip until the force vanishes, and gives the time; None where that is not before the end.

    The equations are compiled here, once, and not within the call.

    :raises SceneError: the scene does not begin in slip.
    """
    import heyoka

    if scene.first_phase() != SLIP:
        raise SceneError(f"heyoka: the scene begins in {scene.first_phase()}, expected {SLIP}")
    system = scene.system(SLIP)
    names = heyoka.make_vars(*(f"x{i}" for i in range(len(system.states))))
    force = next(event.function for event in system.events if event.name == LIFT_OFF)
    *rates, vanishing = translated([*system.right_hand_side, force], _in_heyoka([*names, heyoka.time], heyoka))
    start = [approximate(scene.scaled_initial()[name]) for name in system.states]
    falling = heyoka.t_event(vanishing, direction=heyoka.event_direction.negative)
    made = heyoka.taylor_adaptive(list(zip(names, rates, strict=True)), start, tol=tolerance, t_events=[falling])
    end, small = approximate(scene.until / scene.epsilon), approximate(scene.epsilon)

    def call() -> fmpq | None:
        made.time = 0.0
        made.state[:] = start
        made.reset_cooldowns()
        outcome = made.propagate_until(end)[0]
        if outcome == heyoka.taylor_outcome.time_limit:
            return None
        return fmpq(*(made.time * small).as_integer_ratio())

    return call


def _in_heyoka(variables: Sequence[Any], heyoka: Any) -> Target:
    return Target(
        variable=lambda index: variables[index],
        constant=lambda value: heyoka.expression(approximate(value)),
        sum=heyoka.sum,
        product=operator.mul,
        power=lambda base, exponent: base ** approximate(exponent),
        function=lambda name, part: getattr(heyoka, name)(part),
    )


NAMES = ("model", "extended", "oscillator")
LIMITS = {
    "model": (0.15, 1.0, 6.0, 50.0),
    "extended": (0.15, 1.0, 6.0, 60.0),
    "oscillator": (0.5, 4.0, 20.0, 150.0),
}
"""Seconds of processor time for epsilon = 1e-3, 1e-4, 1e-5, 1e-6, certified, until after the first lift-off."""
_UNTIL = {
    "model": ("0.56", "0.515", "0.505", "0.502"),
    "extended": ("0.45", "0.4", "0.39", "0.385"),
    "oscillator": ("0.105", "0.117", "0.114", "0.113"),
}
"""Just after the first lift-off."""
CERTIFIED_BITS = (160, 192, 256)  # working precisions at which brackets are compared
HEYOKA_TOLERANCES = (1e-8, 1e-12, 1e-15)  # down to the last digit of a double
_REFERENCE_BITS = 320  # more than any run that is compared with it
_MOST_DECIMALS = 16.0  # of a double

Interval = tuple[fmpq, fmpq]
_known: dict[tuple[str, int], Interval] = {}


def scene_of(name: str, k: int) -> Scene:
    """The scene at epsilon = 10^-(k + 3)."""
    epsilon, until = fmpq(1, 10 ** (k + 3)), _UNTIL[name][k]
    if name == "model":
        return load_scene("fig-varsim1", epsilon=epsilon, until=until)
    if name == "extended":
        return load_scene("fig-varsim2", epsilon=epsilon, until=until, chi=1)
    return load_scene("oscillator", epsilon=epsilon, until=until)


def certified_bracket(scene: Scene, bits: int) -> Interval | None:
    """A bracket of the time of lift-off by the validated integrator with ``bits`` bits; None: undecided."""
    events = integrated_run(scene, bits=(bits,)).events
    return (events[0].lower, events[0].upper) if events and events[0].name == LIFT_OFF else None


def exact_bracket(scene: Scene, digits: int) -> Interval | None:
    """The same by the exact solution of the model scene, with ``digits`` digits."""
    events = certified_run(scene, digits, EXACT).events
    return (events[0].lower, events[0].upper) if events and events[0].name == LIFT_OFF else None


def float_time(scene: Scene, method: str, tolerance: float) -> fmpq | None:
    """The time of lift-off by scipy; None: the solver gives up, or reports another event first."""
    try:
        events = float_run(scene, method, tolerance).events
    except SceneError:
        return None
    return events[0].lower if events and events[0].name == LIFT_OFF else None


def heyoka_missing() -> str:
    """Why heyoka cannot be asked; empty when it can."""
    return "" if importlib.util.find_spec("heyoka") else "not installed on this machine"


def bracket_decimals(bracket: Interval) -> float:
    """How many decimals after the point a bracket fixes."""
    return round(-math.log10(approximate(bracket[1] - bracket[0])), 1)


def right_decimals(name: str, k: int, time: fmpq) -> float | None:
    """How many decimals of a time of lift-off without a bound are right; None where not one is."""
    if (name, k) not in _known:
        bracket = certified_bracket(scene_of(name, k), _REFERENCE_BITS)
        if bracket is None:
            return None
        _known[name, k] = bracket
    lower, upper = _known[name, k]
    error = max(abs(approximate(time - lower)), abs(approximate(time - upper)))
    decimals = min(_MOST_DECIMALS, round(-math.log10(error), 1))
    return decimals if decimals >= 1 else None
