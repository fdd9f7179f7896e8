"""Theta at beta = 0, 1, 2, ...: a polynomial in tau with integer coefficients.

Proof page: ``proofs/initial_values.md``.
"""

from __future__ import annotations

from flint import fmpq, fmpq_poly, fmpz

MAX_DEGREE = 20_000  # so that the coefficients fit in memory; ValueError beyond it


def polynomial(n: int) -> fmpq_poly:
    """Theta(., n) = (-1)^n n! [r^n] e^(r tau - r^3/3), exactly.

    :raises TypeError: n is not an int.
    :raises ValueError: n is negative, or above 20,000: the coefficients then fill more than about 200 MB.

    >>> polynomial(3)
    (-1)*x^3 + 2
    """
    if type(n) is not int:
        raise TypeError(f"n must be an int, got {type(n).__name__}")
    if not 0 <= n <= MAX_DEGREE:
        raise ValueError(f"n must lie in 0..{MAX_DEGREE}, got {fmpz(n)}")
    coefficients = [fmpz(0)] * (n + 1)
    value = fmpz(-1) ** n
    for j in range(n // 3 + 1):
        degree = n - 3 * j
        coefficients[degree] = value
        # n!/((n-3j)! 3^j j!) stays an integer: it counts choices of j disjoint triples, times 2^j orders.
        value = -value * degree * (degree - 1) * (degree - 2) / (3 * (j + 1))
    return fmpq_poly(coefficients)


def polynomial_value(tau: fmpq, n: int) -> fmpq:
    """Theta(tau, n) as an exact rational.

    >>> polynomial_value(fmpq(1, 2), 3)
    15/8
    """
    return polynomial(n)(tau)
