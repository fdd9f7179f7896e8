"""Certificates of the runs of mechanisms, from the scene to the checker's statement.

Page: proofs/run_certificate.md, section 1a.
"""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from must_reject import runs

from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.certificates.polynomial_mechanism import NotPolynomial, PolynomialMechanism
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


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("stribeck_rod", "need a friction coefficient that is a number"),
        ("ellipse", "need x, not a slip velocity"),
        ("rod_on_a_shaken_base", "without constraints and time"),
        ("double_pendulum", "more than one coordinate"),
        ("model_system", "with a mass matrix and forces"),
    ],
)
def test_mechanisms_without_certificates(name: str, why: str) -> None:
    with pytest.raises(NotPolynomial, match=why):
        PolynomialMechanism(load(name))
