"""An alpha that is an analytic function of p and b: its Taylor polynomial at p = b = 0, and a bound of what it leaves.

Proof page: ``proofs/from_state.md``, section 8, "Analytic alpha_i" and (18). The polynomial is exact where its
coefficients are rational, else they are balls; the bound is a ball.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.from_state.barrier import Monomials
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.ball_polynomials import BallPolynomial, constant
from gspot_verified.functions.convolution import Convolution, Series, TermByTerm, Weights
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS, Ring
from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull, working_bits

_RING = fmpq_mpoly_ctx.get(("p", "b"), Ordering.lex)
_BITS = 256  # of coefficients that are not rational

Polynomial = fmpq_mpoly | BallPolynomial


class NoTaylorError(ValueError):
    """The function has no enclosure on the box; the message says why."""


@dataclass(frozen=True)
class Analytic:
    """``function`` of the state (p, b), its terms below ``order`` in p and b together by themselves.

    :raises ValueError: it is not analytic at p = b = 0.
    """

    function: Expression
    order: int
    text: str

    def __post_init__(self) -> None:
        if not self.order > 1:
            raise ValueError(f"the order must be at least 2, got {self.order}")
        _terms(self.function, self.order)

    @property
    def value(self) -> Exact:
        """At p = b = 0; a ball unless all coefficients are rational."""
        value: Exact = _terms(self.function, self.order)[0].to_dict().get((0, 0), fmpq(0))
        return value

    @property
    def is_exact(self) -> bool:
        """Whether the Taylor polynomial is."""
        return all(
            isinstance(value, fmpq) for term in _terms(self.function, self.order) for value in term.to_dict().values()
        )

    @property
    def expression(self) -> Expression:
        """The function of the state (p, b, y, v)."""
        return self.function

    def above(self, p: fmpq_mpoly, b: Polynomial) -> Polynomial:
        """The Taylor polynomial without ``value`` where p and b are polynomials."""
        total: Polynomial = p.context().constant(0)
        for term in _terms(self.function, self.order)[1:]:
            for (i, j), value in term.to_dict().items():
                total = total + constant(p.context(), value) * p**i * b**j
        return total

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
    """Terms of order n: polynomials of degree n in p and b, with coefficients in the ring."""

    def __init__(self, ring: Ring) -> None:
        self._ring = ring

    def constant(self, value: Any) -> Polynomial:
        """The number as a polynomial."""
        return constant(_RING, self._ring.number(value))

    def zero(self, order: int) -> fmpq_mpoly:
        """Zero, whatever the order."""
        del order
        return _RING.constant(0)

    def scale(self, term: Polynomial, factor: Any) -> Polynomial:
        """The product."""
        return term * constant(_RING, factor)

    def convolution(self, left: Series, right: Series, weights: Weights | None = None) -> Convolution:
        """The terms of the product of two series."""
        return TermByTerm(left, right, self, self._ring, weights)

    def is_zero(self, term: Polynomial) -> bool:
        """Whether it is certainly 0."""
        return bool(term.is_zero())

    def at_start(self, term: Polynomial) -> Any:
        """Its value, where it is one of degree 0."""
        return self._ring.number(term.to_dict().get((0, 0), fmpq(0)))


@cache
def _terms(function: Expression, order: int) -> tuple[Polynomial, ...]:
    """The parts of degree 0, 1, ..., ``order`` - 1: exact if they can be."""
    try:
        return _terms_in(function, order, RATIONALS)
    except (TypeError, ValueError):  # one is not rational; or the function is not analytic there, and this raises, too
        with working_bits(_BITS):
            return _terms_in(function, order, BALLS)


def _terms_in(function: Expression, order: int, ring: Ring) -> tuple[Polynomial, ...]:
    terms = _Homogeneous(ring)
    series = SeriesOfFunctions([function], terms, ring)
    series.extend([terms.zero(0), terms.zero(0)])
    series.extend(list(_RING.gens()))
    for n in range(2, order):
        series.extend([terms.zero(n), terms.zero(n)])
    return tuple(series[function])
