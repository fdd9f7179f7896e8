"""What is left of a start's fast part at the G-spot: against ``approach`` and the exact coefficients; where nothing."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.mechanisms.approach.approach import approach
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
    assert found.exponent == pytest.approx(expected.fast_exponent, rel=1e-5)
    assert expected.time is not None
    assert found.time == pytest.approx(float(expected.time.mid()), rel=1e-3)
    assert found.factor == pytest.approx(math.exp(-1000 * found.exponent))


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
