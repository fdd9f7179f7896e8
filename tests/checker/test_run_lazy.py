"""Files of provers that cheat or are lazy: consistent but for one rule. The checker without that rule accepts them.

Page: proofs/run_certificate.md.
"""

from __future__ import annotations

import copy
import dataclasses
import itertools
from collections.abc import Callable, Sequence
from typing import Any

import pytest
from flint import arb, arb_mat, arb_poly
from must_reject import runs

from gspot_verified.integrator.norm_steps import taylor_curve
from gspot_verified.integrator.norm_steps.norm_step import UNIT_INTERVAL, NormStep
from gspot_verified.scenes.certificates import bounded_step, run_writer
from gspot_verified.scenes.certificates.run_certificate import certified_with_steps
from gspot_verified.scenes.certified.certified_phase import CertifiedPhase
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

Patch = pytest.MonkeyPatch
FLIGHT = {"beta": "3/2", "nu": "2", "epsilon": "1/20"}  # lift-off at 0.753, touch-down at 1.27
BOUNCE = {
    "damping": "100", "p": "2", "b": "-1", "y": "-1/1000", "z": "0", "v": "1/5",
    "epsilon": "1/20", "alpha_1": "-1/10", "alpha_2": "-1/10",
}  # fmt: skip


def written(name: str, **settings: str) -> runs.Lines:
    run, text, why = certified_with_steps(load_scene(name, **settings))
    assert text is not None, f"{why}: {run}"
    return runs.lines_of(text)


def without_event(patch: Patch, name: str) -> None:
    """A library that does not see an event."""
    true = Scene.system

    def system(self: Scene, phase: str, *others: Any) -> ScaledSystem:
        found = true(self, phase, *others)
        return dataclasses.replace(found, events=tuple(e for e in found.events if e.name != name))

    patch.setattr(Scene, "system", system)


def wide_brackets(patch: Patch, earlier: arb) -> None:
    """Brackets that begin too early, by so much of a step."""
    true = run_writer.RunWriter._first

    def first(self: Any, value: Callable[[arb], arb], middle: arb, side: int) -> arb:
        return true(self, value, middle - (earlier if side < 0 else 0), side)

    patch.setattr(run_writer.RunWriter, "_first", first)


def long_steps(patch: Patch) -> None:
    for name, value in (("_FIRST_LENGTH", 4.0), ("_ORDER_PER_BIT", 1.0), ("_LARGEST_SUM_BITS", 12)):
        patch.setattr(taylor_curve, name, value)


def no_lift_off(patch: Patch) -> runs.Lines:
    without_event(patch, "lift-off")
    return written("fig-varsim1", **FLIGHT, until="77/100")


def no_touch_down(patch: Patch) -> runs.Lines:
    without_event(patch, "touch-down")
    return written("fig-varsim1", **FLIGHT, until="9/5")


def no_stick(patch: Patch) -> runs.Lines:
    without_event(patch, "stick")
    return written("fig-varsim2", nu="4", u="1", epsilon="1/5", until="1/2")


def states_at_the_left_end(patch: Patch) -> runs.Lines:
    """A flight that begins with the states at the beginning of a wide bracket alone."""
    wide_brackets(patch, arb(2) ** -14)
    true = NormStep.enclosure

    def enclosure(self: NormStep, tau: arb = UNIT_INTERVAL) -> list[arb]:
        is_bracket = not tau.is_exact() and tau.rad() < arb(2) ** -14
        return true(self, tau.lower() if is_bracket else tau)

    patch.setattr(NormStep, "enclosure", enclosure)
    return written("fig-varsim1", **FLIGHT, until="77/100")


def time_at_the_left_end(patch: Patch) -> runs.Lines:
    """The same with the time alone: the third hull of an event is that of its time."""
    wide_brackets(patch, arb(2) ** -14)
    true, calls = run_writer.hull, itertools.count()

    def hull(ends: Sequence[arb]) -> arb:
        return true(ends if next(calls) % 3 < 2 else (ends[0], ends[0] + arb(2) ** -200))

    patch.setattr(run_writer, "hull", hull)
    return written("fig-varsim1", **FLIGHT, until="77/100")


def another_event_in_the_bracket(patch: Patch) -> runs.Lines:
    """The contact sticks just before it would lift off; the bracket of lift-off begins before both."""
    without_event(patch, "stick")
    wide_brackets(patch, arb(2) ** -5)
    return written("fig-varsim2", nu="4", u="98.01008", epsilon="1/5", until="13/10")


def bounce_in_the_first_step(patch: Patch) -> runs.Lines:
    """After touch-down the surface pulls and pushes again; its first step ends where it pushes."""
    true = CertifiedPhase.run

    def run(self: CertifiedPhase, start: Any, time: arb, at_zero: Any, *others: Any) -> Any:
        phase = copy.copy(self)
        if "lift-off" in at_zero:
            phase.system, at_zero = dataclasses.replace(self.system, events=()), {}
        return true(phase, start, time, at_zero, *others)

    patch.setattr(CertifiedPhase, "run", run)
    long_steps(patch)
    return written("fig-varsim1", **BOUNCE, until="63/100")


def radii_forgotten(patch: Patch) -> runs.Lines:
    patch.setattr(bounded_step, "block_norms", lambda _, left, right: arb_mat(len(left.blocks), len(right.blocks)))
    return written("fig-varsim1", **FLIGHT, until="77/100")


def jumps_forgotten(patch: Patch) -> runs.Lines:
    """Each curve begins a little above the last one's end."""
    true = run_writer.bounded_step

    def lazy(field: Any, names: Any, chosen: Any, h: arb, before: Any, start: Any, bits: Any) -> Any:
        if before is not None:
            raised = [p + arb_poly([arb(2) ** -40]) for p in chosen.solution]
            chosen = dataclasses.replace(chosen, solution=tuple(raised))
            start = [p(arb(0)) for p in raised]
        return true(field, names, chosen, h, before, start, bits)

    patch.setattr(run_writer, "bounded_step", lazy)
    return written("fig-varsim1", **FLIGHT, until="1/2")


def small_defect(patch: Patch) -> runs.Lines:
    true = bounded_step.defect_bounds
    patch.setattr(bounded_step, "defect_bounds", lambda *given: [value / 512 for value in true(*given)])
    return written("fig-varsim1", **FLIGHT, until="1/2")


def half_of_the_growth(patch: Patch) -> runs.Lines:
    true = bounded_step.growth_rates
    patch.setattr(bounded_step, "growth_rates", lambda *given: true(*given) / 2)
    return written("fig-varsim1", **FLIGHT, until="1/2")


def short_of_the_end(_: Patch) -> runs.Lines:
    lines = written("fig-varsim1", **FLIGHT, until="1/2")
    lines[0]["statement"]["until"] = "51/100"
    return lines


EXCLUSION = 'require(positive(step, watched, since, until), f"{name} in {self.phase} is not excluded")'
CURVE = "curve = Curve(self.numbers, system, h, unit, x)"
RISES = "if rises and step.value(event, tau, tau)[0] > 0:"
RULES: dict[Callable[[Patch], runs.Lines], tuple[str, str]] = {
    no_lift_off: (EXCLUSION, "pass"),
    no_touch_down: (EXCLUSION, "pass"),
    no_stick: (EXCLUSION, "pass"),
    states_at_the_left_end: ("step.states(left, right))", "step.states(left, left))"),
    time_at_the_left_end: ("self.clock = step.time(left, right)", "self.clock = step.time(left, left)"),
    another_event_in_the_bracket: ("left if name == event else right", "left"),
    bounce_in_the_first_step: (RISES, "if step.value(event, tau, tau)[0] > 0:"),
    radii_forgotten: ("        if before is not None:\n            turned", "        if False:\n            turned"),
    jumps_forgotten: (CURVE, f"{CURVE}; start = start if before is None else curve.start"),
    small_defect: ("+ rest, common << self", "+ rest, 1024 * common << self"),
    half_of_the_growth: ("scaled = [[up(entry * h, one)", "scaled = [[up(entry * h, 2 * one)"),
    short_of_the_end: (" and self.clock[0] * unit >= self.scene.until", ""),
}  # fmt: skip


QUICK = {states_at_the_left_end, another_event_in_the_bracket, bounce_in_the_first_step}
CASES = [pytest.param(lazy, marks=[] if lazy in QUICK else pytest.mark.slow) for lazy in RULES]


@pytest.mark.parametrize("lazy", CASES, ids=lambda lazy: lazy.__name__)
def test_each_is_rejected_by_one_rule(lazy: Callable[[Patch], runs.Lines], monkeypatch: Patch) -> None:
    lines = lazy(monkeypatch)
    said = runs.verdict(lines)
    assert said.startswith("REJECTED"), said
    without = runs.verdict(lines, runs.changed(RULES[lazy]))
    assert without.startswith("VERIFIED"), f"{said}; without the rule: {without}"
