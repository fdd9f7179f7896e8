"""A whole state from what a search has found: components that follow, and those that nothing holds.

Page: proofs/all_g_spots.md, section 5.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from flint import arb, fmpq
from samples.strategies import holds

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.spots.all_g_spots import WholeState
from gspot_verified.mechanisms.spots.search_region import search_region
from gspot_verified.mechanisms.spots.spot_conditions import take_apart

Q, S, Q_DOT, S_DOT = (Variable(i) for i in range(4))
WORDS = ("q", "s", "q_dot", "s_dot")
MECHANISM = lagrangian("two", ["q", "s"], [[1, 0], [0, 1]], [0, 0], "q", "s", 1)
CONDITIONS: dict[str, Expression] = {
    "p": Q * Q - Constant(fmpq(4)), "y": S - Constant(fmpq(3)) * Q + Q_DOT, "v": S_DOT - Q,
}  # fmt: skip
"""q is searched, s = 3 q - q_dot and s_dot = q follow, q_dot is free."""


def whole(box: Mapping[str, Any], place: Mapping[str, arb]) -> WholeState:
    apart = take_apart(CONDITIONS, 4, [2])
    assert sorted(each.index for each in apart.explicit) == [1, 3]
    assert apart.free == (2,)
    return WholeState(apart, search_region(MECHANISM, CONDITIONS, apart, box), place, WORDS)


def test_what_follows_is_computed_from_what_is_known_and_chosen() -> None:
    state = whole({}, {}).state({0: arb(2)}, {2: arb(1)})
    assert state == [arb(2), arb(5), arb(1), arb(2)]
    assert not whole({}, {}).state({0: arb(2)}, {2: arb("nan")})[1].is_finite()


@pytest.mark.parametrize(
    ("box", "place", "chosen"),
    [({}, {}, 0), ({}, {"q_dot": arb(7)}, 7), ({"q_dot": (2, 4)}, {}, 3), ({"q_dot": (2, 4)}, {"q_dot": arb(2)}, 2)],
)
def test_a_free_component_has_the_mechanisms_value_where_its_interval_allows_it(
    box: Mapping[str, Any], place: Mapping[str, arb], chosen: int
) -> None:
    found = whole(box, place)
    assert holds(found.chosen_free()[2], chosen)
    every = found.any_free()[2]
    if box:
        assert holds(every, 2)
        assert holds(every, 4)
    else:
        assert not every.is_finite()


@pytest.mark.parametrize(
    ("box", "depends"), [({}, False), ({"s_dot": (0, 1)}, False), ({"q_dot": (0, 1)}, False), ({"s": (0, 1)}, True)]
)
def test_an_interval_on_what_follows_from_a_free_component_is_seen(box: Mapping[str, Any], depends: bool) -> None:
    assert whole(box, {}).depends_on_free() is depends
