"""Bodies in a plane by complex numbers: mass matrix and contact point, by difference quotients and nothing shared."""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from gspot_verified.mechanisms.input.planar_links import PlanarLinks, Point

_STEP = 1e-5


class PlanarNumbers:
    """Of bodies that stand as they are given where all places are 0."""

    def __init__(self, bodies: PlanarLinks) -> None:
        self.bodies = bodies

    def point(self, joints: Sequence[int], point: Point, places: Sequence[float]) -> complex:
        """Where a point of the body behind these joints is: the last joint moves it first."""
        here = complex(*point)
        for number in reversed(joints):
            joint = self.bodies.joints[number]
            place = complex(*joint.place)
            if joint.is_hinge:
                here = place + exp(1j * joint.turn * places[number]) * (here - place)
            else:
                here += place * places[number]
        return here

    def moves(self, joints: Sequence[int], point: Point, places: Sequence[float]) -> NDArray[np.float64]:
        """The rows dx/dq and dy/dq."""
        slopes = _slopes(lambda at: self.point(joints, point, at), places)
        return np.array([[slope.real for slope in slopes], [slope.imag for slope in slopes]])

    def tip(self, places: Sequence[float]) -> NDArray[np.float64]:
        """Those of the point that touches."""
        return self.moves(self.bodies.touching, self.bodies.point, places)

    def mass_matrix(self, places: Sequence[float]) -> NDArray[np.float64]:
        """M: the sum of m v.v and I w^2, and armatures."""
        M = np.diag([joint.armature for joint in self.bodies.joints])
        for link in self.bodies.links:
            rows = self.moves(link.joints, link.centre, places)
            spin = np.array(
                [
                    joint.turn if joint.is_hinge and number in link.joints else 0
                    for number, joint in enumerate(self.bodies.joints)
                ]
            )
            M = M + link.mass * rows.T @ rows + link.inertia * np.outer(spin, spin)
        return M


def _slopes(function: Callable[[list[float]], complex], places: Sequence[float]) -> list[complex]:
    found = []
    for number in range(len(places)):
        ends = [[place + way * (number == i) for i, place in enumerate(places)] for way in (-_STEP, _STEP)]
        found.append((function(ends[1]) - function(ends[0])) / (2 * _STEP))
    return found
