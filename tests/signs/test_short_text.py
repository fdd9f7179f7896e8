from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from strategies import to_fmpq

from gspot_verified.signs.short_text import short_text

VALUES = (fmpq(1, 10**9), fmpq(7, 80), fmpq(-12345, 1000), fmpq(10) ** 25, fmpq(2, 3), fmpq(0), fmpq(1, 5**9))


@pytest.mark.parametrize("value", VALUES, ids=str)
def test_the_text_is_the_number(value: fmpq) -> None:
    assert Fraction(short_text(value)) == Fraction(int(value.p), int(value.q))


@given(st.fractions() | st.decimals(allow_nan=False, allow_infinity=False, places=12).map(Fraction))
def test_the_text_is_every_number(value: Fraction) -> None:
    assert Fraction(short_text(to_fmpq(value))) == value
