"""The fastest oscillation at a start: a spring between two masses, the contact itself, and the steps that are made."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from flint import fmpq

from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.scenes.certified import run_steps
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.floats.fast_oscillation import fast_oscillation
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

BLOCKS = """
format = 1
name = "a block with another one behind a spring"
[energies]
coordinates = ["q", "h", "s"]
kinetic = "(q_dot^2 + h_dot^2)/2 + s_dot^2"
potential = "10*h + 1000000*(s - q)^2/2"
[contact]
x = "q"
y = "h"
mu = "1/2"
"""
EFFECTS = ("compliant_contact", "lift_off", "tangential_motion", "stick")


def test_of_two_masses_and_a_spring() -> None:
    """omega^2 = k (1/m_1 + 1/m_2) with m = 1, 2, without damping: followed to the end."""
    start = {"q": fmpq(0), "q_dot": fmpq(1), "s": fmpq(0), "s_dot": fmpq(1)}
    mechanism = parse_mechanism(BLOCKS)
    scene = Scene("blocks", EFFECTS, fmpq(1, 100), fmpq(1, 10), parameters={}, start=start, mechanism=mechanism)
    found = fast_oscillation(scene)
    assert found is not None
    assert found.rate == pytest.approx(math.sqrt(1_500_000), rel=1e-6)
    assert found.growth == pytest.approx(0, abs=1e-6)
    assert found.until == 0.1
    assert found.periods == pytest.approx(found.rate * 0.1 / (2 * math.pi))


def test_of_the_contact_itself() -> None:
    """The roots of r^3 + 2 r^2 + p r + p over epsilon (paper, compliant1 to compl2 with k_1 = k_2 = c = 1), but for
    what the slow b adds."""
    scene = load_scene("fig-varsim1", epsilon="1/1000")
    roots = np.roots([1, 2, 0.5, 0.5]) * 1000
    root = max(roots, key=lambda each: each.imag)
    found = fast_oscillation(scene)
    assert found is not None
    assert (found.rate, found.growth) == pytest.approx((root.imag, root.real), abs=2)
    late = fast_oscillation(replace(scene, until=fmpq(100)))
    assert late is not None
    assert late.until == pytest.approx(-90 / found.growth)  # it has decayed long before
    assert math.exp(late.growth * late.until) < 2.0**-129


def test_where_nothing_oscillates() -> None:
    """In flight above the surface."""
    scene = load_scene("fig-varsim1", epsilon="1/1000")
    flying = replace(scene, start={**scene.start, "y": fmpq(1), "z": fmpq(0), "v": fmpq(-1)})
    assert flying.first_phase() == "flight"
    assert fast_oscillation(flying) is None


@pytest.mark.slow
def test_the_integrator_makes_about_as_many_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_steps, "QUIET_SECONDS", 0.0)
    said: list[str] = []
    scene = load_scene("rod", until="1/10")
    integrated_run(scene, bits=(192,), progress=said.append)
    found = fast_oscillation(scene)
    assert found is not None
    assert len(said) / 2 < found.steps < 2 * len(said)
