"""Certificates of the runs of mechanisms, from the scene to the checker's statement.

Page: proofs/run_certificate.md, section 1a.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from flint import arb, arb_mat, arb_poly, arb_series, fmpq
from must_reject import runs

from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.integrator.norm_steps.fast_decay import DecayState
from gspot_verified.integrator.norm_steps.norm_step import Basis, NormPlan
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.scenes.certificates.bounded_step import NotBounded
from gspot_verified.scenes.certificates.mechanism_writer import (
    MechanismEquations,
    MechanismPhase,
    MechanismWriter,
    _cut,
)
from gspot_verified.scenes.certificates.polynomial_mechanism import INVERSE, SLIDE, NotPolynomial, V, Y, Z
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


# One step of a mechanism's run with sines, cosines and divisors beside its states: curves, bases, phases.


HANGING = """
format = 1
name = "hanging"
[angles.th]
sine = "3/5"
cosine = "4/5"
[lagrangian]
coordinates = ["th", "H"]
mass_matrix = [[1, "sin(th)"], ["sin(th)", "2 + (th - th_ref)^2/8"]]
forces = ["-th_dot/3", "-2 - cos(th)*th_dot^2"]
[contact]
x = "sin(th) + cos(th)/2"
y = "H + 1 - cos(th)"
mu = "1/2"
"""
HANGING_SCENE = """
format = 1
name = "hanging"
mechanism = "hanging.toml"
effects = ["compliant_contact", "lift_off", "stick", "tangential_motion"]
epsilon = "1/7"
until = "1/50"
[start]
th = "th_ref + 1/5"
th_dot = "4/3"
"""
PLACE, UNIT = "(th-th_ref)", 80
DECAY = DecayState((), (), 1.0, 1.0, 1.0)


@cache
def scene(mechanism: str = HANGING) -> Scene:
    with TemporaryDirectory() as folder:
        (Path(folder) / "hanging.toml").write_text(mechanism)
        (Path(folder) / "scene.toml").write_text(HANGING_SCENE)
        return load_scene(Path(folder) / "scene.toml")


@cache
def equations_of(mechanism: str = HANGING) -> MechanismEquations:
    return MechanismEquations(scene(mechanism))


def by_hand(place: Any, phase: MechanismPhase) -> dict[str, Any]:
    """Sine, cosine and divisors of the hanging mechanism from its angle; of series."""
    s, c = place.sin(), place.cos()
    sine, cosine = s * ball(fmpq(4, 5)) + c * ball(fmpq(3, 5)), c * ball(fmpq(4, 5)) - s * ball(fmpq(3, 5))
    inertia = place * place / 8 * (1 if PLACE in phase.names else 0) + 2
    found = {"sin(th)": sine, "cos(th)": cosine, INVERSE: 1 / (inertia - sine * sine)}
    return found | ({SLIDE: 1 / ((cosine - sine / 2) ** 2 * inertia)} if SLIDE in phase.names else {})


def series_step(names: list[str]) -> ChosenStep:
    """Curves of degree 3 with a small slope, and a basis without a 0 for each of two pieces; V has small entries."""
    start = {PLACE: arb(0.25), "th_dot": arb(1.5)}
    small = [arb((1, -13)), arb((-3, -25)), arb((5, -37))]
    curves = tuple(arb_poly([start.get(name, arb(0.5)), *small[: 1 if name == V else 3]]) for name in names)
    n = range(len(names))
    entries = [[[1 + (7 * i + 3 * j + k) % 11 + 12 * (i == j) for j in n] for i in n] for k in (0, 1)]
    scales = arb_mat([[arb((int(i == j), -130 if names[i] == V else 0)) for j in n] for i in n])
    bases = tuple(Basis(scales * arb_mat(rows), (1,) * len(n)) for rows in entries)
    return ChosenStep(curves, arb(1), NormPlan((arb(0), arb(0.25), arb(1)), bases, (arb(2), arb(3)), 5, 4), 1.0, DECAY)


@pytest.mark.parametrize(("name", "kept"), [("slip", True), ("stick", True), ("stick", False)])
def test_curves_and_bases_move_sines_and_divisors_with_the_states(name: str, kept: bool) -> None:
    """A column of the run's basis, as a line through a state, has the slopes of sines and divisors along it."""
    with working_bits(300):
        equations = equations_of(HANGING if kept else HANGING.replace(" + (th - th_ref)^2/8", ""))
        phase, run_names = MechanismPhase(equations, name), equations.run_names(name)
        step = series_step(run_names)
        found, turn = phase.chosen(step, UNIT), step.solution[run_names.index(PLACE)]
        curves = dict(zip(phase.names, found.solution, strict=True))
        for tau in (arb(0), arb(0.5), arb(1)):
            for each, value in by_hand(arb_series([turn(tau)], 1), phase).items():
                assert abs(curves[each](tau) - value[0]) < arb((1, 6 - UNIT))
        for basis, given, middle in zip(found.plan.bases, step.plan.bases, (0.125, 0.625), strict=True):
            table = dict(zip(phase.names, basis.S.tolist(), strict=True))
            assert basis.blocks == (1,) * len(phase.names)
            assert basis.S.nrows() == basis.S.ncols() == len(phase.names)
            for j in range(len(run_names)):
                line = dict(zip(run_names, (given.S[i, j] for i in range(len(run_names))), strict=True))
                along = by_hand(arb_series([turn(arb(middle)), line[PLACE]], 2), phase)
                for each in phase.names:
                    slope = along[each][1] if each in along else line[each]
                    assert abs(table[each][j] - slope) <= abs(slope) * arb((1, -50))
            more = {each: row[len(run_names) :] for each, row in table.items()}
            at = {each: value[0] for each, value in by_hand(arb_series([turn(arb(middle))], 1), phase).items()}
            own = [{"sin(th)": 1}, {"cos(th)": 1}] if kept else [{part: at[part] for part in ("sin(th)", "cos(th)")}]
            own += [{each: 1} for each in at if each.startswith("1/")]
            for each, row in more.items():
                assert len(row) == len(own)
                assert all(abs(entry - part.get(each, 0)) < arb((1, -50)) for entry, part in zip(row, own, strict=True))


def test_the_length_of_the_plan_is_that_of_the_longest_rate() -> None:
    equations = equations_of()
    phase = MechanismPhase(equations, "stick")
    step = series_step(equations.run_names("stick"))
    found = phase.chosen(step, UNIT)
    curves = dict(zip(phase.names, found.solution, strict=True))
    rates = equations.phases["stick"].rates
    degrees = [
        sum(
            int(power) * curves[n].degree() for n, power in zip(equations.mechanism.names, powers, strict=True) if power
        )
        for name in phase.names
        for powers in rates[name].to_dict()
    ]
    assert found.plan.length == max(degrees) + 1
    assert (found.plan.ends, found.plan.margins, found.plan.disc) == (step.plan.ends, step.plan.margins, 5)


def test_coefficients_are_rounded_to_the_next_unit() -> None:
    quarters = [-7, -5, -3, -2, -1, 0, 1, 2, 3, 4, 5, 7]
    found = _cut([arb((q, -12)) for q in quarters], 10)
    assert [found[i] for i in range(len(quarters))] == [arb((n, -10)) for n in (-2, -1, -1, 0, 0, 0, 0, 1, 1, 1, 1, 2)]


def test_the_divisor_of_stick_begins_with_it() -> None:
    states = {"sin(th)": arb(0.25), "cos(th)": arb(-0.5), PLACE: arb(2)}
    MechanismPhase(equations_of(), "slip").enter(states)
    assert SLIDE not in states
    MechanismPhase(equations_of(), "stick").enter(states)
    assert abs(states[SLIDE] - 1 / (2.5 * arb(0.625) ** 2)) < 1e-12


def test_states_of_a_phase() -> None:
    run = (PLACE, "th_dot", Y, V, Z)
    for name in ("slip", "reverse slip", "flight"):
        assert MechanismPhase(equations_of(), name).names == (*run, INVERSE, "cos(th)", "sin(th)")
    assert MechanismPhase(equations_of(), "stick").names == (*run, SLIDE, INVERSE, "cos(th)", "sin(th)")
    rod = MechanismEquations(load_scene("rod"))
    assert MechanismPhase(rod, "slip").resting == []
    assert MechanismPhase(rod, "flight").resting == ["X_dot", "theta_dot"]
    rod.kept.add("Y_dot")
    with pytest.raises(NotPolynomial, match="need the state Y_dot, which the run does not follow"):
        MechanismPhase(rod, "slip")


def test_the_phase_after_an_event() -> None:
    writer = MechanismWriter(scene(), None, 100)  # type: ignore[arg-type]
    at = {"sin(th)": arb(0), "cos(th)": arb(0.25), "th_dot": arb(1)}  # u = 1/4
    turned = at | {"th_dot": arb(-1)}
    assert writer.after("flight", "touch-down", at) == "slip"
    assert writer.after("flight", "touch-down", turned) == "reverse slip"
    after = {"lift-off": "flight", "stick": "stick", "slip forwards": "slip", "slip backwards": "reverse slip"}
    for event, name in after.items():
        assert writer.after("slip", event, {}) == name
    slides = MechanismWriter(scene().with_effects(drop=("stick",)), None, 100)  # type: ignore[arg-type]
    assert slides.after("flight", "touch-down", turned) == "slip"
