"""A statement that the contact force is positive falls at a point of it where the force is certainly negative."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.force_over_balls import force_over_balls
from gspot_verified.leading_order.force_refutation import force_refutation
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.work.ranges import Range

# On this side the force tends to -infinity: lift-off at tau = 3.5905... for eps = 1/1000.
LEAVES, EPSILON = contact_force("3/2", c1=-1), fmpq(1, 1000)
EVERY = Range(fmpq(-10), None, True, False)


def test_the_first_place_that_serves_is_the_witness() -> None:
    found = force_refutation(LEAVES, "λ_N > 0", EVERY, [fmpq(0), fmpq(-20), fmpq(4), fmpq(5)], EPSILON)
    assert found is not None
    assert found.point == (fmpq(4),)
    assert found.verdict.outcome is Outcome.REFUTED
    assert (found.verdict.statement, found.verdict.witness) == ("λ_N > 0", "λ_N < 0 at τ = 4")
    assert LEAVES.value(4, EPSILON) < 0 < LEAVES.value(0, EPSILON)


def test_a_witness_against_all_systems_in_balls_says_so() -> None:
    balls = force_over_balls(-1, -1, arb("-1.5", "1e-9"), -1)
    found = force_refutation(balls, "λ_N > 0", EVERY, [fmpq(0), fmpq(4)], EPSILON)
    assert found is not None
    assert found.verdict.witness == "λ_N < 0 for all α1, α2, α3 in the balls at τ = 4"


@pytest.mark.parametrize(
    ("asked", "places"),
    [
        (EVERY, []),
        (EVERY, [fmpq(0), fmpq(3)]),  # the force is positive there
        (Range(fmpq(-10), fmpq(4), True, False), [fmpq(4), fmpq(5)]),  # not in the range
        (EVERY, [fmpq(-20)]),
    ],
)
def test_no_place_serves(asked: Range, places: list[fmpq]) -> None:
    assert force_refutation(LEAVES, "λ_N > 0", asked, places, EPSILON) is None


def test_a_value_that_may_be_positive_refutes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    for value, refuted in ((arb(0), False), (arb(-1, 1), False), (arb("nan"), False), (arb(-2, 1), True)):
        monkeypatch.setattr(type(LEAVES), "value", lambda *_, value=value: value)
        found = force_refutation(LEAVES, "λ_N > 0", EVERY, [fmpq(4)], EPSILON)
        assert (found is not None) is refuted
