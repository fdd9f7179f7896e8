"""The numbers of G-spots: those that slip in contact may reach come first, in the same order everywhere."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots import all_g_spots
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots, relevant_first
from gspot_verified.mechanisms.spots.classify import classify_g_spot, sign_of_exact


def test_cases_come_before_no_case_and_positive_slip_first() -> None:
    """The oscillator has two G-spots in Case III, one of them with u > 0, and four in no Case."""
    spots = find_g_spots(shipped_mechanism("oscillator")).spots
    ranks = []
    for spot in map(classify_g_spot, spots):
        in_a_case = spot.case in ("I", "II", "III")
        ranks.append((not in_a_case, in_a_case and sign_of_exact(spot.slip_velocity) != 1))
    assert ranks == [(False, False), (False, True), *[(True, False)] * 4]


def test_an_open_case_stands_between(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every group, whatever order the search has: (case, slip) in the place of spots."""

    def classified(spot: tuple[str | None, fmpq | arb]) -> SimpleNamespace:
        return SimpleNamespace(case=spot[0], slip_velocity=spot[1])

    monkeypatch.setattr(all_g_spots, "classify_g_spot", classified)
    right = [(case, fmpq(1)) for case in ("I", "III", "II")]
    wrong = [("II", fmpq(-1)), ("I", fmpq(0)), ("III", arb(0, 1))]
    others = [(None, fmpq(-1)), (None, fmpq(1)), ("none", fmpq(-2)), ("none", fmpq(2))]
    expected: list[Any] = [*right, *wrong, *others]
    mixed: list[Any] = [*others[2:], *wrong, *others[:2], *right]
    assert relevant_first(mixed) == expected


def test_any_order_of_the_search_gives_the_same_groups_and_keeps_the_order_in_them() -> None:
    spots = list(find_g_spots(shipped_mechanism("rod")).spots)
    assert relevant_first(spots) == spots
    first, *others = spots
    assert relevant_first([*others, first]) == spots
    assert relevant_first(others[::-1]) == others[::-1]
    assert relevant_first([]) == []
