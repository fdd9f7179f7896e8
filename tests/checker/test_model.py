"""The equations that the checker of runs writes down against those of the library, which share nothing with them.

Page: proofs/run_certificate.md, section 1.
"""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from must_reject import runs

from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

model: Any = runs.part("model")
limits: Any = runs.part("limits")
EXTENDED = {"chi": "2/3", "k_plus": "-3/4", "k_minus": "7/5", "p_minus": "4/3", "nu": "1/3"}
OF_ALL = {
    "damping": "5/4",
    "k_1": "2/3",
    "k_2": "9/7",
    "alpha_1": "-6/5",
    "alpha_2": "-4/7",
    "beta": "8/5",
    "epsilon": "1/30",
}
PHASES = [("fig-varsim1", phase) for phase in ("slip", "flight")]
PHASES += [("fig-varsim2", phase) for phase in ("slip", "reverse slip", "stick", "flight")]


def checkers(scene: Scene) -> Any:
    """The scene as the checker reads it."""
    values = {name: str(value) for name, value in scene.values().items()}
    start = {name: str(value) for name, value in scene.initial().items()}
    return model.Scene(sorted(scene.effects), str(scene.epsilon), str(scene.until), values, start)


def exact(polynomial: Any, at: dict[str, Fraction]) -> Fraction:
    """A polynomial of the checker at a point."""
    total = Fraction(0)
    for key, value in polynomial.items():
        for name in key:
            value *= at[name]
        total += value
    return total


@pytest.mark.parametrize(("name", "phase"), PHASES)
def test_rates_derivatives_and_events(name: str, phase: str) -> None:
    scene = load_scene(name, **OF_ALL, **(EXTENDED if name == "fig-varsim2" else {}))
    system = model.System(checkers(scene), phase)
    chance = random.Random(5)
    with working_bits(200):
        library = CertifiedPhase(scene.system(phase))
        names = ["T" if each == CLOCK else each for each in library.names]
        assert sorted(names) == system.names
        for _ in range(5):
            at = {each: Fraction(chance.randint(-9, 9), chance.randint(1, 9)) for each in names}
            values, rows = library.field.on_box([arb(fmpq(at[each].numerator, at[each].denominator)) for each in names])
            for i, state in enumerate(names):
                assert_holds(values[i], exact(system.rates[state], at))
                for j, other in enumerate(names):
                    here = system.jacobian[system.names.index(state)][system.names.index(other)]
                    assert_holds(rows[i][j], exact(here, at))
    assert set(system.events) == {event.name for event in library.system.events}
    for event in system.events.values():
        along = sum((sign * exact(system.rates[state], at) for state, sign in event.form.items()), Fraction(0))
        assert exact(event.rate, at) == along


def assert_holds(ball: arb, value: Fraction) -> None:
    assert ball.is_finite()
    assert ball.rad() < arb(2) ** -150
    assert abs(ball - arb(fmpq(value.numerator, value.denominator))) < arb(2) ** -150


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"effects": ["lift_off"]}, "not compliant"),
        ({"effects": ["compliant_contact", "stick"]}, "stick without tangential motion"),
        ({"until": "0"}, "ε or the time is not positive"),
        ({"parameters": {"beta": "1"}}, "has not the keys|have not the keys"),
        ({"start": {"b": "1", "p": "1", "v": "0", "y": "0", "z": "0"}}, "not in contact and slip"),
    ],
)
def test_a_scene_that_is_none(change: dict[str, Any], why: str) -> None:
    statement = runs.flight()[0]["statement"] | change
    with pytest.raises(limits.Rejected, match=why):
        model.Scene(*(statement[key] for key in ("effects", "epsilon", "until", "parameters", "start")))
