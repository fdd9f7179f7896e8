from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.numbers.short_text import short_text, table_text

VALUES = (fmpq(1, 10**9), fmpq(7, 80), fmpq(-12345, 1000), fmpq(10) ** 25, fmpq(2, 3), fmpq(0), fmpq(1, 5**9))
TEXTS = {
    fmpq(1, 10**7): "0.0000001",
    fmpq(1, 10**8): "1e-8",
    fmpq(10) ** 20: "1" + 20 * "0",
    fmpq(-(10**21)): "-1e+21",
}
"""At the ends of what is written without an exponent."""


@pytest.mark.parametrize("value", VALUES, ids=str)
def test_the_text_is_the_number(value: fmpq) -> None:
    assert Fraction(short_text(value)) == Fraction(int(value.p), int(value.q))


@given(st.fractions() | st.decimals(allow_nan=False, allow_infinity=False, places=12).map(Fraction))
def test_the_text_is_every_number(value: Fraction) -> None:
    assert Fraction(short_text(to_fmpq(value))) == value


@pytest.mark.parametrize(("value", "text"), TEXTS.items(), ids=map(str, TEXTS))
def test_a_short_exponent_is_left_out(value: fmpq, text: str) -> None:
    assert short_text(value) == text


def test_a_long_number_is_written_as_it_is() -> None:
    """512 bits are shown as a decimal, more are not; 1/5^n = 2^n/10^n."""
    assert short_text(fmpq(2**512 - 1, 10**300)) == f"{str(2**512 - 1)[0]}.{str(2**512 - 1)[1:]}e-146"
    assert short_text(fmpq(2**512 + 1, 10**300)) == f"{2**512 + 1}/{10**300}"
    assert not any("/" in short_text(fmpq(1, 5**n)) for n in range(512))
    assert short_text(fmpq(1, 5**512)) == f"1/{5**512}"


def test_the_smallest_number_is_not_zero() -> None:
    """Its exponent is below -10^6."""
    assert short_text(fmpq(1, 10**1000300)) == "1e-1000300"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (fmpq(18, 55), "18/55"),
        (fmpq(-7, 2), "-3.5"),
        (fmpq(0), "0"),
        (fmpq(186037, 99144), "1.87643"),
        (arb(5), "5"),
        (arb("1e-3", 0).mid(), "0.00100000"),
        (arb("0.3272727272727", 1e-12), "0.327273"),
        (arb(0, 1e-9), "0.000000"),
        (arb("1e-8", 1e-9), "[8.99e-9, 1.11e-8]"),
        (arb("1e-8", 1e-20), "1.00000e-8"),
        (arb(0, 1e-3), "[-0.00101, 0.00101]"),
        (arb("2.5", 1e-3), "[2.50 +/- 1.01e-3]"),
        (arb("nan"), "[no information]"),
    ],
)
def test_numbers_of_a_table(value: fmpq | arb, text: str) -> None:
    assert table_text(value) == text


@given(st.fractions(min_value=-1000, max_value=1000), st.integers(30, 200))
def test_a_rounded_number_is_off_by_one_in_its_last_digit_at_most(value: Fraction, bits: int) -> None:
    exact = to_fmpq(value)
    ball = arb(exact) + arb(0, arb(2) ** -bits * (1 + abs(arb(exact))))
    for text in (table_text(exact), table_text(ball)):
        if "[" in text:
            continue
        digits = text.lstrip("-").partition("e")[0].partition(".")[2]
        unit = Fraction(10) ** (int(text.partition("e")[2] or 0) - len(digits))
        assert abs(Fraction(text) - value) <= (unit if "/" not in text else 0)
