"""Systems whose alpha_1, alpha_2, alpha_3 are functions of p, b, y, v, affine or analytic: the numbers of their G-spot.

Proof page: ``proofs/from_state.md``, section 8. Exact rationals, or balls; the state is (p, b, y, v).
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.from_state.analytic import Analytic, Place, Polynomial
from gspot_verified.expansion.from_state.barrier import Monomials
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.numbers.balls import Exact

_ZERO = fmpq(0)  # of a slope that is not given


@dataclass(frozen=True)
class Affine:
    """``value`` + ``by_p`` p + ``by_b`` b."""

    value: fmpq
    by_p: fmpq = _ZERO
    by_b: fmpq = _ZERO

    def above(self, place: Place) -> Polynomial:
        """What it is above ``value``."""
        p, b, _, _ = place
        above: Polynomial = self.by_b * b + self.by_p * p
        return above

    @property
    def is_exact(self) -> bool:
        """Its numbers are rational."""
        return True

    @property
    def expression(self) -> Expression:
        """The function of the state (p, b, y, v)."""
        return Constant(self.value) + Constant(self.by_p) * Variable(0) + Constant(self.by_b) * Variable(1)

    @property
    def moves(self) -> bool:
        """Neither y nor v occurs."""
        return False

    def rest(self, reach: Cone) -> Monomials:
        """Nothing: it is a polynomial."""
        del reach
        return {}

    def moved(self, reach: Cone) -> tuple[Monomials, Monomials]:
        """Nothing: neither y nor v occurs."""
        del reach
        return {}, {}

    @property
    def text(self) -> str:
        """The formula; exact."""
        parts = [str(self.value), *(f"({c}) {x}" for c, x in ((self.by_p, "p"), (self.by_b, "b")) if c)]
        return " + ".join(parts)


Alpha = Affine | Analytic


@dataclass(frozen=True)
class AffineSystem:
    """p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N with alpha_i of p, b, y, v; the letters are those of the page.

    With a chart the alphas are functions of its system's state, and have it.

    :raises ValueError: alpha_1, alpha_2 are not negative at p = b = 0, beta is at most 1 or an integer.
    """

    alpha_1: Alpha
    alpha_2: Alpha
    alpha_3: Alpha
    regularisation: Regularisation
    chart: Chart | None = None

    def __post_init__(self) -> None:
        if not (self.alpha_1.value < 0 and self.alpha_2.value < 0):
            raise ValueError("alpha_1 and alpha_2 must be negative at the G-spot: else the mean force is not positive")
        if not self.beta > 1 or holds_integer(self.beta):
            raise ValueError(f"beta must be above 1 and no integer, got {self.beta}")

    @property
    def is_exact(self) -> bool:
        """Whether the polynomials of all alphas are."""
        return self.alpha_1.is_exact and self.alpha_2.is_exact and self.alpha_3.is_exact

    @property
    def moves(self) -> bool:
        """Whether y or v occurs in an alpha."""
        return self.alpha_1.moves or self.alpha_2.moves or self.alpha_3.moves

    @property
    def a(self) -> Exact:
        """-alpha_1 at the G-spot."""
        return -self.alpha_1.value

    @property
    def beta(self) -> Exact:
        """alpha_3/alpha_1 at the G-spot."""
        return self.alpha_3.value / self.alpha_1.value

    @property
    def mean_force(self) -> Exact:
        """lambda_N at the G-spot on the distinguished trajectory."""
        return self.alpha_2.value / (self.alpha_3.value - self.alpha_1.value)

    def system(self) -> System:
        """The system of the paper's equations; without a chart the state is (p, b, y, v)."""
        if self.chart is not None:
            return self.chart.system
        first, second, third = (one.expression for one in (self.alpha_1, self.alpha_2, self.alpha_3))
        nothing = Constant(fmpq(0))
        p, b, y, v = (Variable(i) for i in range(4))
        return System(
            "affine system",
            F=(first, second, v, b),
            G=(nothing, Constant(fmpq(-1)) * third, nothing, p),
            y=y,
            v=v,
            p=p,
            b=b,
            alpha_1=first,
            alpha_2=second,
            alpha_3=third,
            J=(),
            point=((fmpq(0) if self.is_exact else arb(0)),) * 4,
            ring=RATIONALS if self.is_exact else BALLS,
            state=("p", "b", "y", "v"),
            regularisation=self.regularisation,
        )


def holds_integer(value: Exact) -> bool:
    """Whether it is, or may be, an integer."""
    return bool(value.q == 1) if isinstance(value, fmpq) else bool(value.contains_integer())
