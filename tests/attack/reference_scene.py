"""A body on its compliant contact from Lagrange's equations by sympy, run by scipy's DOP853 through slip, stick,
reverse slip and flight.

M(q) q'' = F + J_x lambda_t + J_y lambda, eps^2 lambda = k_2 (z - y), (c/eps) z' = -k_1 z/eps^2 - lambda. A crossing is
sought in the dense output; one that starts at 0, comes together with another or only touches 0 raises ``Unsure``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import scipy.integrate
import scipy.optimize
import sympy

FAR = 1e-6
"""How far a quantity must be from 0 that its sign is believed; times closer than this are not told apart."""
_PARTS = 6
_MOST = 40


class Unsure(Exception):
    """A tie, a grazing event, or a start at one."""


@dataclass(frozen=True)
class Texts:
    """A scene in formulas: texts in the coordinates, their rates ``q_dot`` and ``t``."""

    coordinates: tuple[str, ...]
    mass: tuple[tuple[str, ...], ...]
    forces: tuple[str, ...]
    x: str
    y: str
    mu: str
    negative: bool
    effects: tuple[str, ...]
    numbers: Mapping[str, Any]
    """epsilon, until, k_1, k_2, c, belt_velocity."""
    start: Mapping[str, Any]
    """All coordinates and rates but those of the last coordinate but one; y, v, z in their place."""
    solved: str


class Scene:
    """The right sides at a state [q, q_dot, z]."""

    def __init__(self, texts: Texts) -> None:
        self.texts = texts
        names = [*texts.coordinates, *(f"{name}_dot" for name in texts.coordinates), "t"]
        self.symbols = {name: sympy.Symbol(name, real=True) for name in names}
        q = [self.symbols[name] for name in texts.coordinates]
        w = [self.symbols[f"{name}_dot"] for name in texts.coordinates]
        time = self.symbols["t"]

        def rate(f: sympy.Expr) -> sympy.Expr:
            return f.diff(time) + sum(f.diff(a) * b for a, b in zip(q, w, strict=True))

        x, y = self._formula(texts.x) * (-1 if texts.negative else 1), self._formula(texts.y)
        inverse = sympy.Matrix([[self._formula(entry) for entry in row] for row in texts.mass]).inv()
        u, v = rate(x), rate(y)
        rows = [sympy.Matrix([[f.diff(b) for b in w]]) for f in (u, v)]
        free = inverse * sympy.Matrix([self._formula(force) for force in texts.forces])
        push = [inverse * row.T for row in rows]
        a, b = ((row * free)[0] + rate(f) for row, f in zip(rows, (u, v), strict=True))
        scalars = [
            a,
            b,
            *((rows[i] * push[j])[0] for i, j in ((0, 0), (0, 1), (1, 1))),
            u,
            v,
            y,
            self._formula(texts.mu),
        ]
        self.y, self.v = y, v
        self._call = sympy.lambdify([*q, *w, time], [*free, *push[0], *push[1], *scalars], "math", cse=True)
        self.size = len(q)
        self.number = {name: float(value) for name, value in texts.numbers.items()}

    def _formula(self, text: str) -> sympy.Expr:
        return sympy.sympify(text.replace("^", "**"), locals=self.symbols, rational=True)

    def at(self, time: float, state: Sequence[float]) -> dict[str, Any]:
        """The free acceleration, both pushes, a, b, A, B, C, u, v, y, mu and the force."""
        n = self.size
        found = self._call(*map(float, state[: 2 * n]), time)
        names = ("a", "b", "A", "B", "C", "u", "v", "y", "mu")
        here = dict(zip(names, found[3 * n :], strict=True))
        force = self.number["k_2"] / self.number["epsilon"] ** 2 * (float(state[-1]) - here["y"])
        return {"free": found[:n], "x": found[n : 2 * n], "n": found[2 * n : 3 * n], "force": force, **here}

    def first(self) -> list[float]:
        """The state at the start: y and v are solved for one coordinate and its rate."""
        given = {name: sympy.Rational(str(value)) for name, value in self.texts.start.items()}
        own, rate = self.symbols[self.texts.solved], self.symbols[f"{self.texts.solved}_dot"]
        known = {symbol: given.get(name, 0) for name, symbol in self.symbols.items() if symbol not in (own, rate)}
        place = sympy.solve(self.y.subs(known) - given.get("y", 0), own)[0]
        known[own] = place
        known[rate] = sympy.solve(self.v.subs(known) - given.get("v", 0), rate)[0]
        order = [*self.texts.coordinates, *(f"{name}_dot" for name in self.texts.coordinates)]
        return [*(float(known[self.symbols[name]]) for name in order), float(given.get("z", 0))]

    def rates(self, phase: str) -> Callable[[float, Sequence[float]], list[float]]:
        """The right side in one phase."""
        n, number = self.size, self.number

        def found(time: float, state: Sequence[float]) -> list[float]:
            here = self.at(time, state)
            force = 0.0 if phase == "flight" else here["force"]
            along = {
                "flight": 0.0, "slip": -here["mu"] * force, "reverse": here["mu"] * force,
                "stick": -(here["a"] + here["B"] * force) / here["A"],
            }[phase]  # fmt: skip
            turn = [f + x * along + y * force for f, x, y in zip(here["free"], here["x"], here["n"], strict=True)]
            give = number["epsilon"] / number["c"] * (-number["k_1"] / number["epsilon"] ** 2 * state[-1] - force)
            return [*state[n : 2 * n], *turn, give]

        return found

    def slip(self, here: Mapping[str, Any]) -> float:
        """Beside the belt."""
        return float(here["u"] - self.number["belt_velocity"])

    def watched(self, phase: str) -> dict[str, Callable[[Mapping[str, Any]], float]]:
        """What is positive as long as the phase lasts."""
        found: dict[str, Callable[[Mapping[str, Any]], float]] = {}
        if phase == "flight":
            found["touch-down"] = lambda here: -here["force"]
        elif "lift_off" in self.texts.effects:
            found["lift-off"] = lambda here: here["force"]
        if "stick" in self.texts.effects:
            if phase == "slip":
                found["stop"] = self.slip
            elif phase == "reverse":
                found["stop"] = lambda here: -self.slip(here)
            elif phase == "stick":
                found["slip forwards"] = lambda here: _cone(here)[0]
                found["slip backwards"] = lambda here: _cone(here)[1]
        return found

    def closed(self, here: Mapping[str, Any]) -> str:
        """The phase in contact."""
        if "stick" not in self.texts.effects:
            return "slip"
        slip = self.slip(here)
        if abs(slip) < 1e-12:
            return _rest(here)
        if abs(slip) < FAR:
            raise Unsure("the slip velocity is nearly 0")
        return "slip" if slip > 0 else "reverse"

    def begun(self, state: Sequence[float]) -> str:
        """The phase at the start."""
        here = self.at(0.0, state)
        gap = here["force"]
        if abs(gap) < 1e-12:  # just touching: what the force does next
            give = -self.number["k_1"] / (self.number["epsilon"] * self.number["c"])
            gap = give * state[-1] - here["v"]
            if abs(gap) < 1e-12:
                gap = give**2 * state[-1] - here["b"]
            if abs(gap) < FAR:
                raise Unsure("it starts on the surface of lift-off")
        elif abs(gap) < FAR:
            raise Unsure("it starts next to lift-off")
        return self.closed(here) if gap > 0 or "lift_off" not in self.texts.effects else "flight"


def _cone(here: Mapping[str, Any]) -> tuple[float, float]:
    held, needed = here["mu"] * here["A"] * here["force"], here["a"] + here["B"] * here["force"]
    return held - needed, held + needed


def _rest(here: Mapping[str, Any]) -> str:
    forwards, backwards = _cone(here)
    if min(abs(forwards), abs(backwards)) < FAR:
        raise Unsure("the friction is at its limit just when slip stops")
    if forwards > 0 and backwards > 0:
        return "stick"
    if forwards < 0 and backwards < 0:
        raise Unsure("slip may go on both ways")
    return "slip" if forwards < 0 else "reverse"


@dataclass
class Run:
    """Events with their times; in contact the least force, slip velocity beside the belt and least mu there."""

    events: list[tuple[str, float]]
    least_force: float
    least_slip: float
    least_friction: float
    first: str
    last: list[float]
    """The state at the end."""


def run(scene: Scene) -> Run:
    """Until the scene's end. ``Unsure`` where an event is not certain."""
    state, time, until = scene.first(), 0.0, scene.number["until"]
    phase = scene.begun(state)
    found = Run([], math.inf, math.inf, math.inf, phase, state)
    while len(found.events) < _MOST:
        hit = _until_event(scene, phase, time, state, until, found)
        if hit is None:
            return found
        name, time, state = hit
        here = scene.at(time, state)
        if name == "stop":
            phase = _rest(here)
            name = {"stick": "stick", "slip": "slip forwards", "reverse": "slip backwards"}[phase]
        elif name == "touch-down":
            phase = scene.closed(here)
        else:
            phase = {"lift-off": "flight", "slip forwards": "slip", "slip backwards": "reverse"}[name]
        if found.events and time - found.events[-1][1] < FAR:
            raise Unsure("two events nearly coincide")
        found.events.append((name, time))
    raise Unsure("too many events")


def _until_event(
    scene: Scene, phase: str, time: float, state: Sequence[float], until: float, found: Run
) -> tuple[str, float, list[float]] | None:
    watched = scene.watched(phase)
    if time >= until:
        return None
    solver = scipy.integrate.DOP853(
        scene.rates(phase), time, state, until, rtol=1e-11, atol=1e-13, max_step=scene.number["epsilon"] / 12
    )
    armed = dict.fromkeys(watched, False)
    before = {name: watch(scene.at(time, state)) for name, watch in watched.items()}
    low = before
    while solver.status == "running":
        solver.step()
        if solver.status == "failed":
            raise Unsure("the integration fails")
        dense, hits = solver.dense_output(), []
        for k in range(1, _PARTS + 1):
            left = solver.t_old + (solver.t - solver.t_old) * (k - 1) / _PARTS
            right = solver.t_old + (solver.t - solver.t_old) * k / _PARTS
            here = scene.at(right, dense(right))
            _note(scene, phase, here, found)
            for name, watch in watched.items():
                now = watch(here)
                if armed[name] and now < 0:
                    hits.append((scipy.optimize.brentq(
                        lambda s, w=watch, d=dense: w(scene.at(s, d(s))), left, right, xtol=1e-15), name))  # fmt: skip
                elif not armed[name] and now < -FAR:
                    raise Unsure(f"{name} at once")
                elif armed[name] and low[name] < before[name] and low[name] < now and low[name] < FAR:
                    raise Unsure(f"{name} may graze")
                armed[name] = armed[name] or now > FAR
                before, low = {**before, name: low[name]}, {**low, name: now}
            if hits:
                hits.sort()
                if len(hits) > 1 and hits[1][0] - hits[0][0] < FAR:
                    raise Unsure("two events nearly coincide")
                # Another event just behind this one is not told apart either.
                after = scene.at(min(hits[0][0] + FAR, solver.t), dense(min(hits[0][0] + FAR, solver.t)))
                if any(armed[name] and watch(after) < 0 for name, watch in watched.items() if name != hits[0][1]):
                    raise Unsure("two events nearly coincide")
                return hits[0][1], hits[0][0], [float(x) for x in dense(hits[0][0])]
    found.last = [float(x) for x in solver.y]
    return None


def _note(scene: Scene, phase: str, here: Mapping[str, Any], found: Run) -> None:
    if phase != "flight":
        found.least_friction = min(found.least_friction, here["mu"])
        found.least_force = min(found.least_force, here["force"])
        found.least_slip = min(found.least_slip, scene.slip(here))
