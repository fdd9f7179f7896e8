"""A G-spot by its number: the mechanism with its place, and everything that is asked of it there."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, Place
from gspot_verified.mechanisms.iwc import iwc
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_system
from gspot_verified.mechanisms.spots import chosen_spot
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.g_spot_list import Left


@pytest.fixture(scope="module")
def oscillator() -> Mechanism:
    return shipped_mechanism("oscillator")


@pytest.mark.parametrize("name", ["oscillator", "rod", "genot_brogliato_rod"])
def test_every_number_is_that_of_the_list(name: str) -> None:
    """By two ways: the list, and Newton's method from the place that the number gives."""
    mechanism = shipped_mechanism(name)
    listed = classify_all(mechanism)
    assert [spot.number for spot in listed.spots] == list(range(1, len(listed.spots) + 1))
    for number, spot in enumerate(listed.spots[:4], 1):
        again = classify(at_spot(mechanism, number))
        assert again.case == spot.case
        assert again.exact == spot.exact
        for part in ("alpha_1", "alpha_2", "alpha_3", "slip_velocity", "a", "A", "B", "C"):
            left, right = getattr(again, part), getattr(spot, part)
            assert (left - right == 0) if spot.exact else (left.is_finite() and left.overlaps(right))


def test_no_number_and_that_of_the_exact_place_change_nothing(oscillator: Mechanism) -> None:
    assert at_spot(oscillator, None) is oscillator
    assert classify_all(oscillator).at_place == 2
    assert at_spot(oscillator, 2) is oscillator
    assert expand(oscillator, 6, spot=2).b == expand(oscillator, 6).b


@pytest.mark.parametrize("number", [0, -1, 7, True, 1.0, "1"])
def test_a_wrong_number_is_refused_with_how_many_there_are(oscillator: Mechanism, number: Any) -> None:
    with pytest.raises(ValueError, match=r"spot: frictional impact oscillator has 6 G-spots .*a number in 1\.\.6, got"):
        at_spot(oscillator, number)


def test_where_there_is_none_no_number_serves() -> None:
    with pytest.raises(ValueError, match=r"spot: .*: no G-spot was found .*got 1"):
        at_spot(shipped_mechanism("genot_brogliato_rod", mu="13/10"), 1)


def test_a_mechanism_without_a_place_has_one_by_a_number() -> None:
    rod = shipped_mechanism("genot_brogliato_rod")
    bare = at_spot(replace(rod, place=Place()), 1)
    found, known = classify(bare), classify(rod)
    assert found.case == known.case == "II"
    assert found.beta is not None
    assert found.beta.overlaps(known.beta)
    assert found.fixed == bare.place.fixed == ("X", "X_dot")


def test_fixed_components_keep_their_exact_values() -> None:
    """X_dot = 7/3 is no dyadic number: the middle of its ball would be another one."""
    rod = shipped_mechanism("genot_brogliato_rod")
    values = {**dict(rod.place.values), "X_dot": lagrangian("k", ["X"], [[1]], [0], "X", "X", "7/3").mu}
    moved = replace(rod, place=replace(rod.place, values=tuple(values.items())))
    chosen = at_spot(moved, 1)
    assert dict(chosen.place.values)["X_dot"] == values["X_dot"]
    for part in ("alpha_1", "alpha_2", "alpha_3", "slip_velocity"):
        assert getattr(classify(chosen), part).overlaps(getattr(classify(moved), part))


def test_a_start_that_leads_elsewhere_is_refused(oscillator: Mechanism, monkeypatch: pytest.MonkeyPatch) -> None:
    other = at_spot(oscillator, 3)
    assert classify(other).case == "none"
    monkeypatch.setattr(chosen_spot, "_placed_at", lambda *_: other)
    assert at_spot(oscillator, 3) is other
    with pytest.raises(GSpotError, match="G-spot 1 could not be proved again"):
        at_spot(oscillator, 1)


def test_the_expansion_and_the_force_at_another_spot(oscillator: Mechanism) -> None:
    spot = classify_all(oscillator).spots[0]
    trajectory = expand(oscillator, 6, spot=1)
    assert trajectory.accuracy is not None
    assert trajectory.accuracy.reached
    assert trajectory.system.values_at_point([trajectory.system.alpha_1])[0].overlaps(spot.alpha_1)
    force = iwc(oscillator, spot=1, tau_start=-2, digits=6)
    assert force.leading.force.beta.overlaps(spot.beta)
    with pytest.raises(ValueError, match="the statements are about Cases I, II and III"):
        iwc(oscillator, spot=3)


def test_a_number_needs_a_mechanism() -> None:
    with pytest.raises(ValueError, match="spot: it is the number of a mechanism's G-spot"):
        iwc("7/3", spot=1)
    with pytest.raises(ValueError, match="spot: a system has one G-spot"):
        expand(shipped_system("oscillator"), 3, spot=1)


def test_a_state_may_leave_out_what_is_as_at_the_spot() -> None:
    """The rod beside its G-spot 1: X and X_dot are those of the spot, Y and Y_dot follow; as if they were given."""
    rod = shipped_mechanism("rod")
    near = {"theta": "theta_ref - 1/10", "theta_dot": "1/2"}
    short = approach(rod, near, spot=1, max_steps=1)
    long = approach(rod, {**near, "X": 0, "X_dot": 2}, max_steps=1)
    assert short.solved == long.solved == ("Y", "Y_dot")
    assert short.start == long.start
    with pytest.raises(
        StateError, match=r"give all components of the state, or all but the two .*missing: X, Y, X_dot"
    ):
        approach(rod, near)
    everything = {**near, "X": 0, "X_dot": 2, "Y": 1, "Y_dot": 1}
    with pytest.raises(StateError, match="the state gives all components: nothing of the G-spot is left"):
        approach(rod, everything, spot=1)


def test_the_number_of_an_incomplete_list_is_at_least_that_many() -> None:
    found = find_g_spots(shipped_mechanism("model"))
    with pytest.raises(ValueError, match=r"spot: model system has one G-spot \(.*\): expected 1, got 2"):
        found.spot(2)
    with pytest.raises(ValueError, match="model system has at least one G-spot"):
        replace(found, left=(Left((), "open"),)).spot(2)
