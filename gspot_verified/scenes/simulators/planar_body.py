"""A mechanism that is one rigid body in a plane with one point that touches, as programs of rigid bodies know it.

Its mass matrix is diag(m, m, J), its place that of its mass centre and one angle; any forces may act. It is known by
numbers at some states: B and C of Sec. 2 and the directions M^-1 dx/dq, M^-1 dy/dq in which contact forces act.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations

from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import ContactFloats

_CLOSE = 1e-9  # relative: as equal as these numbers in floats can be
_MOVED = (0.0, 0.4, -0.7, 1.3)  # the states at which they are looked at: the start, with each component moved so far


@dataclass(frozen=True)
class PlanarBody:
    """``places``: which coordinates are X, Y and the angle; ``turn``: 1 where the angle counts from X to Y, else -1.

    ``arm``: from the mass centre to the point that touches, at the start.
    """

    mass: float
    inertia: float
    friction: float
    places: tuple[int, ...]
    turn: int
    arm: tuple[float, float]
    functions: ContactFloats
    start: tuple[float, ...]

    def moved(self, state: Sequence[float]) -> list[float]:
        """How far X, Y and the angle, counted from X to Y, are from the start."""
        return [sign * (state[i] - self.start[i]) for i, sign in zip(self.places, (1, 1, self.turn), strict=True)]

    def rates(self, state: Sequence[float]) -> list[float]:
        """Their velocities."""
        return [sign * state[3 + i] for i, sign in zip(self.places, (1, 1, self.turn), strict=True)]

    def forces(self, state: Sequence[float]) -> list[float]:
        """All forces but those of the contact, on X, Y and that angle."""
        free = self.functions.rates(state)[0]
        weights = (self.mass, self.mass, self.turn * self.inertia)
        return [weight * free[3 + i] for i, weight in zip(self.places, weights, strict=True)]

    def state(self, moved: Sequence[float], rates: Sequence[float]) -> list[float]:
        """The state of the mechanism again."""
        state = list(self.start)
        for i, sign, way, rate in zip(self.places, (1, 1, self.turn), moved, rates, strict=True):
            state[i], state[3 + i] = self.start[i] + sign * way, sign * rate
        return state


def planar_body(functions: ContactFloats, start: Sequence[float]) -> PlanarBody:
    """The mechanism as one body.

    :raises SceneError: it is not one, or its friction is no constant.
    """
    if functions.coordinates != 3 or len(start) != 6:
        raise SceneError("only one rigid body with two places and one angle can be told to it")
    frictions = [functions.contact(state).mu for state in _states(start)]
    if not _same(frictions):
        raise SceneError("it takes a constant friction coefficient only")
    for places in permutations(range(3)):
        found = _body(functions, tuple(start), places, frictions[0])
        if found is not None:
            return found
    raise SceneError("only one rigid body in the plane, with the mass matrix diag(m, m, J), can be told to it")


def _states(start: Sequence[float]) -> list[list[float]]:
    return [[value + way * (1 + i / 7) for i, value in enumerate(start)] for way in _MOVED]


def _body(
    functions: ContactFloats, start: tuple[float, ...], places: tuple[int, ...], friction: float
) -> PlanarBody | None:
    x, y, angle = places
    light, inertias, heights, arms = [], [], [], []
    for state in _states(start):
        _, tangent, normal = (rates[3:6] for rates in functions.rates(state))
        contact = functions.contact(state)
        if abs(tangent[y]) + abs(normal[x]) > _CLOSE * (abs(tangent[x]) + abs(normal[y])):
            return None
        light += [tangent[x], normal[y]]
        turned = tangent[angle] ** 2 + normal[angle] ** 2
        if turned == 0 or tangent[x] <= 0:
            return None
        inertias.append((contact.A + contact.C - tangent[x] - normal[y]) / turned)
        # The arm r(cos, sin) moves along turn r(-sin, cos) with the angle: that is J times what was found.
        arms.append((normal[angle] * inertias[-1], -tangent[angle] * inertias[-1]))
        heights.append(contact.y - state[y])
    if not (_same(light) and _same(inertias) and inertias[0] > 0):
        return None
    for turn in (1, -1):
        offsets = [height - turn * arm[1] for height, arm in zip(heights, arms, strict=True)]
        turned_back = [
            _rotated(arm, -turn * (state[angle] - start[angle]))
            for arm, state in zip(arms, _states(start), strict=True)
        ]
        if all(_same([part[i] for part in turned_back], math.hypot(*arms[0])) for i in (0, 1)) and _same(
            offsets, math.hypot(*arms[0])
        ):
            arm = (turn * arms[0][0], turn * arms[0][1])
            return PlanarBody(
                mass=1 / light[0],
                inertia=inertias[0],
                friction=friction,
                places=places,
                turn=turn,
                arm=arm,
                functions=functions,
                start=start,
            )
    return None


def _rotated(arm: tuple[float, float], angle: float) -> tuple[float, float]:
    cosine, sine = math.cos(angle), math.sin(angle)
    return cosine * arm[0] - sine * arm[1], sine * arm[0] + cosine * arm[1]


def _same(values: Sequence[float], size: float = 0.0) -> bool:
    return max(values) - min(values) <= _CLOSE * max(size, *map(abs, values))
