"""One phase compiled to functions of floats: rates, exact Jacobian matrix, events, read-out. Nothing is proved."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.equations.scaled_system import CONTACT
from gspot_verified.scenes.equations.terms import FLIGHT
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.scene.run import IMPACT
from gspot_verified.scenes.scene.scene import Scene, SceneError

if TYPE_CHECKING:
    from numpy import ndarray

_ABSOLUTE = 1e-3  # tolerance, as a share of the relative one
MAX_PULLING = 50_000
"""Evaluations of the equations in one piece of a run with lambda_N < 0, where lift_off is left out: SceneError beyond
it. A mechanism that the surface pulls may turn ever faster, and the run take ever longer."""


class _Pulling(Exception):
    """These evaluations are used up; the argument is the clock there."""


class FloatPhase:
    """``ends``: the name of each event that ends the phase, and the phase that follows; None: the run ends."""

    def __init__(self, scene: Scene, phase: str, large_force: float | None) -> None:
        system = scene.system(phase)
        self.phase, self.states = phase, system.states
        self._rates = float_function(system.right_hand_side)
        self._slopes = float_function([entry for row in system.jacobian() for entry in row])
        self._shown = float_function([function for _, function in system.read_out])
        self.names = tuple(name for name, _ in system.read_out)
        self._epsilon = approximate(scene.epsilon)
        self._may_pull = phase != FLIGHT and "lift_off" not in scene.effects
        self.guards = [
            (event.next_phase, float_function([event.function]))
            for event in system.events
            if event.next_phase not in (FLIGHT, CONTACT)
        ]
        self.ends: list[tuple[str, str | None]] = [(event.name, event.next_phase) for event in system.events]
        self._events = [_terminal(float_function([event.function])) for event in system.events]
        if large_force is not None and phase != FLIGHT:
            seen = float_function([system.shown("lambda_N"), system.shown("p")])

            def below(x: Sequence[float]) -> list[float]:
                force, p = seen(x)
                return [large_force - force if p < 0 else large_force]

            self.ends.append((IMPACT, None))
            self._events.append(_terminal(below))

    def integrate(self, state: Sequence[float], span: tuple[float, float], method: str, tolerance: float) -> Any:
        """What ``solve_ivp`` gives, with its dense output.

        :raises SceneError: the solver fails, its values are not finite, or the surface pulls for too long.
        """
        import numpy as np
        from scipy.integrate import solve_ivp

        size, left = len(self.states), itertools.count(MAX_PULLING, -1)
        surface, body = (self.states.index(name) for name in "ZY")

        def rates(t: float, y: ndarray[Any, Any]) -> list[float]:
            if self._may_pull and y[surface] < y[body] and next(left) <= 0:
                raise _Pulling(t)
            return self._rates([*map(float, y), t])

        try:
            with np.errstate(all="ignore"), warnings.catch_warnings():
                warnings.simplefilter("ignore")  # whether it went well is asked below
                solution = solve_ivp(
                    rates,
                    span,
                    np.array(state),
                    method=method,
                    jac=lambda t, y: np.array(self._slopes([*map(float, y), t])).reshape(size, size),
                    events=self._events,
                    rtol=tolerance,
                    atol=tolerance * _ABSOLUTE,
                    dense_output=True,
                )
        except _Pulling as end:
            raise SceneError(
                f"the float run ended in {self.phase} at t = {end.args[0] * self._epsilon:.6g}: the surface has pulled "
                f"in {MAX_PULLING} evaluations of the equations; without lift_off λ_N is supposed to be positive in "
                "contact, and where it is not this is no motion of the mechanism: add the effect, or end before"
            ) from None
        except (ArithmeticError, ValueError) as error:
            raise SceneError(f"the float run failed in {self.phase}: {error}") from None
        if not solution.success:
            raise SceneError(f"the float run failed in {self.phase}: {solution.message}")
        if not np.all(np.isfinite(solution.y)):
            raise SceneError(f"the float run failed in {self.phase}: a value is too large for a float")
        return solution

    def rows(self, times: Sequence[float], states: ndarray[Any, Any]) -> list[list[float]]:
        """t in the paper's units and the read-out, for each time; ``states`` has one column for each."""
        return [
            [float(t) * self._epsilon, *self._shown([*map(float, y), float(t)])]
            for t, y in zip(times, states.T, strict=True)
        ]

    def shown(self, state: Sequence[float], time: float) -> dict[str, float]:
        """The read-out at one state."""
        return dict(zip(self.names, self._shown([*state, time]), strict=True))


def _terminal(function: Callable[[Sequence[float]], list[float]]) -> Any:
    """An event of ``solve_ivp`` that ends the phase where the function falls through 0."""

    def event(t: float, y: ndarray[Any, Any]) -> float:
        return function([*map(float, y), t])[0]

    event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
    return event
