"""How (0, delta_0] is divided: whatever is followed, the ranges cover it or the reason is given (proofs/uniform.md)."""

from __future__ import annotations

import itertools
from fractions import Fraction

from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.expansion.true_solutions.delta_ranges import in_ranges, smallest

Range = tuple[fmpq, fmpq]


@given(
    st.fractions(Fraction(1, 10**4), 20),
    st.fractions(0, 1, max_denominator=500),
    st.sampled_from([fmpq(2), fmpq(3, 2), fmpq(21, 20), fmpq(101, 100)]),
)
def test_ranges_go_on_from_one_end_to_the_next(top: Fraction, part: Fraction, widest: fmpq) -> None:
    """``follow`` succeeds below a bound from 0, and on short ranges above it."""
    last = to_fmpq(top)
    bound = last * to_fmpq(part)

    def follow(least: fmpq, most: fmpq) -> Range | str:
        assert 0 <= least < most <= last
        return (least, most) if most <= bound or (least > 0 and most <= widest * least) else f"{most} is too large"

    found, failed = in_ranges(follow, last)
    if not found:
        assert bound < smallest(last)
        assert failed == f"{smallest(last)} is too large"
        return
    assert found[0][0] == 0
    assert all(one[1] == other[0] for one, other in itertools.pairwise(found))
    assert (found[-1][1] == last) is (failed == "")
    if widest > fmpq(31, 30) and last < fmpq(1, 8):
        assert failed == ""
