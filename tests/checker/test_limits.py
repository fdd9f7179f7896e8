"""Work is paid before it is done.

Page: proofs/check.md.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from must_reject import mutate
from samples.checker_models import (
    LIMITS,
)

check = mutate.checker()


def test_an_operation_costs_200_products() -> None:
    meter = check.limits.Meter(LIMITS, 10_000)
    meter.spend(1, 2)
    assert meter.left == 10_000 - 401
    meter.spend(9_599, 0)
    with pytest.raises(check.limits.Rejected, match="the limit work"):
        meter.spend(1, 0)


@given(st.integers(-(2**200), 2**200))
def test_the_length_of_an_integer_is_not_too_small(value: int) -> None:
    """A budget that counts too little is none."""
    assert max(1, Fraction(value.bit_length(), 30)) <= check.limits.digits(value) <= value.bit_length() // 30 + 1


@given(st.lists(st.integers(-(2**200), 2**200)))
def test_the_length_of_integers_together_is_not_too_small(numbers: list[int]) -> None:
    assert (
        sum(map(check.limits.digits, numbers))
        <= check.limits.digits(*numbers)
        <= sum(Fraction(value.bit_length(), 30) + 1 for value in numbers)
    )


POWERS = st.lists(st.tuples(st.integers(-(2**100), 2**100), st.integers(0, 6)), max_size=4)


@given(POWERS)
def test_a_product_is_paid_with_the_square_of_its_length(powers: list[tuple[int, int]]) -> None:
    meter = check.limits.Meter(LIMITS, 10**9)
    result = meter.product(*powers)
    assert result == math.prod(base**exponent for base, exponent in powers)
    assert 10**9 - meter.left >= Fraction(result.bit_length() - 1, 30) ** 2
    with pytest.raises(check.limits.Rejected, match="the limit work"):
        check.limits.Meter(LIMITS, 0).product((10**40, 2), *powers)


@given(st.lists(st.tuples(st.integers(-(2**200), 2**200), st.integers(-(2**200), 2**200)), max_size=4))
def test_a_sum_of_products_is_paid_with_each(pairs: list[tuple[int, int]]) -> None:
    meter = check.limits.Meter(LIMITS, 10**9)
    assert meter.dot(*pairs) == sum(one * two for one, two in pairs)
    lengths = [one.bit_length() * two.bit_length() for one, two in pairs]
    assert 10**9 - meter.left >= Fraction(sum(lengths), 900)
    with pytest.raises(check.limits.Rejected, match="the limit work"):
        check.limits.Meter(LIMITS, 0).dot((1, 1), *pairs)


def test_the_limits_are_those_of_the_page() -> None:
    page = (mutate.CHECKER.parent / "check.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \| ([\d, ]+) \|", page, re.MULTILINE)
    found = {
        name: int(value.replace(",", ""))
        for names, values in rows
        for name, value in zip(re.findall(r"\w+", names), values.split(", "), strict=True)
    }
    assert found == LIMITS._asdict()


def test_the_budget_grows_with_the_length_of_the_file() -> None:
    assert LIMITS.budget(0) == 15 * 10**9
    assert LIMITS._replace(work=2).budget(7) == 2 * 10**9 + 7 * 300_000
