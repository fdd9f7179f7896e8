"""The Taylor series at 0 by exact binary splitting.

Page: proofs/splitting.md.
"""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq

from gspot_verified.theta_function.sums.splitting import splitting_sum

_TAUS = st.builds(Fraction, st.integers(-80, 80), st.integers(8, 40))


@given(_TAUS, small_heights(), st.sampled_from([1, 2, 4, 8, 16]))
def test_block_length_does_not_change_the_enclosed_number(tau: Fraction, beta: Fraction, block: int) -> None:
    t, b = to_fmpq(tau), to_fmpq(beta)
    first, second = splitting_sum(t, b, 150, 200, block), splitting_sum(t, b, 150, 200, 2)
    assert first.is_finite()
    assert second.is_finite()
    assert first.overlaps(second)
