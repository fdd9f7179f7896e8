"""The rigid slip flow with its time slowed down by p, so that a G-spot is an equilibrium.

Paper, Sec. 1.2: dt = p ds. With λ_N = -b/p the slip flow ξ' = F - G b/p becomes dξ/ds = p F - b G, where y = v = 0,
p = 0 and p = b = 0 are kept: dy/ds = p v, dv/ds = 0, dp/ds = α_1 p, db/ds = α_2 p + α_3 b.
Proof page: ``proofs/approach.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.straight_line import Given
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.derive.to_system import Shifted


@dataclass(frozen=True)
class ClosedFlow:
    """F and G of some components, with p, b and the α's, as functions of these components alone."""

    F: tuple[Expression, ...]
    G: tuple[Expression, ...]
    p: Expression
    b: Expression
    alpha_1: Expression
    alpha_2: Expression
    alpha_3: Expression

    @property
    def dimension(self) -> int:
        """The number of components."""
        return len(self.F)

    def slowed(self) -> list[Expression]:
        """p F - b G: the components as functions of s."""
        return [self.p * f - self.b * g for f, g in zip(self.F, self.G, strict=True)]

    def by_p(self) -> VectorField:
        """(S, R) of (ξ, λ): dξ/dp = S = (F + G λ)/α_1 and p dλ/dp = R = (α_3/α_1 - 1) λ - α_2/α_1; λ is component m."""
        force = Variable(self.dimension)
        S = [(f + g * force) / self.alpha_1 for f, g in zip(self.F, self.G, strict=True)]
        beta = self.alpha_3 / self.alpha_1
        return VectorField([*S, beta * force - force - self.alpha_2 / self.alpha_1])


@dataclass(frozen=True)
class SlipFlow(ClosedFlow):
    """The functions of Sec. 2 of one mechanism, as expressions of its shifted state at one precision."""

    y: Expression
    v: Expression
    u: Expression

    @classmethod
    def of(cls, shifted: Shifted) -> SlipFlow:
        """From a mechanism; constants that are balls have the precision in force."""
        f = shifted.functions
        scalars = (f.p, f.b, f.alpha_1, f.alpha_2, f.alpha_3, f.y, f.v, f.u)
        size = len(f.F)
        expressions = shifted.expressions([*f.F, *f.G, *scalars], BALLS)
        return cls(tuple(expressions[:size]), tuple(expressions[size : 2 * size]), *expressions[2 * size :])

    def desingularised(self) -> VectorField:
        """(p F - b G, p): the state and the time t as functions of s; component m is t."""
        return VectorField([*self.slowed(), self.p])


@dataclass(frozen=True, slots=True)
class Numbers:
    """Enclosures of the scalar functions, F and G on a box."""

    p: arb
    b: arb
    u: arb
    alpha_1: arb
    alpha_2: arb
    alpha_3: arb
    F: tuple[arb, ...]
    G: tuple[arb, ...]

    @classmethod
    def of(cls, values: Sequence[arb]) -> Numbers:
        """From the values of p, b, u, α_1, α_2, α_3, F and G, in this order."""
        p, b, u, first, second, third, *fields = values
        F, G = fields[: len(fields) // 2], fields[len(fields) // 2 :]
        return cls(p=p, b=b, u=u, alpha_1=first, alpha_2=second, alpha_3=third, F=tuple(F), G=tuple(G))

    @property
    def force(self) -> arb:
        """λ_N = -b/p."""
        return -self.b / self.p


class SlipNumbers:
    """Evaluates them on boxes."""

    def __init__(self, flow: SlipFlow) -> None:
        scalars = (flow.p, flow.b, flow.u, flow.alpha_1, flow.alpha_2, flow.alpha_3)
        self._size = flow.dimension
        self._program = BoxProgram([*scalars, *flow.F, *flow.G], self._size)
        self._beta = BoxProgram([flow.alpha_3 / flow.alpha_1], self._size)
        self._conditions = BoxProgram([flow.p, flow.b, flow.y, flow.v], self._size)

    def at(self, given: Given) -> SlipNumbers:
        """The same with numbers in the place of some constants, as :meth:`BoxProgram.at`."""
        other = copy(self)
        other._program, other._beta = self._program.at(given), self._beta.at(given)
        other._conditions = self._conditions.at(given)
        return other

    def on(self, box: Sequence[arb]) -> Numbers:
        """On one box."""
        return Numbers.of(self._program.values(list(box[: self._size])))

    def beta_slopes(self, box: Sequence[arb]) -> list[arb]:
        """The partial derivatives of α_3/α_1 on a box."""
        return self._beta.gradients(list(box[: self._size]))[1][0]

    def conditions(self, box: list[arb]) -> list[arb]:
        """p, b, y, v."""
        return self._conditions.values(box)

    def condition_rows(self, box: list[arb]) -> list[list[arb]]:
        """Their partial derivatives."""
        return self._conditions.gradients(box)[1]
