from __future__ import annotations

import pytest

from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import SHORT_NAMES, shipped_mechanism, shipped_names


@pytest.mark.parametrize("name", [*shipped_names(), *SHORT_NAMES])
def test_a_mechanism_bears_the_name_that_it_is_called_by(name: str) -> None:
    assert shipped_mechanism(name).name == SHORT_NAMES.get(name, name)


def test_the_name_of_a_file_serves_too() -> None:
    found = shipped_mechanism("falling-rod-lower-friction")
    assert found == shipped_mechanism("falling_rod_lower_friction") == shipped_mechanism("falling rod, lower friction")


@pytest.mark.parametrize("name", ["", "pendulum", "model_systems", "../data/falling_rod"])
def test_another_name_is_refused_with_those_that_there_are(name: str) -> None:
    with pytest.raises(MechanismError, match=r"no shipped mechanism .*; there are: model; .*; falling rod of G"):
        shipped_mechanism(name)
