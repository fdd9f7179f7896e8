"""The Taylor series of Theta at tau = 0, in floating balls.

Proof page: ``proofs/taylor.md``.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from flint import acb, arb, arb_poly, fmpq, fmpz

from gspot_verified.numbers.balls import Exact, add_remainder, ball, nonfinite, working_bits
from gspot_verified.numbers.complex_numbers import ExactComplex, complex_ball
from gspot_verified.theta_function.gamma.initial_values import initial_values

_LONGEST_KEPT = 2**26  # bits of a polynomial; 64 of them are kept


def taylor_coefficients(beta: Exact, length: int, bits: int) -> list[arb]:
    """Enclosures of a_0 .. a_(length-1), Theta = sum a_k tau^k, with working precision ``bits``.

    a_(k+3) = (k - beta) a_k / ((k+1)(k+2)(k+3)), which is the differential equation (paper, eq. btau).
    """
    value, slope, curvature = initial_values(beta, bits)
    with working_bits(bits):
        coefficients = [value, slope, curvature / 2]
        if isinstance(beta, fmpq):
            # (k - beta) = (k q - p)/q with integers: exact, also when beta is next to the integer k.
            q = int(beta.q)
            numerator = -int(beta.p)
            if q.bit_length() > bits:
                # A long denominator: round each exact factor once.
                inverse = 1 / arb(fmpz(q))
                for k, product in zip(range(length - 3), _triples(length - 3), strict=True):
                    coefficients.append(coefficients[k] * arb(fmpz(numerator)) * inverse / product)
                    numerator += q
                return coefficients
            for k, product in zip(range(length - 3), _triples(length - 3), strict=True):
                coefficients.append(coefficients[k] * numerator / (product * q))
                numerator += q
        else:
            for k, product in zip(range(length - 3), _triples(length - 3), strict=True):
                coefficients.append(coefficients[k] * (k - beta) / product)
    return coefficients


@lru_cache(maxsize=4)
def _triples(count: int) -> tuple[int, ...]:
    """(k+1)(k+2)(k+3) for k < count."""
    return tuple((k + 1) * (k + 2) * (k + 3) for k in range(count))


class TaylorPolynomial(NamedTuple):
    """The first K terms at one beta, and what the bound on the rest needs: bounds on |a_K|, |a_(K+1)|,
    |a_(K+2)|, and on (1 + |beta|/K)/((K+1)(K+2))."""

    length: int
    polynomial: arb_poly
    omitted: tuple[arb, arb, arb]
    ratio_factor: arb


def taylor_polynomial(beta: Exact, length: int, bits: int) -> TaylorPolynomial:
    """The Taylor polynomial of ``length`` terms with working precision ``bits``; kept for a rational beta, if short."""
    if isinstance(beta, fmpq) and length * bits <= _LONGEST_KEPT:
        return _cached_polynomial(int(beta.p), int(beta.q), length, bits)  # the hash of an fmpq takes longer
    return _polynomial(beta, length, bits)


@lru_cache(maxsize=64)
def _cached_polynomial(p: int, q: int, length: int, bits: int) -> TaylorPolynomial:
    return _polynomial(fmpq(p, q), length, bits)


def _polynomial(beta: Exact, length: int, bits: int) -> TaylorPolynomial:
    coefficients = taylor_coefficients(beta, length + 3, bits)
    with working_bits(bits):
        first, second, third = (value.abs_upper() for value in coefficients[length:])
        factor = (1 + ball(beta).abs_upper() / length) / ((length + 1) * (length + 2))
        return TaylorPolynomial(length, arb_poly(coefficients[:length]), (first, second, third), factor)


def taylor_sum(tau: Exact, beta: Exact, length: int, bits: int) -> arb:
    """An enclosure of Theta(tau, beta): the Taylor polynomial of ``length`` terms plus the bound on the rest.

    Valid for every real tau and beta, balls included. Not finite when ``length`` is too small for the ratio test:
    with X = |tau| and K = length, q = (1 + |beta|/K) X^3 / ((K+1)(K+2)) must be certainly below 1; then the
    rest is at most sum_(j<3) |a_(K+j)| X^(K+j) / (1 - q).
    """
    series = taylor_polynomial(beta, length, bits)
    with working_bits(bits):
        point = ball(tau)
        return add_remainder(series.polynomial(point), _tail(point.abs_upper(), series))


def complex_taylor_sum(tau: ExactComplex, beta: Exact, length: int, bits: int) -> acb:
    """The same enclosure for every complex tau, rectangles included; the coefficients are real."""
    series = taylor_polynomial(beta, length, bits)
    with working_bits(bits):
        point = complex_ball(tau)
        return add_remainder(series.polynomial(point), _tail(point.abs_upper(), series))


def _tail(size: arb, series: TaylorPolynomial) -> arb:
    """The bound on the rest for |tau| <= size. A point, not a ball: powers of a ball with midpoint 0 are NaN."""
    ratio = series.ratio_factor * (size * size * size)
    if not ratio < 1:  # the hypothesis of the ratio test, certain or not used
        return nonfinite()
    first, second, third = series.omitted
    return (first + size * (second + size * third)) * size**series.length / (1 - ratio)


def taylor_values(points: list[float], size: float, beta: fmpq, length: int, bits: int) -> list[arb]:
    """Enclosures of Theta at many doubles with |tau| <= size: :func:`taylor_sum` with one bound on the rest for all.

    Not finite for a point beyond ``size``.
    """
    series = taylor_polynomial(beta, length, bits)
    with working_bits(bits):
        polynomial = series.polynomial + arb(0, _tail(arb(size), series).abs_upper())
        if max(map(abs, points), default=0.0) <= size:
            return [polynomial(arb(point)) for point in points]
        return [polynomial(arb(point)) if abs(point) <= size else nonfinite() for point in points]


def taylor_derivatives(tau: fmpq, beta: Exact, length: int, bits: int) -> tuple[arb, arb, arb]:
    """Enclosures of Theta, Theta' and Theta'' at tau from one polynomial.

    The rest of the n-th derivative, n <= 2: its terms from K = length >= 3 on, k(k-1)..(k-n+1) a_k tau^(k-n), grow by
    at most q (1 + 3/(K-1))^2 from one to the third after it; not finite when that is not certainly below 1.
    """
    series = taylor_polynomial(beta, length, bits)
    with working_bits(bits):
        point, polynomial = ball(tau), series.polynomial
        size = point.abs_upper()
        ratio = series.ratio_factor * (size * size * size) * (1 + arb(3) / (length - 1)) ** 2
        if not (ratio < 1 and length >= 3):  # the hypothesis, certain or not used
            return nonfinite(), nonfinite(), nonfinite()
        values = []
        for n in range(3):
            total = arb(0)
            for j, omitted in enumerate(series.omitted):
                factor = 1 if n == 0 else (length + j) if n == 1 else (length + j) * (length + j - 1)
                total += factor * omitted * size ** (length + j - n)
            values.append(add_remainder(polynomial(point), total / (1 - ratio)))
            polynomial = polynomial.derivative()
        return values[0], values[1], values[2]
