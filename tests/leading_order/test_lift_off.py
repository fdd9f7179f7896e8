"""The lift-off time against point values of the force, here and in mpmath.

Page: proofs/iwc.md.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq
from witnesses.force import force_by_mpmath

from gspot_verified import Outcome, gamma_sign
from gspot_verified.leading_order.contact_force import ContactForce, contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.leading_order.lift_off import growth_table, lift_off
from gspot_verified.leading_order.stretches import LevelCrossing, first_crossing
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.signs.zeros.brackets import zeros_at

BETAS = ("3/2", "7/3", "29/10", "7/2", "9/2", "27/5", "13/2", "23/3", "101/100", "399/100")


def lift_off_sign(beta: str) -> int:
    return -(gamma_sign(beta) or 0)


@pytest.mark.parametrize("beta", BETAS)
def test_lift_off_bracket(beta: str) -> None:
    force = contact_force(beta, c1=lift_off_sign(beta))
    epsilon = fmpq(1, 10**6)
    found = lift_off(force, epsilon, fmpq(-5), 10)
    assert found.verdict.outcome is Outcome.PROVED
    lower, upper = found.lower, found.upper
    assert lower is not None
    assert upper is not None
    assert 0 < upper - lower <= fmpq(1, 10**10)
    assert force.value(lower, epsilon, 25) > 0
    assert force.value(upper, epsilon, 25) < 0
    assert force_by_mpmath(force, lower - fmpq(1, 100), epsilon) > 0
    assert force_by_mpmath(force, upper + fmpq(1, 100), epsilon) < 0
    points = [fmpq(-5) + (lower + 5) * fmpq(k, 40) for k in range(41)]
    assert all(force.value(tau, epsilon) > 0 for tau in points)
    assert found.number == 1


def test_several_zeros_before_the_last_lift_off() -> None:
    # beta = 7/2, C_1 = -1: -dTheta/dtau falls through the level, rises and falls again when eps is large.
    force = contact_force("7/2", c1=-1)
    signs: list[int] = []
    epsilon = fmpq(1, 2)
    for k in range(-300, 500):
        value = force.value(fmpq(k, 100), epsilon)
        sign = 1 if value > 0 else -1
        if not signs or signs[-1] != sign:
            signs.append(sign)
    found = lift_off(force, epsilon, fmpq(-3), 8)
    assert found.number == len(signs) - 1
    beta = fmpq(11, 2)
    force = contact_force(beta, c1=-1)
    counts = {lift_off(force, fmpq(1, k), fmpq(-2), 4).number for k in range(1, 9)}
    assert 1 in counts
    assert counts <= {1, 3, 5}


def test_growth() -> None:
    result = leading_order_iwc("3/2", c1=-1, growth=True)
    assert [row.epsilon for row in result.growth] == [fmpq(10) ** -n for n in (10, 100, 1_000, 10_000)]
    ratios = [row.ratio for row in result.growth]
    assert all(ratio is not None for ratio in ratios)
    distances = [abs(ratio - 1).mid() for ratio in ratios if ratio is not None]
    assert distances == sorted(distances, reverse=True)
    assert distances[-1] < fmpq(1, 500)
    assert "ε = 1e-10000, at leading order: lift-off in" in str(result)


def test_without_an_answer_from_the_balls_it_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.leading_order.lift_off.first_crossing", lambda *_: None)
    result = leading_order_iwc("7/2", c1=-1)
    assert result.verdict.outcome is Outcome.UNDECIDED
    assert "undecided" in str(result)
    assert result.lift_off is not None
    assert (result.lift_off.lower, result.lift_off.upper, result.lift_off.number) == (None, None, None)
    assert not result.lift_off.whole_line


@pytest.mark.parametrize("failures", [0, 1, 2])
def test_what_the_balls_leave_open_is_tried_once_more(monkeypatch: pytest.MonkeyPatch, failures: int) -> None:
    answers: list[LevelCrossing | None] = []

    def crossing(*arguments: Any) -> LevelCrossing | None:
        answers.append(None if len(answers) < failures else first_crossing(*arguments))
        return answers[-1]

    monkeypatch.setattr("gspot_verified.leading_order.lift_off.first_crossing", crossing)
    found = lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-10))
    assert len(answers) == min(failures + 1, 2)
    if failures < 2:
        assert found.verdict.outcome is Outcome.PROVED
        assert found.verdict.detail == "zeros of λ_N on [-10, inf): 1"
        assert found.lower is not None
        assert found.upper is not None
        assert fmpq(1, 10**16) < found.upper - found.lower <= fmpq(1, 10**15)
    else:
        assert found.verdict.outcome is Outcome.UNDECIDED


def test_a_number_of_zeros_that_is_open_is_not_stated(monkeypatch: pytest.MonkeyPatch) -> None:
    known = lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-10))
    assert known.lower is not None
    assert known.upper is not None
    assert known.verdict.evidence is not None
    crossing = LevelCrossing(known.lower, known.upper, None, known.verdict.evidence)
    monkeypatch.setattr("gspot_verified.leading_order.lift_off.first_crossing", lambda *_: crossing)
    found = lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-10))
    assert (found.verdict.outcome, found.number, found.verdict.detail) == (Outcome.PROVED, None, "")


def test_a_force_that_is_negative_at_the_start() -> None:
    found = lift_off(contact_force("1/2", c1=1), fmpq(1, 10), fmpq(-10))
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.verdict.statement.endswith("λ_N > 0 at τ = -10")
    assert found.verdict.witness == "λ_N < 0 at τ = -10"
    assert found.lower is None


def test_what_balls_say_at_the_start_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """A level that is said to be below the function's values does not refute: the force at the start does."""
    monkeypatch.setattr(ContactForce, "level", lambda *_: arb(-(10**9)))
    found = lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-3))
    assert found.verdict.outcome is Outcome.UNDECIDED


def test_the_other_side_does_not_lift_off() -> None:
    with pytest.raises(ValueError, match="tends to \\+infinity"):
        lift_off(contact_force("7/2"), fmpq(1, 10), fmpq(-3))


@pytest.mark.parametrize("digits", [1, 2, 4])
@pytest.mark.parametrize("beta", ["7/2", "9/2", "11/2", "13/2"])
def test_starts_at_in_and_near_brackets(beta: str, digits: int) -> None:
    """What is proved holds at the start, at every critical point before the bracket, and at its ends."""
    b = fmpq(*map(int, beta.split("/")))
    force = contact_force(beta, c1=lift_off_sign(beta))
    critical = [(lower + upper) / 2 for lower, upper in zeros_at(b - 1, 30).brackets]
    for lower, upper in zeros_at(b - 1, 1).brackets:
        for start in (lower, lower + (upper - lower) / 3, (lower + upper) / 2, upper, upper + fmpq(1, 10**9)):
            for epsilon in (fmpq(1, 10**6), fmpq(1, 2), fmpq(40)):
                found = lift_off(force, epsilon, start, digits)
                before = force.value(start, epsilon, 30)
                assert (found.verdict.outcome is Outcome.REFUTED) == bool(before < 0)
                if found.lower is None or found.upper is None:
                    continue
                assert start <= found.lower < found.upper
                places = [start, found.lower, *(tau for tau in critical if start <= tau <= found.lower)]
                assert all(force.value(tau, epsilon, 30) > 0 for tau in places)
                assert force.value(found.upper, epsilon, 30) < 0
                signs = [force.value(tau, epsilon, 30) > 0 for tau in [start, *(c for c in critical if c > start)]]
                assert found.number == sum(a != b for a, b in zip(signs, [*signs[1:], False], strict=True))


def test_to_the_left_of_the_start() -> None:
    """Only where -dTheta/dtau decreases from +infinity: C_1 < 0, and the start before all critical points."""
    for beta, charge, whole in (("7/2", -1, True), ("5/2", 1, False), ("9/2", 1, False)):
        force = contact_force(beta, c1=charge)
        found = lift_off(force, fmpq(1, 1000), fmpq(-2))
        assert found.whole_line is whole
        far = [force.value(-(2**k), fmpq(1, 1000)) for k in range(1, 14)]
        assert all(value > 0 for value in far) is whole
    assert not lift_off(contact_force("7/2", c1=-1), fmpq(1, 1000), fmpq(3)).whole_line
    below_1 = lift_off(contact_force("1/2", alpha_2=1, c1=1), fmpq(1, 10), fmpq(-2))
    assert below_1.verdict.outcome is Outcome.PROVED
    assert not below_1.whole_line
    assert below_1.ratio is None  # the law is for beta > 1


def test_the_ratio_is_that_of_the_bracket() -> None:
    found = lift_off(contact_force("3/2", c1=-1), fmpq(1, 10**4), fmpq(-2), 10)
    assert found.ratio is not None
    assert found.lower is not None
    assert found.upper is not None
    with working_bits(128):
        law = (arb(fmpq(1, 2)) * arb(10**4).log()) ** arb(fmpq(2, 3))
        assert (found.ratio * law).contains((found.lower + found.upper) / 2)
        assert found.ratio.rad() < fmpq(1, 10**9)
    assert lift_off(contact_force("3/2", c1=-1), fmpq(1), fmpq(-2)).ratio is None


def test_the_growth_table_has_its_rows() -> None:
    rows = growth_table(contact_force("3/2", c1=-1), fmpq(-2))
    assert [row.epsilon for row in rows] == [fmpq(10) ** -n for n in (10, 100, 1_000, 10_000)]
    assert all(
        fmpq(1, 10**4) < row.upper - row.lower <= fmpq(1, 1000)
        for row in rows
        if row.upper is not None and row.lower is not None
    )
    assert all(row.verdict.outcome is Outcome.PROVED for row in rows)


def test_what_a_bracket_says_of_itself() -> None:
    found = lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-10), 6)
    data = found.to_json()
    assert (data["epsilon"], data["bracket"]) == ("1/1000", [str(found.lower), str(found.upper)])
    assert found.ratio is not None
    assert Dyadic.parse(data["ratio"]) == Dyadic.from_ball(found.ratio)
    assert ", over ((β-1) ln(1/ε))^(2/3): [1.571" in str(found)
    without = replace(found, ratio=None, lower=None, upper=None)
    assert (without.to_json()["bracket"], without.to_json()["ratio"]) == (None, None)
    assert str(without) == "ε = 0.001, at leading order: proved"
    assert "over" not in str(replace(found, ratio=None))
