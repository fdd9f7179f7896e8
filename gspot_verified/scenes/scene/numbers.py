"""Numbers in scenes: exact, without units, and small enough to compute with."""

from __future__ import annotations

import re

from flint import fmpq

from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.scenes.equations.motion import SceneError

MAX_BITS = 2000  # of a numerator or denominator, small enough to compute with
_UNIT = re.compile(
    r"\s*[+-]?(?!0[xX][0-9a-fA-F]|0[bB][01]|0[oO][0-7])"  # not hexadecimal, binary or octal, which no input may be
    r"[0-9.]+(?:[eE][+-]?[0-9]+)?(?:/[0-9]+)?\s*(?![eE][+-]?[0-9]+)([A-Za-zµμ°%][A-Za-z0-9µμ°%/^* ]*)\s*"
)


def scene_number(value: ExactInput, name: str) -> fmpq:
    """The exact rational that an input is.

    :raises SceneError: a number with a unit, or one with more than 2000 bits.
    :raises ValueError: no number.
    :raises TypeError: a float.

    >>> scene_number("1e-3", "epsilon")
    1/1000
    """
    if isinstance(value, str) and (unit := _UNIT.fullmatch(value[:200])):
        raise SceneError(
            f"{name}: {value[:40]!r} has a unit ({unit[1].strip()}); numbers stand without units, in those of the "
            "mechanism"
        )
    if isinstance(value, str) and len(value) > MAX_BITS:
        raise SceneError(f"{name}: a number of {len(value)} characters; at most {MAX_BITS} bits are allowed")
    number = rational(value, name)
    size = max(int(number.p).bit_length(), int(number.q).bit_length())
    if size > MAX_BITS:
        raise SceneError(f"{name}: a number of {size} bits; at most {MAX_BITS} are allowed")
    return number
