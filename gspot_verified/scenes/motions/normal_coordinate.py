"""The coordinate and the velocity that y and v take the place of: y is linear in the one, v in the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.functions.derivative import ZERO, partial_derivative
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.formulas.rewriting import replaced, simplified
from gspot_verified.mechanisms.formulas.simplify import constant, minus, product_of, rational_value
from gspot_verified.mechanisms.formulas.symbol import variable_indices
from gspot_verified.scenes.equations.motion import SceneError


@dataclass(frozen=True)
class NormalCoordinate:
    """y = ``slope`` xi_i + rest with a rational number ``slope``, and v = ``rate_slope`` xi_j + rest, i = ``place``,
    j = ``velocity``; y does not depend on xi_j."""

    place: int
    velocity: int
    slope: fmpq
    rate_slope: fmpq
    y: Expression
    v: Expression

    @classmethod
    def of(cls, name: str, y: Expression, v: Expression, state: Sequence[str]) -> NormalCoordinate:
        """The first pair of components with which this works.

        :raises SceneError: there is none: the contact has no free translation along its normal.
        """
        size = len(state)
        found = [(i, slope) for i in range(size) if (slope := free_slope(y, i, size)) is not None]
        rates = [(j, slope) for j in range(size) if (slope := free_slope(v, j, size)) is not None]
        used = variable_indices([y])
        pair = next(((i, j) for i in found for j in rates if i[0] != j[0] and j[0] not in used), None)
        if pair is None:
            raise SceneError(
                f"{name}: no component of the state in which y is linear with a constant factor (a free translation "
                f"along the normal), and none likewise for v: scenes put epsilon^2 Y and epsilon V in their places; "
                f"the components are: {', '.join(state)}"
            )
        (i, slope), (j, rate_slope) = pair
        return cls(i, j, slope, rate_slope, y, v)

    def solved(self, y: Expression, v: Expression) -> dict[Expression, Expression]:
        """The two components as functions of the others, of ``y`` and of ``v``."""
        place, velocity = Variable(self.place), Variable(self.velocity)
        (rest,) = replaced([self.y], {place: ZERO})
        first = product_of(constant(1 / self.slope), minus(y, rest))
        (rate_rest,) = replaced([self.v], {place: first, velocity: ZERO})
        return {place: first, velocity: product_of(constant(1 / self.rate_slope), minus(v, rate_rest))}


def free_slope(function: Expression, index: int, size: int) -> fmpq | None:
    """The derivative, where it is a rational number other than 0."""
    (slope,) = simplified(partial_derivative(function, index, size))
    value = rational_value(slope)
    return None if value is None or value == 0 else value
