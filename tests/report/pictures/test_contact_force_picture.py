"""The labels of the contact force: what is known of each side, also where the force is negative before it grows."""

from __future__ import annotations

import pytest
from flint import arb

from gspot_verified import iwc, plot
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.pictures.contact_force_picture import contact_force_picture


def test_a_side_whose_contact_is_lost_is_not_said_to_take_an_impact(monkeypatch: pytest.MonkeyPatch) -> None:
    """Beta = 3/2, C_1 = 1, epsilon = 1: the force tends to infinity, and is negative at tau = -10."""
    from matplotlib.axes import Axes

    assert leading_order_iwc("3/2", c1=1, epsilon=1).verdict.outcome is Outcome.REFUTED
    labels, plot = [], Axes.plot

    def noted(self: Axes, *values: object, **look: object) -> object:
        labels.append(look.get("label"))
        return plot(self, *values, **look)  # type: ignore[arg-type]

    monkeypatch.setattr(Axes, "plot", noted)
    contact_force_picture(contact_force("3/2", c1=1), 1)
    assert labels == ["C₁ = 1: λ_N → +∞", "C₁ = −1: λ_N → −∞"]


def test_a_system_of_balls_has_a_picture() -> None:
    """Its mean is a method, that of one system a number."""
    found = iwc(alpha_1=-1, alpha_2=-1, alpha_3=arb("-2.5", "1e-3"))
    assert "λ_N(τ) at leading order" in str(plot(found))


def test_the_data_say_where_the_force_tends() -> None:
    for c1 in (1, -1):
        data = contact_force("3/2", c1=c1).to_json()
        assert data["tends_to_plus_infinity"] is (c1 == 1)
        assert "takes_impact" not in data
