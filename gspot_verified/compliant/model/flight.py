"""Free flight of the model after lift-off, in closed form: balls in the normal form (alpha_1 = -1).

Proof page: ``proofs/flight.md``, section 1.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, arb_poly, fmpq


@dataclass(frozen=True, slots=True)
class ContactState:
    """p, b, V, Y and lambda of the normal form as balls (no hats: nothing is subtracted), Z = Y + lambda.

    One object stands for every state whose numbers lie in the balls. beta, epsilon and alpha_2 are those of the normal
    form, exact.
    """

    beta: fmpq
    epsilon: fmpq
    alpha_2: fmpq
    p: arb
    b: arb
    V: arb
    Y: arb
    force: arb

    @property
    def pull(self) -> fmpq:
        """A = -epsilon alpha_2: b falls at this rate in flight."""
        return -self.epsilon * self.alpha_2

    @property
    def force_rate(self) -> arb:
        """D = d lambda/dT = -2 lambda - Y - V, as long as the contact lasts."""
        return -2 * self.force - self.Y - self.V


@dataclass(frozen=True, slots=True)
class Flight:
    """The flight that begins in ``start``, a state with lambda = 0, so Z = Y: ``start.force`` is not used.

    u is the time since lift-off as T is, in units of epsilon. h = Y - Z is positive in flight.
    """

    start: ContactState

    @property
    def _moved(self) -> arb_poly:
        """Y(u) - Y(0), a cubic."""
        start = self.start
        return arb_poly([0, start.V, start.b / 2, arb(-start.pull) / 6])

    def gap(self, u: arb) -> arb:
        """h(u) = V u + b u^2/2 - A u^3/6 + Y (1 - e^-u)."""
        return self._moved(u) - self.start.Y * (-u).expm1()

    def gap_rate(self, u: arb) -> arb:
        """h'(u) = V(u) + Z(u)."""
        return self._moved.derivative()(u) + self.start.Y * (-u).exp()

    def landed(self, u: arb) -> ContactState:
        """The state at a touch-down in ``u``: lambda = 0, Y = Z = Y(0) e^-u."""
        start = self.start
        return ContactState(
            beta=start.beta,
            epsilon=start.epsilon,
            alpha_2=start.alpha_2,
            p=start.p - start.epsilon * u,
            b=start.b - start.pull * u,
            V=self._moved.derivative()(u),
            Y=start.Y * (-u).exp(),
            force=arb(0),
        )
