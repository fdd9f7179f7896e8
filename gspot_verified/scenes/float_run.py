"""Float runs: scipy in variables scaled by epsilon, with the exact Jacobian, phase after phase. Nothing is proved."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.balls import approximate
from gspot_verified.scenes.effects.terms import FLIGHT, STICK
from gspot_verified.scenes.float_function import FloatFunction, float_function
from gspot_verified.scenes.run import IMPACT, SIMULATED, RunEvent, Samples, SceneRun, fate_of
from gspot_verified.scenes.scaled_system import ScaledSystem
from gspot_verified.scenes.scene import Scene, SceneError
from gspot_verified.verdict import Reason, Verdict

if TYPE_CHECKING:
    from numpy import ndarray

METHODS = ("Radau", "LSODA", "BDF")
MAX_PHASES = 200
LEAST_EPSILON = fmpq(1, 10**12)
_ABSOLUTE = 1e-3


@dataclass
class _Record:
    """What the phases leave behind."""

    events: list[tuple[str, float]]
    rows: list[ndarray[Any, Any]]
    phases: list[str]


def float_run(scene: Scene, method: str = "Radau", tolerance: float = 1e-10) -> SceneRun:
    """The scene integrated with floats until ``scene.until``, or until the force is ``scene.stop_at_force`` times the
    first one at some p < 0, which is then called an impact without collision: a threshold, not a statement.

    :param tolerance: relative; the absolute one is a thousandth of it, in scaled variables.
    :raises SceneError: an unknown method, a tolerance outside 1e-13..1e-2, epsilon < 1e-12, or the solver fails.
    """
    import numpy as np

    if method not in METHODS:
        raise SceneError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    if not 1e-13 <= tolerance <= 1e-2:
        raise SceneError(f"tolerance: expected 1e-13..1e-2, got {tolerance}")
    if scene.epsilon < LEAST_EPSILON:
        raise SceneError(f"float runs need epsilon >= 1e-12, got {scene.epsilon}")
    record = _Record([], [], [])
    phase, state, time = scene.first_phase(), _scaled_start(scene), 0.0
    end = approximate(scene.until / scene.epsilon)
    force = float_function([scene.system(phase).shown("lambda_N")])(
        [*(state[n] for n in scene.system(phase).states), 0.0]
    )[0]
    for _ in range(MAX_PHASES):
        system = scene.system(phase)
        found = _phase(scene, system, [state[name] for name in system.states], (time, end), force, method, tolerance)
        record.rows.append(_rows(system, found.t, found.y, scene.epsilon))
        record.phases += [phase] * len(found.t)
        state = {**state, **dict(zip(system.states, map(float, found.y[:, -1]), strict=True))}
        time = float(found.t[-1])
        hits = zip(_ends(scene, system), found.t_events, strict=True)
        ended = next((event for event, times in hits if len(times)), None)
        if ended is None:
            break
        record.events.append((ended[0], time * approximate(scene.epsilon)))
        if ended[1] is None:
            break
        state["u"] = 0.0 if ended[1] == STICK else state.get("u", 1.0)
        phase = scene.contact_phase(state["u"] == 0) if ended[1] == "contact" else ended[1]
    columns = np.concatenate(record.rows, axis=1)
    names = ("t", *(name for name, _ in scene.system(phase).read_out))
    samples = Samples(dict(zip(names, columns, strict=True)), tuple(record.phases))
    events = tuple(RunEvent(name, *(2 * [fmpq(*at.as_integer_ratio())])) for name, at in record.events)
    fate = fate_of([event.name for event in events])
    detail = f"simulated with floats ({method}, relative tolerance {tolerance:g}): no error is bounded"
    return SceneRun(SIMULATED, fate, events, Verdict.undecided(fate, Reason.HYPOTHESIS, detail), samples)


def _scaled_start(scene: Scene) -> dict[str, float]:
    start, small = scene.initial(), scene.epsilon
    exact = {**start, "Y": start["y"] / small**2, "V": start["v"] / small, "Z": start["z"] / small**2}
    found = {name: approximate(value) for name, value in exact.items()}
    for name, value in found.items():
        if not math.isfinite(value):
            raise SceneError(f"start: {name} is too large for a float")
    return found


def _ends(scene: Scene, system: ScaledSystem) -> list[tuple[str, str | None]]:
    """The events of a phase and what follows them; None: the run ends."""
    ends: list[tuple[str, str | None]] = [(event.name, event.next_phase) for event in system.events]
    if scene.stop_at_force is not None and system.phase != FLIGHT:
        ends.append((IMPACT, None))
    return ends


def _phase(
    scene: Scene,
    system: ScaledSystem,
    state: Sequence[float],
    span: tuple[float, float],
    force: float,
    method: str,
    tolerance: float,
) -> Any:
    import numpy as np
    from scipy.integrate import solve_ivp

    size = len(system.states)
    rates = float_function(system.right_hand_side)
    slopes = float_function([entry for row in system.jacobian() for entry in row])
    events = [_terminal(_first(float_function([event.function]))) for event in system.events]
    if scene.stop_at_force is not None and system.phase != FLIGHT:
        large = approximate(scene.stop_at_force) * force
        seen = float_function([system.shown("lambda_N"), system.shown("p")])

        def below(x: Sequence[float]) -> float:
            found, p = seen(x)
            return large - found if p < 0 else large

        events.append(_terminal(below))
    found = solve_ivp(
        lambda t, y: rates([*y, t]),
        span,
        state,
        method=method,
        jac=lambda t, y: np.array(slopes([*y, t])).reshape(size, size),
        events=events,
        rtol=tolerance,
        atol=tolerance * _ABSOLUTE,
    )
    if not found.success:
        raise SceneError(f"the float run failed: {found.message}")
    return found


def _first(functions: FloatFunction) -> Callable[[Sequence[float]], float]:
    return lambda x: functions(x)[0]


def _terminal(function: Callable[[Sequence[float]], float]) -> Any:
    """An event of ``solve_ivp`` that ends the phase where the function falls through 0."""

    def event(t: float, y: Sequence[float]) -> float:
        return function([*y, t])

    event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
    return event


def _rows(system: ScaledSystem, times: Sequence[float], states: Any, epsilon: fmpq) -> ndarray[Any, Any]:
    import numpy as np

    shown = float_function([function for _, function in system.read_out])
    rows = [[t * approximate(epsilon), *shown([*y, t])] for t, y in zip(times, states.T, strict=True)]
    return np.array(rows).T
