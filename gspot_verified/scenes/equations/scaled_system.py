"""The equations of one phase of motion in variables scaled by epsilon: what every run computes with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gspot_verified.functions.derivative import partial_derivative
from gspot_verified.functions.expressions import Constant, Expression, Variable, in_order

CONTACT = "contact"
"""In the place of the phase that follows an event: the one that the slip velocity and the force of friction choose."""


@dataclass(frozen=True)
class PhaseEvent:
    """Where a phase ends: ``function`` vanishes, falling; ``next_phase`` follows, or CONTACT.

    ``left_out``: the effect that brings this event and is left out: there its absence is wrong, and the run ends.
    """

    name: str
    function: Expression
    next_phase: str
    left_out: str = ""


@dataclass(frozen=True)
class ScaledSystem:
    """d(state)/dT = ``right_hand_side`` in one phase, T = t/epsilon the clock, from 0 at the start of the scene.

    States: b, p, u, x of the model, or components of a mechanism's state (an angle with a reference counted from it),
    in the paper's units; Y = y/epsilon^2, V = v/epsilon, Z = z/epsilon^2. Component i of the state is ``Variable(i)``;
    the clock is ``Variable(d)`` for d states: it may enter (p = p_0 + alpha_1 epsilon T where p is a known function)
    and is not integrated. ``read_out``: names and functions in the paper's units. Constants are exact; a mechanism with
    a number that is not rational has balls there, of the precision in force when the system was made.
    """

    phase: str
    states: tuple[str, ...]
    right_hand_side: tuple[Expression, ...]
    events: tuple[PhaseEvent, ...]
    read_out: tuple[tuple[str, Expression], ...]
    supposed: tuple[tuple[str, Expression], ...] = ()
    """Functions without which the equations have no sense where they are negative, by name."""

    def __post_init__(self) -> None:
        if len(self.states) != len(self.right_hand_side):
            raise ValueError(f"{len(self.states)} states, {len(self.right_hand_side)} rates")

    @property
    def clock(self) -> Variable:
        """T."""
        return Variable(len(self.states))

    def jacobian(self) -> list[list[Expression]]:
        """The derivatives of the right-hand side by the states, exactly."""
        size = len(self.states) + 1
        return [[partial_derivative(rate, i, size) for i in range(size - 1)] for rate in self.right_hand_side]

    def operations(self) -> int:
        """How many operations the right-hand side takes, each shared value counted once."""
        return operations(self.right_hand_side)

    def shown(self, name: str) -> Expression:
        """One function of the read-out.

        :raises KeyError: there is none with this name.
        """
        return dict(self.read_out)[name]


def operations(functions: Sequence[Expression]) -> int:
    """How many operations they take, each shared value counted once: what leaving an effect out saves.

    >>> x = Variable(0)
    >>> operations([x * x, x * x + x])
    2
    """
    return sum(1 for node in in_order(functions) if not isinstance(node, Constant | Variable))
