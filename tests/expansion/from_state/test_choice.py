"""Numbers that are tried; any are right, so only what others lean on is asked."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.expansion.from_state.choice import LARGEST_DELTA, largest_delta, near
from gspot_verified.numbers.balls import working_bits


def test_a_number_near_a_ball_is_no_integer_by_rounding() -> None:
    with working_bits(100):
        assert near(fmpq(7, 3)) == fmpq(7, 3)
        assert near(arb("1.6188", "1e-9")) == fmpq(4047, 2500)
        beside = near(arb("2.0000001", "1e-9"))
        assert beside.q != 1
        assert abs(arb(beside) - 2) < arb("1e-6")
        assert near(arb(2, "1e-9")) == 2


def test_ranges_begin_where_the_fast_part_of_the_start_may_fall() -> None:
    assert largest_delta(fmpq(100), fmpq(1)) == LARGEST_DELTA
    for p in (fmpq(1, 10), fmpq(1, 1000), arb("0.0067", "1e-5")):
        delta = arb(largest_delta(p, fmpq(1)))
        assert delta**3 <= 8 * arb(p) ** 2 / 20
        assert (4 * delta) ** 3 > 8 * arb(p).lower() ** 2 / 21
