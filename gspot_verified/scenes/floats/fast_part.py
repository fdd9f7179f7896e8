"""How much of the fast part of a scene's start is left at the G-spot: rigid slip in floats, nothing is proved."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from flint import fmpq

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.mechanisms.approach.fast_decay import surviving_exponent
from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.scenes.equations.terms import SLIP
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.mechanism_motion import MechanismMotion
from gspot_verified.scenes.scene.scene import Scene

_NEAR = 1e-4  # of p at the start: there the G-spot is as good as reached, what is left out of E is of its square
_FAR = 100.0  # times p at the start: it does not fall to a G-spot; any number is a choice
_LONGEST = 1e3  # in units of s, dt = p ds, against endless work
_STEPS = 400  # points of the path


@dataclass(frozen=True)
class FastPart(NoTruthValue, Written):
    """e^(-``exponent``/epsilon) = ``factor`` of it is left at the G-spot, at the ``time`` after the start; about so."""

    ask: ClassVar[str] = ".factor says how much is left"
    written: ClassVar[str] = "exponent factor time"

    exponent: float
    factor: float
    time: float

    def __str__(self) -> str:
        return (
            f"of a fast oscillation at the start about e^(-{self.exponent:.4g}/ε) = {self.factor:.2g} is left at the "
            f"G-spot, t = {self.time:.3g} (floats)"
        )


def fast_part(scene: Scene) -> FastPart | None:
    """None where the scene does not start in slip with p > 0 and b < 0, or slip does not reach a G-spot (where the
    scene knows u, nor where u has come down to the surface's velocity before); nor where friction depends on the slip
    speed: then p = 0 may be reached elsewhere (``proofs/slip_speed.md``).

    The path is that of rigid slip with its time slowed down by p: dxi/ds = p F - b G, dt/ds = p.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> print(fast_part(load_scene("fig-varsim1", epsilon="1/1000")))
    of a fast oscillation at the start about e^(-0.01559/ε) = 1.7e-07 is left at the G-spot, t = 0.5 (floats)
    """
    import numpy as np
    from scipy.integrate import solve_ivp

    motion = scene.motion
    if scene.first_phase() != SLIP or (isinstance(motion, MechanismMotion) and motion.sees_slip_speed):
        return None
    flow = _RigidSlip(scene)
    p, b = flow.p_and_b(flow.start)
    if not (p > 0 and b < 0):
        return None
    near, far = _ends(lambda x: flow.p_and_b(x)[0] - _NEAR * p), _ends(lambda x: _FAR * p - flow.p_and_b(x)[0])
    lift_off, slow = _ends(lambda x: -flow.p_and_b(x)[1]), _ends(flow.slip)
    try:
        path = solve_ivp(
            flow.rates, (0, _LONGEST), flow.start, "LSODA", events=[near, far, lift_off, slow], rtol=1e-8,
            dense_output=True,
        )  # fmt: skip
    except (ArithmeticError, ValueError):
        return None
    if path.status != 1 or not len(path.t_events[0]):
        return None
    states = path.sol(np.linspace(0, path.t[-1], _STEPS)).T
    p_on_way, times = [flow.p_and_b(state)[0] for state in states], states[:, -1] * flow.epsilon
    exponent = surviving_exponent([*times], p_on_way, flow.regularisation)
    return FastPart(exponent, math.exp(-exponent / flow.epsilon), float(times[-1]))


class _RigidSlip:
    """The equations of the scene with the force -b/p in the place of the contact; the last component is the clock."""

    def __init__(self, scene: Scene) -> None:
        system, start, values = scene.system(SLIP), scene.scaled_initial(), scene.values()
        self.epsilon = approximate(scene.epsilon)
        self.regularisation = Regularisation(values["k_1"], values["k_2"], values["damping"])
        self.start = [*(0.0 if name in "YVZ" else approximate(start[name]) for name in system.states), 0.0]
        self._fast = [system.states.index(name) for name in "YVZ"]
        self._k_2 = approximate(values["k_2"])
        self._rates = float_function(system.right_hand_side)
        self._seen = float_function([system.shown("p"), system.shown("b")])
        knows_slip = "u" in dict(system.read_out)
        self._u = float_function([system.shown("u")]) if knows_slip else None
        self._belt = approximate(values.get("belt_velocity", fmpq(0)))

    def p_and_b(self, state: Sequence[float]) -> list[float]:
        """At a state in which Y = V = Z = 0."""
        return self._seen([*map(float, state)])

    def slip(self, state: Sequence[float]) -> float:
        """u less the velocity of the surface; positive where the scene does not know it."""
        return 1.0 if self._u is None else self._u([*map(float, state)])[0] - self._belt

    def rates(self, _: float, state: Sequence[float]) -> list[float]:
        """dstate/ds = (p/epsilon) dstate/dT, with Z = lambda/k_2 to give the force and Y = V = 0."""
        p, b = self.p_and_b(state)
        pushed = [*map(float, state)]
        pushed[self._fast[2]] = -b / p / self._k_2
        faster = p / self.epsilon
        rates = [faster * rate for rate in self._rates(pushed)]
        for i in self._fast:
            rates[i] = 0.0
        return [*rates, faster]


def _ends(function: Any) -> Any:
    """An event of ``solve_ivp`` that ends the path."""

    def event(_: float, state: Sequence[float]) -> float:
        return float(function(state))

    event.terminal = True  # type: ignore[attr-defined]
    return event
