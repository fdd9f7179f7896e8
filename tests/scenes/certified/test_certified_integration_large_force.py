"""Where a scene ends its run by the force: certain comparisons, against an explicit force and against a float run."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified import load, load_scene, scene_before_spot, simulate
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified.certified_integration import LargeForce
from gspot_verified.scenes.scene.scene import Scene

MODEL = load_scene("fig-varsim2", epsilon="1/10")


def states(p: object, force: object) -> dict[str, arb]:
    """In contact, λ_N = Z - Y for k_1 = 1."""
    return {"p": arb(p), "b": arb(-1), "Y": -arb(force), "V": arb(0), "Z": arb(0), "u": arb(1), "T": arb(0)}


def large(factor: int | None) -> LargeForce:
    scene = replace(MODEL, stop_at_force=None if factor is None else fmpq(factor))
    return LargeForce(scene.system("slip"), scene)


def test_the_force_is_compared_with_that_of_rigid_slip_at_the_start() -> None:
    """Of fig-varsim2 at the start p = 1/2, b = -nu p |alpha_2/(alpha_3 - alpha_1)|."""
    start = MODEL.initial()
    rigid = -start["b"] / start["p"]
    with working_bits(80):
        for factor in (3, 50):
            above, below = rigid * factor + fmpq(1, 10**6), rigid * factor - fmpq(1, 10**6)
            assert large(factor).shown(states(-1, above)) is not None
            assert large(factor).shown(states(-1, below)) is None


def test_what_is_not_certain_or_not_so_does_not_end_a_run() -> None:
    with working_bits(80):
        assert large(3).shown(states(-1, 1000)) is not None
        assert large(3).shown(states(1, 1000)) is None
        assert large(3).shown(states(0, 1000)) is None
        assert large(3).shown(states(arb(-1, 2), 1000)) is None
        assert large(3).shown(states(-1, arb(1000, 1000))) is None
        assert large(3).shown(states(arb("nan"), arb("nan"))) is None
        assert large(None).shown(states(-1, 1000)) is None
    flight = replace(MODEL, stop_at_force=fmpq(3))
    assert LargeForce(flight.system("flight"), flight).shown(states(-1, 1000)) is None


@pytest.fixture(scope="module")
def rod() -> Scene:
    return scene_before_spot(load("rod"), 1).with_settings(until="0.053")


def test_a_run_ends_in_its_impact(rod: Scene) -> None:
    """The statement ends where the force has passed the bound; a float run has that force there, too."""
    whole = simulate(rod, digits=5)
    stopped = replace(rod, stop_at_force=fmpq(20))
    run = simulate(stopped, digits=5)
    assert run.verdict.outcome is Outcome.PROVED
    assert [event.name for event in run.events] == ["impact without collision"]
    assert run.events == whole.events[:1]
    assert [event.name for event in whole.events][1:2] == ["stick"]
    known = re.search(
        r"until t = (\S+) after the start; by t = (\S+) λ_N is more than 20 times that of rigid slip at the start",
        run.verdict.statement,
    )
    assert known
    assert Fraction(known[1]) <= Fraction(known[2]) < Fraction(known[1]) + Fraction(1, 10**9)
    end = float(run.verdict.statement.partition("until t = ")[2].split()[0])
    samples = simulate(rod, floats=True).samples
    assert samples is not None
    p, b, force, t = (samples.columns[name] for name in ("p", "b", "lambda_N", "t"))
    assert np.interp(end, t, p) < 0
    assert np.interp(end, t, force) > 20 * -b[0] / p[0]
    assert run.events[0].upper < fmpq(round(end * 10**6), 10**6) < whole.events[1].lower


def test_before_an_impact_is_shown_nothing_ends(rod: Scene) -> None:
    """A bound that is never reached changes nothing but the scene."""
    short = rod.with_settings(until="1/100")
    assert simulate(replace(short, stop_at_force=fmpq(2)), digits=5) == simulate(short, digits=5)
