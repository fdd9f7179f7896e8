"""What Theorem 1 needs of a mechanical system in positive slip, at one G-spot.

Paper, eqs. genSysXi to genSysGSpotNonSing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.series.legend import state_names
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import RATIONALS, Ring


class GSpotError(ValueError):
    """The point is no G-spot at which Theorem 1 holds; the message says which hypothesis fails."""


class SymbolsError(TypeError, ValueError):
    """Symbols where numbers are needed: of a system, for a function the wrong type, for a user the wrong value."""


@dataclass(frozen=True)
class System:
    """dξ/dt = F + G λ_N with y, v, p, b, α_1, α_2, α_3 and the extra conditions J as functions of ξ, and a G-spot ξ*.

    ``point`` is ξ*, numbers of ``ring``. The number of conditions J is the dimension of ξ minus 4.
    """

    name: str
    F: tuple[Expression, ...]
    G: tuple[Expression, ...]
    y: Expression
    v: Expression
    p: Expression
    b: Expression
    alpha_1: Expression
    alpha_2: Expression
    alpha_3: Expression
    J: tuple[Expression, ...]
    point: tuple[Any, ...]
    ring: Ring = RATIONALS
    state: tuple[str, ...] = ()
    """The mechanism's names of the components, for texts; empty: xi_1, xi_2, ..."""
    regularisation: Regularisation = PAPER

    def __post_init__(self) -> None:
        dimension = len(self.point)
        if not len(self.F) == len(self.G) == dimension or len(self.J) != dimension - 4:
            raise ValueError("F, G and the point must have one length m, and J the length m - 4")
        if self.state and len(self.state) != dimension:
            raise ValueError("the state must have one name for each component")

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the components."""
        return state_names(self.state, len(self.point))

    @property
    def conditions(self) -> tuple[Expression, ...]:
        """p, b, y, v and J: what vanishes at the G-spot."""
        return (self.p, self.b, self.y, self.v, *self.J)

    def check_numbers(self, what: str) -> None:
        """Nothing, where the numbers of the system are rationals or balls.

        :raises SymbolsError: they are symbols; the message says that ``what``, a plural, needs numbers.
        """
        if not isinstance(self.ring.number(0), fmpq | arb):
            raise SymbolsError(f"{what} need numbers: put numbers in the place of the symbols")

    def values_at_point(self, functions: Sequence[Expression]) -> list[Any]:
        """The numbers that the functions are at ξ*."""
        series = SeriesOfFunctions(functions, NumberTerms(self.ring), self.ring)
        series.extend(list(self.point))
        return [series[function][0] for function in functions]

    def jacobian(self) -> list[list[Any]]:
        """The rows of the derivatives of p, b, y, v, J at ξ*; paper, eq. genSysGSpotNonSing."""
        zero, one = self.ring.number(0), self.ring.number(1)
        columns = []
        series = SeriesOfFunctions(self.conditions, NumberTerms(self.ring), self.ring)
        series.extend(list(self.point))
        for j in range(len(self.point)):
            series.extend([one if i == j else zero for i in range(len(self.point))])
            columns.append([series[condition][1] for condition in self.conditions])
            series.drop_last()
        return [[column[i] for column in columns] for i in range(len(self.conditions))]

    def check(self) -> tuple[Any, Any, Any]:
        """α_1*, α_2*, α_3*, after the hypotheses of Theorem 1 have been checked.

        :raises GSpotError: p, b, y, v, J do not vanish at ξ*, or α_1* or α_3* is not negative.
        """
        names = ["p", "b", "y", "v", *(f"J_{i + 1}" for i in range(len(self.J)))]
        for name, value in zip(names, self.values_at_point(self.conditions), strict=True):
            if self.ring.is_nonzero(value):
                raise GSpotError(f"{self.name}: not a G-spot: {name} = {value} does not vanish there")
        first, second, third = self.values_at_point((self.alpha_1, self.alpha_2, self.alpha_3))
        for name, value in (("alpha_1", first), ("alpha_3", third)):
            if not self.ring.is_negative(value):
                raise GSpotError(
                    f"{self.name}: {name} = {value} must be negative at the G-spot: it is in no Case "
                    "(classify_all lists the G-spots, the number and the Case of each)"
                )
        return first, second, third
