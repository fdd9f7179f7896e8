"""Files of provers that cheat with a mechanism: consistent but for one rule. The checker without it accepts them.

Page: proofs/run_certificate.md, section 1a.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import pytest
from flint import arb, arb_series, fmpq
from must_reject import runs

from gspot_verified.numbers.balls import series_length
from gspot_verified.scenes.certificates import bounded_step
from gspot_verified.scenes.certificates.mechanism_writer import MechanismEquations, MechanismPhase
from gspot_verified.scenes.certificates.polynomial_mechanism import PolynomialMechanism
from gspot_verified.scenes.certificates.run_certificate import certified_with_steps
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

Patch = pytest.MonkeyPatch
LITTLE = fmpq(1, 10**20)  # far above the bounds of the errors, far below what a float shows


def written(scene: Scene) -> runs.Lines:
    run, text, why = certified_with_steps(scene)
    assert text is not None, f"{why}: {run}"
    return runs.lines_of(text)


def rod() -> Scene:
    return load_scene("rod", epsilon="1/20", until="1/50")


def without_event(patch: Patch, name: str) -> None:
    true = Scene.system

    def system(self: Scene, phase: str, *others: Any) -> ScaledSystem:
        found = true(self, phase, *others)
        return dataclasses.replace(found, events=tuple(e for e in found.events if e.name != name))

    patch.setattr(Scene, "system", system)


def bent(patch: Patch, name: str, rows: slice) -> None:
    """A curve that does not obey its equation, and a prover who does not look at it."""
    true, defects = MechanismPhase._curves, bounded_step.defect_bounds

    def curves(self: MechanismPhase, step: Any, length: int) -> dict[str, arb_series]:
        found = true(self, step, length)
        with series_length(length):
            return found | {name: found[name] + arb_series([0, 0, arb(LITTLE)], length)}

    def defect_bounds(*given: Any) -> list[arb]:
        found = defects(*given)
        assert found is not None
        found[rows] = [arb(0)] * len(found[rows])
        return found

    patch.setattr(MechanismPhase, "_curves", curves)
    patch.setattr(bounded_step, "defect_bounds", defect_bounds)


def a_rotation_that_is_not_verified(patch: Patch) -> runs.Lines:
    bent(patch, "sin(theta)", slice(-2, None))
    return written(rod())


def a_divisor_that_is_not_verified(patch: Patch) -> runs.Lines:
    bent(patch, "1/det M", slice(-3, -2))
    return written(load_scene("oscillator", epsilon="1/20", until="1/100"))


def off_the_circle(patch: Patch) -> runs.Lines:
    """Sine and cosine begin on a larger circle, and stay on it."""
    true = MechanismEquations.turned

    def turned(self: MechanismEquations, q: str, angle: Any) -> dict[str, Any]:
        return {name: value * arb(1 + LITTLE) for name, value in true(self, q, angle).items()}

    patch.setattr(MechanismEquations, "turned", turned)
    return written(rod())


def a_reference_off_the_circle(patch: Patch) -> runs.Lines:
    """The same, as the statement says it."""
    true = PolynomialMechanism.__init__

    def init(self: PolynomialMechanism, *given: Any) -> None:
        true(self, *given)
        pair = [value * (1 + LITTLE) for value in self.references["theta"]]
        self.references["theta"] = (pair[0], pair[1])
        self.given["angles"]["theta"] = [str(value) for value in pair]

    patch.setattr(PolynomialMechanism, "__init__", init)
    return written(rod())


def a_negative_mass(_: Patch) -> runs.Lines:
    """Of a coordinate on whose acceleration nothing depends that is followed."""
    lines = written(rod().with_effects(drop=("stick", "tangential_motion"), add=("belt",)))
    lines[0]["statement"]["mechanism"]["mass_matrix"][0][0] = "-1"
    return lines


def a_lift_off_at_the_start(patch: Patch) -> runs.Lines:
    """y = z and v > 0: the contact opens at once and soon closes again."""
    without_event(patch, "lift-off")
    patch.setattr(Scene, "first_phase", lambda _: "slip")
    return written(load_scene("rod", epsilon="1/20", until="1/50", y="0", z="0", v="1/20000"))


def no_slip_backwards(patch: Patch) -> runs.Lines:
    """The contact sticks where friction cannot hold it."""
    without_event(patch, "slip backwards")
    return written(load_scene("rod", epsilon="1/20", until="83/200"))


CURVE = "curve = Curve(self.numbers, system, h, unit, x)"
EACH = "        found = []\n        for name in self.names:\n"
SKIP = "            if name[:2] in {}:\n                found.append(0)\n                continue\n"
RULES: dict[Callable[[Patch], runs.Lines], tuple[str, str, str]] = {
    a_rotation_that_is_not_verified: ("run", EACH, EACH + SKIP.format('("si", "co")')),
    a_divisor_that_is_not_verified: ("run", EACH, EACH + SKIP.format('("1/",)')),
    off_the_circle: (
        "run",
        CURVE,
        f"{CURVE}; start = start | {{n: v for n, v in curve.start.items() if n[:3] in ('sin', 'cos')}}",
    ),
    a_reference_off_the_circle: ("mechanism", "require(sine**2 + cosine**2 == 1, ", "require(True, "),
    a_negative_mass: ("mechanism", "require(minor.on(box, numbers)[0] > 0, ", "require(True, "),
    a_lift_off_at_the_start: ("mechanism", "2 if event.rate.on(box, numbers) == (0, 0) else 1", "2"),
    no_slip_backwards: (
        "run",
        'require(positive(step, watched, since, until), f"{name} in {self.phase} is not excluded")',
        "pass",
    ),
}
QUICK = {a_reference_off_the_circle, a_negative_mass}
CASES = [pytest.param(lazy, marks=[] if lazy in QUICK else pytest.mark.slow) for lazy in RULES]


@pytest.mark.parametrize("lazy", CASES, ids=lambda lazy: lazy.__name__)
def test_each_is_rejected_by_one_rule(lazy: Callable[[Patch], runs.Lines], monkeypatch: Patch) -> None:
    lines = lazy(monkeypatch)
    said = runs.verdict(lines)
    assert said.startswith("REJECTED"), said
    name, *rule = RULES[lazy]
    without = runs.verdict(lines, runs.changed((rule[0], rule[1]), name=name))
    assert without.startswith("VERIFIED"), f"{said}; without the rule: {without}"
