"""The Taylor coefficients in tau of the slow solution G_b(tau; eta) at one tau, all from one set of integrals.

Proof page: ``proofs/exact_solution.md``, section 3; the integrals: ``proofs/slow_integral.md``.
"""

from __future__ import annotations

import math

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.recurrence import climbed
from gspot_verified.compliant.slow.slow_integral import slow_moments
from gspot_verified.compliant.slow.slow_plan import bits_lost, steps_from_below, trapezoid_plan
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma

_ORDER = 4  # consecutive b that the recurrence in b begins with: proofs/slow_integral.md


def slow_jet(tau: fmpq, b: fmpq, epsilon: fmpq, count: int, bits: int) -> list[arb]:
    """Enclosures of c_k = (-b)_k/k! G_(b-k)(tau; eta), 0 <= k < ``count``: G_b(tau + x) = sum c_k x^k.

    About ``bits`` bits are right where nothing cancels.

    >>> [value.contains(fmpq(1, 4)) for value in slow_jet(fmpq(1, 2), fmpq(2), fmpq(1), 1, 60)]
    [True]
    """
    eta = (approximate(epsilon) / 2) ** (1 / 3)
    place = approximate(tau)
    steps = max(steps_from_below(approximate(b), place, bits), count - _ORDER)
    base = b - steps
    lost = bits_lost(approximate(b), place, eta, steps)
    plan = trapezoid_plan(place, approximate(base), eta, _ORDER, bits + lost)
    with working_bits(plan.bits):
        exact_eta, exact_tau = scale(epsilon), arb(tau)
        moments = slow_moments(exact_tau, base, epsilon, _ORDER, plan)
        lowest = [value * reciprocal_gamma(j - base, plan.bits) for j, value in enumerate(moments)]
        values = lowest[::-1]
        for k in range(steps - 1, -1, -1):
            lowest = climbed(lowest, b - k, 1, exact_tau, exact_eta)
            values.append(lowest[0])
        values.reverse()
        return [value * _rising(-b, k) / math.factorial(k) for k, value in enumerate(values[:count])]


def _rising(a: fmpq, k: int) -> fmpq:
    """(a)_k = a (a + 1) ... (a + k - 1)."""
    return math.prod((a + i for i in range(k)), start=fmpq(1))
