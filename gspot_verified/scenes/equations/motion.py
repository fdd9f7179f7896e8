"""What moves in a scene: the model system, or a mechanism. Both give the same to the effects."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from flint import arb, fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.equations.terms import Terms


class SceneError(ValueError):
    """The description of the scene is wrong; the message names the part."""


class Motion(Protocol):
    """The states of what moves, their equations, and its start."""

    parameters: Mapping[str, fmpq]
    """Numbers that the equations need and the scene may change, with their values."""

    is_model: bool
    """Whether this is the model system, or the extended example."""

    @property
    def depends_on_place(self) -> bool:
        """False: no equation depends on the place of the contact along the surface; True: one may."""
        ...

    def states(self, phase: str) -> tuple[str, ...]:
        """The states that are integrated in one phase."""
        ...

    def terms(self, phase: str, states: tuple[str, ...], values: Mapping[str, fmpq]) -> Terms:
        """The functions of the equations of one phase, for all its states."""
        ...

    def rates(self, terms: Terms) -> dict[str, Expression]:
        """The equations of its own states."""
        ...

    def shown(self, terms: Terms) -> dict[str, Expression]:
        """p, b and what else there is to see, in the paper's units."""
        ...

    def start(self, values: Mapping[str, fmpq]) -> dict[str, fmpq]:
        """The values of its states that are given, and of y, v, z, at the start, in the paper's units.

        :raises SceneError: one is missing, or too many are given.
        """
        ...

    def enclosed_start(self) -> dict[str, arb]:
        """Enclosures of those of its states at the start that follow from the others and from y, v, z.

        :raises SceneError: they are not certainly determined.
        """
        ...

    def check(self, values: Mapping[str, fmpq]) -> None:
        """Passes where the equations hold at the start.

        :raises MechanismError: the mass matrix is not certainly positive definite there.
        """
        ...

    def normal_acceleration(self, values: Mapping[str, fmpq]) -> fmpq | arb:
        """b at the start: dv/dt without contact."""
        ...

    def painleve_parameter(self, values: Mapping[str, fmpq]) -> fmpq | arb:
        """p at the start."""
        ...

    def slip_velocity(self, values: Mapping[str, fmpq]) -> fmpq | arb:
        """u at the start."""
        ...
