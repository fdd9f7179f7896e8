from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.signs.cover.statements import BracketsStatement, SignStatement, ZerosStatement, cells_of
from gspot_verified.work.ranges import Range


@given(st.fractions(-20, 20, max_denominator=40), st.fractions(0, 4, max_denominator=40))
def test_the_cells_cover_the_range_and_no_more(lower: Fraction, width: Fraction) -> None:
    """One after another from end to end, none across an integer, none wider than a quarter."""
    cells = cells_of(Range.parse(f"[{lower}..{lower + width}]", "beta"))
    assert (cells[0][0], cells[-1][1]) == (to_fmpq(lower), to_fmpq(lower + width))
    assert all(one[1] == other[0] for one, other in pairwise(cells))
    for a, b in cells:
        assert b.ceil() - a.floor() <= 1
        assert b - a <= fmpq(1, 4 if a < 16 else 16)
        assert a < b or not width


@pytest.mark.parametrize("ends", ["-inf..1", "1..inf", "-inf..inf"])
def test_an_infinite_range_has_no_cells(ends: str) -> None:
    with pytest.raises(ValueError, match="must be finite"):
        cells_of(Range.parse(ends, "beta"))


@pytest.mark.parametrize(
    ("tau", "beta", "sign", "text"),
    [
        ("1/2", "3", 1, "dΘ/dτ > 0 at τ = 1/2 and at β = 3"),
        ("1/2", "3..4", -1, "dΘ/dτ < 0 at τ = 1/2 and every β in (3, 4)"),
        ("0..inf", "3", 0, "dΘ/dτ = 0 for every τ in (0, inf) and at β = 3"),
        ("(-inf..0]", "[3..4)", 1, "dΘ/dτ > 0 for every τ in (-inf, 0] and every β in [3, 4)"),
    ],
)
def test_a_sign_in_words(tau: str, beta: str, sign: int, text: str) -> None:
    statement = SignStatement(Range.parse(tau, "tau"), Range.parse(beta, "beta"), sign)
    assert str(statement) == text
    assert statement.to_json()["sign"] == sign


def test_zeros_in_words() -> None:
    counts = ZerosStatement(Range.parse("1..3", "beta"), ((1, 1), (2, 2)))
    assert str(counts).endswith("has exactly N real zeros, all simple: N = 1 on (1, 2), N = 2 on (2, 3)")
    brackets = BracketsStatement(fmpq(5, 2), ((fmpq(-1), fmpq(0)), (fmpq(1), fmpq(2))))
    assert str(brackets).endswith("has exactly 2 real zeros, all simple, one in each of: (-1, 0), (1, 2)")
    alone = BracketsStatement(fmpq(3, 2), ((fmpq(-1), fmpq(0)),))
    assert str(alone).endswith("has exactly one real zero, simple, in (-1, 0)")


def test_these_statements_are_those_of_certificates_of_version_1() -> None:
    """proofs/certificate.md: versions 2 and 3 have others."""
    assert [kind.version for kind in (SignStatement, ZerosStatement, BracketsStatement)] == [1, 1, 1]
