"""zeros(): one question for one beta, an integer, a range, and at finite epsilon."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import Brackets, IntegerZeros, Range, SlowZeros, ZeroMap, ZerosResult, zeros
from gspot_verified.compliant.zeros.zero_count import slow_zeros
from gspot_verified.compliant.zeros.zero_map import zero_map
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.integer_zeros import zeros_at_integer
from gspot_verified.signs.zeros.zeros import zeros_on_range


def test_each_question_has_its_answer(tmp_path: Path) -> None:
    cases: list[tuple[Any, Any, type]] = [
        (zeros("5/2"), zeros_at("5/2", 15), Brackets),
        (zeros(fmpq(5, 2), digits=3), zeros_at("5/2", 3), Brackets),
        (zeros(3, digits=5), zeros_at_integer(3, 5), IntegerZeros),
        (zeros("2..5/2", budget=9, journal=tmp_path / "kept"), zeros_on_range("2..5/2"), ZerosResult),
        (zeros("5/2", "1/10"), slow_zeros("5/2", "1/10"), SlowZeros),
        (zeros("17/4..35/8", fmpq(1, 10)), zero_map("17/4..35/8", "1/10"), ZeroMap),
    ]
    for found, expected, kind in cases:
        assert type(found) is kind
        assert str(found) == str(expected)
    assert (tmp_path / "kept").exists()
    assert str(zeros(Range.parse("2..5/2", "beta"))) == str(zeros("2..5/2"))


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (("1..2",), {"digits": 5}, "digits: for one value of beta"),
        (("5/2",), {"budget": 5}, "budget: it needs a range of beta"),
        (("5/2", "0..1"), {}, "epsilon: it needs a range of beta"),
        (("5..6", arb("0.1", "0.01")), {}, "epsilon: expected a range or one exact number, got a ball"),
        (("401/2",), {}, "200"),
    ],
)
def test_what_does_not_fit_is_refused(arguments: tuple[Any, ...], options: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        zeros(*arguments, **options)


@pytest.mark.parametrize("arguments", [(0.5,), ("5/2", 0.1), ("5..6", 0.1)])
def test_a_float_is_refused(arguments: tuple[Any, ...]) -> None:
    with pytest.raises(TypeError, match="float"):
        zeros(*arguments)
