"""The functions of Sec. 2 of a mechanism at states of floats, angles counted as the user counts them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import angle_ball, shift
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.floats.float_function import FloatFunction, float_function

_SCALARS = ("y", "u", "v", "A", "B", "C", "p", "b", "mu")
_BITS = 64  # of the constants, before they become doubles


@dataclass(frozen=True)
class Contact:
    """The numbers of the contact in one state: y, u = x', v = y', A, B, C, p, b of Sec. 2 and the friction mu."""

    y: float
    u: float
    v: float
    A: float
    B: float
    C: float
    p: float
    b: float
    mu: float


@dataclass(frozen=True)
class ContactFloats:
    """``coordinates`` q and their velocities, in that order, are the first components of the state."""

    names: tuple[str, ...]
    coordinates: int
    references: tuple[float, ...]
    scalars: FloatFunction
    fields: FloatFunction

    def contact(self, state: Sequence[float]) -> Contact:
        """The numbers of the contact."""
        return Contact(*self.scalars(self._shifted(state)))

    def rates(self, state: Sequence[float]) -> tuple[list[float], list[float], list[float]]:
        """F, G_T and G_N: the rate of the state is F + λ_T G_T + λ_N G_N."""
        values, m = self.fields(self._shifted(state)), len(self.names)
        return values[:m], values[m : 2 * m], values[2 * m :]

    def _shifted(self, state: Sequence[float]) -> list[float]:
        return [value - reference for value, reference in zip(state, self.references, strict=True)]


def contact_floats(mechanism: Mechanism) -> ContactFloats:
    """The functions of a mechanism with coordinates and velocities.

    :raises MechanismError: a parameter without a value, or the mechanism is given by its fields: it has no velocities
        that a simulator could step.

    >>> from gspot_verified import load
    >>> round(contact_floats(load("rod with a wrist")).contact([0, 1, 0.5, 5, 1, 3]).C, 6)
    3.310453
    """
    if not isinstance(mechanism.motion, Lagrangian):
        raise MechanismError(f"{mechanism.name}: simulators need coordinates and velocities, not fields of a state")
    shifted = shift(mechanism)
    f = shifted.functions
    with working_bits(_BITS):
        scalars = shifted.expressions([getattr(f, name) for name in _SCALARS], BALLS)
        fields = shifted.expressions([*f.F, *f.G_T, *f.G_N], BALLS)
        references = {angle.coordinate: approximate(angle_ball(angle)) for angle in mechanism.angles}
        return ContactFloats(
            names=mechanism.state,
            coordinates=len(mechanism.motion.coordinates),
            references=tuple(references.get(name, 0.0) for name in mechanism.state),
            scalars=float_function(scalars),
            fields=float_function(fields),
        )
