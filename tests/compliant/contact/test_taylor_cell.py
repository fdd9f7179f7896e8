"""Bounds of the slow force on an interval: below and above a scan, near it on short ones, and rising only where it is.

Page: proofs/monotone.md, section 5.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.contact.taylor_cell import TaylorCell, _parabola, larger
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.balls import working_bits

BETAS = [fmpq(1, 2), fmpq(3, 2), fmpq(5, 2), fmpq(7, 2), fmpq(9, 2), fmpq(11, 2)]
ENDS = [(fmpq(-6), fmpq(-3)), (fmpq(-2), fmpq(0)), (fmpq(-1, 2), fmpq(1)), (fmpq(1), fmpq(3)), (fmpq(2), fmpq(5, 2))]


@pytest.fixture(autouse=True)
def _precise() -> Iterator[None]:
    with working_bits(120):
        yield


@pytest.mark.parametrize("beta", BETAS)
@pytest.mark.parametrize("ends", ENDS)
def test_the_bounds_hold_on_a_scan(beta: fmpq, ends: tuple[fmpq, fmpq]) -> None:
    profile = Profile.leading_order(beta)
    cell = TaylorCell(profile, *ends, 15)
    assert cell.least < cell.greatest
    for k in range(9):
        value, slope = profile.derivatives(ends[0] + (ends[1] - ends[0]) * k / 8, range(2), 20)
        assert cell.least <= value.upper()
        assert value.lower() <= cell.greatest
        assert slope > 0 or not cell.rising


@pytest.mark.parametrize("beta", BETAS)
@pytest.mark.parametrize("place", [fmpq(-5), fmpq(-1), fmpq(3, 2), fmpq(3)])
def test_on_a_short_interval_they_are_near(beta: fmpq, place: fmpq) -> None:
    """The part that is not linear is of the square of the length; and the sign of the slope is seen."""
    profile, half = Profile.leading_order(beta), fmpq(1, 10**4)
    cell = TaylorCell(profile, place - half, place + half, 20)
    value, slope, bend = profile.derivatives(place, range(3), 25)
    near = 2 * abs(bend) * half * half + fmpq(1, 10**9)
    assert cell.least > value - abs(slope) * half - near
    assert cell.greatest < value + abs(slope) * half + near
    assert (cell.rising is not None) is bool(slope > 0)


def test_where_it_rises_the_least_value_is_at_the_left_end() -> None:
    for beta in BETAS:
        cell = TaylorCell(Profile.leading_order(beta), fmpq(4), fmpq(33, 8), 15)
        assert cell.rising
        left = cell.profile.value(fmpq(4), 15)
        assert left.lower() <= cell.least <= left.upper()


@pytest.mark.parametrize(
    ("taylor", "half", "expected"),
    [
        ([2], 1, 2),
        ([2, 1], 1, 1),
        ([2, -1], fmpq(1, 2), fmpq(3, 2)),
        # 1 + t + t^2 is 3/4 at its vertex; 1 + t - t^2 is -1 at the left end
        ([1, 1, 1], 1, fmpq(3, 4)),
        ([1, 1, -1], 1, -1),
        ([1, 2, 1], fmpq(1, 4), fmpq(1, 2)),
        ([1, 0, 3], 1, 1),
    ],
)
def test_the_least_value_of_a_parabola(taylor: list[int], half: fmpq | int, expected: fmpq | int) -> None:
    found = _parabola([arb(value) for value in taylor], arb(half))
    assert abs(found - expected) < 1e-25


def test_the_larger_of_two_lower_bounds() -> None:
    two, wide, unknown = arb(2), arb((3, 0), (2, 0)), arb("nan")
    assert larger(two, wide) == 2
    assert larger(wide, arb(0)) <= 1
    assert larger(two, unknown) == 2
    assert larger(unknown, two) == 2
    assert not larger(unknown, unknown).is_finite()


def test_wide_values_are_rounded_to_the_safe_side() -> None:
    """f = 1 +- 1/2 and f' = -1 in the middle, a straight line: between -1/2 and 5/2 on [-1, 1]."""

    class Line:
        order = 2

        def derivatives(self, _: fmpq, orders: range, __: int) -> list[arb]:
            return [arb(1, 0.5) if k == 0 else arb(-1) if k == 1 else arb(0) for k in orders]

    cell = TaylorCell(Line(), fmpq(-1), fmpq(1), 10)  # type: ignore[arg-type]
    assert not cell.rising
    assert -0.51 < cell.least <= -0.5
    assert 2.5 <= cell.greatest < 2.51
