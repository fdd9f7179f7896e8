"""The number of real zeros of the polynomial F_n for every epsilon of a range, exactly.

Proof page: ``proofs/finite_epsilon_zeros.md``, section 3.
"""

from __future__ import annotations

from functools import lru_cache

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from gspot_verified.compliant.slow.force_polynomial import distinct_real_zeros, force_polynomial


def number_at_integer(n: int, epsilon_lower: fmpq, epsilon_upper: fmpq) -> int | None:
    """The number of distinct real zeros of F_n(.; epsilon), the same for all epsilon > 0 of [lower, upper]; None when
    two zeros, real or not, meet at one of them.

    ``epsilon_lower`` = 0: for all epsilon in (0, upper].

    :raises ValueError: n < 2, or not 0 <= lower <= upper, 0 < upper.

    >>> [number_at_integer(8, fmpq(0), fmpq(upper)) for upper in (13, 14)]
    [2, None]
    """
    if n < 2 or not 0 <= epsilon_lower <= epsilon_upper or epsilon_upper == 0:
        raise ValueError("expected n >= 2 and 0 <= lower <= upper, upper > 0")
    discriminant = force_discriminant(n)
    # T^2 has its double zero at every epsilon, and no other.
    if not discriminant.is_zero():
        first = 1 / epsilon_upper
        last = 1 / epsilon_lower if epsilon_lower > 0 else None
        if discriminant(first) == 0 or distinct_real_zeros(discriminant, first, last):
            return None
    return distinct_real_zeros(force_polynomial(n, epsilon_upper))


@lru_cache(maxsize=32)
def force_discriminant(n: int) -> fmpq_poly:
    """The discriminant of F_n as a polynomial of T; its variable is 1/epsilon.

    >>> force_discriminant(3).coeffs()
    [0, 0, -432]
    """
    ring = fmpq_mpoly_ctx.get(["T", "d"], "lex")
    time, inverse = ring.gens()
    # F_n has degree at most n/3 in 1/epsilon: Newton's divided differences at 1/epsilon = 1, 2, ...
    nodes = range(1, n // 3 + 2)
    values = [_lifted(force_polynomial(n, fmpq(1, node)), time) for node in nodes]
    for order in range(1, len(values)):
        for i in range(len(values) - 1, order - 1, -1):
            values[i] = (values[i] - values[i - 1]) * fmpq(1, order)
    polynomial = values[-1]
    for node, value in reversed(list(zip(nodes, values, strict=True))[:-1]):
        polynomial = polynomial * (inverse - node) + value
    discriminant = fmpq_poly([])
    for (_, power), coefficient in polynomial.discriminant("T").to_dict().items():
        discriminant += fmpq_poly([0] * power + [coefficient])
    return discriminant


def _lifted(polynomial: fmpq_poly, variable: fmpq_mpoly) -> fmpq_mpoly:
    total = variable * 0
    for power, coefficient in enumerate(polynomial.coeffs()):
        total += coefficient * variable**power
    return total
