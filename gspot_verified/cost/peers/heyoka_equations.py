"""The equations of a scene for heyoka, Taylor's method without a bound, where it is installed."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from flint import fmpq

from gspot_verified.functions.translation import Target, translated
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.equations.terms import SLIP
from gspot_verified.scenes.scene.scene import Scene, SceneError


def lift_off_call(scene: Scene, tolerance: float) -> Callable[[], fmpq | None]:
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
