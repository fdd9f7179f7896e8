"""One cell of epsilon: what it holds on a half-line and to the left of it, and that it must not say more.

Page: proofs/monotone.md, section 10.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.contact import cells_of_epsilon
from gspot_verified.compliant.contact.cells_of_epsilon import above_on_cell, falling_to_the_left
from gspot_verified.compliant.contact.least_value import least_value
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import contact_force

START = fmpq(-10)


def test_a_cell_that_reaches_beyond_the_threshold_is_not_proved() -> None:
    force = contact_force("13/2")
    for ends, answer in (((fmpq(0), fmpq(3, 10)), True), ((fmpq(3, 10), fmpq(7, 20)), False)):
        epsilon = 2 * ends[1] ** 3
        bound = -force.level(epsilon, 20)
        assert (above_on_cell(force.beta, START, ends, bound) is not None) is answer
    profile = Profile.at_root(force.beta, fmpq(7, 20))
    assert profile.value(fmpq(15, 4), 12) < -force.level(2 * fmpq(7, 20) ** 3, 20)


def test_falling_to_the_left() -> None:
    beta, ends = fmpq(13, 2), (fmpq(0), fmpq(20))
    assert falling_to_the_left(beta, START, ends)
    for root in (fmpq(1, 10), fmpq(1), fmpq(7), fmpq(20)):
        values = Profile.at_root(beta, root).derivatives(START, range(6), 15)
        assert all((-1) ** k * value > 0 for k, value in enumerate(values))
    assert not falling_to_the_left(beta, fmpq(0), (fmpq(0), fmpq(1, 3)))
    assert Profile.at_root(beta, fmpq(1, 10)).derivatives(fmpq(0), range(1, 2), 15)[0] > 0


def test_a_half_line_that_begins_where_f_rises_is_judged_by_its_first_point(monkeypatch: pytest.MonkeyPatch) -> None:
    """No interval is left to be cut there; and without a point beyond which f rises nothing is said."""
    beta, roots, start = fmpq(21, 4), (fmpq(1, 10), fmpq(11, 100)), fmpq(20)
    value = Profile.at_root(beta, roots[0]).value(start, 15)
    assert above_on_cell(beta, start, roots, value.lower() / 2) is not None
    assert above_on_cell(beta, start, roots, value.upper()) is None
    assert above_on_cell(beta, start, (roots[0], roots[0]), value.lower() * (1 - arb(10) ** -12)) is not None
    monkeypatch.setattr(cells_of_epsilon, "_rising_from", lambda *_: None)
    assert above_on_cell(beta, start, roots, value.lower() / 2) is None


def test_an_interval_that_is_left_out_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The cells of tau must cover the half-line: here each half but the first is lost."""
    force, ends = contact_force("13/2"), (fmpq(0), fmpq(3, 10))
    bound = -force.level(2 * ends[1] ** 3, 20)
    assert "cover [-10, inf]" in str(above_on_cell(force.beta, START, ends, bound))
    monkeypatch.setattr(cells_of_epsilon, "halves", lambda lower, upper: ((lower, (lower + upper) / 2),))
    assert above_on_cell(force.beta, START, ends, bound) is None


def drifts(monkeypatch: pytest.MonkeyPatch, of: dict[int, arb]) -> None:
    """The bound of the change with eta is given, by the order of the derivative; 0 for the others."""
    monkeypatch.setattr(cells_of_epsilon, "drift", lambda _, derivative, *__: of.get(derivative, arb(0)))


@pytest.mark.parametrize("k", range(6))
def test_each_derivative_to_the_left_outlasts_its_drift(monkeypatch: pytest.MonkeyPatch, k: int) -> None:
    """f^(k) at the lower end for even k, at the upper end for odd k, and no less than the drift from 0."""
    beta, roots = fmpq(13, 2), (fmpq(1, 10), fmpq(1, 5))
    value = Profile.at_root(beta, roots[k % 2]).derivatives(START, range(k, k + 1), 20)[0]
    assert (value > 0) is (k % 2 == 0)
    small = arb(10) ** -9
    drifts(monkeypatch, {k: -abs(value) * (1 - small)})
    assert falling_to_the_left(beta, START, roots)
    drifts(monkeypatch, {k: -abs(value) * (1 + small)})
    assert not falling_to_the_left(beta, START, roots)
    # What is left must be more than 0: here it is 0, exactly.
    monkeypatch.setattr(Profile, "derivatives", lambda _, __, orders, ___: [arb((-1) ** j) for j in orders])
    drifts(monkeypatch, {k: arb(-1)})
    assert not falling_to_the_left(beta, START, roots)
    drifts(monkeypatch, {k: arb(-1) + small})
    assert falling_to_the_left(beta, START, roots)


def test_the_first_point_of_the_half_line_is_lowered_by_the_drift(monkeypatch: pytest.MonkeyPatch) -> None:
    beta, roots, start = fmpq(21, 4), (fmpq(1, 10), fmpq(11, 100)), fmpq(20)
    value = Profile.at_root(beta, roots[0]).value(start, 20)
    small = arb(10) ** -9
    drifts(monkeypatch, {0: -value / 4})
    assert above_on_cell(beta, start, roots, value * 3 / 4 * (1 - small)) is not None
    assert above_on_cell(beta, start, roots, value * 3 / 4 * (1 + small)) is None


def test_between_the_start_and_the_rise_the_drift_lowers_f(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bound must be below the least value of f plus the drift; beyond 8, where f rises, f is large."""
    rising_from = cells_of_epsilon._rising_from
    monkeypatch.setattr(cells_of_epsilon, "_rising_from", lambda f, _, change: rising_from(f, fmpq(8), change))
    beta, root = fmpq(13, 2), fmpq(3, 10)
    least = least_value(Profile.at_root(beta, root), START, 12)
    assert least is not None
    assert least.place < 8
    for part, above in ((fmpq(9, 10), False), (fmpq(11, 10), True)):
        drifts(monkeypatch, {0: arb(least.lower)})
        evidence = above_on_cell(beta, START, (root, root), arb(least.lower * (1 + part)))
        assert (evidence is not None) is above


@pytest.mark.parametrize("k", range(1, 6))
def test_where_f_may_fall_for_some_epsilon_the_half_line_does_not_begin(
    monkeypatch: pytest.MonkeyPatch, k: int
) -> None:
    """f^(k) at the start is positive, and its drift leaves it so, or does not: then the next point is asked."""
    beta, roots, start = fmpq(21, 4), (fmpq(1, 10), fmpq(11, 100)), fmpq(20)
    profile = Profile.at_root(beta, roots[0])
    value, slope = profile.value(start, 20), profile.derivatives(start, range(k, k + 1), 20)[0]
    small = arb(10) ** -9
    for share, begins in ((1 - small, True), (1 + small, False)):
        drifts(monkeypatch, {k: -slope * share})
        evidence = above_on_cell(beta, start, roots, value / 2)
        assert ("one part covers [20, inf]" in str(evidence)) is begins
