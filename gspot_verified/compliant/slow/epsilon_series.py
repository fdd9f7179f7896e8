"""G_b(tau; eta) as a series in eta on Theta and its derivatives, with the remainder of Theorem B.

Proof page: ``proofs/epsilon_series.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.compliant.slow.slow_integral import tangent_bound
from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma

_BOUND_BITS = 64  # of a bound, of which a few digits count; any number is right


@lru_cache(maxsize=128)
def series_coefficients(k: int) -> tuple[fmpq, ...]:
    """c_(k,1), ..., c_(k,k): e^h = sum_k eta^k sum_m c_(k,m) rho^(k+3m), exactly; for k = 0 the one number c_(0,0).

    From k c_(k,m) = sum_j j h_j c_(k-j,m-1), h_j = (-1)^(j+1)/(2 (j + 3)).

    >>> series_coefficients(2)
    (-1/10, 1/128)
    """
    if k == 0:
        return (fmpq(1),)
    coefficients = []
    for m in range(1, k + 1):
        total = fmpq(0)
        for j in range(1, k - m + 2):
            lower = series_coefficients(k - j)
            # c_(k-j, m-1): m - 1 = 0 only with k - j = 0.
            if (m == 1 and k == j) or 1 <= m - 1 <= k - j:
                total += fmpq(j * (-1) ** (j + 1), 2 * (j + 3)) * lower[max(m - 2, 0)]
        coefficients.append(total / k)
    return tuple(coefficients)


def epsilon_sum(derivatives: Sequence[arb], eta: arb, terms: int) -> arb:
    """sum_(k<terms) eta^k sum_m c_(k,m) Theta^(k+3m), from Theta^(0), ..., Theta^(4 terms - 4) at tau and b."""
    total = derivatives[0]
    power = arb(1)
    for k in range(1, terms):
        power = power * eta
        part = arb(0)
        for m, coefficient in enumerate(series_coefficients(k), 1):
            part += coefficient * derivatives[k + 3 * m]
        total += power * part
    return total


def epsilon_remainder(tau: arb, b: Exact, eta: arb, terms: int, places: Sequence[tuple[arb, arb]]) -> arb:
    """A bound of |G_b - sum of the first N = ``terms`` orders| for all numbers in the balls (Theorem B):

        eta^N |1/Gamma(-b)| sum_(m=1)^N |c_(N,m)| int_0^oo rho^(N+3m-b-1) e^(-rho^3/3 + rho tau + h) drho.

    ``places``: for each m two points for the tangents that bound the integral. Hypotheses, checked: eta > 0, N > b - 3,
    and those of :func:`tangent_bound` for each m (b <= N + 3m - 1); otherwise the result is not finite.
    """
    with working_bits(_BOUND_BITS):
        parameter = ball(b)
        if not (eta > 0 and parameter < terms + 3 and len(places) == terms):
            return nonfinite()
        total = arb(0)
        for m, ((rising, falling), coefficient) in enumerate(zip(places, series_coefficients(terms), strict=True), 1):
            shifted = parameter - terms - 3 * m
            total += abs(coefficient) * tangent_bound(tau, shifted, eta, arb(0), rising, falling)
        return (eta**terms * abs(reciprocal_gamma(-b, _BOUND_BITS)) * total).abs_upper()


def theta_derivatives(first: Sequence[arb], tau: arb, b: Exact, count: int) -> list[arb]:
    """``count`` derivatives of Theta from the first three, by Theta^(n+3) = tau Theta^(n+1) + (n - b) Theta^(n)."""
    derivatives = list(first)
    for n in range(count - 3):
        derivatives.append(tau * derivatives[n + 1] + (n - b) * derivatives[n])
    return derivatives[:count]


def epsilon_series(
    first: Sequence[arb], tau: arb, b: Exact, eta: arb, places: Sequence[tuple[arb, arb]], bits: int
) -> arb:
    """An enclosure of G_b(tau; eta) from enclosures of Theta, Theta', Theta'' at (tau, b); N = len(places) orders."""
    terms = len(places)
    with working_bits(bits):
        derivatives = theta_derivatives(first, tau, b, max(3, 4 * terms - 3))
        return add_remainder(epsilon_sum(derivatives, eta, terms), epsilon_remainder(tau, b, eta, terms, places))
