"""The Taylor series of Theta at tau = 0, in floating balls.

Proof page: ``proofs/taylor.md``.
"""

from __future__ import annotations

from functools import lru_cache

from flint import arb, arb_poly, fmpq

from gspot_verified.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.theta.initial_values import initial_values


def taylor_coefficients(beta: Exact, length: int, bits: int) -> list[arb]:
    """Enclosures of a_0 .. a_(length-1), Theta = sum a_k tau^k, with working precision ``bits``.

    a_(k+3) = (k - beta) a_k / ((k+1)(k+2)(k+3)), which is the differential equation (paper, eq. btau).
    """
    value, slope, curvature = initial_values(beta, bits)
    with working_bits(bits):
        coefficients = [value, slope, curvature / 2]
        if isinstance(beta, fmpq):
            # (k - beta) = (k q - p)/q with integers: exact, also when beta is next to the integer k.
            p, q = int(beta.p), int(beta.q)
            for k in range(length - 3):
                coefficients.append(coefficients[k] * (k * q - p) / ((k + 1) * (k + 2) * (k + 3) * q))
        else:
            for k in range(length - 3):
                coefficients.append(coefficients[k] * (k - beta) / ((k + 1) * (k + 2) * (k + 3)))
    return coefficients[:length]


@lru_cache(maxsize=64)
def _cached_polynomial(beta: fmpq, length: int, bits: int) -> tuple[arb_poly, list[arb]]:
    return _polynomial(beta, length, bits)


def _polynomial(beta: Exact, length: int, bits: int) -> tuple[arb_poly, list[arb]]:
    coefficients = taylor_coefficients(beta, length + 3, bits)
    with working_bits(bits):
        return arb_poly(coefficients[:length]), coefficients[length:]


def taylor_sum(tau: Exact, beta: Exact, length: int, bits: int) -> arb:
    """An enclosure of Theta(tau, beta): the Taylor polynomial of ``length`` terms plus the bound on the rest.

    Valid for every real tau and beta, balls included. Not finite when ``length`` is too small for the ratio test:
    with X = \\|tau\\| and K = length, q = (1 + \\|beta\\|/K) X^3 / ((K+1)(K+2)) must be certainly below 1; then the
    rest is at most sum_(j<3) \\|a_(K+j)\\| X^(K+j) / (1 - q).
    """
    polynomial, omitted = (
        _cached_polynomial(beta, length, bits)
        if isinstance(beta, fmpq)
        else _polynomial(beta, length, bits)
    )
    with working_bits(bits):
        point = ball(tau)
        total = polynomial(point)
        return add_remainder(total, _tail(point, beta, length, omitted))


def _tail(point: arb, beta: Exact, length: int, omitted: list[arb]) -> arb:
    with working_bits(64):
        return _ratio_test(point, beta, length, omitted)


def _ratio_test(point: arb, beta: Exact, length: int, omitted: list[arb]) -> arb:
    size = point.abs_upper()  # a point: powers of a ball with midpoint 0 are NaN
    ratio = (1 + ball(beta).abs_upper() / length) * size**3 / ((length + 1) * (length + 2))
    if not ratio < 1:  # the hypothesis of the ratio test, certain or not used
        return nonfinite()
    first = omitted[0].abs_upper() + size * (omitted[1].abs_upper() + size * omitted[2].abs_upper())
    return first * size**length / (1 - ratio)
