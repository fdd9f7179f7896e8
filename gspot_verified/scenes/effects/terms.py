"""What the equations of one phase are written with: states, the clock, parameters, the contact force."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import fmpq

from gspot_verified.expansion.derivative import plus, times
from gspot_verified.expansion.expressions import Constant, Expression, Variable

SLIP, STICK, FLIGHT = "slip", "stick", "flight"


class Terms:
    """The states, parameters and common functions of one phase.

    ``share`` is c of eq. lambda+: which part of the force is that of positive slip; 1 in slip.
    """

    def __init__(
        self, phase: str, states: Sequence[str], epsilon: fmpq, start_p: fmpq, parameters: Mapping[str, fmpq]
    ) -> None:
        self.phase, self.states, self.epsilon = phase, tuple(states), epsilon
        self._start_p, self._parameters = start_p, parameters
        self.share = self["k_minus"] / (self["k_minus"] - self["k_plus"]) if phase == STICK else fmpq(1)

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
    def p(self) -> Expression:
        """p, a state where something acts back on it; otherwise known: p_0 + alpha_1 epsilon T."""
        if "p" in self.states:
            return self.state("p")
        return plus(number(self._start_p), scaled(self["alpha_1"] * self.epsilon, self.clock))

    @property
    def force(self) -> Expression:
        """lambda_N = k_2 (Z - Y) in contact, 0 in flight."""
        return number(fmpq(0)) if self.phase == FLIGHT else self.closing

    @property
    def closing(self) -> Expression:
        """k_2 (Z - Y): the force in contact, negative when the contact is open."""
        return scaled(self["k_2"], self.state("Z") - self.state("Y"))


def number(value: fmpq) -> Expression:
    """A constant."""
    return Constant(value)


def scaled(value: fmpq, expression: Expression) -> Expression:
    """A multiple; nothing is left of a multiple by 0, and a factor 1 costs nothing."""
    return times(Constant(value), expression)
