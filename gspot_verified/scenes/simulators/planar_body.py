"""A mechanism that is one rigid body in a plane with one point that touches, as programs of rigid bodies know it.

Its mass matrix is diag(m, m, J), its place that of its mass centre and one angle; any forces may act. It is known by
numbers at some states: B and C of Sec. 2 and the directions M^-1 dx/dq, M^-1 dy/dq in which contact forces act.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import permutations

from gspot_verified.mechanisms.input.planar_links import PlanarJoint, PlanarLink, PlanarLinks
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import ContactFloats
from gspot_verified.scenes.simulators.planar_model import PlanarModel, moved_states

_CLOSE = 1e-9  # relative: as equal as these numbers in floats can be
_UNKNOWN = "its equations do not say which bodies move"
_OR_READ = "or a mechanism of from_urdf or from_mjcf can be told to it"


def planar_model(bodies: PlanarLinks | None, functions: ContactFloats, start: Sequence[float]) -> PlanarModel:
    """The mechanism as its ``bodies``, or else as the one body that its formulas tell.

    :raises SceneError: there are none, they form no tree of bodies with masses, or the friction is no constant.
    """
    if bodies is None and (functions.coordinates != 3 or len(start) != 6):
        raise SceneError(f"{_UNKNOWN}: only one rigid body with two places and one angle, {_OR_READ}")
    frictions = [functions.contact(state).mu for state in moved_states(start)]
    if not _same(frictions):
        raise SceneError("it takes a constant friction coefficient only")
    if bodies is not None:
        found = PlanarModel(bodies, tuple(range(functions.coordinates)), frictions[0], functions, tuple(start))
        found.check()
        return found
    for places in permutations(range(3)):
        body = _body(functions, tuple(start), places, frictions[0])
        if body is not None:
            return body
    raise SceneError(f"{_UNKNOWN}: only one rigid body in the plane, with the mass matrix diag(m, m, J), {_OR_READ}")


def _body(
    functions: ContactFloats, start: tuple[float, ...], places: tuple[int, ...], friction: float
) -> PlanarModel | None:
    x, y, angle = places
    light, inertias, heights, arms = [], [], [], []
    for state in moved_states(start):
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
            for arm, state in zip(arms, moved_states(start), strict=True)
        ]
        if all(_same([part[i] for part in turned_back], math.hypot(*arms[0])) for i in (0, 1)) and _same(
            offsets, math.hypot(*arms[0])
        ):
            joints = (
                PlanarJoint(is_hinge=False, place=(1, 0), reference=start[x]),
                PlanarJoint(is_hinge=False, place=(0, 1), reference=start[y]),
                PlanarJoint(is_hinge=True, place=(0, 0), turn=turn, reference=start[angle]),
            )
            link = PlanarLink((0, 1, 2), mass=1 / light[0], inertia=inertias[0], centre=(0, 0))
            bodies = PlanarLinks(joints, (link,), link.joints, (turn * arms[0][0], turn * arms[0][1]))
            return PlanarModel(bodies, places, friction, functions, start)
    return None


def _rotated(arm: tuple[float, float], angle: float) -> tuple[float, float]:
    cosine, sine = math.cos(angle), math.sin(angle)
    return cosine * arm[0] - sine * arm[1], sine * arm[0] + cosine * arm[1]


def _same(values: Sequence[float], size: float = 0.0) -> bool:
    return max(values) - min(values) <= _CLOSE * max(size, *map(abs, values))
