"""Leading terms of sums of monomials w^a T^b, where T is a power of the small number w > 0 with an unknown exponent.

T = w^(u (r - 1)) with r > 0 unknown and u > 0. A monomial has the order a + u (r - 1) b. Beside w^c T, of order
c + u (r - 1), the monomial w^a T^b is of higher order for every r > 0 when
a - c - u (b - 1) + u (b - 1) r > 0 for every r > 0.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.identities import Algebra


def is_dominated(a: int, b: int, c: int, unit: int = 1) -> bool:
    """Whether w^a T^b is of higher order than w^c T for every r > 0.

    >>> is_dominated(2, 1, 1), is_dominated(1, 2, 0), is_dominated(0, 2, 0)
    (True, True, False)
    """
    return b >= 1 and a > c and a - c >= unit * (b - 1)


def leading(algebra: Algebra, value: fmpq_mpoly, c: int, unit: int = 1) -> tuple[fmpq_mpoly, list[fmpq_mpoly]]:
    """The coefficient of w^c T, and the coefficients of what is not of higher order: none in a correct expansion."""
    rest = []
    for a, in_t in algebra.coefficients(value, "w").items():
        for b, coefficient in algebra.coefficients(in_t, "T").items():
            if (a, b) != (c, 1) and not is_dominated(a, b, c, unit):
                rest.append(coefficient)
    return algebra.coefficient_of(algebra.coefficient_of(value, "w", c), "T", 1), rest
