"""Planar trees: against homogeneous transforms in space, multiplied out and differentiated by sympy."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.mechanisms.foreign.planar_tree import Body, Joint, PlanarContact, planar_mechanism
from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.input.mechanism import Lagrangian, MechanismError

EYE, ZERO = sympy.ImmutableMatrix(sympy.eye(3)), sympy.ImmutableMatrix([0, 0, 0])
NUMBERS = st.integers(-3, 3)
POINTS = st.tuples(NUMBERS, NUMBERS, NUMBERS)
JOINTS = st.lists(st.tuples(st.booleans(), POINTS, st.sampled_from([1, -1]), NUMBERS), min_size=1, max_size=3)
CONTACT = PlanarContact("body 1", (0, 0, 0), 1, 0, "z", "x")


def joint(number: int, is_hinge: bool, anchor: Any, sign: int, reference: int) -> Joint:
    axis = [0, sign, 0] if is_hinge else [sympy.Rational(3, 5), 0, sympy.Rational(4 * sign, 5)]
    return Joint(f"j{number}", is_hinge, sympy.ImmutableMatrix(axis), sympy.ImmutableMatrix(anchor), reference)


def body(number: int, joints: tuple[Joint, ...], centre: Any, **parts: Any) -> Body:
    inertia = sympy.ImmutableMatrix([[7, 1, 2], [1, number, 3], [2, 3, 9]])
    return replace(
        Body(f"body {number}", joints, EYE, ZERO, sympy.Integer(number), sympy.ImmutableMatrix(centre), inertia),
        **parts,
    )


def transform(each: Joint, q: Any) -> sympy.Matrix:
    """The motion that the joint makes of all that is behind it, in space."""
    amount = q - each.reference
    if not each.is_hinge:
        turn, shift = sympy.eye(3), each.axis * amount
    else:
        x, y, z = each.axis
        K = sympy.Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        turn = sympy.eye(3) + sympy.sin(amount) * K + (1 - sympy.cos(amount)) * K * K  # Rodrigues
        shift = each.anchor - turn * each.anchor
    return turn.row_join(sympy.Matrix(shift)).col_join(sympy.Matrix([[0, 0, 0, 1]]))


@settings(max_examples=5, deadline=None)
@given(JOINTS, POINTS, POINTS)
def test_mass_matrix_and_weights_are_those_of_transforms_in_space(rows: Any, centre: Any, point: Any) -> None:
    """The first joint bears two bodies, the second of them behind all other joints: a tree."""
    joints = tuple(joint(number, *row) for number, row in enumerate(rows))
    bodies = [body(2, joints[:1], (1, 0, 2)), body(1, joints, centre)]
    contact = PlanarContact("body 1", point, 1, 2, "z", "x")
    found = planar_mechanism("tree", bodies, contact, sympy.ImmutableMatrix([3, 5, -4]), {}, {})
    q, count = sympy.symbols(f"j:{len(joints)}"), len(joints)
    place = {letter: sympy.Rational(3 + 2 * i, 7) for i, letter in enumerate(q)}
    M, pull = sympy.zeros(count, count), sympy.zeros(count, 1)
    for each in bodies:
        moved = sympy.eye(4)
        for one in each.joints:
            moved = moved * transform(one, q[joints.index(one)])
        slopes = (moved * each.centre.col_join(sympy.Matrix([1])))[:3, 0].jacobian(q)
        spin = sympy.Matrix([[one.axis[1] if one.is_hinge and one in each.joints else 0 for one in joints]])
        M += each.mass * slopes.T * slopes + each.inertia[1, 1] * spin.T * spin
        pull += each.mass * slopes.T * sympy.Matrix([3, 5, -4])
    tip = (moved * sympy.Matrix([*point, 1]))[:3, 0]
    motion = found.motion
    assert isinstance(motion, Lagrangian)
    assert found.x is not None
    still = place | {sympy.Symbol(f"j{i}_dot"): 0 for i in range(count)} | {sympy.Symbol("height"): 2}

    def number(expression: Any) -> Any:
        return to_sympy(expression, found.state).xreplace(still).evalf(30)

    for i in range(count):
        assert abs(number(motion.forces[i]) - pull[i].xreplace(place).evalf(30)) < 1e-25
        for j in range(count):
            assert abs(number(motion.mass_matrix[i][j]) - M[i, j].xreplace(place).evalf(30)) < 1e-25
    assert abs(number(found.x) - tip[0].xreplace(place).evalf(30)) < 1e-25
    assert abs(number(found.y) - (tip[2] - 2).xreplace(place).evalf(30)) < 1e-25


def hinge(**parts: Any) -> Joint:
    return replace(joint(0, True, (0, 0, 0), 1, 0), **parts)


def test_springs_dampers_and_armatures_act_along_their_joint() -> None:
    spring = hinge(damping=sympy.Integer(3), stiffness=sympy.Integer(5), rest=sympy.Rational(1, 2), armature=11)
    made = planar_mechanism("one", [body(1, (spring,), (0, 0, 0))], CONTACT, ZERO, {}, {})
    motion = made.motion
    assert isinstance(motion, Lagrangian)
    assert to_sympy(motion.mass_matrix[0][0]) == 12
    force = to_sympy(motion.forces[0], made.state)
    assert sympy.expand(force - sympy.sympify("-3*j0_dot - 5*(j0 - 1/2)")) == 0


@pytest.mark.parametrize("axis", [(0, 0, 1), (0, 1, 1), (1, 0, 0)])
def test_a_hinge_that_leaves_the_plane_is_refused(axis: tuple[int, int, int]) -> None:
    with pytest.raises(MechanismError, match=r"joint 'j0' turns about .*must be parallel to the normal of the plane"):
        planar_mechanism("one", [body(1, (hinge(axis=sympy.ImmutableMatrix(axis)),), (0, 0, 0))], CONTACT, ZERO, {}, {})


def test_a_slide_that_leaves_the_plane_is_refused() -> None:
    slide = hinge(is_hinge=False)
    with pytest.raises(MechanismError, match=r"joint 'j0' slides along .*must be perpendicular"):
        planar_mechanism("one", [body(1, (slide,), (0, 0, 0))], CONTACT, ZERO, {}, {})


@pytest.mark.parametrize(("tangent", "normal", "n"), [("x", "z", (0, -1, 0)), ("z", "x", (0, 1, 0)),
                                                      ("-x", "z", (0, 1, 0)), ("x", "+y", (0, 0, 1))])  # fmt: skip
def test_the_plane_is_to_the_right_about_its_normal(tangent: str, normal: str, n: tuple[int, int, int]) -> None:
    """A hinge about n turns the tangent to the normal: the tip (1, 0) goes to y > 0."""
    forwards = hinge(axis=sympy.ImmutableMatrix(n))
    tip = {"x": (1, 0, 0), "z": (0, 0, 1), "-x": (-1, 0, 0)}[tangent]
    contact = replace(CONTACT, tangent=tangent, normal=normal, point=tip)
    found = planar_mechanism("one", [body(1, (forwards,), (0, 0, 0))], contact, ZERO, {}, {})
    assert found.x is not None
    angle = sympy.Symbol("j0")
    assert to_sympy(found.x, found.state) == sympy.cos(angle)
    assert to_sympy(found.y, found.state) == sympy.sin(angle) - sympy.Symbol("height")


@pytest.mark.parametrize("count", [0, 13])
def test_the_number_of_joints_has_limits(count: int) -> None:
    joints = tuple(joint(i, True, (0, 0, 0), 1, 0) for i in range(count))
    with pytest.raises(MechanismError, match=f"between 1 and 12 joints that move .*got {count} and 1"):
        planar_mechanism("many", [body(1, joints, (0, 0, 0))], CONTACT, ZERO, {}, {})


def test_the_number_of_bodies_has_a_limit() -> None:
    with pytest.raises(MechanismError, match="at most 200 bodies, got 1 and 201"):
        planar_mechanism("many", [body(1, (hinge_0,), (0, 0, 0))] * 201, CONTACT, ZERO, {}, {})


hinge_0 = hinge()
