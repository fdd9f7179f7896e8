"""An alpha that is an analytic function of p, b, y, v: its Taylor polynomial at 0, and a bound of what it leaves.

Proof page: ``proofs/from_state.md``, section 8, "Analytic alpha_i" and (18). The polynomial is exact where its
coefficients are rational, else they are balls; the bound is a ball.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.chart.taylor_rest import NoTaylorError, taylor_rests
from gspot_verified.expansion.from_state.barrier import Monomials, added
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.ball_polynomials import BallPolynomial, constant
from gspot_verified.functions.convolution import Convolution, Series, TermByTerm, Weights
from gspot_verified.functions.expressions import Expression, Variable, in_order
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS, Ring
from gspot_verified.numbers.balls import Exact, ball, working_bits

_RING = fmpq_mpoly_ctx.get(("p", "b", "y", "v"), Ordering.lex)
_WEIGHTS = (1, 1, 3, 2)  # of p, b, y, v: powers of delta^2 near the G-spot
_MOST = 4  # up to this order y and v occur by themselves, and times p or b, alone
_BITS = 256  # of coefficients that are not rational

Polynomial = fmpq_mpoly | BallPolynomial
Place = tuple[Polynomial, Polynomial, Polynomial, Polynomial]
"""p, b, y, v."""


@dataclass(frozen=True)
class Analytic:
    """``function`` of the state, as one of (p, b, y, v): its terms of weight below ``order`` by themselves; the weight
    of p and b is 1, that of v 2, that of y 3. Without a chart the state is (p, b, y, v).

    :raises ValueError: it is not analytic at 0; y or v occurs and the order is above 4.
    """

    function: Expression
    order: int
    text: str
    chart: Chart | None = None

    def __post_init__(self) -> None:
        if not self.order > 1:
            raise ValueError(f"the order must be at least 2, got {self.order}")
        if self.moves and self.order > _MOST:
            raise ValueError(f"with y or v the order must be at most {_MOST}, got {self.order}")
        _terms(self.function, self.order, self.chart)

    @property
    def value(self) -> Exact:
        """At 0; a ball unless all coefficients are rational."""
        value: Exact = _terms(self.function, self.order, self.chart)[0].to_dict().get((0,) * 4, fmpq(0))
        return value

    @property
    def is_exact(self) -> bool:
        """Whether the Taylor polynomial is."""
        return all(
            isinstance(value, fmpq)
            for term in _terms(self.function, self.order, self.chart)
            for value in term.to_dict().values()
        )

    @property
    def moves(self) -> bool:
        """Whether y or v occurs, or may occur."""
        if self.chart is not None:
            return True
        return any(isinstance(node, Variable) and node.index > 1 for node in in_order([self.function]))

    @property
    def expression(self) -> Expression:
        """The function of the state."""
        return self.function

    def above(self, place: Place) -> Polynomial:
        """The Taylor polynomial without ``value``."""
        ring = place[0].context()
        total: Polynomial = ring.constant(0)
        for term in _terms(self.function, self.order, self.chart)[1:]:
            for exponents, value in term.to_dict().items():
                product = constant(ring, value)
                for base, exponent in zip(place, exponents, strict=True):
                    product = product * base ** int(exponent)
                total = total + product
        return total

    def rest(self, reach: Cone) -> Monomials:
        """A bound of \\|function - polynomial\\| on the cone, which begins at p = 0.

        :raises NoTaylorError: it is not certainly analytic there.
        """
        if self.chart is not None:
            known = _rests(self.chart, reach.last, reach.beside, reach.height, reach.speed, self.order)
            return {(0, 2 * n): size for n, size in known[self.function].items()}
        series = SeriesOfFunctions([self.function], NumberTerms(BALLS), BALLS)
        try:
            for row in reach.rows(self.order + 1):
                series.extend(row)
        except ValueError as error:
            raise NoTaylorError(str(error)) from error
        return {(0, 2 * self.order): abs(series[self.function][self.order]).upper()}

    def moved(self, reach: Cone) -> tuple[Monomials, Monomials]:
        """Bounds of what a change of y, and one of v, changes in the polynomial, over that change."""
        by_y, by_v = Monomials(), Monomials()
        for term in _terms(self.function, self.order, self.chart):
            for (p, b, y, v), value in term.to_dict().items():
                if y or v:  # one of them once, by the order
                    size = abs(ball(value)) * reach.force.abs_upper() ** int(b)
                    added(by_y if y else by_v, {(0, 2 * int(p + b)): size.upper()}, 1)
        return by_y, by_v


class _Homogeneous:
    """Terms of order n: polynomials of weight n in p, b, y, v, with coefficients in the ring."""

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
        return self._ring.number(term.to_dict().get((0,) * 4, fmpq(0)))


@cache
def _rests(
    chart: Chart, last: fmpq, beside: fmpq, height: fmpq, speed: fmpq, order: int
) -> dict[Expression, dict[int, arb]]:
    """Of the three alphas at once, on the cone around the mean force."""
    system = chart.system
    functions = system.alpha_1, system.alpha_2, system.alpha_3
    with working_bits(_BITS):
        first, second, third = system.values_at_point(functions)
        cone = Cone(fmpq(0), last, second / (third - first), beside, height, speed)
        return dict(zip(functions, taylor_rests(chart, functions, cone, order), strict=True))


@cache
def _terms(function: Expression, order: int, chart: Chart | None) -> tuple[Polynomial, ...]:
    """The parts of weight 0, 1, ..., ``order`` - 1: exact if they can be."""
    if chart is None or chart.system.ring is RATIONALS:
        try:
            return _terms_in(function, order, RATIONALS, chart)
        except (TypeError, ValueError):  # one is not rational; or the function is not analytic, and this raises, too
            pass
    with working_bits(_BITS):
        return _terms_in(function, order, BALLS, chart)


def _terms_in(function: Expression, order: int, ring: Ring, chart: Chart | None) -> tuple[Polynomial, ...]:
    terms = _Homogeneous(ring)
    rows = [
        [part if weight == n else terms.zero(n) for part, weight in zip(_RING.gens(), _WEIGHTS, strict=True)]
        for n in range(order)
    ]
    if chart is not None:
        start = [terms.constant(value) for value in chart.system.point]
        return tuple(chart.series([function], rows[1:], start, chart.slopes(), terms, ring)[function])
    series = SeriesOfFunctions([function], terms, ring)
    for row in rows:
        series.extend(row)
    return tuple(series[function])
