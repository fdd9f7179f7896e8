"""The equations of mechanisms that the checker derives against those of the library, and what it refuses.

Page: proofs/run_certificate.md, section 1a.
"""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any

import pytest
from flint import arb, fmpq
from must_reject import runs
from samples.checker_models import at_balls

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.derive.to_system import angle_ball
from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.certificates.polynomial_mechanism import PolynomialMechanism
from gspot_verified.scenes.certified.certified_phase import CertifiedPhase
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

mechanism: Any = runs.part("mechanism")
intervals: Any = runs.part("intervals")
limits: Any = runs.part("limits")
PHASES = [("rod", phase) for phase in ("slip", "reverse slip", "stick", "flight")]
PHASES += [("oscillator", phase) for phase in ("slip", "flight")]
SCALED = {"Y": mechanism.Y, "V": mechanism.V, "Z": mechanism.Z}
KEYS = ("mechanism", "effects", "epsilon", "until", "parameters", "start")


def scene_of(*given: Any) -> Any:
    return mechanism.MechanismScene(*given, limits.Meter(limits.Limits(), 10**9))


def checkers(scene: Scene) -> Any:
    """The scene as the checker reads it."""
    assert scene.mechanism is not None
    polynomials = PolynomialMechanism(scene.mechanism)
    values = {name: str(scene.values()[name]) for name in ("damping", "k_1", "k_2")}
    start = {polynomials.place.get(name, name): str(value) for name, value in scene.initial().items()}
    effects = sorted(scene.effects)
    return scene_of(polynomials.given, effects, str(scene.epsilon), str(scene.until), values, start)


@pytest.mark.parametrize(("name", "phase"), PHASES)
def test_rates_and_events(name: str, phase: str) -> None:
    """At random states: polynomials of sine, cosine and divisor against functions of the angle."""
    scene = load_scene(name, epsilon="1/30", k_1="2/3", k_2="9/7", damping="5/4")
    found = checkers(scene)
    system, chance = found.systems[phase], random.Random(3)
    assert scene.mechanism is not None
    (angle,) = scene.mechanism.angles
    q, place = angle.coordinate, found.mechanism.place[angle.coordinate]
    with working_bits(200):
        library = CertifiedPhase(scene.system(phase))
        values = [fmpq(chance.randint(-9, 9), chance.randint(3, 9)) for _ in library.names]
        at = {
            SCALED.get(each, found.mechanism.place.get(each, each)): arb(v)
            for each, v in zip(library.names, values, strict=True)
        }
        whole = at[place] + angle_ball(angle)
        at |= {f"sin({q})": whole.sin(), f"cos({q})": whole.cos()}
        at[mechanism.INVERSE] = 1 / at_balls(system.motion.minors[-1], at)
        if system.motion.divisor:
            at[mechanism.SLIDE] = 1 / at_balls(system.motion.divisor, at)
        rates, _ = library.field.on_box([arb(v) for v in values])
        for each, rate in zip(library.names, rates, strict=True):
            own = SCALED.get(each, found.mechanism.place.get(each, each))
            if own in system.names:
                assert_same(rate, at_balls(system.rates[own], at))
        for event in library.system.events:
            own = {"slip stops": "stick"}.get(event.name, event.name)
            factor = arb(1) if own == "stick" else 1 / arb(fmpq(9, 7))  # k_2: the library has the force for Z - Y
            factor = at_balls(system.motion.minors[-1], at) if own in ("slip forwards", "slip backwards") else factor
            assert own in system.events
            assert_same(factor * of_library(event.function, values), at_balls(system.events[own].function, at))
    assert len(system.events) == len(library.system.events)


def of_library(function: Any, values: list[fmpq]) -> arb:
    return BoxProgram([function], len(values)).values([arb(v) for v in values])[0]


def assert_same(one: arb, two: arb) -> None:
    assert one.is_finite()
    assert two.is_finite()
    assert abs(one - two) < arb(2) ** -150


def statement() -> dict[str, Any]:
    found: dict[str, Any] = runs.rod()[0]["statement"]
    return found


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"effects": ["lift_off"]}, "not compliant"),
        ({"effects": ["compliant_contact", "stick"]}, "stick without tangential motion"),
        ({"effects": ["belt", "compliant_contact", "tangential_motion"]}, "on a belt"),
        ({"effects": ["compliant_contact", "two_way_coupling"]}, "not some of those known"),
        ({"until": "0"}, "the time is not positive"),
        ({"parameters": {"damping": "1", "k_1": "0", "k_2": "1"}}, "is not > 0"),
        ({"start": {"z": "-1"}}, "not in contact"),
        ({"start": {"X": "0"}}, "has not the keys|have not the keys"),
    ],
)  # fmt: skip
def test_a_scene_that_is_none(change: dict[str, Any], why: str) -> None:
    given = statement()
    change |= {"start": given["start"] | change.get("start", {})}
    with pytest.raises(limits.Rejected, match=why):
        scene_of(*((given | change)[key] for key in KEYS))


@pytest.mark.parametrize("name", ["M", "T", "damping", "f", "k_1", "k_2", "t", "u", "v", "x", "y", "z"])
def test_a_coordinate_with_a_name_that_the_statement_has_for_something_else(name: str) -> None:
    """Whoever reads "f = (..., -1*x), x = 1*X" would take the contact's x for the coordinate."""
    given = {"coordinates": ["X", "Y", name], "angles": {}, "x": "1*X"}
    with pytest.raises(limits.Rejected, match="no name of a coordinate"):
        mechanism.Mechanism(statement()["mechanism"] | given)


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"coordinates": ["X", "T", "theta"]}, "no name of a coordinate"),
        ({"coordinates": ["X", "Y", "theta_dot"]}, "no name of a coordinate"),
        ({"coordinates": ["X", "X", "theta"]}, "two coordinates have one name"),
        ({"angles": {"theta": ["3/5", "3/5"]}}, "do not add to 1"),
        ({"angles": {"phi": ["3/5", "4/5"]}}, "not coordinates"),
        ({"forces": ["0", "1*sin(theta)^2", "0"]}, "has a name that it cannot have"),
        ({"forces": ["0", "-3/5"]}, "the number of forces"),
        ({"forces": ["0", "0" + " + 0" * 300, "0"]}, "more than 1000 characters"),
        ({"mass_matrix": [["1", "1*X_dot", "0"], ["0", "1", "0"], ["0", "0", "1"]]}, "cannot have"),
        ({"mass_matrix": [["1", "0", "1/9"], ["0", "1", "0"], ["0", "0", "1"]]}, "not symmetric"),
        ({"mass_matrix": [["0", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]}, "det M is 0"),
        ({"mu": "-1/2"}, "μ < 0"),
        ({"x": "1"}, "A is 0"),
        ({"y": "1*sin(theta)"}, "y has no coordinate"),
        ({"y": "1*Y*theta"}, "cannot have"),
        ({"y": "1*Y + 1*Y*Y"}, "y has no coordinate"),
    ],
)  # fmt: skip
def test_a_mechanism_that_is_none(change: dict[str, Any], why: str) -> None:
    given = statement()
    scene = given | {"mechanism": given["mechanism"] | change}
    with pytest.raises(limits.Rejected, match=why):
        scene_of(*(scene[key] for key in KEYS))


def test_a_velocity_that_nothing_sees_may_end_to_exist() -> None:
    given = statement()
    changed = {"forces": ["1*X_dot*X_dot", "-3/5", "0"], "x": "1*X", "mu": "0"}
    start = {name: value for name, value in given["start"].items() if name != "X_dot"}
    scene = given | {
        "mechanism": given["mechanism"] | changed,
        "effects": ["belt", "compliant_contact"],
        "start": start,
    }
    with pytest.raises(limits.Rejected, match="may be one that ends to exist"):
        scene_of(*(scene[key] for key in KEYS))


def test_masses_are_positive_at_the_start() -> None:
    given = statement()
    rows = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "-1/3"]]
    scene = scene_of(*((given | {"mechanism": given["mechanism"] | {"mass_matrix": rows}})[key] for key in KEYS))
    numbers = intervals.Numbers(128, limits.Meter(limits.Limits(), 10**9))
    with pytest.raises(limits.Rejected, match="not certainly positive definite"):
        scene.first_box(numbers)


def test_many_terms_end_soon() -> None:
    """Each formula is within its limit, their products are not."""
    n = range(4)
    long = " + ".join(f"{i}/41{'*sin(a)' * (i % 6)}{'*b' * (i // 6)}" for i in range(1, 31))
    rows = [[long if i == j else "1*cos(a)" for j in n] for i in n]
    given = {"angles": {}, "coordinates": ["a", "b", "c", "d"], "forces": [long] * 4, "mass_matrix": rows, "mu": "1",
             "x": "1*sin(a)", "y": "1*d"}  # fmt: skip
    with pytest.raises(limits.Rejected, match="a product of two polynomials has too many terms"):
        mechanism.Mechanism(given)


def test_what_terms_become_is_paid() -> None:
    """A velocity that stands for 29 terms, twice in each of 45 terms of a force."""
    names = ["sin(a)", "cos(a)", "sin(b)", "cos(b)", "sin(c)", "cos(c)", "a", "b", "c"]
    pairs = list(combinations_with_replacement(names, 2))
    force = " + ".join(f"{i + 2}*{'*'.join(pairs[i * 7 % 45])}*d_dot*d_dot" for i in range(30))
    given = {"angles": {}, "coordinates": ["a", "b", "c", "d"], "forces": [force] * 4, "mu": "1", "x": "1*a",
             "mass_matrix": [["1" if i == j else "0" for j in range(4)] for i in range(4)],
             "y": " + ".join(["1*d", *(f"{i + 2}*{'*'.join(pairs[i * 5 % 45])}" for i in range(14))])}  # fmt: skip
    lines = runs.rod()
    lines[0]["statement"]["mechanism"] = given
    assert "out of the checker's range: the limit work" in runs.verdict(lines[:2])


@pytest.mark.parametrize("z", ["0", "1/1000"])
def test_a_force_that_is_0_at_the_start_is_not_said_to_be_positive(z: str) -> None:
    given = statement()
    scene = given | {"effects": ["compliant_contact", "tangential_motion"], "start": given["start"] | {"z": z}}
    begins = " after the start, where it is 0" * (z == "0")
    said = scene_of(*(scene[key] for key in KEYS)).seen()[0]
    assert said == f"λ_N > 0 all along{begins}, as leaving an effect out assumes"


def test_the_start_is_on_the_circle() -> None:
    scene = checkers(load_scene("rod"))
    numbers = intervals.Numbers(192, limits.Meter(limits.Limits(), 10**9))
    box = scene.first_box(numbers)
    with working_bits(300):
        angle = load_scene("rod").mechanism.angles[0]
        whole = angle_ball(angle) - arb(1) / 10
        for name, exact in (("sin(theta)", whole.sin()), ("cos(theta)", whole.cos())):
            low, high = box[name]
            assert arb(low) / numbers.one < exact
            assert exact < arb(high) / numbers.one
            assert 0 < high - low < 400


def test_order_of_contact_at_the_start() -> None:
    """y = v = z = 0: the force and its first derivative are 0; with a velocity it is the derivative that decides."""
    given = statement()
    numbers = intervals.Numbers(128, limits.Meter(limits.Limits(), 10**9))
    for start, order in (({}, ("lift-off", 2)), ({"v": "-1/10"}, ("lift-off", 1)), ({"y": "-1/100"}, ("", 0))):
        scene = scene_of(*((given | {"start": given["start"] | start})[key] for key in KEYS))
        assert scene.begin(scene.first_box(numbers), numbers) == ("slip", *order)


def test_words_hold_the_formulas() -> None:
    words = checkers(load_scene("oscillator")).words()
    assert "M = (1, 1*sin(phi); 1*sin(phi), 2)" in words
    assert "sin(phi_ref) = 4/5, cos(phi_ref) = 3/5" in words
    assert "x = 1*sin(phi), y = -1*cos(phi) + 1*psi + 1, μ = 25/12" in words
    assert Fraction(25, 12) == checkers(load_scene("oscillator")).mechanism.mu
