"""How much of the fast part of a scene's start is left at the G-spot: rigid slip in floats, nothing is proved."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.mechanisms.approach.fast_decay import decay_rate
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
_FIRST = 1e-3  # length of the first step, in units of s
_TOLERANCE = 1e-7  # of a step, relative, beside components of about 1/100 absolute
_MOST_STEPS = 20_000  # against endless work


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
            f"of a fast oscillation at the start about e^(-{self.exponent:.4g}/ε) = {self.factor:.2g} is left where "
            f"rigid slip reaches the G-spot, t = {self.time:.3g} (floats)"
        )


def fast_part(scene: Scene) -> FastPart | None:
    """None where the scene does not start in slip with p > 0 and b < 0, or slip does not reach a G-spot (where the
    scene knows u, nor where u has come down to the surface's velocity before); nor where friction depends on the slip
    speed: then p = 0 may be reached elsewhere (``proofs/slip_speed.md``).

    The path is that of rigid slip with its time slowed down by p: dxi/ds = p F - b G, dt/ds = p.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> print(fast_part(load_scene("fig-varsim1", epsilon="1/1000")))  # doctest: +ELLIPSIS
    of a fast oscillation at the start about e^(-0.01559/ε) = 1.7e-07 is left where rigid slip reaches the G-spot...
    """
    motion = scene.motion
    if scene.first_phase() != SLIP or (isinstance(motion, MechanismMotion) and motion.sees_slip_speed):
        return None
    flow = _RigidSlip(scene)
    p, b = flow.p_and_b(flow.start)
    if not (p > 0 and b < 0):
        return None
    try:
        return _followed(flow, p)
    except (ArithmeticError, ValueError):
        return None


def _followed(flow: _RigidSlip, p: float) -> FastPart | None:
    """To p = _NEAR of its start, and no end before: Runge and Kutta's steps, each beside its two halves."""
    state, s, length, exponent = flow.start, 0.0, _FIRST, 0.0
    for _ in range(_MOST_STEPS):
        half = _step(flow.rates, state, length / 2)
        end, rough = _step(flow.rates, half, length / 2), _step(flow.rates, state, length)
        error = max(abs(x - y) / (_TOLERANCE * (1e-2 + abs(x))) for x, y in zip(end, rough, strict=True))
        longer = length * min(2.0, 0.9 * max(error, 1e-10) ** -0.2)
        if not error <= 1:
            length = longer if error > 1 else length / 2
            continue
        near, *others = flow.ends(end, p)
        if near <= 0 and min(others) <= 0:
            length /= 2  # which of them comes first is seen in shorter steps
            continue
        first, middle, last = (max(flow.p_and_b(x)[0], 0.0) for x in (state, half, end))
        parts = [x * decay_rate(x, flow.regularisation) for x in (first, middle, last)]
        exponent += length / 6 * (parts[0] + 4 * parts[1] + parts[2])
        if near <= 0:
            return FastPart(exponent, math.exp(-exponent / flow.epsilon), end[-1] * flow.epsilon)
        if min(others) <= 0 or s > _LONGEST:
            return None
        state, s, length = end, s + length, longer
    return None


def _step(rates: Callable[[Sequence[float]], list[float]], state: list[float], length: float) -> list[float]:
    """One step of the classical method of Runge and Kutta."""
    first = rates(state)
    second = rates([x + length / 2 * r for x, r in zip(state, first, strict=True)])
    third = rates([x + length / 2 * r for x, r in zip(state, second, strict=True)])
    fourth = rates([x + length * r for x, r in zip(state, third, strict=True)])
    moves = zip(state, first, second, third, fourth, strict=True)
    return [x + length / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in moves]


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
        return self._seen(state)

    def ends(self, state: Sequence[float], start: float) -> tuple[float, float, float, float]:
        """What falls to 0 at the G-spot, then where p has gone far off, contact is lost, and slip stops; that is u less
        the velocity of the surface, positive where the scene does not know it."""
        p, b = self.p_and_b(state)
        slip = 1.0 if self._u is None else self._u(state)[0] - self._belt
        return p - _NEAR * start, _FAR * start - p, -b, slip

    def rates(self, state: Sequence[float]) -> list[float]:
        """dstate/ds = (p/epsilon) dstate/dT, with Z = lambda/k_2 to give the force and Y = V = 0."""
        p, b = self.p_and_b(state)
        pushed = [*state]
        pushed[self._fast[2]] = -b / p / self._k_2
        faster = p / self.epsilon
        rates = [faster * rate for rate in self._rates(pushed)]
        for i in self._fast:
            rates[i] = 0.0
        return [*rates, faster]
