"""The contact force over an interval of times: the slow part by Taylor's formula, the fast part by its bound.

Proof page: ``proofs/force_range.md``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.fast.fast_part import fast_bound_at
from gspot_verified.compliant.motion.compliant_force import ContactMotion
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import approximate, hull, nonfinite, working_bits

_DIGITS = 12  # of the slow part: an interval of times is wider
_HEURISTIC_DIGITS = 5  # of a value that only says whether to go on
_BITS = 64  # beyond the heights of the inputs; any number is right


def slow_range(beta: fmpq, epsilon: fmpq, first: fmpq, last: fmpq, order: int) -> arb:
    """An enclosure of d^order F_beta/dT^order over first <= T <= last (Taylor's formula at ``first``).

    The last derivative used is a multiple of F_c with c <= 0, which is positive and does not decrease.
    """
    degree = max(0, math.ceil(approximate(beta - order)))
    while beta - order - degree > 0:
        degree += 1
    ends = [slow_value(place, beta, epsilon, order + degree, _DIGITS).value for place in (first, last)]
    with working_bits(_BITS + int((last - first).height_bits())):
        total = hull([ends[0], ends[1]])
        step = hull([arb(0), arb(last - first)])
        for k in range(degree - 1, -1, -1):
            total = slow_value(first, beta, epsilon, order + k, _DIGITS).value + total * step / (k + 1)
        return total


@dataclass(frozen=True, slots=True)
class ForceRange:
    """The deviation of the force, lambda - mean, of one motion over intervals of T (normal form)."""

    motion: ContactMotion
    coefficient: arb

    def mean(self) -> fmpq:
        """lambda-bar in the normal form."""
        return self.motion.model.mean_force * self.motion.model.sigma**2

    def over(self, first: fmpq, last: fmpq) -> arb:
        """An enclosure of lambda over [first, last]."""
        bound = self._fast(first, last)
        with working_bits(_BITS + self._bits()):
            return self._slow(first, last, 1) + self.mean() + hull([arb(0), bound, -bound])

    def slope(self, first: fmpq, last: fmpq) -> arb:
        """An enclosure of d lambda/dT over [first, last]: lambda' = -lambda - Z - V in the hats of the fast part."""
        bound = self._fast(first, last, ("force", "Z", "V"))
        with working_bits(_BITS + self._bits()):
            return self._slow(first, last, 2) + hull([arb(0), bound, -bound])

    def near(self, place: fmpq) -> float:
        """About lambda at T without its fast part; a heuristic."""
        beta, small = self.motion.model.beta, self.motion.model.scaled_epsilon
        value = slow_value(place, beta, small, 1, _HEURISTIC_DIGITS).value
        with working_bits(_BITS):
            return approximate(self.coefficient * value / (beta * small) + self.mean())

    def _bits(self) -> int:
        return 2 * int(self.motion.model.scaled_epsilon.height_bits())

    def _slow(self, first: fmpq, last: fmpq, order: int) -> arb:
        beta, small = self.motion.model.beta, self.motion.model.scaled_epsilon
        return self.coefficient * slow_range(beta, small, first, last, order) / (beta * small)

    def _fast(self, first: fmpq, last: fmpq, names: tuple[str, ...] = ("force",)) -> arb:
        """A bound of the sum of the named fast parts over [first, last], which does not hold 0 in its inside."""
        state = self.motion.state
        if state is None:
            return arb(0)
        if first < 0 < last:
            return nonfinite()
        p = -(first if first < 0 else last) * state.epsilon
        bounds = fast_bound_at(state, p, names)
        with working_bits(_BITS + self._bits()):
            return sum((bounds[name] for name in names), arb(0)).abs_upper()
