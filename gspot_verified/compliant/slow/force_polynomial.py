"""The slow solution at an integer b, where it is a polynomial with rational coefficients, and its number of real zeros.

Proof pages: ``proofs/exact_solution.md``, section 3 (e), (g); ``proofs/finite_epsilon_zeros.md``, section 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from flint import fmpq, fmpq_poly


def force_polynomial(n: int, epsilon: fmpq) -> fmpq_poly:
    """F_n(T; epsilon) for n = 0, 1, 2, ..., from F_0 = 1 by the recurrence in b at integers:

        F_c = -T F_(c-1) + (c-1) [T F_(c-2) + F_(c-1)] + (c-1)(c-2) (2/epsilon) [F_(c-3) - (c-3)/2 F_(c-4)].

    :raises ValueError: n < 0 or epsilon <= 0.

    >>> force_polynomial(4, fmpq(1, 2)).coeffs()
    [12, -32, 0, 0, 1]
    """
    if n < 0 or epsilon <= 0:
        raise ValueError("expected n >= 0 and epsilon > 0")
    time = fmpq_poly([0, 1])
    polynomials = [fmpq_poly([1])]
    for c in range(1, n + 1):
        # What lies before F_0 has a factor 0.
        first, second, third, fourth = [*reversed(polynomials[-4:]), *[fmpq_poly([])] * 4][:4]
        older = third - fmpq(c - 3, 2) * fourth
        polynomials.append(-time * first + (c - 1) * (time * second + first) + (c - 1) * (c - 2) * 2 / epsilon * older)
    return polynomials[n]


def distinct_real_zeros(polynomial: fmpq_poly, lower: fmpq | None = None, upper: fmpq | None = None) -> int:
    """The number of distinct zeros in (lower, upper] of a polynomial that is not 0, by Sturm's theorem; None: infinity.

    :raises ValueError: the polynomial is 0.

    >>> distinct_real_zeros(fmpq_poly([0, 0, 1])), distinct_real_zeros(fmpq_poly([1, 0, 1]))
    (1, 0)
    >>> distinct_real_zeros(fmpq_poly([0, -1, 1]), fmpq(0)), distinct_real_zeros(fmpq_poly([0, -1, 1]), None, fmpq(0))
    (1, 1)
    """
    if polynomial.is_zero():
        raise ValueError("the polynomial 0 has no number of zeros")
    # Without multiple zeros the theorem holds at an end that is a zero too.
    chain = [polynomial // polynomial.gcd(polynomial.derivative())]
    following = chain[0].derivative()
    while not following.is_zero():
        chain.append(following)
        following = -(chain[-2] % chain[-1])
    return _changes(_values(chain, lower, -1)) - _changes(_values(chain, upper, 1))


def _values(chain: list[fmpq_poly], point: fmpq | None, side: int) -> list[fmpq]:
    """At a point, or far out on one side up to positive factors."""
    if point is not None:
        return [element(point) for element in chain]
    return [element.leading_coefficient() * side ** element.degree() for element in chain]


def _changes(values: Sequence[fmpq]) -> int:
    signs = [value > 0 for value in values if value != 0]
    return sum(first != second for first, second in pairwise(signs))
