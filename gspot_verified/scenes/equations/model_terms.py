"""The functions of the model system and of the extended example (paper, Secs. 2.3 and 2.4) in one phase."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import fmpq

from gspot_verified.functions.derivative import plus, times
from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.equations.terms import REVERSE, SLIP, STICK, Terms, number, scaled


class ModelTerms(Terms):
    """p is a state where something acts back on it; otherwise known: p_0 + alpha_1 epsilon T."""

    def __init__(
        self, phase: str, states: Sequence[str], epsilon: fmpq, parameters: Mapping[str, fmpq], start_p: fmpq
    ) -> None:
        super().__init__(phase, states, epsilon, parameters)
        self._start_p = start_p

    @property
    def p(self) -> Expression:
        """The Painlevé parameter."""
        if "p" in self.states:
            return self.state("p")
        return plus(number(self._start_p), scaled(self["alpha_1"] * self.epsilon, self.clock))

    @property
    def forward(self) -> Expression:
        """lambda^+ = c lambda_N (eq. lambda+); in stick (eq. cdot) (k^- lambda_N + a)/(k^- - k^+)."""
        if self.phase == STICK:
            return self._stick_share(self["k_minus"], self["a"])
        return self.force if self.phase == SLIP else number(fmpq(0))

    @property
    def backward(self) -> Expression:
        """lambda^- = (1 - c) lambda_N."""
        if self.phase == STICK:
            return self._stick_share(-self["k_plus"], -self["a"])
        return self.force if self.phase == REVERSE else number(fmpq(0))

    def _stick_share(self, slope: fmpq, constant: fmpq) -> Expression:
        width = self["k_minus"] - self["k_plus"]
        return plus(scaled(slope / width, self.force), number(constant / width))

    @property
    def acceleration(self) -> Expression:
        """b + p lambda^+ + p^- lambda^- (eq. newex4)."""
        pushed = number(fmpq(0))
        if self.phase in (STICK, REVERSE):
            pushed = scaled(self["p_minus"], self.backward)
        return plus(self.state("b"), times(self.p, self.forward), pushed)

    @property
    def u(self) -> Expression:
        """The state u; where the contact sticks it is the velocity of the surface."""
        if self.phase == STICK:
            return number(self._parameters.get("belt_velocity", fmpq(0)))
        return self.state("u")

    @property
    def stick_ends(self) -> tuple[tuple[str, Expression], ...]:
        """lambda^+ and lambda^- must not be negative. One that cannot be while lambda_N > 0 is left out."""
        k_plus, k_minus, a = self["k_plus"], self["k_minus"], self["a"]
        ends: list[tuple[str, Expression]] = []
        if not (k_plus < 0 and a <= 0):
            ends.append((SLIP, plus(scaled(-k_plus, self.force), number(-a))))
        if not (k_minus > 0 and a >= 0):
            ends.append((REVERSE, plus(scaled(k_minus, self.force), number(a))))
        return tuple(ends)

    @property
    def tangential_acceleration(self) -> Expression:
        """du/dt = a + k^+ lambda^+ + k^- lambda^- (eq. udot), outside of stick."""
        rate = {SLIP: "k_plus", REVERSE: "k_minus"}.get(self.phase)
        return number(self["a"]) if rate is None else plus(number(self["a"]), scaled(self[rate], self.force))
