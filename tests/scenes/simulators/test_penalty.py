"""The compliant contact in floats: a weight that slides, whose motion in contact is linear."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from scipy import integrate
from scipy.linalg import expm

from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.penalty import penalty
from gspot_verified.scenes.simulators.simulated import Simulated

WEIGHT = """
format = 1
name = "weight"
[regularisation]
k_1 = "3/2"
k_2 = "5/2"
c = "{damper}"
[lagrangian]
coordinates = ["H", "X"]
mass_matrix = [[4, 0], [0, 2]]
forces = ["-6", "{push}"]
[contact]
x = "X"
y = "H"
mu = "1/4"
"""
FORCE, SERIES, OWN, DAMPER, EPSILON = 6.0, 1.5, 2.5, 0.75, 0.125
DEPTH = EPSILON**2 * FORCE * (1 / SERIES + 1 / OWN)


def run(folder: Path, start: Sequence[float], until: float, velocity: float = 0.0, **given: str) -> Simulated:
    (folder / "weight.toml").write_text(WEIGHT.format(**{"damper": "3/4", "push": "0"} | given))
    weight = load(folder / "weight.toml")
    return penalty(weight, contact_floats(weight), start, epsilon=EPSILON, until=until, surface_velocity=velocity)


@pytest.mark.parametrize(("slip", "velocity", "friction"), [(2.0, 0.0, -1), (2.0, 3.0, 1), (-2.0, 0.0, 1)])
def test_a_weight_at_rest_on_its_springs_is_braked_by_friction_alone(
    tmp_path: Path, slip: float, velocity: float, friction: int
) -> None:
    found = run(tmp_path, [0.0, 1.0, 0.0, slip], 0.25, velocity)
    end = found.states[-1]
    assert found.times[-1] == pytest.approx(0.25)
    assert found.forces is not None
    for state, force in zip(found.states, found.forces, strict=True):
        assert state[0] == pytest.approx(-DEPTH, rel=1e-6)
        assert force == pytest.approx(EPSILON**2 * FORCE / OWN, rel=1e-6)
    assert end[3] == pytest.approx(slip + friction * 0.25 * FORCE / 4 / 2, abs=1e-4)
    assert end[1] == pytest.approx(1 + slip * 0.25 + friction * 0.25**3 * FORCE / 8 / 0.5, abs=1e-4)
    assert max(later - earlier for earlier, later in pairwise(found.times)) <= 0.25 / 4000 * (1 + 1e-9)


def test_a_weight_that_is_pushed_stays_on_the_surface_but_for_the_smoothed_friction(tmp_path: Path) -> None:
    """Half of the friction that there may be: tanh of the slip velocity, over 1e-5 of that at the start, is 1/2."""
    found = run(tmp_path, [0.0, 0.0, 0.0, 0.625], 0.5, 0.5, push="3/4")
    assert found.states[-1][3] - 0.5 == pytest.approx(1e-5 * 0.125 * math.atanh(0.5), rel=1e-2)


def test_a_weight_that_swings_on_its_springs_follows_the_linear_equations(tmp_path: Path) -> None:
    """About rest, for the height and the place between the springs: 4 H'' = own (z - H)/eps^2, and the damper."""
    e = EPSILON
    stiff = OWN / e**2
    matrix = np.array([
        [0, 1, 0], [-stiff / 4, 0, stiff / 4], [stiff * e / DAMPER, 0, -(SERIES / e**2 + stiff) * e / DAMPER]
    ])  # fmt: skip
    found = run(tmp_path, [0.0, 0.0, 0.05, 9.0], 1.0)
    assert found.forces is not None
    assert min(found.forces) > 0
    for k in (1000, 2500, -1):
        height, speed, inner = expm(matrix * found.times[k]) @ [0.0, 0.05, 0.0]
        assert found.states[k][0] + DEPTH == pytest.approx(height, abs=1e-7)
        assert found.states[k][2] == pytest.approx(speed, abs=1e-7)
        assert found.forces[k] == pytest.approx(e**2 * FORCE / OWN + inner - height, abs=1e-7)


def test_a_weight_that_is_thrown_up_flies(tmp_path: Path) -> None:
    found = run(tmp_path, [0.0, 0.0, 4.0, 2.0], 0.75)
    first = next(k for k, force in enumerate(found.forces or ()) if force == 0)
    last = len(found.times) - 1
    assert (found.forces or ())[-1] == 0
    later = found.times[last] - found.times[first]
    assert found.states[last][2] == pytest.approx(found.states[first][2] - 1.5 * later, abs=1e-6)
    assert found.states[last][3] == pytest.approx(found.states[first][3], abs=1e-6)


def test_what_cannot_be_run_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(SceneError, match=r"weight: this run needs a damper, regularisation\.c > 0"):
        run(tmp_path, [0.0, 0.0, 0.0, 2.0], 0.25, damper="0")
    failed = SimpleNamespace(success=False, message="too many steps")
    monkeypatch.setattr(integrate, "solve_ivp", lambda *_, **__: failed)
    with pytest.raises(SceneError, match=r"LSODA gives up at ε = 0.125: too many steps"):
        run(tmp_path, [0.0, 0.0, 0.0, 2.0], 0.25)
