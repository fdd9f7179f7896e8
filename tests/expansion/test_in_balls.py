"""Expansions in balls contain the exact ones."""

from __future__ import annotations

import pytest
from samples.strategies import holds, to_fraction

from gspot_verified import expand
from gspot_verified.expansion.in_balls import expand_in_balls
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.testing import extended_example


@pytest.mark.parametrize("name", ["extended system", "oscillator"])
def test_every_exact_coefficient_is_in_its_ball(name: str) -> None:
    mechanism = shipped_mechanism(name)
    exact, balls = expand(mechanism, 30), expand(mechanism, 30, bits=150)
    assert exact.accuracy is None
    assert balls.accuracy is not None
    assert balls.accuracy.certain_bits > 60
    compared = 0
    for key, rows in exact.terms().items():
        for term, other in zip(rows, balls.terms()[key], strict=True):
            numbers, enclosures = term.coefficients(), other.coefficients()
            enclosures += [0] * (len(numbers) - len(enclosures))
            for number, enclosure in zip(numbers, enclosures, strict=False):
                compared += 1
                assert number == 0 if isinstance(enclosure, int) else holds(enclosure, to_fraction(number))
            for enclosure in enclosures[len(numbers) :]:
                assert holds(enclosure, 0)
    assert compared > 300
    value, other = exact.evaluate(1, "1/20", 12), balls.evaluate(1, "1/20", 12)
    assert all(value[key].overlaps(other[key]) for key in value)


def test_a_system_in_balls_and_bad_input() -> None:
    system = extended_example(chi=1)
    assert holds(
        expand_in_balls(system, 7, 80).p[6].coefficients()[1],
        to_fraction(expand_system(system, 7).p[6].coefficients()[1]),
    )
    for bits in (31, 10**6 + 1, 64.0, True):
        with pytest.raises(ValueError, match="bits must be"):
            expand_in_balls(system, 7, bits)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="order"):
        expand_in_balls(system, 0, 64)
