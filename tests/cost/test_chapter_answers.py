"""What accuracy buys: in each case the certified answer stands by two routes, and a cheap answer is wrong."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.cost.measurement.file import recorded
from gspot_verified.cost.measurement.measurement import NO_ANSWER, NOT_ASKED, CheapAnswer
from gspot_verified.cost.parts.cheap_answers import Case, cases, theta_in_doubles
from gspot_verified.numbers.balls import approximate
from gspot_verified.theta_function.theta import theta

CASES = cases()


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.question)
def test_the_cheap_answer_is_wrong_and_the_certified_one_stands_twice(case: Case) -> None:
    found = case.answered()
    assert len({name for name, _ in case.certified}) == 2
    assert found.certified not in (NO_ANSWER, NOT_ASKED)
    assert found.wrong(found.doubles) or found.wrong(found.mpmath)


def test_the_recorded_answers_ask_the_same() -> None:
    assert [answer.question for answer in recorded().answers] == [case.question for case in CASES]
    assert all(answer.wrong(answer.doubles) or answer.wrong(answer.mpmath) for answer in recorded().answers)


def test_the_series_in_doubles_is_right_where_nothing_cancels() -> None:
    for tau, beta in ((fmpq(-1), fmpq(1, 2)), (fmpq(2), fmpq(7, 3)), (fmpq(-2), fmpq(-5, 2))):
        assert theta_in_doubles(tau, beta) == pytest.approx(approximate(theta(tau, beta)), rel=1e-12)
    assert theta_in_doubles(fmpq(1), fmpq(3)) is None  # a pole of Gamma


def test_routes_that_disagree_are_an_error() -> None:
    case = CASES[0]
    broken = Case(case.question, "", (case.certified[0], ("other", lambda: "zero")), case.doubles, "", case.mpmath)
    with pytest.raises(ArithmeticError, match="says zero"):
        broken.answered()
    silent = Case(case.question, "", (case.certified[0], ("other", lambda: None)), case.doubles, "", case.mpmath)
    with pytest.raises(ArithmeticError, match="says None"):
        silent.answered()


def test_no_answer_is_not_wrong() -> None:
    answer = CheapAnswer("", "", "positive", ("", ""), NO_ANSWER, "", NOT_ASKED)
    assert not answer.wrong(answer.doubles)
    assert not answer.wrong(answer.mpmath)
    assert answer.wrong("zero")
