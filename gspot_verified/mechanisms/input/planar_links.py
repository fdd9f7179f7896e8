"""The rigid bodies of a mechanism in its plane, where it came from a file of bodies: in floats, for other programs.

The formulas of a mechanism say all of its motion, but not which bodies move so: links of other masses may have the same
mass matrix. So bodies come from who knows them.
"""

from __future__ import annotations

from dataclasses import dataclass

Point = tuple[float, float]


@dataclass(frozen=True)
class PlanarJoint:
    """A hinge about ``place``, or a slide along the direction ``place``; the bodies stand as they are given where its
    coordinate is ``reference``. ``turn``: 1 where a hinge counts from x to y, else -1."""

    is_hinge: bool
    place: Point
    turn: int = 1
    reference: float = 0.0
    armature: float = 0.0


@dataclass(frozen=True)
class PlanarLink:
    """One rigid body behind ``joints``, by their numbers from the root on; its ``inertia`` is about its ``centre``."""

    joints: tuple[int, ...]
    mass: float
    inertia: float
    centre: Point


@dataclass(frozen=True)
class PlanarLinks:
    """``joints`` are in the order of the mechanism's coordinates; ``point`` of the body behind ``touching`` touches."""

    joints: tuple[PlanarJoint, ...]
    links: tuple[PlanarLink, ...]
    touching: tuple[int, ...]
    point: Point
