from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.piece_samples import assert_column
from samples.strategies import near_integers
from witnesses.theta import theta_witness

from gspot_verified.certificates.text import certificate_text, write_certificate
from gspot_verified.numbers.balls import sign_of
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.signs.cover.pieces import Kind
from gspot_verified.signs.cover.zero_column import zero_column
from gspot_verified.signs.gamma import count_law
from gspot_verified.signs.zeros import zeros
from gspot_verified.signs.zeros.brackets import Brackets, zeros_at
from gspot_verified.signs.zeros.slope_at import UndecidedError
from gspot_verified.signs.zeros.zeros import ZerosResult, _counts, zeros_on_range
from gspot_verified.theta_function.value.evaluate import evaluate

PROOFS = Path(__file__).resolve().parents[3] / "proofs"


def assert_brackets(found: Brackets, digits: int) -> None:
    """As many as the count law says, disjoint, narrow, each with a certain change of sign."""
    brackets = found.brackets
    assert len(brackets) == count_law.number_of_zeros(found.beta)
    assert sum(upper <= 0 for _, upper in brackets) == count_law.negative_zeros(found.beta)
    for (_, upper), (lower, _) in pairwise(brackets):
        assert upper <= lower
    for lower, upper in brackets:
        assert 0 < upper - lower <= fmpq(1, 10**digits)
        left, right = (sign_of(evaluate(end, found.beta, 1, digits=2).value) for end in (lower, upper))
        assert left in (1, -1)
        assert right == -left
    assert found.column.lower is not None
    assert found.column.lower <= found.beta <= found.column.upper


def assert_follows_the_law(result: ZerosResult) -> None:
    assert result.statement is not None
    for m, count in result.statement.counts:
        assert count == count_law.number_of_zeros(m + fmpq(1, 2))


@pytest.mark.parametrize(
    "beta",
    [
        "0..1",
        "1..2",
        "2..3",
        "19/10..21/10",
        "[2..3]",
        "29/10..31/10",
        "5/2",
        "7/2..7/2",
        "1..9/2",
        "11/2..13/2",
        "10..21/2",
    ],
)
def test_counts_equal_the_count_law(beta: str) -> None:
    if beta == "7/2..7/2":
        with pytest.raises(ValueError, match="empty"):
            zeros_on_range(beta)
        return
    result = zeros_on_range(beta)
    assert_follows_the_law(result)
    for k, column in enumerate(result.columns):
        assert_column(column, None, None, seed=k)
    first, last = result.columns[0], result.columns[-1]
    assert (first.lower, last.upper) == (result.beta.lower, result.beta.upper)
    for column, following in zip(result.columns, result.columns[1:], strict=False):
        assert column.upper == following.lower
    json.dumps(result.to_json())
    assert str(result).startswith("proved: for every β")


@pytest.mark.parametrize("width", [10, 40, 300])
@pytest.mark.parametrize("integer", [1, 2, 3, 4, 6])
def test_narrow_ranges_around_integers(integer: int, width: int) -> None:
    gap = Fraction(1, 10**width)
    result = zeros_on_range(f"{integer - gap}..{integer + gap}")
    assert_follows_the_law(result)
    assert result.examined <= 20


@pytest.mark.parametrize("beta", ["1/2", "3/2", "5/2", "299/100", "301/100", "7/2", "9/2", "11/2", "599/100", "38/3"])
def test_brackets(beta: str) -> None:
    found = zeros_at(beta, 10)
    assert_brackets(found, 10)
    assert_column(found.column, None, None)


@pytest.mark.parametrize("digits", [1, 2, 12, 13, 14, 30, 200])
def test_brackets_of_any_width(digits: int) -> None:
    found = zeros_at("5/2", digits)
    assert_brackets(found, digits)
    assert all((lower * 10**digits).q == 1 for lower, _ in found.brackets)


def test_brackets_against_another_library() -> None:
    for lower, upper in zeros_at("5/2", 25).brackets:
        ends = [theta_witness(Fraction(int(t.p), int(t.q)), Fraction(3, 2), 40) for t in (lower, upper)]
        assert ends[0] * ends[1] < 0


@pytest.mark.parametrize("digits", [15, 45])
@pytest.mark.parametrize("gap", [Fraction(1, 10**40), Fraction(1, 10**400), Fraction(1, 65), Fraction(1, 63)])
@pytest.mark.parametrize("integer", [2, 3, 6])
def test_brackets_next_to_integers(integer: int, gap: Fraction, digits: int) -> None:
    for beta in (integer - gap, integer + gap):
        assert_brackets(zeros_at(beta, digits), digits)


def test_a_number_of_many_digits() -> None:
    beta = 2 + Fraction(1, 10**1999)
    assert_brackets(zeros_at(beta, 10), 10)


@settings(max_examples=15)
@given(st.one_of(st.fractions(0, 7, max_denominator=20), near_integers(6)), st.integers(1, 20))
def test_brackets_at_random(beta: Fraction, digits: int) -> None:
    if beta > 0 and beta.denominator > 1:
        assert_brackets(zeros_at(beta, digits), digits)


def test_a_large_beta() -> None:
    found = zeros_at("81/2", 5)
    assert len(found.brackets) == 14
    assert_brackets(found, 5)


@pytest.mark.parametrize(("beta", "meetings"), [("1..2", ()), ("5/2..7/2", (3,)), ("11/2..6", (6,))])
def test_where_two_zeros_meet(beta: str, meetings: tuple[int, ...]) -> None:
    steps: list[Any] = []
    found = zeros_on_range(beta, progress=steps.append)
    assert found.meetings == meetings
    assert [step.examined for step in steps] == list(range(1, found.examined + 1))
    line = f"  two zeros meet at τ = 0 and vanish at β = {meetings[0] if meetings else ''}"
    assert (line in str(found).splitlines()) is bool(meetings)
    flat = (replace(c, pieces=tuple(piece for piece in c.pieces if piece.kind is not Kind.FOLD)) for c in found.columns)
    assert not replace(found, columns=tuple(flat)).meetings


def test_tubes_contain_the_brackets() -> None:
    result = zeros_on_range("2..7/2")
    for column in result.columns:
        assert column.lower is not None
        beta = (column.lower + column.upper) / 2
        brackets = zeros_at(beta, 8).brackets
        for lower, upper in column.tubes():
            assert sum(lower < b and a < upper for a, b in brackets) == 1


@pytest.mark.parametrize("beta", ["5/2", "299/100", "301/100", f"2.{'9' * 40}"])
def test_the_checker_agrees_about_brackets(tmp_path: Path, beta: str) -> None:
    found = zeros_at(beta, 8)
    path = tmp_path / "brackets.cert"
    write_certificate(path, found.statement, [found.column])
    run = subprocess.run(
        [sys.executable, "-I", "-S", str(PROOFS / "checker"), str(path)], capture_output=True, check=False
    )
    assert run.stdout.startswith(b"VERIFIED "), run.stderr


def test_the_checker_agrees_about_a_range(tmp_path: Path) -> None:
    result = zeros_on_range("19/10..16/5")
    assert result.statement is not None
    path = tmp_path / "zeros.cert"
    write_certificate(path, result.statement, result.columns)
    run = subprocess.run(
        [sys.executable, "-I", "-S", str(PROOFS / "checker"), str(path)], capture_output=True, check=False
    )
    assert run.stdout.startswith(b"VERIFIED "), run.stderr


def test_an_ended_budget_is_undecided() -> None:
    for budget in (0, 3):
        result = zeros_on_range("2..5", budget=budget)
        assert result.statement is None
        assert result.examined == budget
        assert result.unfinished
        assert_tiles(result)
        known, route, left = str(result).splitlines()
        assert known == f"proved: {count_law.numbers_on('2..5')}"
        assert route == "  route: the count law (proofs/count_law.md)"
        assert left.startswith(f"undecided by columns: {len(result.columns)} ranges of β settled, ")
        assert left.endswith(" and 4 more") == (len(result.unfinished) == 12)
        assert result.to_json()["statement"] is None
        assert result.to_json()["by_count_law"]["counts"] == [[2, 2], [3, 1], [4, 2]]


def assert_tiles(result: ZerosResult) -> None:
    """Settled and unfinished ranges together are the whole range."""
    parts = sorted([*((c.lower, c.upper) for c in result.columns), *result.unfinished])
    assert (parts[0][0], parts[-1][1]) == (result.beta.lower, result.beta.upper)
    assert all(before[1] == after[0] for before, after in pairwise(parts))


@pytest.mark.parametrize("beta", ["300..302", "199..201", "403/2"])
def test_above_the_reach_of_columns_the_count_law_answers(beta: str) -> None:
    result = zeros_on_range(beta)
    assert (result.statement, result.columns, result.unfinished, result.examined) == (None, (), (), 0)
    assert result.by_count_law.counts
    for m, count in result.by_count_law.counts:
        assert count == count_law.number_of_zeros(m + fmpq(1, 2))
    first, route, reach = str(result).splitlines()
    assert first == f"proved: {result.by_count_law}"
    assert route == "  route: the count law (proofs/count_law.md)"
    assert reach == "  no tubes: columns are sought for β <= 200"
    assert result.to_json()["route"] == "the count law"


@pytest.mark.parametrize(("beta", "sought"), [("399/2..200", True), ("199..200", True), ("200..401/2", False)])
def test_up_to_the_reach_of_columns_they_are_sought(beta: str, sought: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(zeros, "zero_column", lambda *_: None)
    found = zeros_on_range(beta, budget=1)
    assert (found.examined == 1, bool(found.unfinished)) == (sought, sought)


def test_the_numbers_are_given_in_the_order_of_the_cells() -> None:
    columns = [zero_column(fmpq(k, 2), fmpq(k, 2)) for k in (5, 3, 1)]
    assert _counts(tuple(column for column in columns if column)) == ((0, 0), (1, 1), (2, 2))


def test_columns_that_contradict_the_count_law_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:

    monkeypatch.setattr(zeros, "_counts", lambda _: ((2, 1),))
    with pytest.raises(ArithmeticError, match="disagree"):
        zeros_on_range("2..5/2")


@pytest.mark.parametrize(
    ("lower", "upper"),
    [
        # One zero is far out: all powers of b count in the tail.
        (100 + Fraction(1, 2**60), 100 + Fraction(1, 2**59)),
        (60 + Fraction(1, 2**42), 60 + Fraction(1, 2**41)),
        # Two zeros are near 0: their distance needs narrow boxes.
        (33 - Fraction(33, 2**15), 33 - Fraction(1, 2**10)),
    ],
)
def test_one_column_next_to_a_large_integer(lower: Fraction, upper: Fraction) -> None:
    result = zeros_on_range(f"{lower}..{upper}", budget=1)
    assert_follows_the_law(result)
    assert len(result.columns[0].tubes()) + result.columns[0].pieces[-1].mark == result.by_count_law.counts[0][1]


@pytest.mark.parametrize(("integer", "exponent"), [(31, 60), (100, 300)])
def test_up_to_a_large_integer_itself(integer: int, exponent: int) -> None:
    result = zeros_on_range(f"{integer}..{integer + Fraction(1, 2**exponent)}", budget=1)
    assert_follows_the_law(result)
    assert result.arrivals == (integer,)


def test_few_steps_lead_to_an_integer() -> None:
    """Down to about 2^-60 above 31: cuts at the squares of the distance, then in the middle of logarithms."""
    result = zeros_on_range(f"31..{31 + Fraction(1, 2**20)}", budget=25)
    assert_follows_the_law(result)


@pytest.mark.parametrize(
    ("beta", "error", "message"),
    [
        ("3", ValueError, "polynomial"), ("-1..2", ValueError, "must lie inside"),
        ("0..inf", ValueError, "must lie inside"),
        ("1..1002", ValueError, "at most 1000"), ("201", ValueError, "polynomial"), ("3..2", ValueError, "reversed"),
        ("nan", ValueError, "expected a number"),
        (2.5, TypeError, "expected a Range"), (None, TypeError, "expected a Range"),
    ],
)  # fmt: skip
def test_bad_ranges(beta: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        zeros_on_range(beta)


@pytest.mark.parametrize(
    ("beta", "digits", "error"),
    [
        (3, 15, ValueError), (0, 15, ValueError), ("-1/2", 15, ValueError), ("201.5", 15, ValueError),
        ("5/2", 0, ValueError),
        ("5/2", 2001, ValueError), ("5/2", 2.5, ValueError), ("5/2", True, ValueError), (2.5, 15, TypeError),
        (arb(2, 1), 15, ValueError), ("nan", 15, ValueError),
    ],
)  # fmt: skip
def test_bad_points(beta: Any, digits: Any, error: type[Exception]) -> None:
    with pytest.raises(error):
        zeros_at(beta, digits)


def test_an_open_sign_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    from gspot_verified.signs.zeros import brackets

    monkeypatch.setattr(brackets, "_changes", lambda *_: [])
    monkeypatch.setattr(brackets, "zero_column", lambda *_: None)
    with pytest.raises(UndecidedError, match="no certain column"):
        zeros_at("5/2")


def test_the_most_digits() -> None:
    found = zeros_at("5/2", 2000)
    assert_brackets(found, 2000)
    assert len(str(found)) > 8000
    assert certificate_text(found.statement, [found.column])


def test_decimal_text() -> None:
    assert decimal_text(fmpq(-1, 100), fmpq(0)) == "-0.01..0.00"
    assert decimal_text(fmpq(3), fmpq(7, 2)) == "3.0..3.5"
    assert decimal_text(fmpq(3), fmpq(4)) == "3..4"


@pytest.mark.slow
def test_the_long_range_is_the_certificate_in_proofs() -> None:
    result = zeros_on_range("1..13")
    assert_follows_the_law(result)
    assert result.statement is not None
    text = certificate_text(result.statement, result.columns)
    path = PROOFS / "zeros_1_13.cert"
    if path.is_file():
        assert path.read_bytes() == text.encode()
