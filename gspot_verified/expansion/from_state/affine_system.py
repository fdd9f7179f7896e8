"""Systems whose alpha_1, alpha_2, alpha_3 are affine functions of p and b: their reference force, slopes and bounds.

Proof page: ``proofs/from_state.md``, section 8. Exact rationals; the state is (p, b, y, v).
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.expansion.from_state.barrier import Monomials, added
from gspot_verified.expansion.from_state.slow_series import Slopes
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.expressions import Constant, Expression, Variable

_ZERO = fmpq(0)  # of a slope that is not given


@dataclass(frozen=True)
class Affine:
    """``value`` + ``by_p`` p + ``by_b`` b."""

    value: fmpq
    by_p: fmpq = _ZERO
    by_b: fmpq = _ZERO

    @property
    def expression(self) -> Expression:
        """The function of the state (p, b, y, v)."""
        return Constant(self.value) + Constant(self.by_p) * Variable(0) + Constant(self.by_b) * Variable(1)

    @property
    def text(self) -> str:
        """The formula; exact."""
        parts = [str(self.value), *(f"({c}) {x}" for c, x in ((self.by_p, "p"), (self.by_b, "b")) if c)]
        return " + ".join(parts)


@dataclass(frozen=True)
class AffineSystem:
    """p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N with affine alpha_i; the letters are those of the page.

    :raises ValueError: alpha_1, alpha_2 are not negative at p = b = 0, beta is at most 1, or 2.
    """

    alpha_1: Affine
    alpha_2: Affine
    alpha_3: Affine
    regularisation: Regularisation

    def __post_init__(self) -> None:
        if not (self.alpha_1.value < 0 and self.alpha_2.value < 0):
            raise ValueError("alpha_1 and alpha_2 must be negative at the G-spot: else the mean force is not positive")
        if not self.beta > 1 or self.beta == 2:
            raise ValueError(f"beta must be above 1 and not 2, got {self.beta}")

    @property
    def a(self) -> fmpq:
        """-alpha_1 at the G-spot."""
        return -self.alpha_1.value

    @property
    def beta(self) -> fmpq:
        """alpha_3/alpha_1 at the G-spot."""
        return self.alpha_3.value / self.alpha_1.value

    @property
    def mean_force(self) -> fmpq:
        """lambda_N at the G-spot on the distinguished trajectory."""
        return self.alpha_2.value / (self.alpha_3.value - self.alpha_1.value)

    def along(self, function: Affine) -> fmpq:
        """d: its derivative by p along b = -p times the mean force."""
        return function.by_p - function.by_b * self.mean_force

    @property
    def _turn(self) -> fmpq:
        return self.along(self.alpha_1) - self.along(self.alpha_3)

    @property
    def _turn_by_b(self) -> fmpq:
        return self.alpha_1.by_b - self.alpha_3.by_b

    @property
    def tilt(self) -> fmpq:
        """Lambda_1: the reference force is the mean force + Lambda_1 p."""
        driven = self.along(self.alpha_2) + self._turn * self.mean_force
        return -driven / (self.a * (self.beta - 2))

    @property
    def _force(self) -> fmpq:
        """c - b_rho."""
        return self._turn - self.alpha_2.by_b - self._turn_by_b * self.mean_force

    @property
    def slopes(self) -> Slopes:
        """What is of first order in p."""
        return Slopes(
            fall=-self.along(self.alpha_1) / self.a,
            force=self._force / self.a,
            back=-self.along(self.alpha_3) / self.a,
            turn=self._turn / self.a,
        )

    def rests(self, reach: fmpq, coefficient: arb, ratio: fmpq) -> Rests:
        """Bounds of what the slopes leave out, for p <= reach and coefficient/ratio <= \\|C\\| <= ratio coefficient."""
        tilt, by_b, turn = abs(self.tilt), abs(self.alpha_1.by_b), abs(self._turn_by_b)
        largest, least = ratio * coefficient, coefficient / ratio
        still = (abs(self._force) + abs(self.along(self.alpha_1)) + reach * tilt * (turn + by_b)) * tilt

        def of(free: fmpq, by_l: fmpq, by_p: fmpq) -> Monomials:
            total: Monomials = {}
            for power, size, unit in (
                (2 * (3 - self.beta), free, 1 / least),
                (2 * self.beta, by_l, largest),
                (fmpq(4), by_p, arb(1)),
            ):
                if size > 0:
                    added(total, {(fmpq(0), power): unit}, size / self.a)
            return total

        return Rests(
            force=of(still, turn, (2 * turn + by_b) * tilt),
            fall=of(_ZERO, by_b, by_b * tilt),
            back=of(_ZERO, abs(self.alpha_3.by_b), abs(self.alpha_3.by_b) * tilt),
            turn=of(_ZERO, turn, turn * tilt),
        )

    def system(self) -> System:
        """The system of the paper's equations with the state (p, b, y, v)."""
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
            point=(fmpq(0),) * 4,
            state=("p", "b", "y", "v"),
            regularisation=self.regularisation,
        )


@dataclass(frozen=True)
class Rests:
    """Bounds by monomials of r: ``force`` of sigma_/L, tau_/L; ``fall``, ``back``, ``turn`` of pi_, beta_, omega_."""

    force: Monomials
    fall: Monomials
    back: Monomials
    turn: Monomials
