"""How much slip is lost at most (proofs/chart.md, section 5), beside motions by hand."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.derive.slip_loss import SlipLoss
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.given import from_fields
from gspot_verified.mechanisms.load import load
from gspot_verified.numbers.balls import working_bits

BITS = 100


@cache
def model() -> SlipLoss:
    """u' = -lambda, b' = -1 + 3 lambda/2."""
    return SlipLoss(shift(load("model system")))


@cache
def driven(free: str, alpha_2: str, alpha_3: str, grip: int = 1) -> SlipLoss:
    """u' = free - grip lambda, b' = alpha_2 - alpha_3 lambda."""
    names = ["x", "u", "y", "v", "p", "b"]
    return SlipLoss(shift(from_fields(
        "driven", names, ["u", free, "v", "b", -1, alpha_2],
        [0, f"{2 * grip + 1}/(2*(1 - p))", 0, "1/2", 0, f"({alpha_3})/(2*(1 - p))"],
        [0, "1/2", 0, "(1 + p)/2", 0, f"-({alpha_3})/2"], "x", "y", "1 - p",
    )))  # fmt: skip


def box(b: arb, u: arb | None = None) -> list[arb]:
    return [arb(0), arb(1) if u is None else u, arb(0), arb(0), arb("0.25"), b]


def test_with_a_constant_force_nothing_is_given_away() -> None:
    """lambda = 2 for a time of 1/2: b rises by 1, u falls by 1."""
    with working_bits(BITS):
        lost = model().largest([box(arb(0, "0.5"))], arb("0.5"))
        assert lost is not None
        assert 1 <= lost < 1 + arb("1e-6")
        apart = model().largest([box(arb("-0.25", "0.25")), box(arb("0.25", "0.25"))], arb("0.5"))
        assert apart is not None
        assert 1 <= apart < 1 + arb("1e-6")


@given(
    st.lists(st.tuples(st.integers(0, 40), st.integers(1, 8)), min_size=1, max_size=6),
    st.integers(-9, 9),
    st.integers(-9, 9),
    st.integers(1, 9),
    st.integers(-9, 9),
)
def test_no_motion_loses_more(pieces: list[tuple[int, int]], free: int, second: int, third: int, turning: int) -> None:
    """The force is constant on each piece; u' = free/4 - lambda, b' = second/4 + third lambda/4."""
    b = least = most = fmpq(turning, 8)
    lost = largest = passed = fmpq(0)
    for force, length in pieces:
        time = fmpq(length, 8)
        lost += (force - fmpq(free, 4)) * time
        b += (fmpq(second, 4) + fmpq(third, 4) * force) * time
        passed += time
        least, most, largest = min(least, b), max(most, b), max(largest, lost)
    with working_bits(BITS):
        middle, radius = (least + most) / 2, (most - least) / 2
        loss = driven(str(Fraction(free, 4)), str(Fraction(second, 4)), str(Fraction(-third, 4)))
        bound = loss.largest([box(arb(middle, arb(radius).upper()))], arb(passed))
        assert bound is not None
        assert bound.is_finite()
        assert bound >= largest.p / arb(largest.q)


def test_each_part_counts() -> None:
    """(b's range + T sup(-alpha_2)) sup|g|/inf|alpha_3| + T sup(-f), by hand."""
    with working_bits(BITS):
        cases = {
            ("-1", "-1", "-2"): (1 + 2) / 2 + 2,
            ("1", "-1", "-2"): 1.5,
            ("-1", "1", "-2"): 0.5 + 2,
            ("0", "0", "-1"): 1,
        }
        for words, wanted in cases.items():
            lost = driven(*words).largest([box(arb(0, "0.5"))], arb(2))
            assert lost is not None
            assert wanted <= lost < wanted + arb("1e-6"), words
        strong = driven("-1", "-1", "-2", 3).largest([box(arb(0, "0.5"))], arb(2))
        assert strong is not None
        assert 6.5 <= strong < 6.5 + arb("1e-6")
        rounded = driven("-1", "0", "-1").largest([box(arb(0))], arb(1) / 3)
        assert rounded is not None
        assert 1 <= 3 * rounded < 1 + arb("1e-6")
        wide = driven("u/2", "b", "-1-u").largest([box(arb(0, 1), arb(1, "0.5")), box(arb(0, 1), arb(0))], arb(2))
        assert wide is not None
        assert 4 <= wide < 4 + arb("1e-6")  # b: 2, T sup(-alpha_2) = 2, inf |alpha_3| = 1, f >= 0


@pytest.mark.parametrize(
    ("words", "b", "time"),
    [
        (("0", "-1", "1"), arb(0), arb(1)),
        (("0", "-1", "b"), arb("-0.5", "0.5"), arb(1)),
        (("0", "-1", "-1"), arb("nan"), arb(1)),
        (("1/b", "-1", "-1"), arb(0, 1), arb(1)),
        (("0", "-1", "-1"), arb(0), arb("nan")),
        (("0", "-1", "-1"), arb(0), arb("inf")),
    ],
)
def test_what_is_not_certain_says_nothing(words: tuple[str, str, str], b: arb, time: arb) -> None:
    with working_bits(BITS):
        assert driven(*words).largest([box(arb(-1)), box(b)], time) is None


def test_the_components_that_count() -> None:
    assert model().components == {4, 5}
    assert driven("x", "-1", "-1").components == {0, 4, 5}
    with pytest.raises(ValueError, match="not enough values"):
        model().largest([], arb(1))
