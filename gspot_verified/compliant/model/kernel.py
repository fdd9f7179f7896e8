"""The integrand of the first integrals of the contact phase: s^(beta-1) e^((-psi(s) + p s)/epsilon) k(s).

Proof page: ``proofs/first_integrals.md``, section 1.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import acb, arb

from gspot_verified.compliant.model.normal_form import Deviation


@dataclass(frozen=True, slots=True)
class Kernel:
    """The state and the parameters in balls of one precision; k(s) = b + s V + s^2 (Y - s lambda)/(1 + s)."""

    beta: arb
    epsilon: arb
    p: arb
    b: arb
    V: arb
    Y: arb
    force: arb

    @property
    def size(self) -> arb:
        """|b| + |V| + |Y| + |lambda|: a bound of |(1 + s) k(s)| for -1 <= s <= 0."""
        total = abs(self.b) + abs(self.V) + abs(self.Y) + abs(self.force)
        return total.abs_upper()

    def polynomial(self, s: acb, one_plus_s: acb) -> acb:
        """(1 + s) k(s), entire."""
        return one_plus_s * (self.b + s * self.V) + s * s * (self.Y - s * self.force)

    def exponent(self, s: acb, log_one_plus_s: acb) -> acb:
        """(-psi(s) + p s)/epsilon with a given branch of log(1 + s)."""
        return (log_one_plus_s + s * (self.p - 1 + s / 2 + s * s / 3)) / self.epsilon


def kernel(state: Deviation) -> Kernel:
    """The kernel of a state at the current precision."""
    names = ("beta", "epsilon", "p", "b", "V", "Y", "force")
    return Kernel(*(arb(getattr(state, name)) for name in names))
