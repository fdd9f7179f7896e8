"""Sums of fractions on one denominator, against fmpq_poly."""

from __future__ import annotations

from flint import fmpq_poly, fmpz, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.expansion.series.terms import sum_of_fractions

fractions = st.tuples(st.lists(st.integers(-9, 9), max_size=4).map(fmpz_poly), st.integers(1, 40).map(fmpz))


@given(st.lists(fractions, max_size=6))
def test_the_sum_on_the_least_common_multiple(summands: list[tuple[fmpz_poly, fmpz]]) -> None:
    expected, common = fmpq_poly([]), fmpz(1)
    for above, below in summands:
        expected += fmpq_poly(above, below)
        common = common.lcm(below)
    numerator, denominator = sum_of_fractions(iter(summands))
    assert fmpq_poly(numerator, denominator) == expected
    assert denominator == common
