"""The statements on the contact force that a certificate of version 2 proves; ``proofs/certificate.md``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from flint import fmpq

from gspot_verified.leading_order.contact_force import ContactForce
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.work.ranges import Range

_NOT_HERE = "is what is stated; that it holds is proved elsewhere"


@dataclass(frozen=True, slots=True)
class ForceStatement(NoTruthValue, Written):
    """On the slow manifold lambda > 0 for every tau of the range and every epsilon in (0, epsilon]; |F| <= level where
    F has the sign that lowers the force."""

    version: ClassVar[int] = 2
    kind: ClassVar[Literal["force"]] = "force"
    ask: ClassVar[str] = f".epsilon {_NOT_HERE}"
    written: ClassVar[str] = "kind alpha=force.alphas c1=force.c1 epsilon level tau"

    force: ContactForce
    tau: Range
    epsilon: fmpq
    level: fmpq

    def __str__(self) -> str:
        return f"{_on_the_manifold(self.force)}, λ > 0 for every τ in {self.tau} and every ε in (0, {self.epsilon}]"


@dataclass(frozen=True, slots=True)
class LiftOffStatement(NoTruthValue, Written):
    """On the slow manifold lambda < 0 at tau for every epsilon >= epsilon, so contact is lost before; |F| >= level."""

    version: ClassVar[int] = 2
    kind: ClassVar[Literal["lift_off"]] = "lift_off"
    ask: ClassVar[str] = f".epsilon {_NOT_HERE}"
    written: ClassVar[str] = "kind alpha=force.alphas c1=force.c1 epsilon level tau"

    force: ContactForce
    tau: fmpq
    epsilon: fmpq
    level: fmpq

    def __str__(self) -> str:
        return f"{_on_the_manifold(self.force)}, λ < 0 at τ = {self.tau} for every ε ≥ {self.epsilon}"


def _on_the_manifold(force: ContactForce) -> str:
    numbers = f"({force.alpha_1}, {force.alpha_2}, {force.alpha_3})"
    return f"on the slow manifold of the compliant model with α = {numbers} and C1 = {force.c1}, τ = κ t ε^(-2/3)"
