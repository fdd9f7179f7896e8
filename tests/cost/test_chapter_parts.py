"""Each part with few arguments: its routes give points, and those without a bound agree with the certified ones."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.cost.measurement import contest
from gspot_verified.cost.measurement.contest import QUICK, TimedRoute
from gspot_verified.cost.measurement.measurement import FILES, Part, Route
from gspot_verified.cost.parts import slow_solution_digits
from gspot_verified.cost.parts.theta_digits import ode_value, ode_zeros, right_decimals
from gspot_verified.cost.run import blueprints, machine, versions
from gspot_verified.cost.times.baseline import right_digits
from gspot_verified.numbers.balls import approximate
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.theta_function.theta import theta
from gspot_verified.work.journal_file import source_key

EFFORT = replace(QUICK, seconds=0.0, patience=60.0)
SLOW = ("scenes", "formal", "checker")
PARTS = {blueprint.key: blueprint for blueprint in blueprints(False)}


def shortened(contestant: TimedRoute, last: bool) -> TimedRoute:
    return replace(contestant, arguments=contestant.arguments[-1:] if last else contestant.arguments[:1])


def measured(key: str, monkeypatch: pytest.MonkeyPatch) -> tuple[Part, tuple[TimedRoute, ...]]:
    monkeypatch.setattr(contest, "memory_alone", lambda *_: 1024)
    blueprint = PARTS[key]
    few = tuple(shortened(one, bool(one.panel) and key not in SLOW) for one in blueprint.contestants())
    return replace(blueprint, contestants=lambda: few).measured(EFFORT), few


def excused(route: Route, contestant: TimedRoute) -> bool:
    """Another program may be absent, or be there and give no answer: then the note says so."""
    return bool(contestant.missing or contestant.seconds) and bool(route.note)


@pytest.mark.parametrize("key", [key for key in PARTS if key not in SLOW])
def test_every_route_of_a_part_has_a_point(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    part, contestants = measured(key, monkeypatch)
    for route, contestant in zip(part.routes, contestants, strict=True):
        assert route.points or excused(route, contestant), (route.panel, route.name, route.note)
        # The memory of a program that tells its own time is that of another process: it is not measured.
        expected = None if contestant.seconds is not None else 1024
        assert all(point.memory == expected for point in route.points)
    assert part.limit is not None
    assert part.limit.seconds > 0


@pytest.mark.slow
@pytest.mark.parametrize("key", SLOW)
def test_every_route_of_a_slow_part_has_a_point(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    part, contestants = measured(key, monkeypatch)
    for route, contestant in zip(part.routes, contestants, strict=True):
        assert route.points or excused(route, contestant), (route.panel, route.name, route.note)


def test_the_integrals_of_the_slow_solution_are_the_slow_solution() -> None:
    for epsilon in (fmpq(1, 1000), fmpq(1, 10**12)):
        known = slow_value(0, slow_solution_digits.B, epsilon, 0, 25).value
        assert known.is_finite()
        assert right_digits(slow_solution_digits.by_mpmath(epsilon, 20), known, 20) >= 19
        assert (right_decimals(slow_solution_digits.by_scipy(epsilon, 1e-10), approximate(known)) or 0) > 8


def test_the_solver_finds_values_and_zeros() -> None:
    assert ode_value(fmpq(2), fmpq(1, 2), 1e-10) == pytest.approx(float(theta(2, "1/2").mid()), rel=1e-8)
    zeros = ode_zeros(fmpq(5, 2), -5.0, 5.0, 1e-10)
    assert len(zeros) == 2
    for zero, (lower, upper) in zip(zeros, zeros_at("5/2", 12).brackets, strict=True):
        assert zero == pytest.approx(approximate((lower + upper) / 2), rel=1e-8)


def test_what_it_was_measured_on_is_named() -> None:
    assert "core" in machine()
    found = versions()
    assert found["FLINT"].count(".") == 2
    assert {"Python", "python-flint", "scipy", "gspot-verified"} <= set(found)
    assert found[FILES] == source_key()[:16]
