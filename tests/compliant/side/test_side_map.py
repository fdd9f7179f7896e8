"""The map of the exact side rule: signs at points, and where both rules agree."""

from __future__ import annotations

import pytest
from flint import acb, arb, fmpq

from gspot_verified.compliant.model.normal_form import Deviation, compliant_model, compliant_state, deviation
from gspot_verified.compliant.side import side_map as side_map_module
from gspot_verified.compliant.side.side_map import (
    SidePoint,
    agreement_limits,
    paper_deviation,
    side_map,
    side_point,
)
from gspot_verified.compliant.side.side_rule import side_rule


def test_the_unit_data_are_those_of_the_figures() -> None:
    model = compliant_model("5/2", "1/50")
    p, nu, mean = fmpq(1, 2), fmpq(1, 4), model.mean_force
    b = -nu * p * abs(mean)
    state = compliant_state(p, b, 2 * model.epsilon**2 * b / p, 0, model.epsilon**2 * b / p)
    hats, unit = deviation(model, state), paper_deviation(fmpq(5, 2), fmpq(1, 50))
    size = (1 - nu) * mean
    assert [hats.b, hats.V, hats.Y, hats.Z] == [size * value for value in (unit.b, unit.V, unit.Y, unit.Z)]
    (point,) = side_map([fmpq(5, 2)], [fmpq(1, 50)])
    found = side_rule(model, state)
    assert point.exact == (1 if found.side > 0 else -1)


def test_where_both_rules_agree() -> None:
    told: list[tuple[int, int]] = []
    epsilons = [fmpq(1, n) for n in (10, 700, 2000, 10**6)]
    points = side_map([fmpq(3, 2), fmpq(13, 2)], epsilons, lambda done, number: told.append((done, number)))
    assert told == [(1, 2), (2, 2)]
    limits = agreement_limits(points)
    assert limits[fmpq(3, 2)] == fmpq(1, 10)
    assert limits[fmpq(13, 2)] == fmpq(1, 2000)
    open_point = SidePoint(fmpq(2), fmpq(1), None, 1)
    assert agreement_limits([open_point]) == {fmpq(2): None}


def test_the_agreement_ends_at_the_first_point_that_is_open_or_differs() -> None:
    """Both open is no agreement; what agrees beyond a point that does not is not counted."""
    for exact, slow in ((None, None), (None, 1), (1, None), (1, -1)):
        row = [SidePoint(fmpq(2), fmpq(1, 100), -1, -1), SidePoint(fmpq(2), fmpq(1, 10), exact, slow)]
        assert agreement_limits([SidePoint(fmpq(2), fmpq(1), 1, 1), *row]) == {fmpq(2): fmpq(1, 100)}
        assert agreement_limits(row[1:]) == {fmpq(2): None}


def test_an_open_sign_is_looked_at_more_closely_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    honest = side_map_module.coefficients

    def rough(state: Deviation, bits: int) -> tuple[arb, acb, arb]:
        asked.append(bits)
        slow, fast, side = honest(state, bits)
        return slow, fast, side + arb(0, 10) if len(asked) in still_open else side

    monkeypatch.setattr(side_map_module, "coefficients", rough)
    still_open: set[int] = set()
    for exact, calls in ((1, 1), (1, 2), (None, 2)):
        assert side_point(fmpq(13, 2), fmpq(1, 1000)) == SidePoint(fmpq(13, 2), fmpq(1, 1000), exact, -1)
        assert len(asked) == calls
        assert sorted(set(asked)) == asked
        asked.clear()
        still_open.add(len(still_open) + 1)
