"""The coefficients c_k(beta) of Theorem 5 (th:4), as exact polynomials in beta, by two independent derivations.

Proof page: ``proofs/asymptotic_coefficients.md``.
"""

from __future__ import annotations

from functools import lru_cache

from flint import fmpq, fmpq_poly


def coefficient(k: int) -> fmpq_poly:
    """c_k as a polynomial in beta of degree 2k, c_0 = 1. First derivation: the differential equation.

    With a = -beta/3 - 1/2 and g_k = c_k (3/2)^k, putting e^(2 lambda/3) lambda^a sum g_k lambda^(-k) with
    lambda = tau^(3/2) into the equation gives
    3 k g_k = A_1(a - k + 1) g_(k-1) + A_0(a - k + 2) g_(k-2), where
    A_1(m) = (27 m^2 - 9 m - 1)/4 and A_0(m) = 3 m (3m - 2)(3m - 4)/8.

    :raises ValueError: k is negative.

    >>> coefficient(1)
    1/6*x^2 + 2/3*x + 41/72
    """
    if k < 0:
        raise ValueError(f"k must be at least 0, got {k}")
    return _scaled(k) * fmpq(2, 3) ** k


def first_order_factor(m: fmpq_poly) -> fmpq_poly:
    """A_1(m) of :func:`coefficient`."""
    return (27 * m * m - 9 * m - 1) / 4


def second_order_factor(m: fmpq_poly) -> fmpq_poly:
    """A_0(m) of :func:`coefficient`."""
    return 3 * m * (3 * m - 2) * (3 * m - 4) / 8


@lru_cache(maxsize=512)
def _scaled(k: int) -> fmpq_poly:
    previous, current = fmpq_poly([0]), fmpq_poly([1])
    exponent = fmpq_poly([fmpq(-1, 2), fmpq(-1, 3)])
    for j in range(1, k + 1):
        following = first_order_factor(exponent - j + 1) * current
        following += second_order_factor(exponent - j + 2) * previous
        previous, current = current, following / (3 * j)
    return current


def coefficient_by_inversion(k: int) -> fmpq_poly:
    """c_k as a polynomial in beta. Second derivation: the saddle point, by Lagrange's inversion formula.

    c_k = (2/3)^k (1/2)_k [u^(2k)] (1 + u)^(-beta - 1) (1 + u/3)^(-k - 1/2). No differential equation is used.

    :raises ValueError: k is negative.

    >>> coefficient_by_inversion(1) == coefficient(1)
    True
    """
    if k < 0:
        raise ValueError(f"k must be at least 0, got {k}")
    degree = 2 * k
    total = fmpq_poly([0])
    first = _binomials(fmpq_poly([-1, -1]), degree)
    second = fmpq(1)
    for j in range(degree + 1):
        total += first[degree - j] * second
        second *= (fmpq(-2 * k - 1, 2) - j) / (3 * (j + 1))
    half = fmpq(1)
    for j in range(k):
        half *= fmpq(2 * j + 1, 2)
    return total * half * fmpq(2, 3) ** k


def _binomials(top: fmpq_poly, count: int) -> list[fmpq_poly]:
    """binomial(top, j) for j = 0 .. count, as polynomials."""
    values = [fmpq_poly([1])]
    for j in range(count):
        values.append(values[-1] * (top - j) / (j + 1))
    return values
