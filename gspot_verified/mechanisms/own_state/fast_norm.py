"""A norm of the contact's fast variables that falls where p > 0, and how fast.

Proof page: ``proofs/from_own_state.md``, section 2.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.mechanisms.derive.mass_matrix import positive_definite
from gspot_verified.numbers.balls import ball
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence


@dataclass(frozen=True)
class Decay:
    """At every p of a ball: \\|M - 1\\| <= ``tilt`` < 1, and \\|X\\|_M falls at least at ``rate`` by the frozen
    equations."""

    tilt: arb
    rate: arb
    evidence: Evidence


@dataclass(frozen=True)
class FastNorm:
    """M, with k_1 = ``weight``, k_2 = ``weight``/2, theta = ``weight``/5."""

    contact: Contact
    weight: fmpq

    def decay(self, p: arb) -> Decay | None:
        """None: that it falls is not certain for some p of the ball."""
        kappa, g, lag = (ball(value) for value in (self.contact.kappa, self.contact.rate, self.contact.lag))
        first, second, theta = (ball(self.weight / n) for n in (1, 2, 5))
        if less(0, p) is None:
            return None
        root = p.sqrt()
        above, below = second * lag * root / (g * kappa.sqrt()), first * lag.sqrt() * root / g
        square, q = above**2 + below**2, lag * p / g
        n_11, n_22 = 2 * (second - theta) * lag / g, 2 * (first - second - theta) * lag / g
        n_12, n_13 = -2 * theta * lag / g * above, above * lag.sqrt() - below * kappa.sqrt()
        n_23, n_33 = 2 * theta * lag / g * root * below - first * lag.sqrt(), 2 * g - 2 * (first + theta) * q
        evidence = every([less(square, 1), positive_definite([n_11, n_12, n_13, n_12, n_22, n_23, n_13, n_23, n_33])])
        return None if evidence is None else Decay(square.sqrt().upper(), (theta * q).lower(), evidence)
