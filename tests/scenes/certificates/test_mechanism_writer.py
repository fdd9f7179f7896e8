"""Certificates of the runs of mechanisms, from the scene to the checker's statement.

Page: proofs/run_certificate.md, section 1a.
"""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest
from must_reject import runs

from gspot_verified.scenes.certificates.bounded_step import NotBounded
from gspot_verified.scenes.certificates.mechanism_writer import MechanismEquations, MechanismPhase
from gspot_verified.scenes.certificates.run_certificate import certified_with_steps
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene


def said_of(scene: Scene) -> str:
    run, text, why = certified_with_steps(scene)
    assert text is not None, f"{why}: {run}"
    return runs.verdict(text.encode())


@pytest.mark.slow
def test_all_phases_of_the_rod() -> None:
    """Events and their order are those of the run at another precision."""
    said = runs.verdict(runs.rod())
    found = re.findall(r"([a-z -]+) at t in \[([\d.]+), ([\d.]+)\]", said)
    run = certified_run(load_scene("rod", epsilon="1/20", until="1/2"), digits=20)
    assert [name.strip() for name, _, _ in found] == [event.name for event in run.events]
    for (_, low, high), event in zip(found, run.events, strict=True):
        assert Fraction(high) - Fraction(low) < Fraction(1, 10**25)
        assert Fraction(low) <= Fraction(str(event.upper))
        assert Fraction(high) >= Fraction(str(event.lower))
    assert said.startswith("VERIFIED the mechanism M q'' = f + λ_N dy/dq + λ_T dx/dq with q = (X, Y, theta)")
    assert "μ = 73/36" in said
    assert said.endswith("until t = 1/2")


def test_a_divisor_and_an_assumption() -> None:
    said = runs.verdict(runs.oscillator())
    assert said.startswith("VERIFIED the mechanism")
    assert "M = (1, 1*sin(phi); 1*sin(phi), 2)" in said
    assert said.endswith("until t = 1/10; provided that in contact slip is positive, which is not shown")


@pytest.mark.slow
def test_effects_that_are_left_out() -> None:
    scene = load_scene("rod", epsilon="1/20", until="1/50").with_effects(
        drop=("stick", "lift_off", "tangential_motion")
    )
    said = said_of(scene)
    assert "; λ_N > 0 all along after the start, where it is 0, as leaving an effect out assumes; " in said
    assert said.endswith("; u > 0 in contact all along, as leaving an effect out assumes")


@pytest.mark.slow
def test_a_touch_down() -> None:
    said = said_of(load_scene("oscillator", epsilon="1/1000", until="23/200"))
    assert "lift-off at t in [" in said
    assert "touch-down at t in [" in said


COUPLED = """
format = 1
name = "coupled"
[lagrangian]
coordinates = ["X", "H", "th"]
mass_matrix = [[1, 0, "sin(th)/8"], [0, 1, "cos(th)/8"], ["sin(th)/8", "cos(th)/8", "5/8"]]
forces = ["-15/8", "-5/4", "3/8*cos(th)"]
[contact]
x = "X + 5/4*cos(th)"
y = "H - 5/4*sin(th)"
mu = "1/2"
"""
SCENE = """
format = 1
name = "coupled"
mechanism = "coupled.toml"
effects = ["compliant_contact", "lift_off", "stick", "tangential_motion"]
epsilon = "1/10"
until = "1/50"
[start]
th = "1/3"
th_dot = "-3/8"
X_dot = "1/2"
"""


def test_a_determinant_that_is_constant_but_for_a_sum_of_squares(tmp_path: Path) -> None:
    """det M has sin² + cos², so its derivative is noise: what is below the checker's bits is not written."""
    (tmp_path / "coupled.toml").write_text(COUPLED)
    (tmp_path / "scene.toml").write_text(SCENE)
    assert said_of(load_scene(tmp_path / "scene.toml")).startswith("VERIFIED")


def test_a_slip_that_turns_at_once_has_no_certificate() -> None:
    """At u = 0 friction may not hold the contact; sections 1a and 4 have no such change."""
    phase = MechanismPhase(MechanismEquations(load_scene("rod")), "slip")
    with pytest.raises(NotBounded, match="do not cover slip backwards right after slip"):
        phase.event("slip backwards")
