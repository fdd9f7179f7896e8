"""The equations that the checker of runs writes down against those of the library, which share nothing with them.

Page: proofs/run_certificate.md, section 1.
"""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from must_reject import runs, short_runs

from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

model: Any = runs.part("model")
limits: Any = runs.part("limits")
intervals: Any = runs.part("intervals")
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


ALL = ["compliant_contact", "lift_off", "stick", "tangential_motion", "two_way_coupling"]
KEYS = ("effects", "epsilon", "until", "parameters", "start")
STICKS: dict[str, Any] = short_runs.stick()[0]["statement"]
SLIDES = {
    "effects": ["compliant_contact", "tangential_motion"],
    "parameters": {name: v for name, v in STICKS["parameters"].items() if name not in ("k_minus", "p_minus", "chi")},
}


def scene_of(**change: Any) -> Any:
    return model.Scene(*((STICKS | change)[key] for key in KEYS))


def of_stick(**change: str) -> dict[str, Any]:
    return {"parameters": STICKS["parameters"] | change}


def from_start(**change: str) -> dict[str, Any]:
    return {"start": STICKS["start"] | change}


LONG = "1" * 400
NONE, HELD = "not some of those known, in order", "friction may end a stick"


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"effects": ["lift_off"]}, "not compliant"),
        ({"effects": "compliant_contact"}, NONE),
        ({"effects": {"compliant_contact": 0}}, NONE),
        ({"effects": ["compliant_contact", ["stick"]]}, NONE),
        ({"effects": ["compliant_contact", "wind"]}, NONE),
        ({"effects": ["lift_off", "compliant_contact"]}, NONE),
        ({"effects": ["compliant_contact", "compliant_contact"]}, NONE),
        ({"effects": ["compliant_contact", "stick"]}, "stick without tangential motion"),
        ({"until": "0"}, "ε or the time is not positive"),
        ({"until": "-1"}, "ε or the time is not positive"),
        ({"epsilon": "0"}, "ε or the time is not positive"),
        ({"epsilon": LONG + "1"}, "a number of the scene has more than 400 characters"),
        ({"epsilon": 1}, "a number of the scene has more than 400 characters"),
        ({"parameters": {"beta": "1"}}, "has not the keys|have not the keys"),
        *((of_stick(**{name: "0"}), "a stiffness or the damping") for name in ("damping", "k_1", "k_2")),
        (of_stick(k_plus="0"), HELD),
        (of_stick(k_plus="1/2"), HELD),
        (of_stick(k_minus="0"), HELD),
        (of_stick(a="1"), HELD),
        (of_stick(a="-1"), HELD),
        (from_start(z="-1/4"), "not in contact and slip"),
        (from_start(z="-1"), "not in contact and slip"),
        (from_start(u="0"), "not in contact and slip"),
        (SLIDES | from_start(u="-1"), "not in contact and slip"),
    ],
)
def test_a_scene_that_is_none(change: dict[str, Any], why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        scene_of(**change)


def test_a_number_that_is_as_long_as_it_may_be() -> None:
    assert scene_of(until=LONG).until == Fraction(LONG)


def test_a_slip_that_is_driven() -> None:
    """Without stick a is free: u' = ε (a + k⁺ k₂ (Z - Y)), eq. udot."""
    parameters = SLIDES["parameters"] | {"a": "5/7", "k_plus": "3", "k_2": "11"}  # type: ignore[operator]
    system = scene_of(effects=SLIDES["effects"], parameters=parameters).system("slip")
    assert system.rates["u"] == {(): Fraction(5, 14), ("Z",): Fraction(33, 2), ("Y",): Fraction(-33, 2)}


def test_short_runs_are_proved() -> None:
    for lines in (short_runs.one(), short_runs.flight(), short_runs.stick()):
        assert runs.verdict(lines).startswith("VERIFIED")


def test_the_start_in_units_of_epsilon() -> None:
    numbers = intervals.Numbers(64, limits.Meter(limits.Limits(), 10**9))
    found = scene_of(epsilon="1/4", **from_start(v="1/2", z="1/2")).first_box(numbers)
    exact = {"Y": -4, "V": 2, "Z": 8, "T": 0, "b": 3, "p": Fraction(-1, 2), "u": Fraction(1, 8)}
    assert found == {name: (value * 2**64,) * 2 for name, value in exact.items()}


@pytest.mark.parametrize(
    ("event", "u", "found"),
    [
        ("lift-off", (0, 0), ("flight", "touch-down", 1)),
        ("stick", (-1, 1), ("stick", "", 0)),
        ("touch-down", (1, 5), ("slip", "lift-off", 1)),
        ("touch-down", (-5, -1), ("reverse slip", "lift-off", 1)),
        ("touch-down", (0, 0), ("stick", "lift-off", 1)),
        ("touch-down", (0, 1), None),
        ("touch-down", (-1, 0), None),
        ("touch-down", (-1, 1), None),
    ],
)
def test_the_phase_after_an_event(event: str, u: tuple[int, int], found: tuple[str, str, int] | None) -> None:
    box = {"u": u}
    if found is None:
        with pytest.raises(limits.Rejected, match="the direction of slip at touch-down is not certain"):
            scene_of().after(event, box, None)
        return
    assert scene_of().after(event, box, None) == found
    assert box == {"u": (0, 0) if event == "stick" else u}
    if found[0] != "slip" and event == "touch-down":
        with pytest.raises(limits.Rejected, match="the direction of slip at touch-down is not certain"):
            scene_of(**SLIDES).after(event, box, None)


def test_without_a_velocity_there_is_slip() -> None:
    assert scene_of().begin({}, None) == ("slip", "", 0)
    assert scene_of().after("touch-down", {}, None) == ("slip", "lift-off", 1)


@pytest.mark.parametrize(
    ("phase", "functions", "endings"),
    [
        ("slip", {"lift-off": {"Z": 1, "Y": -1}, "stick": {"u": 1}}, ["lift-off", "stick"]),
        ("reverse slip", {"lift-off": {"Z": 1, "Y": -1}, "stick": {"u": -1}}, ["lift-off", "stick"]),
        ("stick", {"lift-off": {"Z": 1, "Y": -1}}, ["lift-off"]),
        ("flight", {"touch-down": {"Y": 1, "Z": -1}}, ["touch-down"]),
    ],
)
def test_the_table_of_events(phase: str, functions: dict[str, Any], endings: list[str]) -> None:
    system = scene_of().system(phase)
    assert {name: event.form for name, event in system.events.items()} == functions
    assert system.endings == endings
    assert scene_of(**SLIDES).system("slip").endings == []


def test_what_is_said_of_effects_that_are_left_out() -> None:
    force, slip = (f"{sign} all along, as leaving an effect out assumes" for sign in ("λ_N > 0", "u > 0 in contact"))
    assert scene_of().seen() == []
    assert scene_of(**SLIDES).seen() == [force, slip]
    assert model.Scene(*(short_runs.one()[0]["statement"][key] for key in KEYS)).seen() == [force]
    assert model.Scene(*(short_runs.flight()[0]["statement"][key] for key in KEYS)).seen() == []


def test_the_words_of_a_scene() -> None:
    assert scene_of().words() == (
        "the model system with compliant_contact, lift_off, stick, tangential_motion, two_way_coupling, ε = 1/2, "
        "a = 0, alpha_1 = -1, alpha_2 = -6, beta = 1, chi = 1/4, damping = 1, k_1 = 1, k_2 = 1, k_minus = 2, "
        "k_plus = -1, p_minus = 1/2, from b = 3, p = -1/2, u = 1/8, v = 0, y = -1/4, z = 0"
    )


x, y = model.state("x"), model.state("y")


def test_polynomials() -> None:
    p = model.number(3) * x * x * y - model.number(Fraction(1, 2)) * y + model.number(5)
    assert p == {("x", "x", "y"): 3, ("y",): Fraction(-1, 2), (): 5}
    assert y * x == x * y == {("x", "y"): 1}
    assert p.by("x") == {("x", "y"): 6}
    assert p.by("y") == {("x", "x"): 3, (): Fraction(-1, 2)}
    assert p.by("z") == p - p == model.number(0) == {}
    assert model.along(p, {"x": y, "y": model.number(2)}) == {("x", "y", "y"): 6, ("x", "x"): 6, (): -1}
    box = {"x": (2**64, 2**65), "y": (-(2**64), 2**64)}
    assert p.on(box, intervals.Numbers(64, limits.Meter(limits.Limits(), 10**9))) == (
        5 * 2**64 - 12 * 2**64 - 2**63,
        5 * 2**64 + 12 * 2**64 + 2**63,
    )


@pytest.mark.parametrize(
    ("function", "form"),
    [
        (x - y, {"x": 1, "y": -1}), (x + x, {}), (x * y, {}), (x + model.number(1), {}),
        (model.number(Fraction(1, 2)) * x + y, {}),
    ],
)  # fmt: skip
def test_sums_of_states(function: Any, form: dict[str, int]) -> None:
    event = model.Event(function, {"x": x * y, "y": model.number(3)})
    assert event.form == form
    assert event.curvature == model.along(model.along(function, event.rates), event.rates)


def with_terms(count: int) -> Any:
    return model.Polynomial({(f"x{i}",): Fraction(1) for i in range(count)})


def test_limits_of_polynomials() -> None:
    assert len(with_terms(50) * model.Polynomial({("y",) * i: Fraction(1) for i in range(40)})) == 2000
    high = model.Polynomial({("x",) * 39: Fraction(1)})
    assert high * x == {("x",) * 40: 1}
    long = model.Polynomial({(): Fraction(2**3999)})
    short = model.Polynomial({(): Fraction(1, 2**3998)})
    assert long + x
    assert short * model.number(Fraction(1, 2)) == {(): Fraction(1, 2**3999)}
    with pytest.raises(limits.Rejected, match="has too many terms"):
        with_terms(3) * with_terms(667)
    for left, right in (high * x, x), (long, model.number(2)), (short, model.number(Fraction(1, 4))):
        with pytest.raises(limits.Rejected, match="too high a degree, or too long a number"):
            left * right
