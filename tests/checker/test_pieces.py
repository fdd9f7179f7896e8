"""What each piece of a column proves, at the edge of its hypotheses.

Page: proofs/check.md.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from must_reject import mutate
from must_reject.mutate import lines_of, text_of
from samples.checker_models import (
    on_a_column,
)

check = mutate.checker()


def test_the_left_tail_at_its_limit() -> None:
    """At b = 1/2 3x³ = |b(b - 1)(b - 2)| for x = 1/2: that is not enough, a little more is."""
    half = Fraction(1, 2)
    assert not on_a_column().left_holds(half, half, 0, half)
    assert on_a_column().left_holds(half, half, 0, half * (1 + Fraction(1, 2**20)))


@given(
    st.fractions(-1, 12, max_denominator=30),
    st.fractions(0, 1, max_denominator=30),
    st.fractions(0, 5, max_denominator=9),
)
def test_the_left_tail_in_rationals(low: Fraction, width: Fraction, x: Fraction) -> None:
    """tails.md, τ → -∞, written out."""
    n = math.floor(low)
    high = min(low + width, Fraction(n + 1))
    number = max(1, n // 3 + 1)
    product = math.prod(max(abs(low - i), abs(high - i)) for i in range(3 * number))
    holds = x > 0 and x ** (3 * number) * 3**number * math.factorial(number) > product
    assert on_a_column().left_holds(low, high, n, x) is bool(holds)


@pytest.mark.parametrize("point", ["0", "30"])
def test_the_left_tail_ends_at_a_negative_time(point: str) -> None:
    """For 3 ≤ b < 6 x is taken to an even power: without its sign all zeros up to τ = 30 would be passed over."""
    statement = {"beta": "[11/2, 28/5]", "kind": "sign", "sign": -1, "tau": f"(-inf, {point}]"}
    data = text_of(lines_of(statement, (["11/2", "28/5"], [["left", point]])))
    with pytest.raises(check.limits.Rejected, match="the remainder is too large"):
        check.main.check_text(data)


def test_the_left_tail_needs_b_from_minus_1_on() -> None:
    below = -1 - Fraction(1, 2**20)
    assert on_a_column().left_holds(Fraction(-1), Fraction(-1), -1, Fraction(9))
    assert not on_a_column().left_holds(below, below, -2, Fraction(9))


@pytest.mark.parametrize(
    ("signs", "found"),
    [
        ((1, -1, 1), [1, -1, 1, -1]),
        ((1, 0, -1), [1, -1, -1]),
        ((1, -1, 0), []),
        ((-1, 0, -1), []),
        ((0, 1, -1), []),
        ((1, 0, 0), []),
    ],
)
def test_a_sign_of_the_right_tail_may_be_open_between_opposite_ones_alone(
    signs: tuple[int, ...], found: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between equal ones there may be no change or two, before the first one a change or none."""
    checker = on_a_column()
    monkeypatch.setattr(checker, "sign", lambda _, k, __: signs[k])
    box = (Fraction(2), Fraction(17, 8), Fraction(4), Fraction(4))
    assert checker.right_signs(box, 2) == found


@pytest.mark.parametrize("n", [2, 5, 9])
def test_a_tail_at_a_long_point(n: int) -> None:
    """All orders up to n are needed, at a point whose denominator is beyond every accuracy that is tried."""
    beta, point = n + Fraction(3, 2), str(n + 3 + Fraction(1, 10**2000))
    statement = {"beta": f"[{beta}, {beta}]", "kind": "sign", "sign": (-1) ** n, "tau": f"[{point}, inf)"}
    data = text_of(lines_of(statement, ([str(beta)] * 2, [["right", point, 0]])))
    assert check.main.check_text(data).startswith("dΘ/dτ " + "><"[n % 2])
    statement["sign"] *= -1
    with pytest.raises(check.limits.Rejected, match="gives dΘ/dτ the sign"):
        check.main.check_text(text_of(lines_of(statement, ([str(beta)] * 2, [["right", point, 0]]))))


@pytest.mark.parametrize("wrong", range(4))
@pytest.mark.parametrize("sign", [0, -1])
def test_each_hypothesis_of_the_fold_is_checked(wrong: int, sign: int, monkeypatch: pytest.MonkeyPatch) -> None:
    checker, asked = on_a_column(), []

    def answer(box: tuple[Fraction, ...], order: int) -> int:
        asked.append((box, order))
        return sign if len(asked) == wrong + 1 else 1

    monkeypatch.setattr(checker, "sign", answer)
    low, high, start, end = box = (Fraction(2), Fraction(17, 8), Fraction(-1, 4), Fraction(1, 3))
    assert not checker.fold_holds(box)
    del asked[:]
    wrong = 9
    assert checker.fold_holds(box)
    assert asked == [((low, high, start, start), 0), ((low, high, end, end), 0), (box, 2), (box, -1)]


def test_the_derivative_in_b_of_a_narrow_fold_is_taken_on_a_wider_range(monkeypatch: pytest.MonkeyPatch) -> None:
    checker, asked = on_a_column(), []
    monkeypatch.setattr(checker, "sign", lambda box, order: asked.append((box, order)) or 1)
    low, high, start, end = Fraction(2), 2 + Fraction(1, 10**40), Fraction(-1, 4), Fraction(1, 3)
    assert checker.fold_holds((low, high, start, end))
    (low_b, high_b, *in_tau), order = asked[-1]
    assert (order, in_tau) == (-1, [start, end])
    assert low_b <= low < high < low_b + Fraction(1, 300) < high_b


@pytest.mark.parametrize(("low", "x", "holds"), [("-1", "2", True), ("-3/2", "2", False), ("-1/2", "0", False)])
def test_the_left_tail_needs_its_range(low: str, x: str, holds: bool) -> None:
    """b ≥ -1 and x > 0; with b in [-1, 0]: x³·3 > 1·2·3."""
    assert on_a_column().left_holds(Fraction(low), Fraction(0), -1, Fraction(x)) is holds


@pytest.mark.parametrize(
    ("signs", "found"),
    [
        ([1, 1, -1], [1, 1, -1, -1]),
        ([1, 0, -1], [1, -1, -1]),
        ([1, 1, 0], [1, 1, -1]),
        ([-1, 0, -1], []),
        ([0, 1, -1], []),
        ([1, 0, 0], []),
        ([-1, -1, 0], []),
    ],
)
def test_open_signs_of_coefficients(signs: list[int], found: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    checker, zero = on_a_column(), Fraction(0)
    monkeypatch.setattr(checker, "sign", lambda _box, order, _splits: signs[order])
    assert checker.right_signs((zero, zero, zero, zero), 2) == found


@pytest.mark.parametrize(
    ("low", "high", "cell"), [("-1/2", "1", -2), ("0", "1", -1), ("1", "2", 0), ("2", "2", 0), ("5/2", "3", 1)]
)
def test_a_column_lies_in_one_cell_or_left_of_0(low: str, high: str, cell: int) -> None:
    """b = β - 1 in [cell, cell + 1], or b ≤ 0; beyond the cell by ever so little it is refused."""

    def read(end: str) -> Any:
        return check.pieces.read_column(mutate.canonical({"beta": [low, end], "pieces": []}).encode())

    assert read(high) == (Fraction(low), Fraction(high), cell, [])
    beyond = str(max(Fraction(high), Fraction(cell + 2), Fraction(1)) + Fraction(1, 10**30))
    if low != high:
        with pytest.raises(check.limits.Rejected, match="crosses an integer"):
            read(beyond)


@pytest.mark.parametrize(
    ("low", "high", "tau", "limit"),
    [(-201, -200, 1, "beta"), (-201, 0, 1, "beta"), (199, 201, 1, "beta"), (0, 1, 201, "tau"), (-200, 0, 200, "")],
)
def test_the_range_of_beta_and_tau_is_looked_at_first(low: int, high: int, tau: int, limit: str) -> None:
    pieces = [check.pieces.read_piece(["sign", str(-tau), "0", 1])]
    column = check.pieces.Column(Fraction(low), Fraction(high), -1, pieces)
    checker = check.pieces.ColumnCheck(column, check.limits.Limits(), 0)
    if limit:
        with pytest.raises(check.limits.Rejected, match=f"the limit {limit}=200"):
            checker.begin(Fraction(-tau), Fraction(0))
    else:
        checker.begin(Fraction(-tau), Fraction(0))
