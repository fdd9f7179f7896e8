"""How (0, delta_0] is divided: whatever is followed, the ranges cover it or the reason is given (proofs/uniform.md)."""

from __future__ import annotations

import itertools
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.expansion.true_solutions.delta_ranges import in_ranges, smallest
from gspot_verified.expansion.true_solutions.side_end import SideEnd, joined, latest_at, proved_so_far
from gspot_verified.numbers.evidence import less

Range = tuple[fmpq, fmpq]
SHOWN = less(0, 1)
assert SHOWN is not None


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


def end(least: fmpq, most: fmpq, side: int = 1) -> SideEnd:
    assert SHOWN is not None
    return SideEnd(least, most, side, fmpq(2), arb(1), arb(3), arb(5), SHOWN)


def test_only_ranges_that_cover_all_on_one_side_are_joined() -> None:
    whole = [end(fmpq(0), fmpq(1, 4)), end(fmpq(1, 4), fmpq(1, 2))]
    assert joined(whole, fmpq(1, 2)) is not None
    assert proved_so_far(whole) == "; it is proved up to epsilon = 1/8"
    wrong = [
        [],
        whole[:1],
        whole[1:],
        [whole[0], end(fmpq(1, 4) + fmpq(1, 10**9), fmpq(1, 2))],
        [end(fmpq(1, 10**9), fmpq(1, 4)), whole[1]],
        [whole[0], replace(whole[1], side=-1)],
    ]
    for ends in wrong:
        assert joined(ends, fmpq(1, 2)) is None
    for ends in (wrong[0], wrong[2], wrong[-1]):
        assert proved_so_far(ends) == ""


def test_no_time_where_nothing_is_proved() -> None:
    ends = [end(fmpq(1, 4), fmpq(1, 2))]
    assert latest_at(ends, fmpq(1, 64), fmpq(1)).is_finite()
    for epsilon in (fmpq(0), fmpq(1, 65), fmpq(1, 7), fmpq(-1)):
        with pytest.raises(ValueError, match="nothing is proved"):
            latest_at(ends, epsilon, fmpq(1))
