"""Bounds of the slow contact force on an interval of tau, from its derivatives at the middle.

Proof page: ``proofs/monotone.md``, section 5.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import factorial

from flint import arb, fmpq

from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Evidence


@dataclass(frozen=True)
class TaylorCell:
    """f on [lower, upper]; the bounds are formed in the precision in force."""

    profile: Profile
    lower: fmpq
    upper: fmpq
    digits: int

    @property
    def middle(self) -> fmpq:
        """The centre of the expansion."""
        return (self.lower + self.upper) / 2

    @cached_property
    def taylor(self) -> list[arb]:
        """f^(k)/k! at the middle, k = 0, ..., n."""
        slopes = self.profile.derivatives(self.middle, range(self.profile.order + 1), self.digits)
        return [slope / factorial(k) for k, slope in enumerate(slopes)]

    @property
    def _half(self) -> arb:
        return arb((self.upper - self.lower) / 2)

    @cached_property
    def least(self) -> arb:
        """A lower bound of f on the interval; where f' > 0 on all of it, that is f at the left end."""
        n, half, taylor = self.profile.order, self._half, self.taylor
        bound = _parabola(taylor[:n], half)
        for k in range(3, n):
            bound -= abs(taylor[k]) * half**k
        if n % 2:
            bound -= taylor[n] * half**n
        return larger(bound, self.profile.value(self.lower, self.digits)) if self.rising is not None else bound.lower()

    @cached_property
    def greatest(self) -> arb:
        """An upper bound of f on the interval."""
        n, half = self.profile.order, self._half
        last = self.profile.derivatives(self.upper, range(n, n + 1), self.digits)[0]
        bound = last * half**n / factorial(n)
        for k in range(n):
            bound += self.taylor[k] if k == 0 else abs(self.taylor[k]) * half**k
        return bound.upper()

    @cached_property
    def rising(self) -> Evidence | None:
        """That f' > 0 on the interval; None where it is not certain. For n < 2 it holds everywhere."""
        n, half, taylor = self.profile.order, self._half, self.taylor
        if n < 2:
            return less(n, 2)
        slope = taylor[1] - sum((k * abs(taylor[k]) * half ** (k - 1) for k in range(2, n)), arb(0))
        if n % 2 == 0:
            slope -= n * taylor[n] * half ** (n - 1)
        return less(0, slope)


def _parabola(taylor: list[arb], half: arb) -> arb:
    """A lower bound of a_0 + a_1 t + a_2 t^2, |t| <= half; terms that are missing count as 0."""
    first, second, third = [*taylor, arb(0), arb(0), arb(0)][:3]
    at_ends = first - abs(second) * half + third.min(arb(0)) * half * half
    return larger(at_ends, first - second * second / (4 * third)) if third > 0 else at_ends


def larger(left: arb, right: arb) -> arb:
    """The larger one of two lower bounds, or the one that is finite."""
    if not right.is_finite():
        return left.lower()
    return left.lower().max(right.lower()) if left.is_finite() else right.lower()
