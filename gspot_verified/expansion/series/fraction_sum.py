"""Sums of fractions with integer polynomials above, on one denominator that grows with the sum."""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpz, fmpz_poly

Fraction = tuple[fmpz_poly, fmpz]
"""Numerator and denominator, not reduced."""


def sum_of_fractions(fractions: Iterable[Fraction]) -> Fraction:
    """The sum, on the least common multiple of the denominators.

    Cheapest from the smallest denominator to the largest: then what is scaled again is no longer than the next summand.

    >>> sum_of_fractions([(fmpz_poly([0, 1]), fmpz(4)), (fmpz_poly([1]), fmpz(6))])
    (3*x + 2, 12)
    """
    summands = iter(fractions)
    numerator, denominator = next(summands, (fmpz_poly([]), fmpz(1)))
    for above, below in summands:
        missing = below // denominator.gcd(below)
        if missing != 1:
            numerator, denominator = numerator * missing, denominator * missing
        numerator += above * (denominator // below)
    return numerator, denominator
