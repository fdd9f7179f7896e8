"""What forces change at once: a sum over coordinates and velocities, and a rod."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_2 import general_system as ledger


@pytest.mark.parametrize(
    ("coordinates", "slopes", "vanishes"),
    [
        ("0*g", "0*w", True),
        ("c", "-k", True),  # k c - k c: what cancels is no change either
        ("c", "k", False),
        ("0*g", "w", False),
        ("g", "0*w", False),
    ],
)
def test_a_change_is_a_sum_over_coordinates_and_velocities(
    monkeypatch: pytest.MonkeyPatch, coordinates: str, slopes: str, vanishes: bool
) -> None:
    monkeypatch.setattr(ledger, "AT_ONCE", {"coordinates": coordinates, "slopes": slopes})
    assert ledger.along_a_force() is vanishes


@pytest.mark.parametrize("force", ["T", "N"])
@pytest.mark.parametrize("place", ["x", "y"])
def test_a_place_with_a_velocity_in_it_is_changed_at_once(
    monkeypatch: pytest.MonkeyPatch, force: str, place: str
) -> None:
    assert ledger.of_the_rod() is True
    speed = {"T": "U", "N": "W"}[force]
    monkeypatch.setitem(ledger.PLACES, place, f"{ledger.PLACES[place]} + {speed}")
    assert ledger.of_the_rod() is False


def test_the_forces_are_those_of_the_motion_in_slip(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ledger.FORCES["T"], "w", "k*s")
    assert ledger.of_the_rod() is False
