"""Plans of the series in eta: the fewest orders that serve, points on both sides of each peak, none where none serves.

Any plan is correct; these are good ones.
"""

from __future__ import annotations

import pytest

from gspot_verified.compliant.slow.series_plan import ORDERS, series_plan


@pytest.mark.parametrize("tau", [-8.0, 0.0, 3.0, 40.0])
@pytest.mark.parametrize("b", [-2.5, 0.5, 5.5])
def test_a_plan_has_two_points_for_each_order(tau: float, b: float) -> None:
    terms = []
    for goal in (40, 80, 160):
        plan = series_plan(tau, b, 1e-9, goal)
        assert plan is not None
        assert plan.terms in ORDERS
        assert plan.terms > b - 2
        assert len(plan.places) == plan.terms
        assert all(0 < rising < falling for rising, falling in plan.places)
        assert plan.bits > goal
        terms.append(plan.terms)
    assert terms == sorted(terms)
    assert terms[0] < terms[-1]


def test_there_is_none_where_the_remainder_stays_large() -> None:
    assert series_plan(0.0, 0.5, 1.0, 40) is None
    assert series_plan(0.0, 0.5, 1e-9, 10**6) is None
    assert series_plan(0.0, 97.9, 1e-30, 40) is not None
    assert series_plan(0.0, 98.0, 1e-30, 40) is None
