"""The Taylor series of dTheta/dbeta at tau = 0, in floating balls.

Proof page: ``proofs/beta_series.md``.
"""

from __future__ import annotations

from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta_function.gamma.initial_values import InitialValues
from gspot_verified.theta_function.gamma.power import positive_power
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma_series
from gspot_verified.theta_function.sums.taylor import taylor_coefficients

_HALF, _THIRD = fmpq(1, 2), fmpq(1, 3)  # exact, made once


def beta_derivative_sum(tau: Exact, beta: Exact, length: int, bits: int) -> arb:
    """An enclosure of dTheta/dbeta (tau, beta): ``length`` >= 3 terms of the series plus the bound on the rest.

    With a_k the coefficients of Theta and d_k = da_k/dbeta: d_(k+3) = ((k - beta) d_k - a_k)/((k+1)(k+2)(k+3)). Valid
    for every real tau and beta, balls included. Not finite when ``length`` is too small for the ratio test: with
    X = |tau|, K = length, q = (1 + |beta|/K) X^3/((K+1)(K+2)) must be certainly below 1; then the rest is at most
    (D + A X^3/((K+1)(K+2)(K+3)(1 - q)))/(1 - q), D and A the sums of |d_(K+j)| and |a_(K+j)| times X^(K+j), j < 3.
    """
    coefficients = taylor_coefficients(beta, length + 3, bits)
    with working_bits(bits):
        value, slope, curvature = initial_slopes(beta, bits)
        slopes = [value, slope, curvature / 2]
        for k in range(length):
            slopes.append((slopes[k] * (k - beta) - coefficients[k]) / ((k + 1) * (k + 2) * (k + 3)))
        point = ball(tau)
        size = point.abs_upper()
        cube = size * size * size
        ratio = (1 + ball(beta).abs_upper() / length) * cube / ((length + 1) * (length + 2))
        if not ratio < 1:  # the hypothesis of the ratio test, certain or not used
            return nonfinite()
        first, second, third = (abs(a) for a in coefficients[length:])
        omitted = (first + size * (second + size * third)) * size**length
        first, second, third = (abs(d) for d in slopes[length:])
        own = (first + size * (second + size * third)) * size**length
        carried = omitted * cube / ((length + 1) * (length + 2) * (length + 3) * (1 - ratio))
        return add_remainder(arb_poly(slopes[:length])(point), (own + carried) / (1 - ratio))


def initial_slopes(beta: Exact, bits: int) -> InitialValues:
    """Enclosures of the derivatives by beta of Theta(0), Theta'(0), Theta''(0): the product rule in the entire form."""
    with working_bits(bits):
        series = [reciprocal_gamma_series(ball((j - beta) / 3), arb(-_THIRD), 2) for j in range(3)]
        log = arb(3).log()
        found = []
        for j, (first, second) in enumerate(((1, 2), (0, 2), (0, 1))):
            (f, df), (g, dg) = series[first], series[second]
            constant = 2 * arb.pi() * positive_power(arb(3), (2 * beta + j) / 3 - _HALF)
            found.append(constant * (2 * log / 3 * f * g + df * g + f * dg))
        return found[0], found[1], found[2]
