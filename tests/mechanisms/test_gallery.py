"""The gallery: each mechanism again from the places of its mass centres, by Lagrange's equations in sympy."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from typing import Any

import pytest
import sympy
from flint import arb, fmpq
from sympy import Rational, cos, pi, sin, sqrt

from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.classify import classify_g_spot
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import working_bits
from tests.mechanisms.derive.test_derivation import BALLS, narrow, values

X, Y, TH, T1, T2, T = sympy.symbols("X Y theta theta_1 theta_2 t")
XD, YD, THD, T1D, T2D = sympy.symbols("X_dot Y_dot theta_dot theta_1_dot theta_2_dot")
RATES = {X: XD, Y: YD, TH: THD, T1: T1D, T2: T2D}


@dataclass(frozen=True)
class Bodies:
    """Mass, place of the mass centre, moment of inertia about it, and angle of each body; what acts; the contact."""

    coordinates: tuple[Any, ...]
    masses: tuple[tuple[Any, tuple[Any, Any], Any, Any], ...]
    forces: tuple[Any, ...]  # generalised forces of everything but inertia
    height: Any
    slip: Any


def weight(g: Any, coordinates: Any, masses: Any) -> list[Any]:
    """The generalised forces of gravity: -g times the weighted gradients of the heights."""
    return [-g * sum(mass * sympy.diff(place[1], q) for mass, place, _, _ in masses) for q in coordinates]


def added(*forces: Any) -> tuple[Any, ...]:
    return tuple(sum(parts) for parts in zip(*forces, strict=True))


def rate(place: Any) -> Any:
    return sum(sympy.diff(place, q) * velocity for q, velocity in RATES.items()) + sympy.diff(place, T)


def rod(push: Any, torque: Any, length: Any, g: Any, base: Any = 0) -> Bodies:
    """A free rod of unit mass; ``length`` is half of its length."""
    masses = ((1, (X, Y), length**2 / sympy.Integer(3), TH),)
    forces = added(weight(g, (X, Y, TH), masses), (0, -push, torque))
    return Bodies((X, Y, TH), masses, forces, Y - length * sin(TH) - base, rate(X + length * cos(TH)))


def arm(mass: Any, length: Any, h: Any, torques: tuple[Any, Any], belt: Any = 0) -> Bodies:
    """Two links below a shoulder at the height h; the first has mass and length 1, gravity is 1."""
    elbow = (cos(T1), h - sin(T1))
    first = (1, (cos(T1) / 2, h - sin(T1) / 2), Rational(1, 12), T1)
    second = (
        mass,
        (elbow[0] + length * cos(T2) / 2, elbow[1] - length * sin(T2) / 2),
        Rational(1, 12) * mass * length**2,
        T2,
    )
    forces = added(weight(1, (T1, T2), (first, second)), (torques[0] - torques[1], torques[1]))
    tip = (elbow[0] + length * cos(T2), elbow[1] - length * sin(T2))
    return Bodies((T1, T2), (first, second), forces, tip[1], rate(tip[0]) - belt)


def upper_end_on_a_line(forces: tuple[Any, Any], slip: Any) -> Bodies:
    """A uniform rod of mass and length 1 whose upper end has the height Y on a vertical line; its lower end touches."""
    return Bodies((Y, TH), ((1, (cos(TH) / 2, Y - sin(TH) / 2), Rational(1, 12), TH),), forces, Y - sin(TH), slip)


def ellipse(a: Any, b: Any) -> Bodies:
    """The lowest point of the turned ellipse (a cos s, b sin s), where its height is least over s."""
    s = sympy.atan2(-b * cos(TH), -a * sin(TH))  # d/ds (a cos s sin θ + b sin s cos θ) = 0, the lower one
    along, up = a * cos(s) * cos(TH) - b * sin(s) * sin(TH), a * cos(s) * sin(TH) + b * sin(s) * cos(TH)
    masses = ((1, (X, Y), (a**2 + b**2) / 4, TH),)
    assert sympy.simplify(sympy.diff(up, TH) - along) == 0  # v_N = Y' + θ' along, so the support function serves
    return Bodies((X, Y, TH), masses, tuple(weight(1, (X, Y, TH), masses)), Y + up, XD - THD * up)


def wheel() -> Bodies:
    e = Rational(3, 5)
    masses = ((1, (X + e * cos(TH), Y + e * sin(TH)), Rational(1, 10), TH),)
    return Bodies((X, Y, TH), masses, tuple(weight(1, (X, Y, TH), masses)), Y - 1, XD + THD)


def biped() -> Bodies:
    legs = [(1, (X + cos(t) / 2, Y - sin(t) / 2), sympy.Integer(0), t) for t in (T1, T2)]
    masses = ((2, (X, Y), sympy.Integer(0), TH), *legs)
    coordinates = (X, Y, T1, T2)
    forces = tuple(weight(1, coordinates, masses))
    return Bodies(coordinates, masses, forces, Y - sin(T1), rate(X + cos(T1)))


BODIES = {
    "rod with a wrist": rod(5, -5 * (TH - Rational(9, 10)) - THD, 1, Rational(981, 100)),
    "rod on a shaken base": rod(0, 0, 1, Rational(3, 5), sin(T) / 20),
    "ladder on a vertical guide": upper_end_on_a_line((-1, cos(TH) / 2), -sin(TH) * THD),
    "chalk pushed along a board": upper_end_on_a_line((-2, -2 * (TH - 1) - THD / 2), 4 - sin(TH) * THD),
    "sliding ellipse": ellipse(1, Rational(1, 5)),
    "unbalanced wheel": wheel(),
    "two-link arm": arm(1, Rational(1, 2), Rational(1, 4), (20, 5)),
    "two-link arm on a belt": arm(1, Rational(1, 2), Rational(1, 4), (20, 5), belt=-4),
    "double pendulum on a rough surface": arm(4, 1, Rational(1, 4), (0, 0)),
    "compass biped": biped(),
}


def reference(bodies: Bodies, at: dict[Any, Any]) -> dict[str, Any]:
    """A, B, C, a, b by M q'' = f: Lagrange's equations with the kinetic energy of the mass centres, at one state."""
    q = bodies.coordinates
    velocities = [RATES[x] for x in q]
    kinetic = sum(
        mass * (rate(place[0]) ** 2 + rate(place[1]) ** 2) / 2 + inertia * rate(angle) ** 2 / 2
        for mass, place, inertia, angle in bodies.masses
    )
    momenta = [sympy.diff(kinetic, velocity) for velocity in velocities]
    matrix = sympy.Matrix([[sympy.diff(p, velocity) for velocity in velocities] for p in momenta])
    right = [f + sympy.diff(kinetic, x) - rate(p) for f, x, p in zip(bodies.forces, q, momenta, strict=True)]
    matrix, right = matrix.subs(at).evalf(40), sympy.Matrix(right).subs(at).evalf(40)
    tangent = sympy.Matrix([sympy.diff(bodies.slip, velocity) for velocity in velocities]).subs(at).evalf(40)
    normal = sympy.Matrix([sympy.diff(bodies.height, x) for x in q]).subs(at).evalf(40)
    free, of_tangent, of_normal = (matrix.LUsolve(side) for side in (right, tangent, normal))
    return {
        "A": tangent.dot(of_tangent), "B": tangent.dot(of_normal), "C": normal.dot(of_normal),
        "a": tangent.dot(free) + rate(bodies.slip).subs(at).evalf(40),
        "b": normal.dot(free) + rate(rate(bodies.height)).subs(at).evalf(40),
        "y": bodies.height.subs(at).evalf(40), "u": bodies.slip.subs(at).evalf(40),
    }  # fmt: skip


@pytest.mark.parametrize("name", BODIES)
def test_each_file_is_the_mechanism_that_it_says(name: str) -> None:
    shifted = shift(shipped_mechanism(name))
    source = random.Random(name)
    numbers = [Rational(source.randint(-60, 60), 64) for _ in shifted.mechanism.state]
    at = dict(zip(map(sympy.Symbol, shifted.mechanism.state), numbers, strict=True))
    expected = reference(BODIES[name], at)
    with working_bits(160):
        letters = list(expected)
        expressions = shifted.expressions([getattr(shifted.functions, letter) for letter in letters], BALLS)
        balls = values(expressions, [arb(fmpq(int(value.p), int(value.q))) for value in numbers])
        for letter, ball in zip(letters, balls, strict=True):
            assert narrow(ball)
            assert abs(ball - arb(str(sympy.N(expected[letter], 35)))) < arb(10) ** -25, letter


@pytest.mark.parametrize(
    ("name", "case"),
    [
        ("rod with a wrist", "III"),
        ("rod on a shaken base", "II"),
        ("chalk pushed along a board", "III"),
        ("sliding ellipse", "II"),
        ("unbalanced wheel", "II"),
        ("two-link arm", "II"),
        ("two-link arm on a belt", "II"),
        ("compass biped", "II"),
        ("frictional impact oscillator on a belt", "III"),
    ],
)
def test_the_place_of_the_file_is_a_g_spot(name: str, case: str) -> None:
    found = classify_g_spot(find_g_spot(shipped_mechanism(name)))
    assert str(found.case) == case


def test_no_other_joint_is_below_the_surface() -> None:
    """The equations know one contact; a place where the elbow or the other foot is under the floor is no mechanism."""
    for name, height in (
        ("two-link arm", lambda s: 0.25 - math.sin(s["theta_1"])),
        ("two-link arm on a belt", lambda s: 0.25 - math.sin(s["theta_1"])),
        ("compass biped", lambda s: s["Y"] - math.sin(s["theta_2"])),
        ("ladder on a vertical guide", lambda s: s["Y"]),
    ):
        spot = find_g_spot(shipped_mechanism(name))
        place = [float(arb(value).mid()) for value in spot.system.point]
        assert height(dict(zip(spot.mechanism.state, place, strict=True))) > 0.1


def test_a_belt_changes_the_slip_velocity_only() -> None:
    for still, moving in (
        ("two-link arm", "two-link arm on a belt"),
        ("frictional impact oscillator, all parameters", "frictional impact oscillator on a belt"),
    ):
        systems = [find_g_spot(shipped_mechanism(name)) for name in (still, moving)]
        assert all(a.overlaps(b) for a, b in zip(*(spot.system.check() for spot in systems), strict=True))


def test_a_ball_of_the_ellipse_is_smooth_where_its_height_is() -> None:
    a, b = 1, Rational(1, 5)
    height = sqrt(a**2 * sin(TH) ** 2 + b**2 * cos(TH) ** 2)
    assert sympy.simplify((ellipse(a, b).height - (Y - height)).subs(TH, pi / 3)) == 0
