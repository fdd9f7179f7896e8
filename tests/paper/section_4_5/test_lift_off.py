"""The brackets of the growth law: two signs at the ends, a ratio that holds the bracket, and what is nearer to 1."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from flint import arb, fmpq

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_4_5 import lift_off


def test_the_ratio_comes_near_to_one() -> None:
    for beta in (fmpq(3, 2), fmpq(5, 2)):
        found = lift_off.growth_brackets((beta,))
        assert abs(found[-1].ratio - 1) < arb("0.002")
        assert all(bracket.closer_than_before for bracket in found)
        for bracket in found:
            with working_bits(128):
                law = ((beta - 1) * bracket.exponent * arb(10).log()) ** arb(fmpq(2, 3))
                for end in (bracket.lower, bracket.upper):
                    assert bracket.ratio.overlaps(end / law)
                assert bracket.ratio.rad() < arb("0.001")
            assert lift_off._above(bracket.lower, beta, goal(beta, bracket.exponent)) is False
            assert lift_off._above(bracket.upper, beta, goal(beta, bracket.exponent)) is True


def goal(beta: fmpq, exponent: int) -> arb:
    """((2 β - 2)/3) ln(1/ε)."""
    with working_bits(128):
        return (2 * beta - 2) / 3 * exponent * arb(10).log()


@pytest.mark.parametrize(
    ("below", "above", "closer"), [(False, True, True), (None, True, False), (True, True, False), (False, None, False)]
)
def test_both_ends_need_their_sign(
    monkeypatch: pytest.MonkeyPatch, below: bool | None, above: bool | None, closer: bool
) -> None:
    monkeypatch.setattr(lift_off, "_above", lambda tau, *_: below if tau == 2 else above)
    monkeypatch.setattr(lift_off, "narrowed", lambda _, lower, upper, *__: (lower, upper))
    found = lift_off._bracket(fmpq(3, 2), 10, None)
    assert found.closer_than_before is closer
    assert (found.lower, found.upper) == (2, 80)


@pytest.mark.parametrize(("before", "closer"), [("2", False), ("3", True), ("-1", True), ("0", False), ("1", False)])
def test_nearer_to_one_than_before(monkeypatch: pytest.MonkeyPatch, before: str, closer: bool) -> None:
    """The ratio is 2 here, or 0 to 2 for the last question."""
    with working_bits(128):
        law = (10 * arb(10).log() / 2) ** arb(fmpq(2, 3))
    monkeypatch.setattr(lift_off, "_above", lambda tau, *_: tau != 2)
    monkeypatch.setattr(lift_off, "narrowed", lambda *_: (2 * law, 2 * law))
    assert lift_off._bracket(fmpq(3, 2), 10, arb(before)).closer_than_before is closer


@pytest.mark.parametrize("before", [0, 2])
def test_as_near_as_before_is_not_nearer(monkeypatch: pytest.MonkeyPatch, before: int) -> None:
    """The ratio is exactly 0 here."""
    monkeypatch.setattr(lift_off, "_above", lambda tau, *_: tau != 2)
    monkeypatch.setattr(lift_off, "narrowed", lambda *_: (fmpq(0), fmpq(0)))
    found = lift_off._bracket(fmpq(3, 2), 10, arb(before))
    assert found.ratio == 0
    assert not found.closer_than_before


@pytest.mark.parametrize(
    ("slope", "answer"),
    [(arb(8), True), (arb(-8), True), (arb(6), False), (arb(7), None), (arb(0), None), (arb(0, 9), None)],
)
def test_above_the_goal(monkeypatch: pytest.MonkeyPatch, slope: arb, answer: bool | None) -> None:
    monkeypatch.setattr(lift_off, "evaluate", lambda *_, **__: SimpleNamespace(value=slope))
    assert lift_off._above(fmpq(2), fmpq(3, 2), arb(7).log()) is answer


def test_a_small_slope_is_below_and_an_equal_one_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lift_off, "evaluate", lambda *_, **__: SimpleNamespace(value=arb("0.5")))
    assert lift_off._above(fmpq(2), fmpq(3, 2), arb(0)) is False
    monkeypatch.setattr(lift_off, "evaluate", lambda *_, **__: SimpleNamespace(value=arb(1)))
    assert lift_off._above(fmpq(2), fmpq(3, 2), arb(0)) is None
