"""Rotations of the frames in URDF and MJCF as exact matrices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

_FEWEST_DECIMALS = 2  # from 1.57 on a decimal is read as pi/2


def about(axis: str, angle: Any) -> Any:
    """The matrix that turns about the axis x, y or z.

    >>> from sympy import pi
    >>> about("z", pi / 2)
    Matrix([
    [0, -1, 0],
    [1,  0, 0],
    [0,  0, 1]])
    """
    import sympy

    c, s = sympy.cos(angle), sympy.sin(angle)
    rows = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return sympy.ImmutableMatrix(rows[axis])


def by_euler(angles: Sequence[Any], sequence: str) -> Any:
    """One turn after the other: a small letter is an axis that moves with the body, a capital one that stays."""
    import sympy

    turn: Any = sympy.ImmutableMatrix(sympy.eye(3))
    for letter, angle in zip(sequence, angles, strict=True):
        next_turn = about(letter.lower(), angle)
        turn = turn * next_turn if letter.islower() else next_turn * turn
    return turn


def by_roll_pitch_yaw(angles: Sequence[Any]) -> Any:
    """URDF's rpy: about the axes x, y, z that stay, in this order."""
    return by_euler(angles, "XYZ")


def by_quaternion(parts: Sequence[Any]) -> Any:
    """The matrix of the quaternion w, x, y, z, divided by its length; None where that is 0.

    >>> by_quaternion([1, 1, 0, 0]) == by_quaternion([2, 2, 0, 0])
    True
    """
    import sympy

    w, x, y, z = map(sympy.sympify, parts)
    square = w**2 + x**2 + y**2 + z**2
    if square == 0:
        return None
    rows = [
        [w**2 + x**2 - y**2 - z**2, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w**2 - x**2 + y**2 - z**2, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w**2 - x**2 - y**2 + z**2],
    ]
    return sympy.ImmutableMatrix(rows) / square


def right_angle(number: Any, word: str) -> Any:
    """The multiple of pi/2 that a decimal stands for: what it shows is that multiple, rounded or cut; else the number.

    >>> from sympy import Rational
    >>> right_angle(Rational("1.5708"), "1.5708"), right_angle(Rational("0.3"), "0.3")
    (pi/2, 3/10)
    """
    import sympy

    if "e" in word.lower() or "." not in word:
        return number
    decimals = len(word.partition(".")[2])
    unit = sympy.Rational(1, 10**decimals)
    count = sympy.Integer(round(2 * number / sympy.pi))
    beyond = abs(number) - abs(count) * sympy.pi / 2
    if count == 0 or decimals < _FEWEST_DECIMALS or not -unit < beyond <= unit / 2:
        return number
    return count * sympy.pi / 2
