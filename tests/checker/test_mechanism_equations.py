"""The equations of a mechanism of two coordinates against Newton's law, solved in rational numbers at single states.

Page: proofs/run_certificate.md, section 1a. M and A depend on the angle, so both divisors are states.
"""

from __future__ import annotations

import copy
import random
from fractions import Fraction
from typing import Any

import pytest
from must_reject import runs

mechanism: Any = runs.part("mechanism")
model: Any = runs.part("model")
intervals: Any = runs.part("intervals")
limits: Any = runs.part("limits")
KEYS = ("mechanism", "effects", "epsilon", "until", "parameters", "start")
STATEMENT: dict[str, Any] = {
    "mechanism": {
        "angles": {"a": ["3/5", "4/5"]}, "coordinates": ["a", "H"],
        "forces": ["2*a_dot*a_dot + -1*sin(a)", "-3/5 + 1/2*H + 1*H_dot*a_dot"],
        "mass_matrix": [["2 + 1*cos(a)", "1*sin(a)"], ["1*sin(a)", "3"]],
        "mu": "5/7", "x": "1*sin(a) + 2*(a-a_ref)", "y": "3*H + -1*cos(a)",
    },
    "effects": ["compliant_contact", "lift_off", "stick", "tangential_motion"], "epsilon": "1/4", "until": "1/2",
    "parameters": {"damping": "5/4", "k_1": "2/3", "k_2": "9/8"},
    "start": {"(a-a_ref)": "1/8", "a_dot": "1/2", "v": "-1/3", "y": "-1/16", "z": "1/32"},
}  # fmt: skip
PLACE, Y, V, Z, INVERSE, SLIDE = (
    "(a-a_ref)",
    *(getattr(mechanism, name) for name in ("Y", "V", "Z", "INVERSE", "SLIDE")),
)


def scene_of(formulas: dict[str, Any] | None = None, /, **change: Any) -> Any:
    given = copy.deepcopy(STATEMENT) | change
    given["mechanism"] |= formulas or {}
    return mechanism.MechanismScene(*(given[key] for key in KEYS), limits.Meter(limits.Limits(), 10**9))


def numbers(bits: int = 64) -> Any:
    return intervals.Numbers(bits, limits.Meter(limits.Limits(), 10**9))


def exact(polynomial: Any, at: dict[str, Fraction]) -> Fraction:
    total = Fraction(0)
    for key, value in polynomial.items():
        for name in key:
            value *= at[name]
        total += value
    return total


def newton(phase: str, at: dict[str, Fraction], eps: Fraction) -> tuple[dict[str, Fraction], dict[str, Fraction]]:
    """Rates and functions from (A) by Cramer's rule; H and its velocity from y = 3 H - cos a and v."""
    s, c, w = at["sin(a)"], at["cos(a)"], at["a_dot"]
    height, speed = (eps**2 * at[Y] + c) / 3, (eps * at[V] - s * w) / 3
    k_1, k_2, damping, mu = (Fraction(v) for v in ("2/3", "9/8", "5/4", "5/7"))
    force = k_2 * (at[Z] - at[Y]) * (phase != "flight")
    pushed = (2 * w**2 - s + force * s, Fraction(-3, 5) + height / 2 + speed * w + 3 * force)
    det, across, slide = 3 * (2 + c) - s**2, (c + 2, Fraction(0)), 3 * (c + 2) ** 2
    holding = -(across[0] * (3 * pushed[0] - s * pushed[1]) - det * s * w**2) / slide
    friction = {"slip": -mu * force, "reverse slip": mu * force, "stick": holding}.get(phase, Fraction(0))
    first = pushed[0] + friction * across[0]
    a_2, h_2 = (3 * first - s * pushed[1]) / det, ((2 + c) * pushed[1] - s * first) / det
    rates = {
        Y: at[V], V: 3 * h_2 + s * a_2 + c * w**2, Z: (-k_1 * at[Z] - force) / damping,
        PLACE: eps * w, "a_dot": eps * a_2, "sin(a)": eps * c * w, "cos(a)": -eps * s * w,
        INVERSE: -eps * (-3 * s - 2 * s * c) * w / det**2, SLIDE: eps * 6 * (c + 2) * s * w / slide**2,
    }  # fmt: skip
    functions = {"touch-down": at[Y] - at[Z]} if phase == "flight" else {"lift-off": at[Z] - at[Y]}
    if phase in ("slip", "reverse slip"):
        functions["stick"] = (c + 2) * w * (1 if phase == "slip" else -1)
    if phase == "stick":
        functions |= {"slip forwards": slide * (mu * force + holding), "slip backwards": slide * (mu * force - holding)}
    return rates, functions


@pytest.mark.parametrize("phase", ["slip", "reverse slip", "stick", "flight"])
def test_rates_and_events_are_those_of_newton(phase: str) -> None:
    scene, chance = scene_of(), random.Random(2)
    system = scene.system(phase)
    assert system.names == sorted([Y, V, Z, INVERSE, "a_dot", "sin(a)", "cos(a)", *[SLIDE] * (phase == "stick")])
    for _ in range(4):
        t = Fraction(chance.randint(-9, 9), 5)
        at = {name: Fraction(chance.randint(-9, 9), chance.randint(1, 9)) for name in (Y, V, Z, PLACE, "a_dot")}
        at |= {"sin(a)": 2 * t / (1 + t**2), "cos(a)": (1 - t**2) / (1 + t**2)}
        c = at["cos(a)"]
        at |= {INVERSE: 1 / (3 * (2 + c) - at["sin(a)"] ** 2), SLIDE: 1 / (3 * (c + 2) ** 2)}
        rates, functions = newton(phase, at, Fraction(1, 4))
        assert {name: exact(rate, at) for name, rate in system.rates.items()} == {n: rates[n] for n in system.names}
        assert {name: exact(event.function, at) for name, event in system.events.items()} == functions
        for name in (PLACE, *((SLIDE,) if phase == "stick" else ())):
            assert exact(system.motion.rates[name], at) == rates[name]


BLOCK: dict[str, Any] = {
    "angles": {}, "coordinates": ["b", "H"], "forces": ["1*b", "-1"], "x": "2*b", "y": "1*H",
    "mass_matrix": [["2", "0"], ["0", "3"]],
}  # fmt: skip
AT_REST = {"b": "0", "b_dot": "1", "v": "0", "y": "-1", "z": "0"}


def test_rates_and_events_with_constant_masses() -> None:
    """det M = 6 and A det M = 12 are numbers: 2 b'' = b + 2 λ_T, 3 y'' = λ - 1, no divisor is a state."""
    eps, mu, force = model.number(Fraction(1, 4)), Fraction(5, 7), model.number(Fraction(9, 8))
    b, force = model.state("b"), force * (model.state(Z) - model.state(Y))
    for phase, friction in ("slip", -mu), ("reverse slip", mu), ("stick", None):
        system = scene_of(BLOCK, start=AT_REST).system(phase)
        assert system.names == sorted([Y, V, Z, "b", "b_dot"])
        assert system.rates[V] == model.number(Fraction(1, 3)) * (force - model.number(1))
        slides = (
            model.Polynomial()
            if friction is None
            else model.number(Fraction(1, 2)) * b + model.number(friction) * force
        )
        assert system.rates["b_dot"] == eps * slides
        if friction is None:
            assert system.events["slip forwards"].function == model.number(12 * mu) * force - model.number(6) * b
            assert system.events["slip backwards"].function == model.number(12 * mu) * force + model.number(6) * b


def test_determinants_and_inverses() -> None:
    """Of a symmetric matrix of four rows; of three rows by hand."""
    rows = [[3, -1, 2, 5], [-1, 7, 4, -2], [2, 4, 1, 6], [5, -2, 6, -8]]
    M = [[model.number(v) for v in row] for row in rows]
    assert mechanism.determinant([row[:3] for row in M[:3]]) == model.number(3 * (7 - 16) + (-1 - 8) + 2 * (-4 - 14))
    det, cofactors = mechanism.determinant(M), mechanism.adjugate(M)
    assert det
    for i, row in enumerate(cofactors):
        for j in range(4):
            assert mechanism.dot(row, [each[j] for each in M]) == (det if i == j else {})


def test_derivatives_of_a_formula() -> None:
    m = scene_of().mechanism
    f = m.formula("2*sin(a)*cos(a)*H + 1*(a-a_ref)*(a-a_ref)", still=True)
    assert m.by(f, "a") == m.formula("2*cos(a)*cos(a)*H + -2*sin(a)*sin(a)*H + 2*(a-a_ref)")
    assert m.rate(f) == m.formula(
        "2*cos(a)*cos(a)*H*a_dot + -2*sin(a)*sin(a)*H*a_dot + 2*(a-a_ref)*a_dot + 2*sin(a)*cos(a)*H_dot"
    )
    assert m.formula("1/2*H + -1/2*H + 3") == model.number(3)
    assert m.formula("1*sin(a)*cos(a)*H") == m.formula("1*H*cos(a)*sin(a)")


LONG_FORMULA = "10000" + " + 0" * 249
CANNOT, SIZE, ANGLES = (
    "has a name that it cannot have",
    "the size of the mass matrix",
    "an angle without sine and cosine",
)
ROWS = STATEMENT["mechanism"]["mass_matrix"]


@pytest.mark.parametrize(
    ("formulas", "why"),
    [
        ({"coordinates": {"a": 0, "H": 1}}, "the number of coordinates"),
        ({"coordinates": []}, "the number of coordinates"),
        ({"coordinates": ["a", "H", "b", "c", "d"]}, "the number of coordinates"),
        ({"coordinates": ["a", 1]}, "no name of a coordinate"),
        ({"coordinates": ["a", "H-b"]}, "no name of a coordinate"),
        ({"coordinates": ["a", "H_dot"]}, "no name of a coordinate"),
        ({"coordinates": ["a", "a_ref"]}, "no name of a coordinate"),
        ({"coordinates": ["a", "M"]}, "no name of a coordinate"),
        ({"coordinates": ["a", "a"]}, "two coordinates have one name"),
        ({"angles": ["a"]}, "the angles are not coordinates"),
        ({"angles": {"b": ["3/5", "4/5"]}}, "the angles are not coordinates"),
        ({"angles": {"a": "34"}}, ANGLES),
        ({"angles": {"a": ["3/5"]}}, ANGLES),
        ({"angles": {"a": ["3/5", "4/5", "0"]}}, ANGLES),
        ({"angles": {"a": ["3/5", "3/5"]}}, "squares that do not add to 1"),
        ({"forces": "00"}, "the number of forces"),
        ({"forces": ["0"]}, "the number of forces"),
        ({"mass_matrix": {"a": ROWS[0], "H": ROWS[1]}}, SIZE),
        ({"mass_matrix": [ROWS[0], "12"]}, SIZE),
        ({"mass_matrix": [ROWS[0], 1]}, SIZE),
        ({"mass_matrix": [ROWS[0], ROWS[1][:1]]}, SIZE),
        ({"mass_matrix": [*ROWS, ROWS[0]]}, SIZE),
        ({"mass_matrix": [["2", "1*sin(a)"], ["-1*sin(a)", "3"]]}, "M is not symmetric"),
        ({"mass_matrix": [["2", "1*a_dot"], ["1*a_dot", "3"]]}, CANNOT),
        ({"x": "1*a_dot"}, CANNOT),
        ({"y": "3*H + 1*a_dot"}, CANNOT),
        ({"x": "1*a"}, CANNOT),
        ({"x": "1*sin(H_dot)"}, CANNOT),
        ({"forces": ["1*T", "0"]}, CANNOT),
        ({"forces": [LONG_FORMULA, "0"]}, "a formula has more than 1000 characters"),
        ({"forces": [0, "0"]}, "a formula has more than 1000 characters"),
        ({"mu": "-1/1000"}, "μ < 0"),
        ({"y": "1*sin(a)"}, "y has no coordinate of which it is a multiple"),
        ({"y": "1*H*H"}, "y has no coordinate of which it is a multiple"),
        ({"y": "1*H + 1*sin(H)"}, "y has no coordinate of which it is a multiple"),
        ({"y": "2"}, "y has no coordinate of which it is a multiple"),
        ({"mass_matrix": [["0", "0"], ["0", "1"]]}, "det M is 0"),
        ({"x": "1"}, "A is 0"),
        ({"forces": ["1*sin(H)", "0"]}, "a sine of the coordinate that y replaces"),
        ({"forces": ["0", "0"], "x": "1*cos(H)"}, "a sine of the coordinate that y replaces"),
    ],
)
def test_a_mechanism_that_is_none(formulas: dict[str, Any], why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        scene_of(formulas)


def test_a_mechanism_at_its_limits() -> None:
    """Four coordinates; a formula of 1,000 characters; no friction; one coordinate alone."""
    assert len(LONG_FORMULA) == 1001
    four = {
        "coordinates": ["a", "H", "b", "d"], "forces": ["0"] * 4,
        "mass_matrix": [[*ROWS[0], "0", "0"], [*ROWS[1], "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]],
    }  # fmt: skip
    assert len(scene_of(four).mechanism.minors) == 4
    assert scene_of({"forces": [LONG_FORMULA.replace("10000", "1000"), "0"], "mu": "0"}).mechanism.mu == 0
    alone = {"angles": {}, "coordinates": ["H"], "forces": ["-1"], "mass_matrix": [["2"]], "x": "0", "y": "1*H"}
    falls = scene_of(alone, effects=["belt", "compliant_contact"], start={"v": "0", "y": "-1", "z": "0"})
    assert falls.kept == {Y, V, Z}
    assert [dict(minor) for minor in falls.mechanism.minors] == [{(): 2}]


OUTER: list[tuple[dict[str, Any], str]] = [
    ({"effects": "compliant_contact"}, "not some of those known, in order"),
    ({"effects": {"compliant_contact": 0}}, "not some of those known, in order"),
    ({"effects": ["compliant_contact", ["stick"]]}, "not some of those known, in order"),
    ({"effects": ["compliant_contact", "two_way_coupling"]}, "not some of those known, in order"),
    ({"effects": ["lift_off", "compliant_contact"]}, "not some of those known, in order"),
    ({"effects": ["compliant_contact", "compliant_contact"]}, "not some of those known, in order"),
    ({"effects": ["lift_off"]}, "the contact is not compliant"),
    ({"effects": ["compliant_contact", "stick"]}, "stick without tangential motion"),
    ({"effects": ["belt", "compliant_contact", "tangential_motion"]}, "tangential motion on a belt"),
    ({"epsilon": "0"}, "ε or the time is not positive"),
    ({"until": "0"}, "ε or the time is not positive"),
    *(
        ({"parameters": STATEMENT["parameters"] | {name: "0"}}, "a stiffness or the damping is not > 0")
        for name in ("damping", "k_1", "k_2")
    ),
    ({"start": STATEMENT["start"] | {"y": "1/31"}}, "the start is not in contact"),
    ({"start": STATEMENT["start"] | {"H": "0"}}, "has not the keys|have not the keys"),
]


@pytest.mark.parametrize(("change", "why"), OUTER)
def test_a_scene_that_is_none(change: dict[str, Any], why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        scene_of(**change)


def test_what_is_not_followed_exists() -> None:
    """A third coordinate on which nothing depends: an integral, unless its acceleration depends on its velocity."""
    more: dict[str, Any] = {
        "coordinates": ["a", "H", "b"], "mass_matrix": [[*ROWS[0], "0"], [*ROWS[1], "0"], ["0", "0", "1"]],
    }  # fmt: skip
    forces = STATEMENT["mechanism"]["forces"]
    kept = scene_of().kept
    assert scene_of(more | {"forces": [*forces, "1*sin(a)"]}).kept == kept
    for force in ("1*b_dot", "1*b_dot*b_dot", "-1*b", "1*sin(b)"):
        with pytest.raises(limits.Rejected, match="may be one that ends to exist"):
            scene_of(more | {"forces": [*forces, force]})


def test_the_start() -> None:
    """Sine and cosine by the addition theorem; 1/det M; the order of what is given."""
    scene = scene_of()
    assert scene.given() == [PLACE, "a_dot"]
    assert scene.kept == {Y, V, Z, INVERSE, SLIDE, "a_dot", "sin(a)", "cos(a)"}
    one, box = 2**64, scene.first_box(numbers())
    assert {name: box[name] for name in (Y, V, Z, "T", PLACE, "a_dot")} == {
        Y: (-one, -one), V: (-4 * one // 3, -4 * one // 3 + 1), Z: (one // 2,) * 2, "T": (0, 0),
        PLACE: (one // 8,) * 2, "a_dot": (one // 2,) * 2,
    }  # fmt: skip
    small = Fraction(1, 8)
    sine = small - small**3 / 6 + small**5 / 120 - small**7 / 5040
    cosine = 1 - small**2 / 2 + small**4 / 24 - small**6 / 720
    s, c = (3 * cosine + 4 * sine) / 5, (4 * cosine - 3 * sine) / 5
    for name, value in ("sin(a)", s), ("cos(a)", c), (INVERSE, 1 / (6 + 3 * c - s**2)):
        low, high = box[name]
        assert 0 < high - low < 2000
        assert abs(Fraction(low, one) - value) < Fraction(1, 10**11)
    assert len(box) == 9


def test_an_angle_without_a_reference_and_a_third_mass() -> None:
    """sin a and cos a are those of 1/8 itself; det M is twice as large."""
    rows = [[*ROWS[0], "0"], [*ROWS[1], "0"], ["0", "0", "2"]]
    formulas = {
        "angles": {}, "coordinates": ["a", "H", "b"], "forces": ["0"] * 3, "mass_matrix": rows, "x": "1*sin(a) + 2*a",
    }  # fmt: skip
    start = {"a": "1/8"} | {name: v for name, v in STATEMENT["start"].items() if name != PLACE}
    rough = numbers()
    box, (sine, cosine) = scene_of(formulas, start=start).first_box(rough), rough.sine_cosine(Fraction(1, 8))
    assert (box["sin(a)"], box["cos(a)"]) == (sine, cosine)
    s, c = (Fraction(ends[0], rough.one) for ends in (sine, cosine))
    assert abs(Fraction(box[INVERSE][0], rough.one) - 1 / (2 * (6 + 3 * c - s**2))) < Fraction(1, 10**15)


def test_masses_of_what_is_not_followed() -> None:
    """Two more coordinates: their block of M has the determinant 1 and depends on an angle that nothing else sees."""
    block = ["1 + 1*sin(b)*sin(b)", "1*sin(b)", "1"]
    rows = [["1", "0", "0"], ["0", block[0], block[1]], ["0", block[1], block[2]]]
    formulas = {"angles": {}, "coordinates": ["H", "b", "c"], "forces": ["-1", "0", "0"], "x": "0", "y": "1*H"}
    scene = scene_of(
        formulas | {"mass_matrix": rows}, effects=["belt", "compliant_contact"], start={"v": "0", "y": "-1", "z": "0"}
    )
    with pytest.raises(limits.Rejected, match="M depends on what is not followed"):
        scene.first_box(numbers())


@pytest.mark.parametrize(
    ("rows", "why"),
    [
        ([["-2", "0"], ["0", "-3"]], "M is not certainly positive definite at the start"),
        ([["2", "0"], ["0", "-3"]], "M is not certainly positive definite at the start"),
        ([["0", "1"], ["1", "3"]], "M is not certainly positive definite at the start"),
        ([["2", "1"], ["1", "1/2 + -1*sin(a)"]], "M is not certainly positive definite at the start"),
    ],
)
def test_masses_that_are_not_positive(rows: list[list[str]], why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        scene_of({"mass_matrix": rows}).first_box(numbers())


def test_masses_are_positive_to_the_last_unit() -> None:
    least = {"mass_matrix": [[f"1/{2**64}", "0"], ["0", "1"]]}
    assert scene_of(least).first_box(numbers())
    with pytest.raises(limits.Rejected, match="not certainly positive definite"):
        scene_of(least).first_box(numbers(63))


@pytest.mark.parametrize(
    ("start", "begins"),
    [
        ({}, ("slip", "", 0)),
        ({"y": "0", "z": "0", "v": "0"}, ("slip", "lift-off", 2)),
        ({"y": "1/32"}, ("slip", "lift-off", 1)),
        ({"y": "0", "z": "0", "v": f"1/{2**70}"}, ("slip", "lift-off", 1)),
        ({"y": "0", "z": "0", "v": f"-1/{2**70}"}, ("slip", "lift-off", 1)),
    ],
)
def test_where_the_run_begins(start: dict[str, str], begins: tuple[str, str, int]) -> None:
    scene, rough = scene_of(start=STATEMENT["start"] | start), numbers()
    assert scene.begin(scene.first_box(rough), rough) == begins


UNSURE = "the direction of slip at touch-down is not certain"


@pytest.mark.parametrize(
    ("event", "speed", "found"),
    [
        ("lift-off", (0, 0), ("flight", "touch-down", 1)),
        ("stick", (0, 0), ("stick", "", 0)),
        ("slip forwards", (0, 0), ("slip", "stick", 2)),
        ("slip backwards", (0, 0), ("reverse slip", "stick", 2)),
        ("touch-down", (1, 9), ("slip", "lift-off", 1)),
        ("touch-down", (-9, -1), ("reverse slip", "lift-off", 1)),
        ("touch-down", (0, 9), None),
        ("touch-down", (-9, 0), None),
        ("touch-down", (-9, 9), None),
    ],
)
def test_the_phase_after_an_event(event: str, speed: tuple[int, int], found: tuple[str, str, int] | None) -> None:
    """u = b's velocity; on a belt it is not asked for."""
    block, start = BLOCK | {"forces": ["0", "-1"], "x": "1*b"}, {name: v for name, v in AT_REST.items() if name != "b"}
    scene, box, rough = scene_of(block, start=start), {"b_dot": speed}, numbers()
    if found is None:
        with pytest.raises(limits.Rejected, match=UNSURE):
            scene.after(event, box, rough)
    else:
        assert scene.after(event, box, rough) == found
    if event == "touch-down":
        slides = scene_of(block, start=start, effects=["compliant_contact", "lift_off", "tangential_motion"])
        if found and found[0] == "slip":
            assert slides.after(event, box, rough) == found
        else:
            with pytest.raises(limits.Rejected, match=UNSURE):
                slides.after(event, box, rough)
        del start["b_dot"]
        belt = scene_of(block, start=start, effects=["belt", "compliant_contact", "lift_off"])
        assert belt.after(event, {}, rough) == ("slip", "lift-off", 1)


def test_the_table_of_events() -> None:
    found = {phase: (list(system.events), system.endings) for phase, system in scene_of().systems.items()}
    slips, sticks = ["lift-off", "stick"], ["lift-off", "slip forwards", "slip backwards"]
    assert found == {
        "slip": (slips, slips), "reverse slip": (slips, slips), "stick": (sticks, sticks),
        "flight": (["touch-down"], ["touch-down"]),
    }  # fmt: skip
    for effects, follows in (
        (["compliant_contact"], ["lift-off", "stick"]),
        (["belt", "compliant_contact"], ["lift-off"]),
    ):
        scene = scene_of(effects=effects)
        assert {phase: (list(system.events), system.endings) for phase, system in scene.systems.items()} == {
            "slip": (follows, [])
        }
    assert not scene_of().coupled


FORCE, SLIP = (f"{sign} all along, as leaving an effect out assumes" for sign in ("λ_N > 0", "u > 0 in contact"))
UNSEEN = "provided that in contact slip is positive, which is not shown"


@pytest.mark.parametrize(
    ("effects", "said"),
    [
        (STATEMENT["effects"], []),
        (["compliant_contact"], [FORCE, SLIP]),
        (["compliant_contact", "lift_off", "tangential_motion"], [SLIP]),
        (["compliant_contact", "stick", "tangential_motion"], [FORCE]),
        (["belt", "compliant_contact"], [FORCE, UNSEEN]),
        (["belt", "compliant_contact", "lift_off"], [UNSEEN]),
    ],
)
def test_what_is_said_of_effects_that_are_left_out(effects: list[str], said: list[str]) -> None:
    assert scene_of(effects=effects).seen() == said
    begins = scene_of(effects=effects, start=STATEMENT["start"] | {"y": "1/32"}).seen()
    assert begins == [
        text.replace("λ_N > 0 all along", "λ_N > 0 all along after the start, where it is 0") for text in said
    ]


def test_the_words_of_a_mechanism() -> None:
    assert scene_of().words() == (
        "the mechanism M q'' = f + λ_N dy/dq + λ_T dx/dq with q = (a, H), sin(a_ref) = 3/5, cos(a_ref) = 4/5, "
        "M = (2 + 1*cos(a), 1*sin(a); 1*sin(a), 3), f = (2*a_dot*a_dot + -1*sin(a), -3/5 + 1/2*H + 1*H_dot*a_dot), "
        "x = 1*sin(a) + 2*(a-a_ref), y = 3*H + -1*cos(a), μ = 5/7, with compliant_contact, lift_off, stick, "
        "tangential_motion, ε = 1/4, damping = 5/4, k_1 = 2/3, k_2 = 9/8, "
        "from (a-a_ref) = 1/8, a_dot = 1/2, v = -1/3, y = -1/16, z = 1/32"
    )


def test_what_terms_become_is_paid_as_they_grow() -> None:
    """A state in place of 40 terms, twice in a key, with short and with long numbers: counted before it is done."""
    for length in (10, 1000):
        table = {"q": model.Polynomial({(f"s{i}",): Fraction(1, 2**length) for i in range(40)})}
        meter = limits.Meter(limits.Limits(), 10**9)
        found = mechanism.put_in(model.Polynomial({("q", "q", "r"): Fraction(1)}), table, meter)
        assert len(found) == 40 * 41 // 2
        assert 10**9 - meter.left > (40 + 1600) * (limits.OPERATION * 60 + 8 * (length // 30) ** 2)
        assert mechanism.put_in(model.state("r"), table, meter) == model.state("r")
        poor = limits.Meter(limits.Limits(), 1000)
        with pytest.raises(limits.Rejected, match="the limit work"):
            mechanism.put_in(model.state("r"), table, poor)


def test_a_stick_begins_with_its_divisor() -> None:
    """A det M = 3 (c + 2)² = 12 at c = 0; it is certainly positive, or the file is rejected."""
    scene, rough = scene_of(), numbers()
    box = {"cos(a)": (0, 0)}
    found = scene.system("stick").entered(box, rough)
    assert found == box | {SLIDE: (rough.one // 12, rough.one // 12 + 1)}
    assert scene.system("slip").entered(box, rough) == box
    with pytest.raises(limits.Rejected, match="a divisor is not certainly positive"):
        scene.system("stick").entered({"cos(a)": (-3 * rough.one, 0)}, rough)
