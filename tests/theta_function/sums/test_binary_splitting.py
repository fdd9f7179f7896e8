"""Hypergeometric sums by binary splitting, against the sum of fractions.

Page: proofs/splitting.md.
"""

from __future__ import annotations

from fractions import Fraction

from flint import fmpz_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds

from gspot_verified.theta_function.sums.binary_splitting import block, split_sum

_FACTORS = st.lists(st.integers(-9, 9), min_size=1, max_size=3)


@given(_FACTORS, _FACTORS, st.sampled_from([1, 2, 4, 8]), st.integers(1, 3), st.integers(0, 4), st.integers(1, 7))
def test_the_sum_and_the_next_term_are_the_fractions(
    above: list[int], below: list[int], length: int, stride: int, first: int, blocks: int
) -> None:
    """Short balls (30 bits), so that most levels of the tree are rounded."""
    numerator, denominator = fmpz_poly(above), fmpz_poly([10_000, *map(abs, below)])  # no zero at an index >= 0
    total, term = Fraction(0), Fraction(1)
    for i in range(length * blocks):
        k = first + stride * i
        total += term
        term *= Fraction(int(numerator(k)), int(denominator(k)))
    for bits in (30, 2_000):
        found, following = split_sum(block(numerator, denominator, length, stride), first, blocks, bits)
        assert holds(found, total)
        assert holds(following, term)
        assert bits == 30 or float(found.rad()) <= 1e-300 * (1 + abs(total))
