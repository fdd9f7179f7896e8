"""Tests of what proofs/signs.md states."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from concurrent.futures import Executor, Future
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.certificates.text import write_certificate
from gspot_verified.numbers.balls import sign_of
from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.signs.cover.pieces import Column
from gspot_verified.signs.cover.sign import SignResult, _cells
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.cover.sign_column import SignQuestion, sign_column
from gspot_verified.signs.cover.subdivision import Progress
from gspot_verified.signs.cover.witness import find_witness, sign_at
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.work.executors import InProcessExecutor
from gspot_verified.work.ranges import Range

CHECKER = Path(__file__).resolve().parents[3] / "proofs" / "checker"
TINY = "0" * 39 + "1"
P, R, U = Outcome.PROVED, Outcome.REFUTED, Outcome.UNDECIDED


def slope_sign(tau: fmpq, beta: fmpq) -> int | None:
    """The sign of dTheta/dtau at a point, by ``evaluate``."""
    value = evaluate(tau, beta, derivative=1, digits=5).value
    assert value.is_finite()
    return sign_of(value)


def assert_refuted(result: SignResult) -> None:
    """The witness lies in the ranges and has another sign."""
    assert result.verdict.outcome is R
    assert result.point is not None
    tau, beta = result.point
    assert result.statement.tau.contains(tau)
    assert result.statement.beta.contains(beta)
    assert result.sign_there != result.statement.sign
    if beta.q == 1 and beta >= 0:
        assert sign_at(tau, beta) == result.sign_there
    else:
        assert slope_sign(tau, beta) == result.sign_there


TABLE = [
    # the whole line
    ("-inf..inf", "0..1", -1, P), ("-inf..inf", "(0..1]", -1, P), ("-inf..inf", "[0..1)", -1, R),
    ("-inf..inf", "0..1", 1, R), ("-inf..inf", "1", -1, P), ("-inf..inf", "0..2", -1, R), ("-inf..inf", "0", -1, R),
    ("-inf..inf", "0", 1, R), ("-inf..inf", "-inf..0", 1, P), ("-inf..inf", "(-inf..0]", 1, R),
    ("-inf..inf", "-inf..0", -1, R), ("-inf..inf", "-1..1", 1, R), ("-inf..inf", "-1..1", -1, R),
    ("-inf..inf", "-7/2", 1, P), ("-inf..inf", f"0..0.{TINY}", -1, P), ("-inf..inf", f"1..1.{TINY}", -1, R),
    # tau < 0: the hinge at beta = 2, the fold at beta = 3
    ("-inf..0", "1..2", -1, P), ("-inf..0", "[1..2]", -1, P), ("(-inf..0]", "[1..2)", -1, P),
    ("(-inf..0]", "[1..2]", -1, R), ("-inf..0", "2..3", -1, R), ("-inf..0", "3..4", -1, P),
    ("-inf..0", "[3..4]", -1, P),
    ("(-inf..0]", "3..4", -1, P), ("(-inf..0]", "[3..4]", -1, R), ("-inf..0", "3..5", -1, P),
    ("-inf..0", "[3..5]", -1, P), ("-inf..0", "3..6", -1, R), ("-inf..0", f"[1.5..2.{TINY}]", -1, R),
    # open and closed ends around beta = 2, 3 and tau = 0
    ("-1..1", f"2.{'9' * 40}..3.{TINY}", -1, R), ("-1/100..1/100", f"(3..3.{TINY}]", -1, P),
    ("-1/100..1/100", f"[3..3.{TINY}]", -1, R), ("-1/100..1/100", f"[2.{'9' * 40}..3)", -1, R),
    ("0..1", f"[2..2.{TINY}]", 1, P), ("[0..1]", f"(2..2.{TINY}]", 1, P), ("[0..1]", f"[2..2.{TINY}]", 1, R),
    ("-1..0", f"[1.{'9' * 40}..2]", -1, P), ("[-1..0]", f"[1.{'9' * 40}..2)", -1, P),
    ("[-1..0]", f"[1.{'9' * 40}..2]", -1, R), ("0", "1..2", -1, P), ("0", "(1..2]", -1, R), ("0", "3..5", -1, P),
    ("0", "[3..5)", -1, R), ("0", "3", -1, R), ("0", "2", 1, R),
    # points; one zero curve through the box
    ("1", "3", -1, P), ("1", "3", 1, R), ("1/2", "7/3", 1, P), ("1/2", "7/3", -1, R), ("-1", "5/2", -1, P),
    ("-1/2..-1/4", "5/2", -1, R), ("-1/2..-1/4", "5/2", 1, R), ("-5..5", "-5..5", 1, R),
    # far out
    ("1e9..inf", "[21/10..3)", -1, P), ("1e9..inf", "[21/10..3)", 1, R), ("1e9..inf", "[21/10..3]", -1, P),
    ("-inf..-1e9", "2..12", -1, P), ("-inf..-1e9", "2..12", 1, R), ("1e300", "2..3", -1, U), ("1e300", "5", 1, R),
    ("3..4", "-100..3/2", 1, R), ("1..inf", "0..inf", -1, R), ("-inf..0", "250..300", -1, R),
]  # fmt: skip


@pytest.mark.parametrize(("tau", "beta", "sign", "outcome"), TABLE)
def test_verdicts(tau: str, beta: str, sign: int, outcome: Outcome) -> None:
    budget = 30 if outcome is U else 2_000
    result = sign_on_ranges(tau, beta, sign, budget=budget)
    assert result.verdict.outcome is outcome, str(result)
    json.dumps(result.to_json())
    assert outcome.value in str(result)
    if outcome is R:
        assert_refuted(result)
    if outcome is P:
        assert result.proved_statement == result.statement


@pytest.mark.parametrize(
    ("tau", "beta", "sign"),
    [
        ("-inf..inf", "0..1", -1), ("-inf..0", "[3..4]", -1), ("0", "3..4", -1), ("1", "3", -1), ("0", "3", 1),
        ("3..4", "1.1..1.2", -1), ("-1", "-3..-2", -1), ("[0..1]", f"(2..2.{TINY}]", 1), ("-inf..inf", "-inf..0", 1),
        ("3..inf", "[5/2..11/4]", -1), ("-1/2..-1/4", "5/2", -1), ("[-1..0]", "[15/8..2)", -1), ("2", "[5/2..8/3]", -1),
    ],
)  # fmt: skip
def test_the_checker_agrees(tmp_path: Path, tau: str, beta: str, sign: int) -> None:
    result = sign_on_ranges(tau, beta, sign)
    assert result.proved_statement is not None
    path = tmp_path / "sign.cert"
    write_certificate(path, result.proved_statement, result.columns)
    run = subprocess.run([sys.executable, "-I", "-S", str(CHECKER), str(path)], capture_output=True, check=False)
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith(b"VERIFIED ")


def test_by_theorem_and_by_numbers_agree() -> None:
    for tau in ("-inf..inf", "-3..3", "[0..1]"):
        numbers, theorem = (sign_on_ranges(tau, "0..1", by_theorem=flag) for flag in (False, True))
        assert numbers.verdict == theorem.verdict
        assert numbers.columns != theorem.columns


def test_budget_zero_decides_nothing() -> None:
    for tau, beta in (("-inf..inf", "0..1"), ("-inf..inf", "0..2"), ("1", "3")):
        result = sign_on_ranges(tau, beta, budget=0)
        assert result.verdict.outcome is U
        assert result.verdict.reason is Reason.BUDGET
        assert result.proved_statement is None


def test_the_budget_is_kept_and_what_is_left_is_named() -> None:
    # Just inside the fold, below the integer 3: true nowhere near tau = 0, and the search is cut short.
    result = sign_on_ranges("1e9..inf", "2..3", -1, budget=7)
    assert result.verdict.outcome is U
    assert result.verdict.reason is Reason.BUDGET
    assert result.examined == 7
    assert result.verdict.remaining
    assert "left: β in [" in result.verdict.detail


def test_stuck_is_not_called_out_of_budget() -> None:
    result = sign_on_ranges("0", "2..3", 1)
    assert result.verdict.outcome is U
    assert result.verdict.reason is Reason.HYPOTHESIS


def test_beyond_the_largest_beta_there_is_no_proof() -> None:
    result = sign_on_ranges("-inf..-1e9", "199..201", -1)
    assert result.verdict.outcome is U
    assert result.verdict.reason is Reason.BEYOND
    assert "a proof is sought for beta <= 200 only; left: β in [199, 201]" in result.verdict.detail


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        (("1..0", "0..1"), ValueError, "tau: the range is reversed"),
        (("0..1", "1..1"), ValueError, "beta: the range"),
        (("0..1", "nan"), ValueError, "beta: expected a number"),
        (("[0..inf]", "0..1"), ValueError, "tau: a range must be open"),
        (("inf", "0..1"), ValueError, "tau: a single value must be finite"),
        ((0.5, "0..1"), TypeError, "tau: expected a Range"),
        (("0..1", 3), TypeError, "beta: expected a Range"),
        (("0..1", "0..1", 0), ValueError, "sign must be"),
        (("0..1", "0..1", 1.0), ValueError, "sign must be"),
        (("0..1", "0..1", True), ValueError, "sign must be"),
    ],
)
def test_bad_input(arguments: tuple[Any, ...], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        sign_on_ranges(*arguments)


@pytest.mark.parametrize("budget", [-1, 1.5, True])
def test_bad_budget(budget: Any) -> None:
    for beta in ("0..1", "0..2"):
        with pytest.raises(ValueError, match="budget"):
            sign_on_ranges("-inf..inf", beta, budget=budget)


def test_sign_at_points() -> None:
    assert sign_at(fmpq(0), fmpq(0)) == 0
    assert sign_at(fmpq(10**400), fmpq(4)) == 1  # -4 (2 - tau^3)
    assert sign_at(fmpq(10**13), fmpq(1, 2)) is None
    assert sign_at(fmpq(0), fmpq(1, 2)) == -1
    for n in range(1, 12):
        for k in range(-12, 13):
            assert sign_at(fmpq(k, 2), fmpq(n)) == slope_sign(fmpq(k, 2), fmpq(n))


def test_a_witness_is_a_certain_one() -> None:
    tau, beta = Range.parse("-1..1", "tau"), Range.parse("(2..3]", "beta")
    found = find_witness(tau, beta, -1)
    assert found is not None
    assert sign_at(*found) != -1
    assert find_witness(tau, Range.parse("0..1", "beta"), -1) is None


def near_end(lower: Fraction, upper: Fraction, source: random.Random) -> fmpq:
    gap = (upper - lower) * source.choice(
        (Fraction(1, 2**60), Fraction(1, 10**5), Fraction(source.randrange(1, 64), 64))
    )
    value = lower + gap if source.random() < 0.5 else upper - gap
    return fmpq(value.numerator, value.denominator)


@settings(max_examples=20)
@given(
    st.fractions(-4, 7, max_denominator=8),
    st.fractions(Fraction(1, 16), 2, max_denominator=16),
    st.fractions(-1, 7, max_denominator=8),
    st.fractions(Fraction(1, 16), Fraction(3, 2), max_denominator=16),
    st.sampled_from((-1, 1)),
    st.integers(0, 2**32),
)
def test_random_ranges(t: Fraction, height: Fraction, b: Fraction, width: Fraction, sign: int, seed: int) -> None:
    result = sign_on_ranges(f"{t}..{t + height}", f"{b}..{b + width}", sign, budget=60)
    if result.verdict.outcome is R:
        assert_refuted(result)
    if result.verdict.outcome is P:
        source = random.Random(seed)
        for _ in range(50):
            tau, beta = near_end(t, t + height, source), near_end(b, b + width, source)
            assert slope_sign(tau, beta) == sign


AWAY_FROM_ZERO = [(tau, beta, sign) for tau, beta, sign, outcome in TABLE if outcome is R and beta[0] in "1234(["
                  and not beta.startswith(("[0", "(-", "[-", "(0"))]  # fmt: skip


@pytest.mark.parametrize(("tau", "beta", "sign"), [*AWAY_FROM_ZERO, ("0..3", "2..5/2", -1), ("2..4", "2..3", 1)])
def test_what_is_false_is_not_proved_when_no_point_was_found_beforehand(
    monkeypatch: pytest.MonkeyPatch, tau: str, beta: str, sign: int
) -> None:
    """The columns stand on their own: a point that the first search misses ends the subdivision, or leaves it open."""
    monkeypatch.setattr("gspot_verified.signs.cover.sign.find_witness", lambda *_: None)
    result = sign_on_ranges(tau, beta, sign, budget=30)
    assert result.verdict.outcome is not P
    if result.verdict.outcome is R:
        assert_refuted(result)


def test_a_point_that_only_the_columns_meet_refutes(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("gspot_verified.signs.cover.sign.find_witness", lambda *_: None)
    result = sign_on_ranges("0..3", "2..5/2", -1, budget=30)
    assert_refuted(result)
    assert result.point is not None
    assert result.to_json()["point"] == [str(value) for value in result.point]
    assert result.to_json()["sign_there"] == 1
    assert result.proved_statement is not None
    write_certificate(tmp_path / "x.cert", result.proved_statement, result.columns)
    run = subprocess.run([sys.executable, str(CHECKER), str(tmp_path / "x.cert")], capture_output=True, check=False)
    assert run.returncode == 0


@pytest.mark.parametrize(
    ("tau", "beta", "sign"), [("0", "1/2", 1), ("-3", "1/3", 1), ("2", "-5/2", -1), ("1", "3/2", -1)]
)
def test_a_refuted_point_has_a_certificate(tau: str, beta: str, sign: int) -> None:
    """On both sides of β = 0 and of β = 1, where dΘ/dτ = -βF turns against F."""
    result = sign_on_ranges(tau, beta, sign)
    assert_refuted(result)
    assert len(result.columns) == 1
    assert result.proved_statement is not None


def test_ranges_may_be_given_read_and_numbers_are_the_default() -> None:
    tau, beta = Range.parse("-inf..inf", "tau"), Range.parse("0..1", "beta")
    by_text, by_theorem = sign_on_ranges("-inf..inf", "0..1"), sign_on_ranges(tau, beta, by_theorem=True)
    assert sign_on_ranges(tau, beta).columns == by_text.columns != by_theorem.columns


def test_what_needs_no_column_examines_nothing() -> None:
    refuted, proved = sign_on_ranges("-1..1", "[2..3]"), sign_on_ranges("1", "3")
    assert (refuted.verdict.outcome, refuted.examined) == (R, 0)
    assert (proved.verdict.outcome, proved.examined, proved.columns) == (P, 0, ())


@pytest.mark.parametrize("sign", [1, -1])
def test_a_point_beyond_the_largest_beta_has_no_certificate(sign: int) -> None:
    """A column is sought for beta <= 200 only; the point itself refutes one of the signs."""
    result = sign_on_ranges("-1", "401/2", sign)
    if result.verdict.outcome is R:
        assert_refuted(result)
        assert result.columns == ()
    assert result.proved_statement is None


def test_one_of_the_signs_at_a_point_beyond_the_largest_beta_is_refuted() -> None:
    outcomes = {sign_on_ranges("-1", "401/2", sign).verdict.outcome for sign in (1, -1)}
    assert outcomes == {R, U}


@pytest.mark.parametrize(("end", "proved"), [(fmpq(1), True), (fmpq(3, 4), False)])
def test_columns_that_leave_a_part_out_prove_nothing(monkeypatch: pytest.MonkeyPatch, end: fmpq, proved: bool) -> None:
    monkeypatch.setattr("gspot_verified.signs.cover.sign._cells", lambda _: [(fmpq(1, 2), end)])
    verdict = sign_on_ranges("-2..-1", "1/2..1").verdict
    assert verdict.outcome is (Outcome.PROVED if proved else Outcome.UNDECIDED)
    assert proved or "leave a part" in verdict.detail


def test_the_largest_beta_belongs_to_those_for_which_a_proof_is_sought(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.signs.cover.sign.find_witness", lambda *_: None)
    monkeypatch.setattr("gspot_verified.signs.cover.sign.sign_column", lambda *_: None)
    for upper, reason in (("200", Reason.BUDGET), ("200.01", Reason.BEYOND)):
        assert sign_on_ranges("-2..-1", f"199.5..{upper}", -1, budget=1).verdict.reason is reason


@pytest.mark.parametrize(
    ("tau", "beta", "point"),
    [
        ("-5..5", "[2..4]", (fmpq(1), fmpq(3))),  # the statement holds there
        ("1..1e14", "1/4..2", (fmpq(10**13), fmpq(1, 2))),  # nothing is certain there
        ("-5..5", "[2..5/2]", (fmpq(1), fmpq(6))),  # it fails there, outside the range
    ],
)
@pytest.mark.parametrize("where", ["find_witness", "sign_column"])
def test_a_point_that_is_not_confirmed_refutes_nothing(
    monkeypatch: pytest.MonkeyPatch, tau: str, beta: str, point: tuple[fmpq, fmpq], where: str
) -> None:
    monkeypatch.setattr("gspot_verified.signs.cover.sign.find_witness", lambda *_: None)
    monkeypatch.setattr(f"gspot_verified.signs.cover.sign.{where}", lambda *_: point)
    result = sign_on_ranges(tau, beta, -1, budget=1)
    assert (result.verdict.outcome, result.verdict.reason) == (U, Reason.HYPOTHESIS)
    assert result.verdict.detail.endswith("could not be confirmed")
    assert result.proved_statement is result.point is result.sign_there is None
    assert result.columns == ()


def test_which_points_have_a_column() -> None:
    """An integer polynomial needs none; at a negative integer there is no polynomial."""
    at_integer, below = sign_on_ranges("1", "3", 1), sign_on_ranges("1", "-3", 1)
    assert (at_integer.verdict.outcome, at_integer.columns) == (R, ())
    assert (below.verdict.outcome, len(below.columns)) == (P, 1)
    at_0 = sign_on_ranges("1", "0", 1)
    assert at_0.proved_statement is not None
    assert (at_0.proved_statement.sign, at_0.columns) == (0, ())


def test_the_boxes_that_are_left_hold_the_whole_ranges() -> None:
    ((box,),) = sign_on_ranges("-inf..inf", "1/3..7/3", budget=0).verdict.remaining
    assert box.contains(Fraction(1, 3))
    assert box.contains(Fraction(7, 3))
    assert not box.contains(Fraction(1, 4))
    assert sign_on_ranges("-inf..inf", "-inf..0", 1, budget=0).verdict.remaining == ()


def test_the_first_columns_end_at_the_integers() -> None:
    quarters = [fmpq(k, 4) for k in range(9)]
    assert _cells(Range.parse("0..2", "beta")) == list(pairwise(quarters))
    assert _cells(Range.parse("-3..-1", "beta")) == [(fmpq(-3), fmpq(-1))]
    assert _cells(Range.parse("-inf..-1", "beta")) == [(None, fmpq(-1))]


def test_for_negative_beta_one_column_is_enough() -> None:
    assert [(column.lower, column.upper) for column in sign_on_ranges("-1", "-3..-3/2", 1).columns] == [
        (fmpq(-3), fmpq(-3, 2))
    ]


def test_the_journal_the_executor_and_the_progress_are_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Counting(Executor):
        calls = 0

        def submit(self, function: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
            Counting.calls += 1
            return InProcessExecutor().submit(function, *args, **kwargs)

    steps: list[Progress] = []
    arguments = ("-inf..inf", "0..1", -1)
    first = sign_on_ranges(*arguments, executor=Counting(), journal=tmp_path / "j", progress=steps.append)
    assert Counting.calls == first.examined == len(steps) > 0
    assert steps[-1].examined == first.examined
    with pytest.raises(ValueError, match="not a journal of this question"):
        sign_on_ranges(*arguments, journal=tmp_path / "j", by_theorem=True)

    along: list[Column] = []

    def again(question: SignQuestion, lower: fmpq, upper: fmpq, known: Column) -> Any:
        along.append(known)
        return sign_column(question, lower, upper, known)

    monkeypatch.setattr("gspot_verified.signs.cover.sign.sign_column", again)
    assert sign_on_ranges(*arguments, journal=tmp_path / "j").columns == first.columns
    assert tuple(along) == first.columns


def test_no_proof_is_sought_for_a_range_without_an_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.signs.cover.sign.find_witness", lambda *_: None)
    result = sign_on_ranges("-inf..-100", "1..inf")
    assert (result.verdict.outcome, result.verdict.reason) == (U, Reason.BEYOND)
    assert "left: β in [1, inf]" in result.verdict.detail
    assert "no point against it was found" in result.verdict.detail
