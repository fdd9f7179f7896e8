"""The steps of a program are followed from the mechanism's start, with the mechanism's own free accelerations."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import pytest
from scenes.simulators.test_comparison_programs import the_rod
from scenes.simulators.test_planar_model import walker

from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.engine import follow
from gspot_verified.scenes.simulators.planar_model import PlanarModel
from gspot_verified.scenes.simulators.simulated import STOPS, what_happens


class Braking:
    """The model's own bodies, slowed down by the force ``force`` along x; or by numbers that are none."""

    def __init__(self, model: PlanarModel, step: float, force: float, turned: float = 1.0) -> None:
        self.model, self.length, self.force, self.turned = model, step, force, turned

    def directions(self, places: Sequence[float]) -> tuple[Sequence[float], Sequence[float]]:
        along, up = self.model.directions(self.model.state(places, [0.0] * len(places)))
        return [self.turned * each for each in along], up

    def begin(self, places: Sequence[float], rates: Sequence[float]) -> None:
        self.places, self.rates = list(places), list(rates)

    def step(self, accelerations: Sequence[float]) -> tuple[Sequence[float], Sequence[float], float]:
        along, _ = self.directions(self.places)
        for i, free in enumerate(accelerations):
            self.rates[i] += self.length * (free + self.force * along[i])
            self.places[i] += self.length * self.rates[i]
        return self.places, self.rates, 1.0


def test_a_motion_without_contact_is_the_free_one() -> None:
    """The rod: the height falls by its parabola, X is not accelerated."""
    model = the_rod()
    found = follow(model, Braking(model, 1e-3, 0.0), step=1e-3, until=0.5)
    assert (len(found.times), found.times[-1]) == (501, pytest.approx(0.5))
    assert found.states[-1][:2] == pytest.approx([2.5, model.start[1] + 2.3 * 0.5 - 14.81 / 8], abs=1e-2)


def test_a_braked_motion_stops_to_slip() -> None:
    model = the_rod()
    found = follow(model, Braking(model, 1e-3, -20.0), step=1e-3, until=0.2)
    assert what_happens(found, model.functions, lasting=0.01).what == STOPS


@pytest.mark.parametrize("made", [the_rod, walker], ids=["rod", "walker"])
def test_other_bodies_and_numbers_that_are_none_are_refused(made: Callable[[], PlanarModel]) -> None:
    model = made()
    follow(model, Braking(model, 1e-3, 0.0, turned=-1.0), step=1e-3, until=1e-3)
    with pytest.raises(SceneError, match="its mass matrix and contact point are not those of the mechanism"):
        follow(model, Braking(model, 1e-3, 0.0, turned=1.001), step=1e-3, until=1e-3)
    with pytest.raises(SceneError, match="its numbers are not finite in step 1"):
        follow(model, Braking(model, 1e-3, math.nan), step=1e-3, until=1e-3)
