"""The place where a first zero is looked for is near the first change of sign; none where there is none.

A heuristic: what is proved there is proved in first_zero.py.
"""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.compliant.motion.rough_zero import rough_zero

UNIT = fmpq(10)


class _Force:
    """A force that is positive before ``zero`` and negative after it."""

    def __init__(self, zero: fmpq | int) -> None:
        self.zero = zero

    def near(self, place: fmpq) -> float:
        return float((self.zero - place).p)


@pytest.mark.parametrize("zero", [-900, -37, 3, 95, 580])
def test_it_is_near_the_change_of_sign(zero: int) -> None:
    found = rough_zero(_Force(zero), fmpq(-1000), UNIT)  # type: ignore[arg-type]
    assert found is not None
    before = max(fmpq(0), fmpq(-zero))
    assert abs(found - zero) <= UNIT / 64 + before / 50


def test_none_without_a_change_of_sign() -> None:
    assert rough_zero(_Force(10**6), fmpq(-1000), UNIT) is None  # type: ignore[arg-type]
    assert rough_zero(_Force(-(10**6)), fmpq(-1000), UNIT) is None  # type: ignore[arg-type]
