"""Exact eps_0 for beta > 5: known values, points inside the cells, and what must not be proved."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.contact import threshold_by_cells as threshold_module
from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.compliant.contact.threshold_by_cells import threshold_by_cells
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


def test_refused() -> None:
    with pytest.raises(ValueError, match="c1"):
        threshold_by_cells(contact_force("13/2", c1=1), START, fmpq(1, 10))
    with pytest.raises(ValueError, match="beta"):
        threshold_by_cells(contact_force("27/2"), START, fmpq(1, 10))


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
