"""The functions of a mechanism in one phase: Sec. 2 of the paper, in the states that are integrated."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.functions.derivative import plus, times
from gspot_verified.functions.expressions import Constant, Expression
from gspot_verified.mechanisms.derive.mass_matrix import leading_minors
from gspot_verified.mechanisms.formulas.rewriting import simplified
from gspot_verified.mechanisms.formulas.simplify import minus, negative, power_of, product_of, sum_of
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK, Terms, scaled


@dataclass(frozen=True)
class Functions:
    """F, G, G_T, G_N of the components that are integrated, and the scalar functions of Sec. 2."""

    F: tuple[Expression, ...]
    G: tuple[Expression, ...]
    G_T: tuple[Expression, ...]
    G_N: tuple[Expression, ...]
    a: Expression
    b: Expression
    A: Expression
    B: Expression
    C: Expression
    p: Expression
    mu: Expression
    u: Expression
    x: Expression


class MechanismTerms(Terms):
    """lambda_T is -mu lambda_N in slip, mu lambda_N in reverse slip, and -(a + B lambda_N)/A in stick (du/dt = 0)."""

    def __init__(
        self,
        phase: str,
        states: Sequence[str],
        epsilon: fmpq,
        parameters: Mapping[str, fmpq],
        functions: Functions,
        masses: Sequence[Expression],
        sees_A: bool,
    ) -> None:
        """``masses``: the entries of the mass matrix, row by row; none where the fields are given.
        ``sees_A``: whether all on which A depends is integrated; else its value means nothing."""
        super().__init__(phase, states, epsilon, parameters)
        self.functions = functions
        self._masses, self._sees_A = masses, sees_A

    @property
    def friction(self) -> Expression:
        """lambda_T."""
        f = self.functions
        if self.phase == STICK:
            return product_of(negative(sum_of(f.a, product_of(f.B, self.force))), power_of(f.A, fmpq(-1)))
        return product_of(f.mu, self.force if self.phase == REVERSE else negative(self.force))

    @property
    def acceleration(self) -> Expression:
        """b + p lambda_N in slip (eq. genx), b + C lambda_N + B lambda_T elsewhere."""
        f = self.functions
        if self.phase == FLIGHT:
            return f.b
        if self.phase == SLIP:
            return plus(f.b, times(f.p, self.force))
        return plus(f.b, times(f.C, self.force), times(f.B, self.friction))

    def own_rates(self) -> list[Expression]:
        """epsilon (F + G_N lambda_N + G_T lambda_T) for each component; F + G lambda_N in slip."""
        f = self.functions
        if self.phase == FLIGHT:
            return [scaled(self.epsilon, rate) for rate in f.F]
        if self.phase == SLIP:
            rates = [plus(rate, times(push, self.force)) for rate, push in zip(f.F, f.G, strict=True)]
        else:
            rates = [
                plus(rate, times(n, self.force), times(t, self.friction))
                for rate, n, t in zip(f.F, f.G_N, f.G_T, strict=True)
            ]
        return [scaled(self.epsilon, rate) for rate in rates]

    @property
    def u(self) -> Expression:
        """The tangential velocity of the contact point."""
        return self.functions.u

    @property
    def supposed(self) -> tuple[tuple[str, Expression], ...]:
        """A positive definite mass matrix, or A > 0 and A C > B^2 where none is given; in contact mu >= 0 and A > 0
        (``proofs/mechanism_hypotheses.md``). A constant has its sign from the start on."""
        f, size = self.functions, math.isqrt(len(self._masses))
        supposed: dict[str, Expression] = {}
        if not self._masses:
            supposed = {"A": f.A, "A C - B^2": minus(product_of(f.A, f.C), product_of(f.B, f.B))}
        elif not all(isinstance(entry, Constant) for entry in self._masses):
            minors = simplified(*leading_minors([self._masses[i : i + size] for i in range(0, size**2, size)]))
            supposed = {f"the leading minor {n} of the mass matrix": minor for n, minor in enumerate(minors, start=1)}
        if self.phase != FLIGHT:
            supposed |= {"mu": f.mu} | ({"A": f.A} if self._sees_A else {})
        return tuple(each for each in supposed.items() if not isinstance(each[1], Constant))

    @property
    def stick_ends(self) -> tuple[tuple[str, Expression], ...]:
        """|lambda_T| <= mu lambda_N, times A > 0."""
        f = self.functions
        at_rest = sum_of(f.a, product_of(f.B, self.force))
        bound = product_of(product_of(f.mu, f.A), self.force)
        return (SLIP, minus(bound, at_rest)), (REVERSE, sum_of(bound, at_rest))
