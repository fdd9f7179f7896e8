from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import rationals, to_fmpq

from gspot_verified.work.ranges import Range


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("0..1", "(0, 1)"),
        ("(0..1)", "(0, 1)"),
        ("[0..1]", "[0, 1]"),
        ("[0..1)", "[0, 1)"),
        ("(0..1]", "(0, 1]"),
        (" [ -2 .. 7/3 ) ", "[-2, 7/3)"),
        ("0.1..0.25", "(1/10, 1/4)"),
        ("-.5...5", None),
        (".5..1", "(1/2, 1)"),
        ("-inf..inf", "(-inf, inf)"),
        ("-INF..+inf", "(-inf, inf)"),
        ("-inf..3]", None),
        ("(-inf..3]", "(-inf, 3]"),
        ("2.5", "[5/2, 5/2]"),
        ("[5/2..2.5]", "[5/2, 5/2]"),
        ("1e-3..1E2", "(1/1000, 100)"),
        ("4/6..1", "(2/3, 1)"),
    ],
)
def test_texts(text: str, shown: str | None) -> None:
    if shown is None:
        with pytest.raises(ValueError, match="beta: "):
            Range.parse(text, "beta")
    else:
        assert str(Range.parse(text, "beta")) == shown


@pytest.mark.parametrize(
    "text",
    [
        "", "..", "0..", "..1", "0...5", "0....5", "0..1..2", "[0..inf]", "[-inf..0]", "inf..-inf", "inf..1", "0..-inf",
        "1..0", "1..1", "[1..1)", "(1..1]", "nan", "nan..1", "0..nan", "inf", "-inf", "+inf", "0..1)", "[0..1", "[3]",
        "{0..1}", "0,1", "(0, 1)", "a..b", "1/0..2", "0..1e6000000", "0x1..2", "1_0..20", "]0..1[", "((0..1))", "٣..٤",
        "--1..2", "1/2/3..4", "infinity..0", "-inf..-inf",
    ],
)  # fmt: skip
def test_what_is_no_range_is_refused_by_name(text: str) -> None:
    with pytest.raises(ValueError, match="tau: "):
        Range.parse(text, "tau")


@pytest.mark.parametrize("value", [0.5, 3, None, fmpq(1), ("0", "1"), b"0..1"])
def test_what_is_no_text_is_refused(value: Any) -> None:
    with pytest.raises(TypeError, match="tau: expected a Range or a text"):
        Range.parse(value, "tau")


@pytest.mark.parametrize("value", [0.5, 1, Fraction(1, 2), "1", float("inf")])
def test_ends_are_exact_rationals(value: Any) -> None:
    with pytest.raises(TypeError, match="end of a range"):
        Range(value, None, False, False)


class Greater(fmpq):
    """A number that is greater than all others."""

    def __gt__(self, other: object) -> bool:
        return True


def test_ends_are_no_numbers_of_another_kind() -> None:
    with pytest.raises(TypeError, match="end of a range must be fmpq or None, got Greater"):
        Range(fmpq(1), Greater(2), True, True)


def test_ends_of_any_precision() -> None:
    narrow = Range.parse("3..3." + "0" * 39 + "1", "beta")
    assert narrow.upper is not None
    assert narrow.upper - 3 == fmpq(1, 10**40)
    assert narrow.contains(3 + fmpq(1, 10**41))
    assert not narrow.contains(fmpq(3))
    assert not narrow.contains(3 + fmpq(1, 10**40))


@given(rationals(), rationals(), st.booleans(), st.booleans(), rationals())
def test_round_trip_and_membership(a: Fraction, b: Fraction, left: bool, right: bool, x: Fraction) -> None:
    lower, upper = min(a, b), max(a, b)
    text = f"{'[' if left else '('}{lower}..{upper}{']' if right else ')'}"
    if lower == upper and not (left and right):
        with pytest.raises(ValueError, match="empty"):
            Range.parse(text, "tau")
        return
    found = Range.parse(text, "tau")
    assert found == Range(to_fmpq(lower), to_fmpq(upper), left, right)
    assert Range.parse(str(found).replace(", ", ".."), "tau") == found
    assert found.is_point == (lower == upper)
    for value in (x, lower, upper, (lower + upper) / 2):
        inside = lower < value < upper or (left and value == lower) or (right and value == upper)
        assert found.contains(to_fmpq(value)) == inside


def test_infinite_ranges_hold_what_they_should() -> None:
    whole, below = Range.parse("-inf..inf", "tau"), Range.parse("(-inf..0]", "tau")
    assert whole.contains(fmpq(10**400))
    assert below.contains(fmpq(0))
    assert not below.contains(fmpq(1, 10**400))
    assert not whole.is_point


def test_the_typeset_minus_is_a_minus() -> None:
    assert Range.parse("[−2..−1/2)", "tau") == Range.parse("[-2..-1/2)", "tau")
    assert Range.parse("−inf..inf", "tau") == Range.parse("-inf..inf", "tau")
