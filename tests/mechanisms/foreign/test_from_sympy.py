"""Mechanisms from sympy's equations: the same as those written by hand, and what cannot be taken is named."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy
from flint import fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanisms.foreign.same import same
from mechanisms.foreign.two_link import (
    VALUES,
    arm,
    by_kane,
    by_lagrange,
    by_textbook,
    contact,
    g,
    h,
    l1,
    m1,
    m2,
    mu,
    q1,
    q2,
    u1,
    u2,
)
from sympy.physics.mechanics import KanesMethod, LagrangesMethod, Point, ReferenceFrame, dynamicsymbols

from gspot_verified import Scene, SceneError, classify, from_sympy, load, sweep
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.formulas.simplify import constant, rational_value
from gspot_verified.mechanisms.input.given import from_energies, lagrangian
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError

x, y, theta = dynamicsymbols("x y theta")
m, k = sympy.symbols("m k")
t = dynamicsymbols._t


def of_arm(method: Any, **options: Any) -> Mechanism:
    return from_sympy(method, **{"contact": contact(), "parameters": VALUES, "name": "arm"} | options)


def of_block(L: Any = None, **options: Any) -> Mechanism:
    """A particle in the plane; ``method`` holds the further arguments of LagrangesMethod."""
    L = m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y if L is None else L
    method = LagrangesMethod(L, [x, y], **options.pop("method", {}))
    given = {"contact": {"x": x, "y": y, "mu": "1/2"}, "parameters": {m: 2, g: 10}} | options
    return from_sympy(method, **given)


@pytest.mark.parametrize(
    "speeds", [(u1, u2), (u1, u1 + u2), (u1 - sympy.cos(q2) * u2, 2 * u2), (u1 + sympy.sin(t), u2)]
)
def test_kanes_equations_are_those_of_the_textbook_for_any_speeds(speeds: tuple[Any, Any]) -> None:
    found = of_arm(by_kane(*speeds))
    assert found.state == ("q1", "q2", "q1_dot", "q2_dot")
    assert found.remarks == ()
    assert same(found, by_textbook())


def test_lagranges_equations_are_those_of_the_textbook() -> None:
    assert same(of_arm(by_lagrange()), by_textbook())
    assert not same(of_arm(by_lagrange()), by_textbook(m2=2))


@pytest.mark.slow  # its quick siblings are the speeds above
@settings(max_examples=10, deadline=None)
@given(st.tuples(*[st.integers(-3, 3)] * 4).filter(lambda n: n[0] * n[3] != n[1] * n[2]))
def test_speeds_that_are_sums_of_velocities_make_no_difference(n: tuple[int, int, int, int]) -> None:
    assert same(of_arm(by_kane(n[0] * u1 + n[1] * u2, n[2] * u1 + n[3] * u2)), by_textbook())


@pytest.mark.parametrize("kind", ["matrices", "arrays", "lists", "flat arrays"])
def test_a_pair_of_matrix_and_forces(kind: str) -> None:
    method = by_lagrange()
    M, f = method.mass_matrix, method.forcing
    pair: dict[str, Any] = {
        "matrices": (M, f),
        "arrays": (np.array(M.tolist(), dtype=object), np.array(f.tolist(), dtype=object)),
        "flat arrays": (np.array(M.tolist(), dtype=object), np.array(list(f), dtype=object)),
        "lists": (M.tolist(), list(f)),
    }
    assert same(of_arm(pair[kind], coordinates=[q1, q2]), by_textbook())


def test_numpy_numbers_are_numbers() -> None:
    values = VALUES | {m1: np.int64(2), m2: np.array(1), l1: np.array(sympy.Integer(1), dtype=object)}
    assert same(of_arm(by_lagrange(), parameters=values), by_textbook())


def test_the_rod_of_a_notebook_is_the_rod_of_the_package() -> None:
    X, Y = dynamicsymbols("X Y")
    L, big = sympy.symbols("L M")
    energy = big * (X.diff() ** 2 + Y.diff() ** 2) / 2 + big * L**2 / 24 * theta.diff() ** 2 - big * g * Y
    found = from_sympy(
        LagrangesMethod(energy, [X, Y, theta]),
        contact={"x": X + L * sympy.cos(theta) / 2, "y": Y - L * sympy.sin(theta) / 2, "mu": mu},
        parameters={big: 1, L: 1, g: 1, mu: 2},
        g_spot={
            "search": True,
            "fixed": [X, X.diff()],
            "point": {
                X: 0,
                Y: 3 * L / 10,
                theta: "2/3",
                X.diff(): 2,
                "Y_dot": "3/4",
                theta.diff(): sympy.Rational(9, 5),
            },
        },
    )
    packaged = load("genot_brogliato_rod")
    assert same(found, packaged)
    one, other = classify(found), classify(packaged)
    assert (one.case, one.impact_sign) == (other.case, other.impact_sign)
    assert [value for _, value in one.short_point] == [value for _, value in other.short_point]


def test_a_reference_angle_and_exact_numbers_make_an_exact_spot() -> None:
    X, Y = dynamicsymbols("X Y")
    energy = (X.diff() ** 2 + Y.diff() ** 2) / 2 + theta.diff() ** 2 / 6 - sympy.Rational(3, 5) * Y
    found = from_sympy(
        LagrangesMethod(energy, [X, Y, theta]),
        contact={"x": X + sympy.cos(theta), "y": Y - sympy.sin(theta), "mu": "73/36"},
        angles={theta: ("3/5", "4/5")},
        g_spot={
            "fixed": [X, X.diff()],
            "point": {X: 0, Y: "3/5", theta: "theta_ref", "X_dot": 2, "Y_dot": "4/5", "theta_dot": 1},
        },
    )
    assert classify(found).beta == fmpq(18, 55)


def test_conditions_of_a_g_spot_are_formulas_of_sympy() -> None:
    found = of_arm(by_kane(), g_spot={"search": True, "point": {q1: 1}, "conditions": [q1 - h, u2 + 1]})
    by_hand = lagrangian("b", ["q1", "q2"], [[1, 0], [0, 1]], [0, 0], "q1", "q2", 1, {"h": 1},
                         conditions=["q1 - h", "q2_dot + 1"])  # fmt: skip
    assert found.place.search
    assert found.place.conditions == by_hand.place.conditions


def test_forces_that_are_not_conservative_are_carried() -> None:
    N = ReferenceFrame("N")
    point = Point("P")
    point.set_vel(N, x.diff() * N.x + y.diff() * N.y)
    found = of_block(method={"forcelist": [(point, -3 * x.diff() * N.x)], "frame": N})
    by_hand = from_energies(
        "block", ["X", "Y"], "X_dot^2 + Y_dot^2", "20*Y", "X", "Y", "1/2", dissipation="3*X_dot^2/2"
    )
    assert same(found, by_hand)


def test_holonomic_constraints_are_carried() -> None:
    found = of_block(method={"hol_coneqs": [x**2 + y**2 - 4]})
    by_hand = lagrangian(
        "pendulum", ["X", "Y"], [[2, 0], [0, 2]], [0, -20], "X", "Y", "1/2", constraints=["X^2 + Y^2 - 4"]
    )
    assert same(found, by_hand)
    assert isinstance(found.motion, Lagrangian)
    assert len(found.motion.constraints) == 1


def test_explicit_time_is_a_component_of_the_state() -> None:
    found = of_block(m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y + x * sympy.sin(3 * t))
    by_hand = lagrangian("b", ["X", "Y"], [[2, 0], [0, 2]], ["sin(3*t)", -20], "X", "Y", "1/2", time="t")
    assert found.state[-1] == "t"
    assert same(found, by_hand)


def test_a_slip_velocity_on_a_belt_and_negative_slip() -> None:
    found = of_block(contact={"slip_velocity": x.diff() - 3, "y": y, "mu": "1/2", "slip": "negative"})
    by_hand = lagrangian("b", ["X", "Y"], [[2, 0], [0, 2]], [0, -20], None, "Y", "1/2",
                         slip_velocity="X_dot - 3", slip="negative")  # fmt: skip
    assert found.mirrored
    assert same(found, by_hand)


@pytest.mark.parametrize("assumed", [{}, {"nonnegative": True}])
def test_friction_may_depend_on_the_slip_speed(assumed: dict[str, bool]) -> None:
    speed = sympy.Symbol("slip_speed", **assumed)
    contact, law = {"x": x, "y": y, "mu": k / (2 + speed)}, "1/3/(2 + slip_speed)"
    by_hand = lagrangian("b", ["X", "Y"], [[2, 0], [0, 2]], [0, -20], "X", "Y", law)
    values = {m: 2, g: 10, k: "1/3"}
    found = of_block(contact=contact, parameters=values)
    assert [name for name, _ in found.parameters] == ["m", "g", "k"]
    speed_held = [shift(mechanism, slip_speed=True).functions for mechanism in (found, by_hand)]
    assert speed_held[0].p == speed_held[1].p
    with pytest.raises(MechanismError, match="the friction coefficient depends on the slip speed"):
        classify(found)
    of_its_own = of_block(contact={"x": x, "y": y, "mu": k / (2 + speed)}, parameters=values | {speed: "1/2"})
    assert shift(of_its_own).functions.mu == constant(fmpq(2, 15))


def test_the_slip_speed_stands_in_no_force() -> None:
    with pytest.raises(MechanismError, match="slip_speed"):
        of_block(m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y + x * sympy.Symbol("slip_speed"))


def test_speeds_of_kane_may_stand_in_the_contact() -> None:
    options = {"contact": {"slip_velocity": -l1 * sympy.sin(q1) * u1, "y": contact()["y"], "mu": mu}}
    by_velocity = {"contact": options["contact"] | {"slip_velocity": -l1 * sympy.sin(q1) * q1.diff()}}
    assert same(of_arm(by_kane(), **options), of_arm(by_lagrange(), **by_velocity))


def test_the_users_own_method_stays_as_it_is() -> None:
    N, _, _, bodies, weights = arm(u1, u2)
    method = KanesMethod(N, [q1, q2], [u1, u2], [q1.diff() - u1, q2.diff() - u2], bodies=bodies, forcelist=weights)
    assert same(of_arm(method), by_textbook())
    with pytest.raises(ValueError, match="compute"):
        _ = method.forcing
    particle = LagrangesMethod(m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y, [x, y])
    from_sympy(particle, contact={"x": x, "y": y, "mu": 1}, parameters={m: 1, g: 1})
    assert particle.eom is None


def test_names_that_scenes_have_are_changed_and_said() -> None:
    found = of_block()
    assert found.state == ("q_x", "q_y", "q_x_dot", "q_y_dot")
    assert found.notes == ("renamed: x is q_x, y is q_y here",)
    hard = sympy.Symbol("q_x"), sympy.Symbol(r"\mu_{0}")
    named = of_block(contact={"x": hard[0] * x, "y": y, "mu": hard[1]}, parameters={m: 1, g: 1, "q_x": 1, hard[1]: 2})
    assert named.notes == ("renamed: x is q_x, y is q_y here", r"renamed: q_x is q_x_, \mu_{0} is mu_0 here")
    assert dict(named.parameters).keys() == {"m", "g", "q_x_", "mu_0"}


def test_a_scene_takes_what_came_in_and_refuses_the_names_as_they_were() -> None:
    def scene(mechanism: Mechanism, word: str) -> Scene:
        effects = ("compliant_contact", "lift_off", "tangential_motion", "stick")
        start = {f"{word}_dot": fmpq(1)}
        return Scene("a block", effects, fmpq(1, 100), fmpq(1), parameters={}, start=start, mechanism=mechanism)

    found = of_block(contact={"x": 2 * x, "y": y - 1, "mu": "1/2"})
    assert scene(found, "q_x").system("stick").states == ("q_x_dot", "Y", "V", "Z")
    named = lagrangian("b", ["x", "y"], [[2, 0], [0, 2]], [0, -20], "2*x", "y - 1", "1/2")
    assert same(found, named)
    with pytest.raises(SceneError, match="scenes use the name 'y'"):
        scene(named, "x")


def test_a_parameter_of_the_name_of_a_coordinate_is_another_thing() -> None:
    angle = sympy.Symbol("x")
    found = of_block(contact={"x": x + angle, "y": y, "mu": "1/2"}, parameters={m: 2, g: 10, angle: 3},
                     g_spot={"point": {"x": 1, y: angle}, "fixed": ["x", y.diff()], "search": True})  # fmt: skip
    assert dict(found.parameters).keys() == {"m", "g", "x"}
    assert [word for word, _ in found.place.values] == ["q_x", "q_y"]
    assert found.place.fixed == ("q_x", "q_y_dot")


def test_a_parameter_of_the_name_of_a_velocity_is_another_thing() -> None:
    speed = sympy.Symbol("theta_dot")
    method = LagrangesMethod(
        m * (x.diff() ** 2 + theta.diff() ** 2) / 2 - speed * theta + theta * theta.diff() ** 2, [x, theta]
    )
    found = from_sympy(method, contact={"x": x, "y": theta, "mu": speed}, parameters={m: 2, speed: 3})
    by_hand = from_energies("b", ["X", "Y"], "X_dot^2 + Y_dot^2 + Y*Y_dot^2", "3*Y", "X", "Y", 3)
    assert found.state == ("q_x", "theta", "q_x_dot", "theta_dot")
    assert dict(found.parameters).keys() == {"m", "theta_dot_"}
    assert same(found, by_hand)


@pytest.mark.parametrize("name", ["", " ", "two\nlines", "a" * 81, 7])
def test_the_name_is_one_line(name: Any) -> None:
    with pytest.raises(MechanismError, match="name"):
        of_block(name=name)


def test_parameters_may_stay_symbols_and_use_each_other() -> None:
    found = of_arm(by_lagrange(), parameters=VALUES | {m1: 2 * m2, mu: None})
    assert dict(found.parameters)["mu"] is None
    assert same(found.with_parameters(mu=2), by_textbook())


def test_a_float_is_refused_by_name_or_taken_as_its_decimal() -> None:
    options: dict[str, Any] = {
        "L": m * (x.diff() ** 2 + y.diff() ** 2) / 2 - 9.81 * m * y - 0.5 * x**2.0,
        "contact": {"x": x, "y": y, "mu": 0.1},
        "parameters": {m: np.float64(0.2)},
    }
    with pytest.raises(MechanismError, match=r"force 1: not exact: the Float -1\.0, 1\.0: write Rational"):
        of_block(**options)
    found = of_block(**options, rationalize=True)
    by_hand = lagrangian("b", ["X", "Y"], [["1/5", 0], [0, "1/5"]], ["-X", "-981/500"], "X", "Y", "1/10")
    assert same(found, by_hand)
    assert rational_value(found.mu) == fmpq(1, 10)
    (decimals,) = (note for note in found.notes if "Floats" in note)
    assert "0.1 is 1/10" in decimals
    assert "9.81 is 981/100" in decimals


PLAIN = m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"L": PLAIN - sympy.Float("0.1", 40) * x, "rationalize": True}, "136 bits"),
        ({"parameters": {m: 2}}, r"no value for g: parameters=\{g: \.\.\.\}"),
        ({"parameters": {m: 0.5, g: 1}}, "parameter m: not exact: the Float 0.5: write"),
        ({"parameters": {m: float("nan"), g: 1}, "rationalize": True}, "not exact, or no function of formulas: nan"),
        ({"parameters": {m: "heavy", g: 1}}, "heavy"),
        ({"parameters": {m: -1, g: 1}}, "mass m is -1"),
        ({"parameters": {m: 1, g: 1, sympy.Symbol("m", positive=True): 1}}, "two different symbols are called 'm'"),
        ({"contact": {"x": x, "y": y}}, "mu is needed"),
        ({"contact": {"x": x, "mu": 1}}, "y is needed"),
        ({"contact": {"y": y, "mu": 1}}, "x, or slip_velocity, is needed"),
        ({"contact": {"x": x, "slip_velocity": x.diff(), "y": y, "mu": 1}}, "x, or slip_velocity, is needed"),
        ({"contact": {"x": x, "y": y, "mu": 1, "slipp": 1}}, "unknown key 'slipp'; did you mean 'slip'"),
        ({"contact": [x, y, 1]}, "contact: give a table"),
        ({"contact": {"x": sympy.Matrix([x]), "y": y, "mu": 1}}, "contact, x: one formula is needed"),
        ({"contact": {"x": x, "y": y.diff(), "mu": 1}}, "must not depend on velocities"),
        ({"contact": {"x": x, "y": y.diff().diff(), "mu": 1}}, "is neither a coordinate nor a velocity"),
        ({"contact": {"x": x, "y": y, "mu": theta}}, r"contact, mu: theta\(t\) is neither a coordinate nor"),
        ({"contact": {"x": x, "y": sympy.Abs(y), "mu": 1}}, "no function of formulas"),
        ({"contact": {"x": x, "y": y, "mu": -1}}, "must not be negative"),
        ({"L": PLAIN + dynamicsymbols("F") * x}, r"force 1: F\(t\) is neither a coordinate nor a velocity"),
        ({"L": x.diff() ** 2 * y.diff() ** 2}, "depend on velocities"),
        ({"L": m * x.diff() ** 2 / 2 - m * g * y}, "not positive definite"),
        ({"method": {"nonhol_coneqs": [x.diff() - y * y.diff()]}}, "1 of the constraints are nonholonomic"),
        ({"method": {"hol_coneqs": [x.diff() - 1]}}, "constraint must not depend on velocities"),
        ({"g_spot": {"serach": True}}, "g_spot: unknown key 'serach'; did you mean 'search'"),
        ({"g_spot": {"search": "false"}}, "search must be True or False"),
        ({"g_spot": {"point": {theta: 1}}}, "is no component of the state"),
        ({"coordinates": [x, y]}, "coordinates= is for a pair"),
    ],
)
def test_what_cannot_be_taken_is_named(options: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        of_block(**options)


def test_two_masses_of_one_name_are_not_made_one() -> None:
    other = sympy.Symbol("m", positive=True)
    with pytest.raises(MechanismError, match="two different symbols are called 'm'"):
        of_block(m * x.diff() ** 2 / 2 + other * y.diff() ** 2 / 2 - m * g * y)


def test_what_sympy_assumed_of_a_symbol_must_hold() -> None:
    stiff = sympy.Symbol("k", positive=True)
    L = PLAIN - sympy.sqrt(stiff**2) * x**2 / 2
    values = {m: 2, g: 10}
    assert same(of_block(L, parameters=values | {stiff: 3}), of_block(PLAIN - 3 * x**2 / 2))
    with pytest.raises(MechanismError, match="symbol k is assumed positive; its value is -3"):
        of_block(L, parameters=values | {stiff: -3})
    with pytest.raises(MechanismError, match="symbol k is assumed positive; its value is -2"):
        of_block(L, parameters=values | {stiff: -m})
    left = of_block(L, parameters=values | {stiff: None})
    assert dict(left.parameters)["k"] is None
    assert same(left.with_parameters(k=3), of_block(PLAIN - 3 * x**2 / 2))
    for later in (left, of_block(L, parameters=values | {stiff: 3})):
        with pytest.raises(MechanismError, match="symbol k is assumed positive; its value is -3"):
            later.with_parameters(k=-3)
    with pytest.raises(MechanismError, match="symbol k is assumed positive; its value is -1"):
        sweep(left, {"k": "-1..3:2"})
    # At both ends and at 0 it is positive, between 2 and 4 not.
    follows = of_block(L, parameters={m: 5, g: 10, stiff: (m - 3) ** 2 - 1})
    for ranges in ({"m": "1/2..5:2"}, {"m": "1/2..5:2", "g": "9..11:2"}):
        with pytest.raises(MechanismError, match=r"k is assumed positive; its value may not be, for m in \[1/2, 5\]"):
            sweep(follows, ranges)
    with pytest.raises(GSpotError):  # no complaint of k
        sweep(follows, {"m": "9/2..5:2"})
    twice = of_block(L, parameters={m: None, g: 10, stiff: -m})
    with pytest.raises(MechanismError, match="symbol k is assumed positive; its value is -2"):
        twice.with_parameters(m=2)
    sign = dynamicsymbols("s", positive=True)
    with pytest.raises(MechanismError, match=r"coordinate s\(t\) is assumed positive"):
        from_sympy((sympy.eye(2), [0, -1]), coordinates=[sign, y], contact={"x": sign, "y": y, "mu": 1})


@pytest.mark.parametrize(
    ("assumption", "formula", "value", "wrong"),
    [
        ("extended_positive", lambda k: sympy.sqrt(k**2), 3, -3),
        ("extended_nonnegative", lambda k: sympy.sqrt(k**2), 0, -3),
        ("extended_negative", lambda k: sympy.sqrt(k**2), -3, 3),
        ("even", lambda k: sympy.cos(sympy.pi * k), 2, 3),
        ("odd", lambda k: sympy.cos(sympy.pi * k), 3, 2),
    ],
)
def test_what_sympy_assumed_in_other_words_must_hold_too(
    assumption: str, formula: Callable[[Any], Any], value: int, wrong: int
) -> None:
    """Sympy puts k for the root of k^2 also where k is extended_positive, and 1 for cos(pi k) where it is even."""
    k = sympy.Symbol("k", **{assumption: True})
    L, values = PLAIN - formula(k) * x**2 / 2, {m: 2, g: 10}
    taken = int(formula(sympy.Integer(value)))
    assert same(of_block(L, parameters=values | {k: value}), of_block(PLAIN - taken * x**2 / 2))
    with pytest.raises(MechanismError, match=f"symbol k is assumed .*; its value is {wrong}"):
        of_block(L, parameters=values | {k: wrong})
    sign = dynamicsymbols("s", **{assumption: True})
    with pytest.raises(MechanismError, match=r"coordinate s\(t\) is assumed"):
        from_sympy((sympy.eye(2), [0, -1]), coordinates=[sign, y], contact={"x": sign, "y": y, "mu": 1})


@pytest.mark.parametrize(
    ("method", "options", "message"),
    [
        (None, {}, "a LagrangesMethod, a KanesMethod or a pair .* is needed, got NoneType"),
        ("arm", {}, "got str"),
        ((sympy.eye(2), sympy.zeros(2, 1)), {}, "give coordinates="),
        ((sympy.eye(2), sympy.zeros(3, 1)), {"coordinates": [q1, q2]}, "of 2 rows and 3 forces"),
        ((sympy.eye(3), sympy.zeros(2, 1)), {"coordinates": [q1, q2]}, "of 3 rows and 2 forces"),
        ((sympy.Matrix([[1, k], [0, 1]]), [0, 0]), {"coordinates": [q1, q2]}, r"not symmetric.*\(2, 1\) is 0"),
        ((sympy.ones(1, 2), [0, 0]), {"coordinates": [q1, q2]}, "as many columns as rows"),
        (("M", [0, 0]), {"coordinates": [q1, q2]}, "mass matrix: a matrix, an array or a list is needed, got str"),
        ((sympy.eye(2), [q1.diff().diff(), 0]), {"coordinates": [q1, q2]}, "not linear in the accelerations"),
        ((sympy.eye(2), [0, 0]), {"coordinates": [sympy.Symbol("a"), q2]}, "the coordinate a is no function of time"),
    ],
)  # fmt: skip
def test_what_is_no_method_is_refused(method: Any, options: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        of_arm(method, **{"parameters": VALUES | {k: 1}} | options)


def test_a_kanes_method_that_has_no_equations_or_dependent_speeds() -> None:
    N, _, _, bodies, weights = arm(u1, u2)
    kinematics = [q1.diff() - u1, q2.diff() - u2]
    with pytest.raises(MechanismError, match=r"call kanes_equations\(bodies, loads\) first"):
        of_arm(KanesMethod(N, [q1, q2], [u1, u2], kinematics))
    rolling = KanesMethod(N, [q1, q2], [u1], kinematics, u_dependent=[u2], velocity_constraints=[u1 - 2 * u2])
    rolling.kanes_equations(bodies, weights)
    with pytest.raises(MechanismError, match="dependent speeds"):
        of_arm(rolling)
    linked = KanesMethod(N, [q1], [u1], kinematics, q_dependent=[q2], configuration_constraints=[q1 - 2 * q2],
                         u_dependent=[u2], velocity_constraints=[u1 - 2 * u2])  # fmt: skip
    linked.kanes_equations(bodies, weights)
    with pytest.raises(MechanismError, match="dependent coordinates"):
        of_arm(linked)


def test_the_component_of_a_general_speed_is_refused() -> None:
    with pytest.raises(MechanismError, match=r"u2\(t\) is no velocity of a coordinate"):
        of_arm(by_kane(u1, u1 + u2), g_spot={"point": {u2: 1}})
    found = of_arm(by_kane(), g_spot={"point": {u2: 1, q1: h}})
    assert [word for word, _ in found.place.values] == ["q2_dot", "q1"]


@pytest.mark.parametrize(
    ("options", "why"),
    [
        ({"parameters": {m: 2, "m": 3, g: 10}}, "parameters: m and 'm' are the same, m"),
        ({"g_spot": {"point": {"x": 0, "q_x": 1}}}, "point: 'x' and 'q_x' are the same, q_x"),
        ({"g_spot": {"point": {x: 0, "x": 1}}}, "point: .* and 'x' are the same, q_x"),
        ({"angles": {x: ("3/5", "4/5"), "x": (0, 1)}}, "angles: .* and 'x' are the same, q_x"),
    ],
)
def test_one_name_in_two_spellings(options: dict[str, Any], why: str) -> None:
    with pytest.raises(MechanismError, match=why):
        of_block(**options)


@pytest.mark.parametrize("key", [t, "t"])
def test_the_time_is_no_parameter(key: Any) -> None:
    """A mass called t is the time to sympy: its value was left aside."""
    energies = (x.diff() ** 2 + y.diff() ** 2) / 2, m * g * y
    with pytest.raises(MechanismError, match="parameters: t is the time of sympy's dynamic symbols"):
        of_block((2 + t) * energies[0] - energies[1], parameters={m: 2, g: 10, key: 3})
    own = sympy.Symbol("t", positive=True)
    block = of_block((2 + own) * energies[0] - energies[1], parameters={m: 2, g: 10, "t": 3})
    assert block.state[-1] == "q_y_dot"
