"""What is left of a start's fast part at the G-spot: against ``approach`` and the exact coefficients; where nothing."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.fast_decay import surviving_exponent
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.scenes.certified_run import exact_start
from gspot_verified.scenes.floats.fast_part import fast_part
from gspot_verified.scenes.scene.file import load_scene


def test_it_is_what_approach_says() -> None:
    """By the path of the proved slip and by that of the scene."""
    start = {"theta": "theta_ref - 1/10", "theta_dot": "1/2", "X_dot": 2, "X": 0}
    expected = approach(shipped_mechanism("rod"), start)
    found = fast_part(load_scene("rod"))
    assert found is not None
    assert found.exponent == pytest.approx(expected.fast_exponent, rel=1e-5)  # two sums in floats, on other points
    assert expected.time is not None
    assert found.time == pytest.approx(float(expected.time.mid()), rel=1e-3)
    assert found.factor == pytest.approx(math.exp(-1000 * found.exponent))


def test_the_path_on_which_p_falls_evenly() -> None:
    """p = 1/2 - t; the rule for given times knows it from many points."""
    found = fast_part(load_scene("fig-varsim1"))
    assert found is not None
    times = [k / 4000 for k in range(2001)]
    expected = surviving_exponent(times, [0.5 - t for t in times], PAPER)
    assert found.exponent == pytest.approx(expected, rel=1e-6)
    assert found.time == pytest.approx(0.5 * (1 - 1e-4), rel=1e-4)


def test_the_exact_fast_coefficient_falls_like_it() -> None:
    """ln|c_+ epsilon^(-beta)| at two epsilons, up to the power that they have in common (proofs/first_integrals.md)."""
    sizes = {}
    for n in (200, 400, 800):
        fast = side_rule(*exact_start(load_scene("fig-varsim1", beta="3/2", nu=2, epsilon=f"1/{n}")), 6).fast
        assert fast is not None
        sizes[n] = math.log(float(abs(fast).mid()))
    found = fast_part(load_scene("fig-varsim1"))
    assert found is not None
    power = ((sizes[200] - sizes[400]) * 2 - (sizes[400] - sizes[800])) / math.log(2)  # the same E(n) cancels
    measured = (sizes[400] - sizes[800] - power * math.log(2)) / 400
    assert measured == pytest.approx(found.exponent, rel=0.02)


STARTS = {"just in contact": {"y": "-1e-30", "v": 0, "z": 0}, "rest": {}, "slip": {"start": "slip"}}
"""Three starts over the same slow states; y = v = z = 0 itself is not yet a state in contact."""


def _stays(start: str, p: fmpq, epsilon: str) -> bool:
    """Whether the exact side of a start is that of the impact. Its slow part always is: nu = 2, beta = 5/2."""
    scene = load_scene("fig-varsim1", beta="5/2", nu=2, epsilon=epsilon, p=p, **STARTS[start])  # type: ignore[arg-type]
    rule = side_rule(*exact_start(scene), 6)
    assert rule.slow_side is not None
    assert rule.slow_side > 0
    assert rule.side > 0 or rule.side < 0
    return bool(rule.side > 0)


def test_what_is_left_of_the_fast_part_may_turn_the_side() -> None:
    """At p = 3/50 e^(-2.25) of it is left, at p = 1/5 e^(-25)."""
    near, far = fmpq(3, 50), fmpq(1, 5)
    assert not _stays("just in contact", near, "1e-4")
    assert not _stays("rest", near, "1e-4")
    assert _stays("slip", near, "1e-4")
    assert _stays("just in contact", far, "1e-4")
    assert _stays("just in contact", near, "1e-5")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("start", "epsilon", "count"),
    [("just in contact", "1e-4", 18), ("rest", "1e-4", 22), ("slip", "1e-4", 26), ("just in contact", "1e-6", 26)],
)
def test_how_many_of_26_starts_stay_on_the_side_of_impact(start: str, epsilon: str, count: int) -> None:
    """docs/scenes.md has these numbers."""
    assert sum(_stays(start, fmpq(k, 100), epsilon) for k in range(4, 30)) == count


def test_other_springs() -> None:
    soft = fast_part(load_scene("fig-varsim1", k_1=4))
    own = fast_part(load_scene("fig-varsim1"))
    assert own is not None
    assert soft is not None
    assert soft.exponent < own.exponent / 4  # about (2/5)^2


@pytest.mark.parametrize(
    "settings",
    [
        {"y": "1/10", "v": 0, "z": 0},  # in flight
        {"b": 1, "y": "-1/1000000", "v": 0, "z": 0},  # no force of rigid slip
        {"alpha_1": 1},  # p rises
    ],
)
def test_where_no_g_spot_is_reached_there_is_nothing_to_say(settings: dict[str, object]) -> None:
    scene = replace(load_scene("fig-varsim1"), stop_at_force=None).with_settings(**settings)  # type: ignore[arg-type]
    assert fast_part(scene) is None


def test_where_slip_stops_before_the_g_spot_there_is_nothing_to_say() -> None:
    """At u = 1/100 it stops after 0.0025, at u = 1 after 0.25, on a belt of that velocity too; at u = 3 not before."""
    slides = load_scene("fig-varsim1").with_effects(add=["tangential_motion", "stick", "belt"], u=3)
    assert fast_part(slides) is not None
    for settings in ({"u": "1/100"}, {"u": 1}, {"belt_velocity": 2}):
        assert fast_part(slides.with_settings(**settings)) is None
