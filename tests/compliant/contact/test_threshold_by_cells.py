"""Exact eps_0 for beta > 5: known values, points inside the cells, and what must not be proved."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.contact import cells_of_epsilon
from gspot_verified.compliant.contact import threshold_by_cells as threshold_module
from gspot_verified.compliant.contact.cells_of_epsilon import above_on_cell, falling_to_the_left
from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.compliant.contact.threshold_by_cells import threshold_by_cells
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.evidence import at_most

START = fmpq(-10)


@pytest.mark.parametrize(
    ("beta", "expected", "digits"),
    [pytest.param("13/2", "0.07892", 5, marks=pytest.mark.slow), ("21/4", "0.0133693", 7)],
)
def test_known_thresholds(beta: str, expected: str, digits: int) -> None:
    """13/2 to the digits known from a scan; 21/4 below the leading order, .0133697."""
    leading = leading_order_iwc(beta)
    assert leading.epsilon_0 is not None
    found, whole = threshold_by_cells(leading.force, START, leading.epsilon_0, 6, leading.whole_line)
    assert found is not None
    assert found.lower is not None
    assert found.upper is not None
    assert found.place is not None
    assert abs(arb(found.lower) - arb(expected)) < fmpq(10) ** -digits
    assert found.upper - found.lower < found.upper * fmpq(1, 10**4)
    assert whole == (beta == "13/2")
    assert slow_force(leading.force, found.place, found.upper, 20) < 0
    for share in (1, 2, 10, 1000):
        for tau in range(-10, 14, 3):
            assert slow_force(leading.force, fmpq(tau), found.lower / share, 15) > 0
    if whole:
        assert all(slow_force(leading.force, -(fmpq(10) ** k), found.lower, 15) > 0 for k in range(1, 5))


def test_below_5_it_agrees_with_the_other_way() -> None:
    """Two routes: for b < 4 the polynomial is 0 and the cells must find what the iteration finds."""
    leading = leading_order_iwc("5/2")
    assert leading.epsilon_0 is not None
    found, _ = threshold_by_cells(leading.force, START, leading.epsilon_0, 5)
    assert found is not None
    assert found.lower is not None
    assert found.upper is not None
    assert found.lower <= fmpq(894881, 10**6)
    assert found.upper >= fmpq(894881, 10**6)


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


def test_refused() -> None:
    with pytest.raises(ValueError, match="c1"):
        threshold_by_cells(contact_force("13/2", c1=1), START, fmpq(1, 10))
    with pytest.raises(ValueError, match="beta"):
        threshold_by_cells(contact_force("27/2"), START, fmpq(1, 10))


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


@pytest.mark.slow
def test_a_cell_of_epsilon_that_is_not_shown_is_not_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    leading = leading_order_iwc("13/2")
    assert leading.epsilon_0 is not None
    found, _ = threshold_by_cells(leading.force, START, leading.epsilon_0, 3)
    assert found is not None
    assert "parts cover [0, " in str(found.evidence)
    monkeypatch.setattr("gspot_verified.compliant.contact.threshold_by_cells.above_on_cell", lambda *_: None)
    assert threshold_by_cells(leading.force, START, leading.epsilon_0, 3) == (None, False)


def test_what_was_reached_is_said_and_nothing_where_nothing_was(monkeypatch: pytest.MonkeyPatch) -> None:
    """A cell that holds, and no least value beyond it: its end is a lower bound. No cell that holds: no threshold."""
    force = contact_force("13/2")
    monkeypatch.setattr(threshold_module, "least_value", lambda *_: None)
    monkeypatch.setattr(threshold_module, "_holds", lambda *_: at_most(fmpq(0), fmpq(1)))
    found, _ = threshold_by_cells(force, START, fmpq(1, 10))
    assert found is not None
    assert found.lower is not None
    assert fmpq(99, 1000) < found.lower <= fmpq(1, 10)
    assert (found.upper, found.place, found.every_epsilon) == (None, None, False)
    monkeypatch.setattr(threshold_module, "_holds", lambda *_: None)
    assert threshold_by_cells(force, START, fmpq(1, 10))[0] is None
