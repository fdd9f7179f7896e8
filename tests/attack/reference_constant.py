"""Rigid slip of the model system with constant alphas, beta > 1, in closed form: with p as the time,
b = -L p + c p^beta, L = alpha_2/(alpha_3 - alpha_1), and u by its integral. C_1 has the sign of c, exactly.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import mpmath

_DIGITS = 60


def _mp(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


@dataclass(frozen=True)
class ConstantSlip:
    """alpha_1 < 0, alpha_2, beta, the constant F_u, and the velocity of the surface."""

    alpha_1: Fraction
    alpha_2: Fraction
    beta: Fraction
    push: Fraction
    surface: Fraction

    @property
    def force(self) -> Fraction:
        """L, the force on the canard."""
        return self.alpha_2 / ((self.beta - 1) * self.alpha_1)

    def on_canard(self, p: Fraction) -> tuple[Fraction, Fraction]:
        """b of the canard, and the u from which it comes to the G-spot just as slip stops."""
        return -self.force * p, self.surface + (self.push - self.force) / self.alpha_1 * p

    def sign(self, p: Fraction, b: Fraction) -> int:
        """Of C_1."""
        off = b + self.force * p
        return (off > 0) - (off < 0)

    def least_slip(self, p: Fraction, b: Fraction, u: Fraction) -> mpmath.mpf:
        """The least u less the surface's velocity from p > 0, b < 0 on until p = 0, that included; alpha_2 < 0."""
        with mpmath.workdps(_DIGITS):
            first, beta, start, force = map(_mp, (self.alpha_1, self.beta, p, self.force))
            factor = (_mp(b) + force * start) / start**beta
            rest = _mp(self.push) - force  # du/dp = (rest + factor p^(beta - 1))/alpha_1

            def slip(at: mpmath.mpf) -> mpmath.mpf:
                way = rest * (at - start) + factor * (at**beta - start**beta) / beta
                return _mp(u - self.surface) + way / first

            places = [mpmath.mpf(0), start]
            if factor != 0 and -rest / factor > 0:
                turn = (-rest / factor) ** (1 / (beta - 1))
                places += [turn] if turn < start else []
            return min(map(slip, places))
