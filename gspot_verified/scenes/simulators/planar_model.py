"""Rigid bodies in a plane with one point that touches, beside the mechanism whose bodies they are.

A program is told the bodies, with the forces that give them the mechanism's own accelerations where nothing touches; so
of the bodies count the mass matrix and the place of the point, and these are compared (:func:`engine.follow`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from gspot_verified.mechanisms.input.planar_links import PlanarLink, PlanarLinks
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import ContactFloats

_RADIUS = 1e-4  # of the sphere that touches, over the radius of gyration about the point at its middle
_MOVED = (0.0, 0.4, -0.7, 1.3)  # the start, with each component moved so far


@dataclass(frozen=True)
class Placed:
    """A body in its tree: ``above`` is the number of the one that it hangs on, or None; ``joints`` are between them."""

    link: PlanarLink
    above: int | None
    joints: tuple[int, ...]


@dataclass(frozen=True)
class PlanarModel:
    """``order``: which coordinate of the mechanism each joint is; ``start`` is a state of the mechanism."""

    bodies: PlanarLinks
    order: tuple[int, ...]
    friction: float
    functions: ContactFloats
    start: tuple[float, ...]

    def places(self, state: Sequence[float]) -> list[float]:
        """How far each joint is from where the bodies stand as they are given."""
        return [state[i] - joint.reference for i, joint in zip(self.order, self.bodies.joints, strict=True)]

    def rates(self, state: Sequence[float]) -> list[float]:
        """The velocities of the joints."""
        return [state[self.functions.coordinates + i] for i in self.order]

    def accelerations(self, state: Sequence[float]) -> list[float]:
        """Those of the joints where nothing touches."""
        return self.rates(self.functions.rates(state)[0])

    def directions(self, state: Sequence[float]) -> tuple[list[float], list[float]]:
        """M^-1 dx/dq and M^-1 dy/dq: how forces on the point accelerate the joints."""
        _, tangent, normal = self.functions.rates(state)
        return self.rates(tangent), self.rates(normal)

    def state(self, places: Sequence[float], rates: Sequence[float]) -> list[float]:
        """The state of the mechanism again."""
        state = list(self.start)
        for i, joint, place, rate in zip(self.order, self.bodies.joints, places, rates, strict=True):
            state[i], state[self.functions.coordinates + i] = joint.reference + place, rate
        return state

    @property
    def height(self) -> float:
        """The place of the surface: where y = 0."""
        still = [0.0] * len(self.order)
        return self.bodies.point[1] - self.functions.contact(self.state(still, still)).y

    @property
    def radius(self) -> float:
        """That of a small sphere about the point; a program lets it touch a surface that lies deeper by so much."""
        link = self.tree()[self.tip].link
        away = math.dist(link.centre, self.bodies.point)
        return _RADIUS * math.hypot(away, math.sqrt(link.inertia / link.mass))

    @property
    def tip(self) -> int:
        """The number of the body that touches."""
        return [placed.link.joints for placed in self.tree()].index(self.bodies.touching)

    def check(self) -> None:
        """Passes for bodies that other programs take.

        :raises SceneError: a joint that moves no mass, or a body without mass or inertia that touches or branches.
        """
        moved = [joint for placed in self.tree() for joint in placed.joints]
        if sorted(moved) != list(range(len(self.bodies.joints))):
            raise SceneError("a joint moves no body with a mass, or two bodies that hang on one without")
        if self.bodies.touching not in [link.joints for link in self.bodies.links]:
            raise SceneError("the body that touches has no mass")
        if any(link.inertia <= 0 for link in self.bodies.links):
            raise SceneError("a body has no inertia about its centre")

    def tree(self) -> list[Placed]:
        """All bodies, each after the one that it hangs on."""
        links = sorted(self.bodies.links, key=lambda link: (len(link.joints), link.joints))
        placed: list[Placed] = []
        for link in links:
            above = max(
                (i for i, other in enumerate(placed) if link.joints[: len(other.link.joints)] == other.link.joints),
                key=lambda i: len(placed[i].link.joints),
                default=None,
            )
            own = link.joints if above is None else link.joints[len(placed[above].link.joints) :]
            placed.append(Placed(link, above, own))
        return placed


def moved_states(start: Sequence[float]) -> list[list[float]]:
    """The start, and others, at which formulas are compared."""
    return [[value + way * (1 + i / 7) for i, value in enumerate(start)] for way in _MOVED]
