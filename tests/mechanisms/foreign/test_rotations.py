"""Rotations: against products of turns and the meaning of each convention; decimals that stand for right angles."""

from __future__ import annotations

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import pi

from gspot_verified.mechanisms.foreign.rotations import about, by_euler, by_quaternion, by_roll_pitch_yaw, right_angle

X, Y, Z = (sympy.ImmutableMatrix(column) for column in ([1, 0, 0], [0, 1, 0], [0, 0, 1]))
A, B, C = sympy.symbols("a b c", real=True)


@pytest.mark.parametrize(
    ("axis", "first", "second"), [("x", Y, Z), ("y", Z, X), ("z", X, Y)]
)  # a turn by a right angle takes the first to the second
def test_a_turn_is_to_the_right_about_its_axis(axis: str, first: sympy.Matrix, second: sympy.Matrix) -> None:
    assert about(axis, pi / 2) * first == second
    assert about(axis, pi / 2) * second == -first
    assert about(axis, A) * {"x": X, "y": Y, "z": Z}[axis] == {"x": X, "y": Y, "z": Z}[axis]


def test_roll_pitch_yaw_is_urdfs() -> None:
    """ROS: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    assert by_roll_pitch_yaw([A, B, C]) == about("z", C) * about("y", B) * about("x", A)


def test_small_letters_move_with_the_body_and_capital_ones_stay() -> None:
    assert by_euler([A, B, C], "xyz") == about("x", A) * about("y", B) * about("z", C)
    assert by_euler([A, B, C], "XYZ") == about("z", C) * about("y", B) * about("x", A)
    assert by_euler([A, B, C], "zXz") == about("x", B) * about("z", A) * about("z", C)


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_quaternion_is_half_the_turn(axis: str) -> None:
    half = sympy.Rational(3, 5), sympy.Rational(4, 5)  # cosine and sine of half the angle
    parts = [half[0], *(half[1] if word == axis else 0 for word in "xyz")]
    cosine, sine = half[0] ** 2 - half[1] ** 2, 2 * half[0] * half[1]
    turned = about(axis, A).subs({sympy.cos(A): cosine, sympy.sin(A): sine})
    assert by_quaternion(parts) == turned


NUMBERS = st.integers(-5, 5)


@settings(max_examples=25, deadline=None)
@given(st.tuples(NUMBERS, NUMBERS, NUMBERS, NUMBERS), st.tuples(NUMBERS, NUMBERS, NUMBERS, NUMBERS))
def test_quaternions_turn_and_their_product_is_one_after_the_other(
    first: tuple[int, int, int, int], second: tuple[int, int, int, int]
) -> None:
    one, other = by_quaternion(first), by_quaternion(second)
    if first == (0, 0, 0, 0) or second == (0, 0, 0, 0):
        assert None in (one, other)
        return
    assert one * one.T == sympy.eye(3)
    assert one.det() == 1
    (a, b, c, d), (e, f, g, h) = first, second
    product = (a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
               a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e)  # fmt: skip
    assert by_quaternion(product) == one * other


@pytest.mark.parametrize(
    ("word", "angle"),
    [("1.57", pi / 2), ("1.571", pi / 2), ("1.570", pi / 2), ("-1.5708", -pi / 2), ("3.14", pi), ("3.1415", pi),
     ("3.14159265359", pi), ("4.712", 3 * pi / 2), ("-6.283", -2 * pi), ("1.5707963267948966", pi / 2)],
)  # fmt: skip
def test_what_shows_a_multiple_of_a_right_angle_is_one(word: str, angle: sympy.Expr) -> None:
    assert right_angle(sympy.Rational(word), word) == angle


@pytest.mark.parametrize(
    "word", ["0", "0.0", "0.001", "1.58", "1.56", "1.6", "1.5", "1.572", "1.5709", "3.15", "3", "0.7854", "2", "157e-2"]
)
def test_another_number_stays(word: str) -> None:
    assert right_angle(sympy.Rational(word), word) == sympy.Rational(word)
