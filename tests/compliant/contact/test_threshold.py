"""Exact eps_0: known values, and points on both sides.

Page: proofs/monotone.md.
"""

from __future__ import annotations

import dataclasses
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.contact import threshold
from gspot_verified.compliant.contact.least_value import LeastValue
from gspot_verified.compliant.contact.slow_manifold import impact
from gspot_verified.compliant.contact.threshold import exact_threshold, slow_force
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.verdict import Outcome

NOT_INTEGER = st.fractions(Fraction(1, 9), Fraction(44, 9), max_denominator=9).filter(lambda b: b.denominator > 1)
START = fmpq(-10)


@pytest.mark.parametrize(
    ("beta", "expected"),
    [("3/2", "0.1788212"), ("7/3", "0.704003"), ("5/2", "0.894881"), ("7/2", "0.01289908"), ("9/2", "0.145789")],
)
def test_known_thresholds(beta: str, expected: str) -> None:
    """To six digits, as found before by other means: quadrature in 80 bits and a scan."""
    leading = leading_order_iwc(beta)
    assert leading.epsilon_0 is not None
    found = exact_threshold(leading.force, START, leading.epsilon_0, 8)
    assert found.lower is not None
    assert found.upper is not None
    assert leading.epsilon_0 < found.lower < found.upper
    assert found.upper - found.lower < found.upper * fmpq(1, 10**6)
    unit = fmpq(10) ** -(len(expected) - 2)
    assert abs(found.lower - arb(expected)) < unit


@settings(max_examples=6, deadline=None)
@given(NOT_INTEGER, st.lists(st.fractions(-10, 12, max_denominator=20), min_size=4, max_size=4))
def test_positive_below_and_negative_above(beta: Fraction, taus: list[Fraction]) -> None:
    leading = leading_order_iwc(beta)
    assert leading.epsilon_0 is not None
    found = exact_threshold(leading.force, START, leading.epsilon_0, 5)
    assert found.lower is not None
    if found.upper is not None and found.place is not None:
        assert slow_force(leading.force, found.place, found.upper, 20) < 0
        assert slow_force(leading.force, found.place, found.lower * fmpq(999, 1000), 20) > 0
        for tau in taus:
            for share in (fmpq(1), fmpq(1, 3), fmpq(1, 10**6)):
                assert slow_force(leading.force, to_fmpq(tau), found.lower * share, 20) > 0


def test_units() -> None:
    """eps_0 of another alpha_1: the same system in its normal form."""
    leading = leading_order_iwc("5/2", alpha_1=-2, alpha_2=-3, c1="-1/2")
    force = leading.force
    assert leading.epsilon_0 is not None
    found = exact_threshold(force, START, leading.epsilon_0, 6)
    # sigma = 1/2: alpha_2' = sigma^3 alpha_2, C_1' = sigma^(2 + beta) C_1, which is irrational; C_1/alpha_2 decides.
    assert found.lower is not None
    assert found.place is not None
    assert found.upper is not None
    assert slow_force(force, found.place, found.lower, 20) > 0
    assert slow_force(force, found.place, found.upper, 20) < 0


def test_refused() -> None:
    with pytest.raises(ValueError, match="c1"):
        exact_threshold(contact_force("5/2", c1=1), START, fmpq(1, 10))
    with pytest.raises(ValueError, match="beta"):
        exact_threshold(contact_force("11/2"), START, fmpq(1, 10))


def test_far_out_of_range_it_stops_with_what_was_proved() -> None:
    found = exact_threshold(contact_force("1.0001"), START, fmpq(10) ** 100)
    assert (found.lower, found.upper, found.every_epsilon) == (fmpq(10) ** 100, None, False)


def test_what_was_proved_to_begin_with_is_not_given_away(monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither by rounding to fewer digits, nor where no least value is found."""
    force = contact_force("5/2")
    proved = fmpq(89488135, 10**8)
    found = exact_threshold(force, START, proved, 3)
    assert found.upper is not None
    assert found.lower == proved < found.upper
    assert found.evidence is not None
    monkeypatch.setattr(threshold, "least_value", lambda *_: None)
    found = exact_threshold(force, START, proved, 3)
    assert (found.lower, found.upper, found.place, found.every_epsilon) == (proved, None, None, False)


def test_without_a_certain_least_value_no_threshold_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """The numbers are found all the same; the verdict that would rest on them is undecided."""
    system = leading_order_iwc("5/2")
    shown = impact(system, None, 4)
    assert shown is not None
    assert shown.verdict.outcome is Outcome.PROVED
    honest = threshold.least_value

    def without(*given: Any) -> LeastValue | None:
        found = honest(*given)
        return None if found is None else dataclasses.replace(found, evidence=None)

    monkeypatch.setattr(threshold, "least_value", without)
    open_one = impact(system, None, 4)
    assert open_one is not None
    assert open_one.verdict.outcome is Outcome.UNDECIDED
    assert open_one.threshold == shown.threshold
