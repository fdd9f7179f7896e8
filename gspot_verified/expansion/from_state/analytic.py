"""An alpha that is an analytic function of p and b: its Taylor polynomial at p = b = 0, and a bound of what it leaves.

Proof page: ``proofs/from_state.md``, section 8, "Analytic alpha_i" and (18). The polynomial is exact, the bound a ball.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.from_state.barrier import Monomials
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.convolution import Convolution, Series, TermByTerm, Weights
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.numbers.balls import add_remainder, ball, hull

_RING = fmpq_mpoly_ctx.get(("p", "b"), Ordering.lex)


class NoTaylorError(ValueError):
    """The function has no enclosure on the box; the message says why."""


@dataclass(frozen=True)
class Analytic:
    """``function`` of the state (p, b), its terms below ``order`` in p and b together by themselves.

    :raises ValueError: it is not analytic at p = b = 0, or a coefficient of its Taylor polynomial is not rational.
    """

    function: Expression
    order: int
    text: str

    def __post_init__(self) -> None:
        if not self.order > 1:
            raise ValueError(f"the order must be at least 2, got {self.order}")
        _terms(self.function, self.order)

    @property
    def value(self) -> fmpq:
        """At p = b = 0."""
        return fmpq(_terms(self.function, self.order)[0].to_dict().get((0, 0), fmpq(0)))

    @property
    def expression(self) -> Expression:
        """The function of the state (p, b, y, v)."""
        return self.function

    def at(self, p: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        """The Taylor polynomial where p and b are polynomials."""
        terms = _terms(self.function, self.order)
        return sum((term.compose(p, b, ctx=p.context()) for term in terms), p.context().constant(0))

    def rest(self, p: fmpq, force: arb) -> Monomials:
        """A bound of \\|function - polynomial\\| where 0 <= r^2 <= p, \\|b\\| <= ``force`` r^2.

        :raises NoTaylorError: it is not certainly analytic there.
        """
        place = [hull([arb(0), ball(p)]), add_remainder(arb(0), (force * p).upper())]
        series = SeriesOfFunctions([self.function], NumberTerms(BALLS), BALLS)
        try:
            series.extend(place)
            series.extend([arb(1), add_remainder(arb(0), force.upper())])
            for _ in range(self.order - 1):
                series.extend([arb(0), arb(0)])
        except ValueError as error:
            raise NoTaylorError(str(error)) from error
        return {(0, 2 * self.order): abs(series[self.function][self.order]).upper()}


class _Homogeneous:
    """Terms of order n: polynomials of degree n in p and b."""

    def constant(self, value: Any) -> fmpq_mpoly:
        """The number as a polynomial."""
        return _RING.constant(RATIONALS.number(value))

    def zero(self, order: int) -> fmpq_mpoly:
        """Zero, whatever the order."""
        del order
        return _RING.constant(0)

    def scale(self, term: fmpq_mpoly, factor: Any) -> fmpq_mpoly:
        """The product."""
        product: fmpq_mpoly = term * factor
        return product

    def convolution(self, left: Series, right: Series, weights: Weights | None = None) -> Convolution:
        """The terms of the product of two series."""
        return TermByTerm(left, right, self, RATIONALS, weights)

    def is_zero(self, term: fmpq_mpoly) -> bool:
        """Exact."""
        return bool(term.is_zero())

    def at_start(self, term: fmpq_mpoly) -> fmpq:
        """Its value, where it is one of degree 0."""
        return fmpq(term.to_dict().get((0, 0), fmpq(0)))


@cache
def _terms(function: Expression, order: int) -> tuple[fmpq_mpoly, ...]:
    """The parts of degree 0, 1, ..., ``order`` - 1."""
    terms = _Homogeneous()
    series = SeriesOfFunctions([function], terms, RATIONALS)
    series.extend([terms.zero(0), terms.zero(0)])
    series.extend(list(_RING.gens()))
    for n in range(2, order):
        series.extend([terms.zero(n), terms.zero(n)])
    return tuple(series[function])
