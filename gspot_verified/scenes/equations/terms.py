"""What the equations of one phase are written with: states, the clock, parameters, the contact force."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence

from flint import fmpq

from gspot_verified.functions.derivative import times
from gspot_verified.functions.expressions import Constant, Expression, Variable

SLIP, STICK, REVERSE, FLIGHT = "slip", "stick", "reverse slip", "flight"
PHASES = (SLIP, STICK, REVERSE, FLIGHT)


class Terms(ABC):
    """The states, parameters and common functions of one phase; what moves (the model, a mechanism) adds its own."""

    def __init__(self, phase: str, states: Sequence[str], epsilon: fmpq, parameters: Mapping[str, fmpq]) -> None:
        self.phase, self.states, self.epsilon = phase, tuple(states), epsilon
        self._parameters = parameters

    def __getitem__(self, parameter: str) -> fmpq:
        return self._parameters[parameter]

    def state(self, name: str) -> Expression:
        """A state that is integrated."""
        return Variable(self.states.index(name))

    @property
    def clock(self) -> Expression:
        """T, from the start of the scene."""
        return Variable(len(self.states))

    @property
    def force(self) -> Expression:
        """lambda_N = k_2 (Z - Y) in contact, 0 in flight."""
        return number(fmpq(0)) if self.phase == FLIGHT else self.closing

    @property
    def closing(self) -> Expression:
        """k_2 (Z - Y): the force in contact, negative when the contact is open."""
        return scaled(self["k_2"], self.state("Z") - self.state("Y"))

    @property
    def slip(self) -> Expression:
        """u less the velocity of the surface (0 without a belt)."""
        return self.u - number(self["belt_velocity"]) if self._parameters.get("belt_velocity", fmpq(0)) != 0 else self.u

    @property
    @abstractmethod
    def acceleration(self) -> Expression:
        """dv/dt."""

    @property
    @abstractmethod
    def u(self) -> Expression:
        """The tangential velocity of the contact point."""

    @property
    def supposed(self) -> tuple[tuple[str, Expression], ...]:
        """What must not be negative for the law of friction to have a sense in this phase, by name; no constants."""
        return ()

    @property
    @abstractmethod
    def stick_ends(self) -> tuple[tuple[str, Expression], ...]:
        """What must stay positive for the contact to stick, each with the phase that follows where it does not."""


def number(value: fmpq) -> Expression:
    """A constant."""
    return Constant(value)


def scaled(value: fmpq, expression: Expression) -> Expression:
    """A multiple; nothing is left of a multiple by 0, and a factor 1 costs nothing."""
    return times(Constant(value), expression)
